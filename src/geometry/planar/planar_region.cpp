#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "core/error.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/boundary_tree.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/single_point.h"

namespace blossom {
namespace {

/// A loop with all that nesting asks for.
struct Loop {
  const Path* path;
  Box2 box;
  double area;  ///< signed
  Vec2 inside;
};

Loop prepared(const Path& path) {
  Loop loop{&path, {}, signedArea(path), interiorPoint(path)};
  for (const Segment& segment : path.segments) loop.box.extend(boxAround(segment));
  return loop;
}

/// Winding numbers of one loop for many points.
class ManyWindings {
 public:
  explicit ManyWindings(const Path& path) : path_(path) {}
  [[nodiscard]] int at(const Vec2& p) {
    constexpr std::size_t few = 64, once = 4;
    if (path_.segments.size() <= few || ++asked_ <= once) return windingNumber(path_, p);
    if (!tree_) tree_.emplace(Region{{path_}});
    return tree_->windingNumber(p);
  }

 private:
  const Path& path_;
  std::size_t asked_ = 0;
  std::optional<BoundaryTree> tree_;
};

/// For every loop, the loops around it, with falling size. Loops do not cross, so one point inside the smaller one decides.
/// O(n log n + k log m) for k pairs whose boxes meet, of loops of m segments that are well spread.
std::vector<std::vector<std::size_t>> containers(const std::vector<Loop>& loops) {
  std::vector<std::size_t> bySize(loops.size()), rank(loops.size());
  std::iota(bySize.begin(), bySize.end(), 0);
  std::stable_sort(bySize.begin(), bySize.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(loops[a].area) > std::abs(loops[b].area); });
  for (std::size_t i = 0; i < bySize.size(); ++i) rank[bySize[i]] = i;
  std::vector<Box2> boxes;
  std::vector<ManyWindings> windings;
  for (const std::size_t i : bySize) {
    boxes.push_back(loops[i].box);
    windings.emplace_back(*loops[i].path);
  }
  const BoxTree<2> tree(boxes);
  std::vector<std::vector<std::size_t>> result(loops.size());
  for (std::size_t inner = 0; inner < loops.size(); ++inner) {
    const Vec2& inside = loops[inner].inside;
    std::vector<std::size_t> around;  // ranks
    tree.meeting(Box2(inside, inside), [&](std::size_t outer) {
      if (outer < rank[inner] && boxes[outer].contains(inside) && windings[outer].at(inside) != 0) around.push_back(outer);
    });
    std::sort(around.begin(), around.end());
    for (const std::size_t outer : around) result[inner].push_back(bySize[outer]);
  }
  return result;
}

int turn(const Loop& loop) { return loop.area > 0 ? 1 : -1; }

struct Sides {
  bool outside, inside;
};

Sides filled(const Loop& loop, const std::vector<std::size_t>& around, const std::vector<Loop>& loops, FillRule rule) {
  if (rule == FillRule::EvenOdd) return {around.size() % 2 == 1, around.size() % 2 == 0};
  int winding = 0;
  for (const std::size_t container : around) winding += turn(loops[container]);
  return {winding != 0, winding + turn(loop) != 0};
}

[[noreturn]] void open(const Path& path, const Tolerance& tolerance) {
  const Vec2 from = startPoint(path);
  const Vec2 to = endPoint(path);
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("The outline is open: a path starts at ({:.6g}, {:.6g}) and ends at ({:.6g}, {:.6g}), {:.3g} mm apart.",
                  from.x(), from.y(), to.x(), to.y(), (to - from).norm()),
      fmt::format("Close the gap in the drawing; ends up to {} mm apart are joined.", tolerance.joining));
}

bool isSpeck(const Path& path, double tolerance) {
  return path.segments.empty() || (path.segments.size() < 3 && length(path) <= tolerance);
}

/// Whether a path without area turns around something all the same, like an 8 whose halves cancel out.
bool turnsBothWays(const Path& path) {
  try {
    (void)interiorPoint(path);
    return true;
  } catch (const Error&) {
    return false;
  }
}

[[noreturn]] void crossing(const Path& path) {
  const Vec2 start = startPoint(path);
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("The outline that begins at ({:.6g}, {:.6g}) crosses itself: its parts cancel out.", start.x(), start.y()),
      "Redraw it, or trim what crosses.");
}

/// Closed paths that enclose something; what encloses nothing (a line there and back) bounds no area.
std::vector<Path> closedPaths(const Curves& curves, const Tolerance& tolerance) {
  std::vector<Path> paths;
  for (Path& path : joined(curves, tolerance).paths) {
    if (isSpeck(path, tolerance.joining)) continue;
    if (!path.closed) open(path, tolerance);
    const double perimeter = length(path);
    if (std::abs(signedArea(path)) > perimeter * tolerance.confusion)
      paths.push_back(std::move(path));
    else if (turnsBothWays(path))
      crossing(path);
  }
  return paths;
}

}  // namespace

Region toRegion(const Curves& curves, const Tolerance& tolerance) {
  const std::vector<Path> paths = closedPaths(curves, tolerance);
  std::vector<Loop> loops;
  loops.reserve(paths.size());
  for (const Path& path : paths) loops.push_back(prepared(path));
  const auto around = containers(loops);

  Region region;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Sides side = filled(loops[i], around[i], loops, curves.fillRule);
    if (side.inside == side.outside) continue;
    const bool counterClockwise = loops[i].area > 0;
    region.loops.push_back(counterClockwise == side.inside ? paths[i] : reversed(paths[i]));
  }
  if (const auto point = singlePoint(curves.paths))
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The drawing is the point ({:.6g}, {:.6g}) and encloses no area.", point->x(), point->y()),
                "Draw at least one closed outline. Morphs and Minkowski sums take points.");
  if (region.loops.empty())
    throw Error(ErrorCode::InvalidInput, "The curves enclose no area.",
                "Draw at least one closed outline that does not cross itself.");
  return region;
}

std::vector<RegionComponent> components(const Region& region) {
  std::vector<Loop> loops;
  loops.reserve(region.loops.size());
  for (const Path& path : region.loops) loops.push_back(prepared(path));
  const auto around = containers(loops);
  std::vector<RegionComponent> result;
  std::vector<std::size_t> componentOf(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].area <= 0) continue;
    componentOf[i] = result.size();
    result.push_back({i, {}});
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].area > 0) continue;
    std::optional<std::size_t> nearest;  // containers come with falling size
    for (const std::size_t container : around[i])
      if (loops[container].area > 0) nearest = container;
    if (!nearest)
      throw Error(
          ErrorCode::InvalidInput,
          fmt::format("The hole at ({:.6g}, {:.6g}) is not inside an outer loop.", loops[i].inside.x(), loops[i].inside.y()),
          "Draw an outline around it; an outline that crosses itself may look like this, too.");
    result[componentOf[*nearest]].holes.push_back(i);
  }
  return result;
}

}  // namespace blossom
