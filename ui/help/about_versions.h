#pragma once
#include <QString>
#include <vector>

namespace blossom::ui {

struct LibraryVersion {
  QString name, version;
};

/// Blossom, the libraries it runs with, the desktop and the graphics driver; the driver is asked in the current OpenGL
/// context, or left out where there is none.
std::vector<LibraryVersion> libraryVersions();
/// One per line, for a report of a problem.
QString asText(const std::vector<LibraryVersion>&);

}  // namespace blossom::ui
