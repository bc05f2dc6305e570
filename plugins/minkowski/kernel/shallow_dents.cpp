#include "kernel/shallow_dents.h"

#include <algorithm>
#include <optional>

#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr std::size_t longestDent = 256;  // edges
constexpr std::size_t tries = 24;         // of lines that do not fit before a longer one is not looked for

/// A loop from its lowest corner on, which lies in no dent of an outer loop.
class DentFiller {
 public:
  DentFiller(const Loop& loop, double depth) : loop_(loop), depth_(depth) {
    std::rotate(loop_.begin(), std::min_element(loop_.begin(), loop_.end(), lower), loop_.end());
  }

  Loop filled() {
    Loop result;
    for (std::size_t i = 0; i < loop_.size(); i = nextAfter(i)) result.push_back(loop_[i]);
    return result;
  }
  [[nodiscard]] double deepest() const { return deepest_; }

 private:
  static bool lower(const Vec2& a, const Vec2& b) { return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x(); }
  [[nodiscard]] const Vec2& corner(std::size_t i) const { return loop_[i % loop_.size()]; }

  /// The end corner to which a line fills a dent that begins at corner i, or the next one.
  std::size_t nextAfter(std::size_t i) {
    std::size_t end = i + 1;
    std::size_t failed = 0;
    for (std::size_t k = i + 2; k <= loop_.size() && k <= i + longestDent && failed < tries; ++k) {
      const std::optional<double> depth = depthOfDent(i, k);
      if (depth) {
        end = k;
        deepest_ = std::max(deepest_, *depth);
      }
      failed = depth ? 0 : failed + 1;
    }
    return end;
  }

  /// By how much filling a dent changes the set: from all of it the boundary is as near as it is deep, and as half of what
  /// it takes up along the line. Nothing when the corners between are no dent, or it changes too much.
  [[nodiscard]] std::optional<double> depthOfDent(std::size_t first, std::size_t last) const {
    const Vec2 across = corner(last) - corner(first);
    const double length = across.norm();
    if (!(length > 0)) return std::nullopt;
    const Vec2 along = across / length;
    double depth = 0, left = 0, right = length;
    for (std::size_t k = first + 1; k < last; ++k) {
      const Vec2 at = corner(k) - corner(first);
      const double above = cross(along, at), beside = along.dot(at);
      left = std::min(left, beside);
      right = std::max(right, beside);
      depth = std::max(depth, above);
      if (above < 0 || std::min(depth, (right - left) / 2) > depth_) return std::nullopt;
    }
    return std::min(depth, (right - left) / 2);
  }

  Loop loop_;
  double depth_;
  double deepest_ = 0;
};

}  // namespace

FilledDents withoutShallowDents(const Polygons& polygons, double depth, const Progress& progress) {
  FilledDents result;
  const auto filled = [&](const Loop& loop) {
    progress.check();
    DentFiller filler(loop, depth);
    Loop simpler = filler.filled();
    result.depth = std::max(result.depth, filler.deepest());
    return simpler;
  };
  Polygons simpler;
  for (const Polygon& polygon : polygons) {
    Polygon& part = simpler.emplace_back(Polygon{filled(polygon.outer), {}});
    for (const Loop& hole : polygon.holes)
      if (Loop smaller = filled(hole); smaller.size() > 2) part.holes.push_back(std::move(smaller));
  }
  if (result.depth == 0) return {polygons, 0};
  // Another part of the boundary may lie in a dent: what is covered once or more belongs to the result.
  const Box2 box = boxOf(simpler);
  const Grid grid{box.center(), gridUnit(box.sizes())};
  result.shape = onPlane(windingFaces(edgesOf(snapped(simpler, grid)), progress), grid);
  return result;
}

}  // namespace blossom::minkowski
