#include "kernel/arrangement/features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/numeric/union_find.h"

namespace blossom::morphology::arrangement {

namespace {

Grid3 onGrid(const Vec3& p, double factor, double step) {
  Grid3 point{};
  const std::int64_t unit = std::abs(factor) == 1 ? 1 : usualSteps;
  for (std::size_t k = 0; k < 3; ++k)
    point[k] = unit * std::llround(factor * p[static_cast<Eigen::Index>(k)] / (static_cast<double>(unit) * step));
  return point;
}

/// Nothing when it has no area.
std::optional<Features::Face> faceOf(const std::vector<Grid3>& points, const std::array<int, 3>& corners) {
  const auto at = [&](std::size_t k) -> const Grid3& { return points[static_cast<std::size_t>(corners[k])]; };
  Features::Face face{corners, cross(at(1) - at(0), at(2) - at(0)), {}};
  if (isZero(face.normal)) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) face.about[k] = rounded(face.normal[k]);
  return face;
}

/// A point of each part that edges connect.
std::vector<int> partsOf(const Features& solid) {
  UnionFind parts(solid.points.size());
  std::vector<bool> used(solid.points.size(), false);
  for (const Features::Edge& edge : solid.edges) {
    parts.unite(static_cast<std::size_t>(edge.from), static_cast<std::size_t>(edge.to));
    used[static_cast<std::size_t>(edge.from)] = true;
  }
  std::vector<int> first;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] && parts.find(v) == v) first.push_back(static_cast<int>(v));
  return first;
}

void addSegment(Features& features, int from, int to, int left, int right) {
  const Grid3 along = features.points[static_cast<std::size_t>(to)] - features.points[static_cast<std::size_t>(from)];
  if (along == Grid3{}) return;
  features.corners[static_cast<std::size_t>(from)].around.push_back(along);
  features.corners[static_cast<std::size_t>(to)].around.push_back(Grid3{} - along);
  features.edges.push_back({from, to, left, right, true});
}

/// Of a face that has the directed edge from one corner to the other, its third corner.
int opposite(const Features::Face& face, int from, int to) {
  for (const int corner : face.corners)
    if (corner != from && corner != to) return corner;
  return -1;
}

}  // namespace

int slope(const Normal3& n, const Bounded3& about, const Grid3& d) {
  const Bounded value = dot(about, exactly(d));
  return value.decided() ? signOf(value.value) : signOf(dot(n, d));
}

bool isReflex(const Features& solid, const Features::Edge& edge) {
  if (edge.left == Features::none || edge.right == Features::none || edge.isConvex) return false;
  const Features::Face &face = solid.faces[static_cast<std::size_t>(edge.left)],
                       &other = solid.faces[static_cast<std::size_t>(edge.right)];
  const auto at = [&](int corner) -> const Grid3& { return solid.points[static_cast<std::size_t>(corner)]; };
  return slope(face.normal, face.about, at(opposite(other, edge.from, edge.to)) - at(edge.from)) > 0;
}

std::optional<Features> featuresOf(const Mesh& triangles, double factor, double step, bool insideOut) {
  Features made;
  made.points.reserve(triangles.points.size());
  for (const Vec3& p : triangles.points) made.points.push_back(onGrid(p, factor, step));
  const auto at = [&](int corner) -> const Grid3& { return made.points[static_cast<std::size_t>(corner)]; };
  const bool turned = (factor < 0) != insideOut;
  std::map<std::pair<int, int>, int> faceBeside;  // of directed edges, the face to their left
  made.faces.reserve(triangles.faceCount());
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const auto corners = triangles.face(f);
    const auto face = faceOf(made.points, {corners[0], corners[turned ? 2 : 1], corners[turned ? 1 : 2]});
    if (!face) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k)
      if (!faceBeside.try_emplace({face->corners[k], face->corners[(k + 1) % 3]}, static_cast<int>(f)).second)
        return std::nullopt;
    made.faces.push_back(*face);
  }
  made.corners.resize(made.points.size());
  for (const auto& [ends, left] : faceBeside) {
    const auto [from, to] = ends;
    made.corners[static_cast<std::size_t>(from)].around.push_back(at(to) - at(from));
    if (from > to) continue;
    const auto beyond = faceBeside.find({to, from});
    if (beyond == faceBeside.end()) return std::nullopt;
    const Features::Face &face = made.faces[static_cast<std::size_t>(left)],
                         &other = made.faces[static_cast<std::size_t>(beyond->second)];
    const bool isConvex = slope(face.normal, face.about, at(opposite(other, from, to)) - at(from)) < 0;
    if (isConvex)
      for (const int end : {from, to}) made.corners[static_cast<std::size_t>(end)].isTouched = true;
    made.edges.push_back({from, to, left, beyond->second, isConvex});
  }
  made.parts = partsOf(made);
  return made;
}

Features featuresOf(std::span<const std::vector<Vec3>> pieces, double factor, double step) {
  Features made;
  for (const std::vector<Vec3>& piece : pieces) {
    const int first = static_cast<int>(made.points.size());
    for (const Vec3& p : piece) made.points.push_back(onGrid(p, factor, step));
    made.parts.push_back(first);
    made.corners.resize(made.points.size());
    for (int k = first; k < static_cast<int>(made.points.size()); ++k)
      made.corners[static_cast<std::size_t>(k)].isTouched = true;
    if (piece.size() == 2) addSegment(made, first, first + 1, Features::none, Features::none);
    if (piece.size() < 3) continue;
    const auto front = faceOf(made.points, {first, first + 1, first + 2});
    int left = Features::none, right = Features::none;
    if (front) {
      left = static_cast<int>(made.faces.size());
      right = left + 1;
      made.faces.push_back(*front);
      made.faces.push_back(*faceOf(made.points, {first, first + 2, first + 1}));
    }
    for (int k = 0; k < 3; ++k) addSegment(made, first + k, first + (k + 1) % 3, left, right);
  }
  return made;
}

}  // namespace blossom::morphology::arrangement
