#pragma once
#include <QString>
#include <vector>

namespace blossom::ui {

struct LibraryVersion {
  QString name, version;
};

/// Versions of Blossom, its libraries, the desktop and the graphics driver; the driver is queried in the current OpenGL
/// context and left out when there is none.
std::vector<LibraryVersion> libraryVersions();
/// One per line, for a report of a problem.
QString asText(const std::vector<LibraryVersion>&);

}  // namespace blossom::ui
