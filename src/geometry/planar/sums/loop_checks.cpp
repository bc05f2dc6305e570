#include "geometry/planar/sums/loop_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/refusal.h"

namespace blossom::planar {

/// A loop drawn twice, once either way round, would cancel out.
void refuseTwice(const Vec2& place, const std::string& name) {
  refuse(ErrorCode::InvalidInput, name, fmt::format("has a loop at {} that is drawn twice.", at(place)),
         "Remove one of the two.");
}

void refuseTwice(const std::vector<Loop>& loops, const std::string& name) {
  std::set<std::vector<std::pair<double, double>>> seen;
  for (const Loop& loop : loops) {
    std::vector<std::pair<double, double>> corners;
    for (const Vec2& p : loop) corners.emplace_back(p.x(), p.y());
    std::sort(corners.begin(), corners.end());
    if (!seen.insert(std::move(corners)).second) refuseTwice(loop.front(), name);
  }
}

void refuseStrayHole(const Nesting& nesting, const std::vector<Loop>& loops, const std::string& name) {
  if (const auto hole = nesting.strayHole())
    refuse(ErrorCode::InvalidInput, name, fmt::format("has a hole at {} that is in no outline.", at(loops[*hole].front())),
           "Draw an outline around it, or remove it.");
}

void refuseEmptyLoops(const std::vector<Loop>& loops, double confusion, const std::string& name) {
  for (const Loop& loop : loops) {
    if (std::abs(signedArea(loop)) <= perimeter(loop) * confusion)
      refuse(ErrorCode::InvalidInput, name, fmt::format("has a loop at {} that encloses nothing.", at(loop.front())),
             "Remove it, or lower the tolerance if it is small.");
  }
}

/// On the grid of a shape that is so large, a loop may have no width: what is added to it would be missed in silence.
void refuseCollapsed(const Nesting& nesting, const std::vector<Loop>& loops, double size, const std::string& name) {
  if (nesting.clear()) return;
  constexpr double told = 64;  // units of the grid
  for (const Loop& loop : loops)
    if (const double width = 2 * signedArea(loop) / perimeter(loop); width > 0 && width < told * nesting.grid().unit)
      refuse(ErrorCode::LimitExceeded, name,
             fmt::format("is {:.3g} mm large, and its loop at {} only {:.2g} mm wide: that cannot be told from a line.",
                         size, at(loop.front()), width),
             "Make it wider, or take the shape apart.");
}

}  // namespace blossom::planar
