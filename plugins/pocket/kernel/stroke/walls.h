#pragma once
#include <utility>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/stroke/inside_test.h"
#include "kernel/stroke/stroke_tree.h"

namespace blossom::pocket {

/// The boundary of a part as strokes, with an inside test.
class Walls {
 public:
  /// @param chord mm, maximum distance of lines from free-form walls
  Walls(const Region& part, double chord);

  /// Depth of the cut beyond the walls of a tool of this radius with its axis at p; negative inside.
  [[nodiscard]] double depth(const Vec2& p, double radius) const;

  /// Maximum depth of the cut beyond the walls of a tool of this radius along a path, within 1e-5 mm, and the fraction of
  /// the path. In closed form where the axis stays inside; by best-first search among intervals where it leaves the part.
  /// When the search takes too long, the result is an upper bound.
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
