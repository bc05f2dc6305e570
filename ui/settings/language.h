#pragma once
#include <QString>
#include <QStringList>

namespace blossom::ui {

/// The window's texts in the preferred language, or in that of the system where Blossom speaks it; otherwise the English
/// they are written in. Before the first widget is made.
void installLanguage();

/// "de" for the preference "deutsch"; for "system" the first of the languages wanted that there is; empty for English.
QString languageCode(const QString& preference, const QStringList& wanted);

}  // namespace blossom::ui
