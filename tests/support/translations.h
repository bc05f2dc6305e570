#pragma once
#include <QFile>
#include <QXmlStreamReader>
#include <vector>

#include "support/support.h"

namespace blossom::test {

/// A file of resources/translations by its name without ".ts".
inline QString translationFile(const QString& name) {
  return QString::fromStdString((sourceFolder() / "resources/translations").string()) + u'/' + name + QStringLiteral(".ts");
}

struct TranslatedMessage {
  QString context, source, translation;
  bool finished = true;
};

inline std::vector<TranslatedMessage> messagesOf(const QString& file) {
  QFile input(file);
  if (!input.open(QIODevice::ReadOnly)) return {};
  QXmlStreamReader xml(&input);
  std::vector<TranslatedMessage> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("message")) messages.push_back({context, {}, {}, true});
    if (xml.name() == QLatin1String("source")) messages.back().source = xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      messages.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      messages.back().translation = xml.readElementText();
    }
  }
  return messages;
}

}  // namespace blossom::test
