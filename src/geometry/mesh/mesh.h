#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/vector.h"
#include "geometry/values/color.h"

namespace blossom {

/// Sharpness of an edge or a vertex of a subdivision cage (OpenSubdiv's `t crease` and `t corner` tags). 10 and above means
/// infinitely sharp.
struct Crease {
  int from = 0, to = 0;  ///< vertex indices
  double sharpness = 0;
  friend bool operator==(const Crease&, const Crease&) = default;
};
struct Corner {
  int vertex = 0;
  double sharpness = 0;
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// Polygons over shared points. Face f has the vertices faceVertices[faceStarts[f] .. faceStarts[f+1]), counter-clockwise
/// seen from outside.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<int> faceStarts{0};  ///< faceCount() + 1 entries
  std::vector<int> faceVertices;
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  std::vector<std::string> otherTags;  ///< `t` lines with other tags, kept verbatim
  std::string name;
  std::optional<Color> color;
  bool flatFaces = false;  ///< each face is drawn flat: it is a face of a solid, not a sample of a smooth surface

  [[nodiscard]] std::size_t faceCount() const { return faceStarts.size() - 1; }
  [[nodiscard]] std::span<const int> face(std::size_t f) const {
    return std::span(faceVertices)
        .subspan(static_cast<std::size_t>(faceStarts[f]), static_cast<std::size_t>(faceStarts[f + 1] - faceStarts[f]));
  }
  void addFace(std::span<const int> vertices) {
    faceVertices.insert(faceVertices.end(), vertices.begin(), vertices.end());
    faceStarts.push_back(static_cast<int>(faceVertices.size()));
  }
  friend bool operator==(const Mesh&, const Mesh&) = default;
};

}  // namespace blossom
