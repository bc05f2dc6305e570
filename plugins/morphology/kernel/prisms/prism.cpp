#include "kernel/prisms/prism.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/planar/area_triangulation.h"
#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::morphology {

namespace {

using planar::CountedEdge, planar::GridPoint, planar::Loop, planar::Polygon, planar::Polygons;

/// Triangles seen along an axis.
class AlongAxis {
 public:
  AlongAxis(const Mesh& triangles, int axis, double step) : mesh_(triangles), axis_(axis), step_(step) {
    for (const Vec3& p : mesh_.points) low_ = std::min(low_, p[axis_]), high_ = std::max(high_, p[axis_]);
  }

  [[nodiscard]] std::optional<Prism> prism(const Progress& progress) const {
    if (high_ - low_ <= 2 * near_ * step_) return std::nullopt;
    double ofWalls = 0, ofUpperEnd = 0, ofLowerEnd = 0;  // areas
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      const std::span<const int> face = mesh_.face(f);
      const bool isLow = isAt(face, low_), isHigh = !isLow && isAt(face, high_);
      if (!isLow && !isHigh && !isWall({seen(face[0], step_), seen(face[1], step_), seen(face[2], step_)}))
        return std::nullopt;
      (isLow    ? ofLowerEnd
       : isHigh ? ofUpperEnd
                : ofWalls) += vectorArea(std::array{point(face[0]), point(face[1]), point(face[2])}).norm();
    }
    Polygons section = sectionOn(step_, progress);
    const double boundary = ofWalls / (high_ - low_);
    if (section.empty() || std::abs(ofLowerEnd - ofUpperEnd) > slack_ * step_ * boundary) return std::nullopt;
    if (!isAll(sectionOn(thin_ * step_, progress), ofUpperEnd, boundary)) return std::nullopt;
    return Prism{axis_, std::move(section), low_, high_};
  }

 private:
  [[nodiscard]] const Vec3& point(int vertex) const { return mesh_.points[static_cast<std::size_t>(vertex)]; }
  [[nodiscard]] GridPoint seen(int vertex, double unit) const {
    const Vec3& p = point(vertex);
    return {std::llround(p[(axis_ + 1) % 3] / unit), std::llround(p[(axis_ + 2) % 3] / unit)};
  }
  /// What the triangles of the upper end cover: sides between them cancel each other.
  [[nodiscard]] Polygons sectionOn(double unit, const Progress& progress) const {
    std::vector<CountedEdge> sides;
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      const std::span<const int> face = mesh_.face(f);
      if (!isAt(face, high_)) continue;
      for (std::size_t k = 0; k < 3; ++k) sides.push_back({seen(face[k], unit), seen(face[(k + 1) % 3], unit)});
    }
    std::erase_if(sides, [](const CountedEdge& side) { return side.from == side.to; });
    planar::joinEqual(sides, progress);
    return planar::scaled(planar::windingFaces(sides, progress), unit);
  }
  /// Whether a section on a grid of `thin_` steps has as much area and boundary: sums of sections would lose what it lost.
  [[nodiscard]] bool isAll(const Polygons& section, double area, double boundary) const {
    double covered = 0, around = 0, corners = 8;
    const auto add = [&](const Loop& loop) {
      covered += planar::signedArea(loop);
      for (std::size_t k = 0; k < loop.size(); ++k) around += (loop[(k + 1) % loop.size()] - loop[k]).norm();
      corners += static_cast<double>(loop.size());
    };
    for (const Polygon& polygon : section) {
      add(polygon.outer);
      for (const Loop& hole : polygon.holes) add(hole);
    }
    const double slack = slack_ * step_, ofHeight = 1e-12 + 4 * near_ * step_ / (high_ - low_);
    return std::abs(covered - area) <= slack * boundary &&
           std::abs(around - boundary) <= slack * corners + ofHeight * boundary;
  }
  [[nodiscard]] bool isAt(std::span<const int> face, double height) const {
    return std::all_of(face.begin(), face.end(),
                       [&](int vertex) { return std::abs(point(vertex)[axis_] - height) <= near_ * step_; });
  }
  static bool isWall(const std::array<GridPoint, 3>& at) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const GridPoint side = at[(k + 1) % 3] - at[k];
      longest = std::max(longest, std::hypot(static_cast<double>(side.x), static_cast<double>(side.y)));
    }
    return std::abs(static_cast<double>(cross(at[1] - at[0], at[2] - at[0]))) <= near_ * longest;
  }

  static constexpr double near_ = 2;   ///< steps: what rounding to the grid does to a plane
  static constexpr double thin_ = 16;  ///< steps: sections may lose what is thinner
  static constexpr double slack_ = 4 * thin_;

  const Mesh& mesh_;
  int axis_;
  double step_;
  double low_ = HUGE_VAL, high_ = -HUGE_VAL;
};

/// Puts triangles together over the corners of a section at both ends.
class PrismMesh {
 public:
  explicit PrismMesh(const Prism& prism) : prism_(prism) {}

  Mesh made(const Progress& progress) && {
    std::vector<Loop> loops;
    loops.reserve(prism_.section.size());
    for (const Polygon& polygon : prism_.section) {
      loops.push_back(polygon.outer);
      loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
    }
    for (const Loop& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) addWall(loop[k], loop[(k + 1) % loop.size()]);
    const AreaTriangles area = triangulateArea(loops, progress);
    for (const auto& [a, b, c] : area.triangles)
      addEnds(area.points[static_cast<std::size_t>(a)], area.points[static_cast<std::size_t>(b)],
              area.points[static_cast<std::size_t>(c)]);
    return std::move(mesh_);
  }

 private:
  struct Corner {
    int low = 0, high = 0;
  };

  Corner corner(const Vec2& p) {
    const auto [place, isNew] = corners_.try_emplace({p.x(), p.y()});
    if (isNew) place->second = {add(p, prism_.low), add(p, prism_.high)};
    return place->second;
  }
  int add(const Vec2& p, double height) {
    Vec3 point;
    point[prism_.axis] = height, point[(prism_.axis + 1) % 3] = p.x(), point[(prism_.axis + 2) % 3] = p.y();
    mesh_.points.push_back(point);
    return static_cast<int>(mesh_.points.size()) - 1;
  }
  /// With the section to the left.
  void addWall(const Vec2& from, const Vec2& to) {
    const Corner a = corner(from), b = corner(to);
    mesh_.addFace(std::array{a.low, b.low, b.high});
    mesh_.addFace(std::array{a.low, b.high, a.high});
  }
  void addEnds(const Vec2& a, const Vec2& b, const Vec2& c) {
    const std::array<Corner, 3> at{corner(a), corner(b), corner(c)};
    mesh_.addFace(std::array{at[0].high, at[1].high, at[2].high});
    mesh_.addFace(std::array{at[2].low, at[1].low, at[0].low});
  }

  const Prism& prism_;
  std::map<std::pair<double, double>, Corner> corners_;
  Mesh mesh_;
};

}  // namespace

std::vector<Prism> prismsOf(const Mesh& triangles, double step, const Progress& progress) {
  std::vector<Prism> prisms;
  for (int axis = 0; axis < 3; ++axis)
    if (auto prism = AlongAxis(triangles, axis, step).prism(progress)) prisms.push_back(*std::move(prism));
  return prisms;
}

Prism scaled(const Prism& prism, double factor) {
  return {prism.axis, planar::scaled(prism.section, factor), factor * prism.low, factor * prism.high};
}

Prism sum(const Prism& a, const Prism& b, const Progress& progress) {
  return {a.axis, planar::sum(a.section, b.section, progress), a.low + b.low, a.high + b.high};
}

std::optional<Prism> difference(const Prism& a, const Prism& b, const Progress& progress) {
  const double low = a.low - b.low, high = a.high - b.high;
  if (!(high > low)) return std::nullopt;
  planar::Effort unlimited;
  Polygons section = planar::difference(a.section, b.section, progress, unlimited);
  if (section.empty()) return std::nullopt;
  return Prism{a.axis, std::move(section), low, high};
}

Mesh trianglesOf(const Prism& prism, const Progress& progress) { return PrismMesh(prism).made(progress); }

}  // namespace blossom::morphology
