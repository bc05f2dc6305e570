#pragma once
#include <utility>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/stroke/inside_test.h"
#include "kernel/stroke/stroke_tree.h"

namespace blossom::pocket {

/// The boundary of a part as strokes, with what is inside.
class Walls {
 public:
  /// @param chord mm by which lines may leave free-form walls
  Walls(const Region& part, double chord);

  /// How far a tool of this radius cuts beyond the walls with its axis at p; negative within them.
  [[nodiscard]] double depth(const Vec2& p, double radius) const;

  /// How far a tool of this radius cuts beyond the walls on its way, at most and within 1e-5 mm, and the share of the way.
  /// In closed form where the axis stays inside; where it leaves the part by best-first search among intervals. Ways of
  /// which that takes too long are told an upper bound.
  /// @throws Error Cancelled.
  [[nodiscard]] std::pair<double, double> gouge(const Stroke& way, double radius, const Progress&) const;

 private:
  struct Interval;
  [[nodiscard]] Interval looked(const Stroke& way, double from, double to, double radius) const;
  [[nodiscard]] double farthest(const Stroke& piece) const;

  StrokeTree tree_;
  InsideTest inside_;
};

}  // namespace blossom::pocket
