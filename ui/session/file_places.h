#pragma once
#include <QString>

namespace blossom::ui {

/// Where file dialogs begin: the folder that was used last, else the user's documents.
QString lastFolder();
void rememberFolder(const QString& file);

}  // namespace blossom::ui
