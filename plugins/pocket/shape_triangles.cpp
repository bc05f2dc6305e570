#include "shape_triangles.h"

#include <algorithm>
#include <array>

#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom::pocket {

double chordOf(const Shape& shape) {
  constexpr double finest = 0.005, coarsest = 0.05, shareOfSize = 1.0 / 20'000;
  return std::clamp(bounds(shape).diagonal() * shareOfSize, finest, coarsest);
}

Triangles trianglesOf(const Shape& shape, const Progress& progress) {
  const Tessellation mesh = tessellate(shape, {.chord = chordOf(shape)}, progress);
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    triangles.push_back({mesh.points.at(static_cast<std::size_t>(t[0])), mesh.points.at(static_cast<std::size_t>(t[1])),
                         mesh.points.at(static_cast<std::size_t>(t[2]))});
  return triangles;
}

Triangles trianglesOf(const Bounds& box) {
  const auto corner = [&](int i) {
    return Vec3((i & 1) != 0 ? box.high.x() : box.low.x(), (i & 2) != 0 ? box.high.y() : box.low.y(),
                (i & 4) != 0 ? box.high.z() : box.low.z());
  };
  Triangles triangles;
  for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                   std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    triangles.push_back({corner(a), corner(b), corner(c)});
    triangles.push_back({corner(a), corner(c), corner(d)});
  }
  return triangles;
}

}  // namespace blossom::pocket
