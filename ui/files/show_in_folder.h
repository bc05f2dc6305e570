#pragma once
#include <QString>

namespace blossom::ui {

/// Opens the folder of a file in the desktop's file manager.
void showInFolder(const QString& file);

}  // namespace blossom::ui
