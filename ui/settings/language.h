#pragma once
#include <QString>
#include <QStringList>

namespace blossom::ui {

/// Installs the translation for the preferred language, or for that of the system if there is one, else English. Call it
/// before the first widget is created.
void installLanguage();

/// "de" for the preference "deutsch"; for "system" the first available of the wanted languages; empty for English.
QString languageCode(const QString& preference, const QStringList& wanted);

}  // namespace blossom::ui
