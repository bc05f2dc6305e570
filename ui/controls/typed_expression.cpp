#include "ui/controls/typed_expression.h"

#include <QRegularExpression>
#include <array>

#include "core/error.h"
#include "parameter/written.h"
#include "ui/look/text.h"
#include "ui/look/units.h"

namespace blossom::ui {

namespace {

const QString numberPattern = QStringLiteral("(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?");

QString withUnits(QString typed, const QString& unit) {
  static const QRegularExpression bare(QStringLiteral("(?<![\\w.])(") + numberPattern +
                                       QStringLiteral(")(?![\\w.])(?!\\s*[\\p{L}\"'\u00b0])"));
  return typed.replace(bare, QStringLiteral("\\1 ") + unit);
}

bool comesTo(const ParameterSpec& spec, const QString& text, const Value& value, const NamedNumbers& names,
             const LengthUnit& unit = {}) {
  try {
    return parseText(spec, text.trimmed().toStdString(), unit, names) == value;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

bool isExpression(const QString& typed) {
  static const QRegularExpression plain(QStringLiteral("^\\s*[-+]?") + numberPattern +
                                        QStringLiteral("\\s*[^\\d\\s+*/^(),-]*\\s*$"));
  return !typed.trimmed().isEmpty() && !plain.match(typed).hasMatch();
}

std::string documentText(const ParameterSpec& spec, const QString& typed, const Value& value, const NamedNumbers& names) {
  const QString unit = qt(lengthUnit().name);
  const std::array forms{typed, QStringLiteral("(%1) %2").arg(typed, unit), withUnits(typed, unit)};
  for (const QString& form : forms)
    if (comesTo(spec, form, value, names)) return form.toStdString();
  return {};
}

bool typedComesTo(const ParameterSpec& spec, const QString& typed, const Value& value, const NamedNumbers& names) {
  return !typed.isEmpty() && !value.is_null() && comesTo(spec, typed, value, names, lengthUnit());
}

Value writtenAs(const ParameterSpec& spec, const QString& expression, const Value& value, const NamedNumbers& names) {
  if (!typedComesTo(spec, expression, value, names)) return value;
  const std::string text = documentText(spec, expression, value, names);
  if (text.empty()) return value;
  return usesNames(text, names) ? Value{{"expression", text}, {"value", value}} : Value(text);
}

QString expressionOf(const Value& stored) {
  if (stored.is_string()) return qt(stored.get<std::string>());
  return isNamedExpression(stored) ? qt(stored.at("expression").get<std::string>()) : QString();
}

Value writtenTyped(const ParameterSpec& spec, const QString& typed, const NamedNumbers& names) {
  const Value value = parseText(spec, typed.trimmed().toStdString(), lengthUnit(), names);
  return isExpression(typed) ? writtenAs(spec, typed.trimmed(), value, names) : value;
}

}  // namespace blossom::ui
