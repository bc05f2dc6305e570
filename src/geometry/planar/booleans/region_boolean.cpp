#include "geometry/planar/booleans/region_boolean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/planar/booleans/boolean_check.h"
#include "geometry/planar/booleans/cut_boundaries.h"
#include "geometry/planar/booleans/point_welder.h"
#include "geometry/planar/fitting/curve_fitting.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom {

using namespace planar;

namespace {

/// Between two cuts of a circle, found by halving from the lower point on, so that arcs in common have the same points.
void addBetween(const Circle& circle, const Vec2& from, const Vec2& to, double sweep, double widest,
                std::vector<Vec2>& out) {
  if (std::abs(sweep) <= widest) return;
  const Vec2 out1 = from - circle.centre, out2 = to - circle.centre;
  const double half = sweep / 2;
  const Vec2 along = std::abs(sweep) < std::numbers::pi / 2
                         ? Vec2(out1 + out2)
                         : Vec2(std::cos(half) * out1 + std::sin(half) * Vec2(-out1.y(), out1.x()));
  const Vec2 middle = circle.centre + circle.radius * along.normalized();
  addBetween(circle, from, middle, half, widest, out);
  out.push_back(middle);
  addBetween(circle, middle, to, half, widest, out);
}

/// The corners of a chain of chords from one cut to the next, without the last one.
void addChords(const CutSegment& cut, std::size_t k, double widest, std::vector<Vec2>& out) {
  const Vec2 &from = cut.cuts[k], &to = cut.cuts[k + 1];
  out.push_back(from);
  const auto* circle = std::get_if<Circle>(&cut.curve);
  if (!circle) return;
  const double sweep = cut.sweepOf(k);
  const double step = std::min(widest, std::abs(sweep) * 0.51);  // a corner at least, off the chord between the cuts
  std::vector<Vec2> between;
  if (fartherLeft(from, to)) {
    addBetween(*circle, from, to, sweep, step, between);
  } else {
    addBetween(*circle, to, from, -sweep, step, between);
    std::reverse(between.begin(), between.end());
  }
  out.insert(out.end(), between.begin(), between.end());
}

/// How the winding numbers of both regions count.
struct Counting {
  int second = 1;    ///< times that of the second region
  WindingRule rule;  ///< of the sum
};

Counting countingOf(BooleanOperation operation) {
  constexpr int lowest = std::numeric_limits<int>::min();
  switch (operation) {
    case BooleanOperation::Union:
      return {1, {lowest, 0}};
    case BooleanOperation::Intersection:
      return {1, {lowest, 1}};
    case BooleanOperation::Difference:
      break;
  }
  return {-1, {lowest, 0}};
}

class Combination {
 public:
  Combination(const CutBoundaries& cut, double within, const Grid& grid) : cut_(cut), within_(within), grid_(grid) {}

  /// Nothing when the chords are too coarse.
  std::optional<Region> run(const Counting& counting, double widest, const Progress& progress) {
    edges_.clear();
    curves_ = {StraightCurve{}};
    longest_ = deepest_ = 0;
    for (const CutSegment& each : cut_.first) addEdges(each, 1, widest);
    const auto ofFirst = static_cast<std::ptrdiff_t>(edges_.size());
    for (const CutSegment& each : cut_.second) addEdges(each, counting.second, widest);
    if (!isSound({edges_.begin(), edges_.begin() + ofFirst}, progress)) return std::nullopt;
    if (!isSound({edges_.begin() + ofFirst, edges_.end()}, progress)) return std::nullopt;
    joinEqual(edges_, progress);
    Effort unlimited;
    const auto faces = tracedFaces(edges_, progress, counting.rule, unlimited);
    const auto curveOf = [&](std::uint32_t edge) { return std::optional(curves_[edges_[edge].source]); };
    const CurveFitting fitting{
        .rounding = within_, .reach = std::max(4 * longest_, 8 * within_), .gap = 4 * (deepest_ + within_)};
    auto region = fittedCurves(faces, grid_, curveOf, fitting, progress);
    if (!region || !hasAllCorners(*region)) return std::nullopt;
    beginWhereInputsBegin(*region);
    return region;
  }

 private:
  void addEdges(const CutSegment& each, int count, double widest) {
    const auto source = static_cast<std::uint32_t>(curves_.size());
    curves_.push_back(each.curve);
    std::vector<Vec2> corners;
    for (std::size_t k = 0; k < each.pieces(); ++k) addChords(each, k, widest, corners);
    corners.push_back(each.cuts.back());
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const CountedEdge edge{grid_.nearest(corners[i - 1]), grid_.nearest(corners[i]), count, 1, source};
      if (edge.from != edge.to) edges_.push_back(edge);
      if (const auto* circle = std::get_if<Circle>(&each.curve)) {
        const double chord = (corners[i] - corners[i - 1]).norm();
        longest_ = std::max(longest_, chord);
        deepest_ = std::max(deepest_, chord * chord / (8 * circle->radius));
      }
    }
  }

  /// Whether the boundary of one region has it to its left, once.
  [[nodiscard]] bool isSound(std::vector<CountedEdge> edges, const Progress& progress) const {
    for (CountedEdge& edge : edges) edge.count = 1;
    joinEqual(edges, progress);
    return edges.empty() || !misplacedFace(edges, within_ / grid_.unit, progress);
  }

  [[nodiscard]] bool hasAllCorners(const Region& region) const {
    PointWelder corners(8 * within_);
    for (const Path& loop : region.loops)
      for (const Segment& segment : loop.segments) corners.welded(startPoint(segment));
    return std::all_of(cut_.crossings.begin(), cut_.crossings.end(),
                       [&](const Vec2& p) { return corners.numberOf(p).has_value(); });
  }

  /// Every loop begins at the earliest corner of the inputs that it has, so that the order of segments depends on nothing
  /// else.
  void beginWhereInputsBegin(Region& region) const {
    PointWelder corners(8 * within_);
    for (const std::vector<CutSegment>* side : {&cut_.first, &cut_.second})
      for (const CutSegment& each : *side) corners.welded(each.cuts.front());
    for (Path& loop : region.loops) {
      std::vector<std::size_t> numbers;
      for (const Segment& segment : loop.segments)
        numbers.push_back(corners.numberOf(startPoint(segment)).value_or(std::numeric_limits<std::size_t>::max()));
      const auto first = std::min_element(numbers.begin(), numbers.end()) - numbers.begin();
      std::rotate(loop.segments.begin(), loop.segments.begin() + first, loop.segments.end());
    }
  }

  const CutBoundaries& cut_;
  double within_;
  Grid grid_;
  std::vector<CountedEdge> edges_;
  std::vector<TrueCurve> curves_;
  double longest_ = 0, deepest_ = 0;  ///< chord, and how far one is from its arc
};

/// Of regions that are apart.
Region combinedApart(const Region& a, const Region& b, BooleanOperation operation) {
  if (operation == BooleanOperation::Intersection) return {};
  Region all = a;
  if (operation == BooleanOperation::Union) all.loops.insert(all.loops.end(), b.loops.begin(), b.loops.end());
  return all;
}

/// Around the segments themselves, and how large their arcs are.
struct Reach {
  Box2 box;
  double radius = 0;

  explicit Reach(const Region& region) {
    for (const Path& loop : region.loops)
      for (const Segment& segment : loop.segments) {
        box.extend(boxAround(segment));
        if (const auto* arc = std::get_if<Arc2>(&segment)) radius = std::max(radius, arc->radius);
      }
  }
};

std::optional<Region> combinedTwo(const Region& a, const Region& b, BooleanOperation operation, const Progress& progress) {
  progress.check();
  const Reach reachA(a), reachB(b);
  const Box2 box = reachA.box.merged(reachB.box);
  const double size = box.sizes().maxCoeff(), radius = std::max(reachA.radius, reachB.radius);
  constexpr double flattest = 1000;  // times the size: flatter arcs meet where rounding says
  if (!std::isfinite(size) || radius > flattest * size) return std::nullopt;
  const Grid grid{box.center(), gridUnit(1.5 * box.sizes())};  // chords may pass beside the box
  const double farthest = std::max({box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff(), radius});
  const double rounding = std::numeric_limits<double>::epsilon() * farthest;
  const double within = std::ldexp(size, -34) + 32 * rounding;
  if (!comeNear(reachA.box, reachB.box, 4 * within)) return combinedApart(a, b, operation);
  const auto cut = cutBoundaries(a, b, within, progress.part(0, 0.3));
  if (!cut) return std::nullopt;
  Combination combination(*cut, within, grid);
  constexpr std::array widest{0.26, 0.065, 0.016};  // radians
  constexpr double gap = 1e-9;                      // mm
  for (const double each : widest) {
    auto region = combination.run(countingOf(operation), each, progress);
    if (region && isWellJoined(*region, std::max(gap, 64 * rounding), within) &&
        boundsAsItShould(*region, {a, b, *cut}, operation, within, progress))
      return region;
  }
  return std::nullopt;
}

/// Of many, halves first, so that each is met by few others.
std::optional<Region> united(std::span<const Region> regions, const Progress& progress) {
  if (regions.empty()) return Region{};
  if (regions.size() == 1) return regions.front();
  const std::size_t half = regions.size() / 2;
  const auto a = united(regions.first(half), progress.part(0, 0.3)),
             b = a ? united(regions.subspan(half), progress.part(0.3, 0.6)) : std::nullopt;
  if (!b) return std::nullopt;
  return combinedTwo(*a, *b, BooleanOperation::Union, progress.part(0.6, 1));
}

std::optional<Region> inCommon(std::span<const Region> regions, const Progress& progress) {
  std::optional<Region> common = regions.front();
  for (const Region& each : regions.subspan(1)) {
    common = combinedTwo(*common, each, BooleanOperation::Intersection, progress);
    if (!common || common->loops.empty()) break;
  }
  return common;
}

}  // namespace

std::optional<Region> combined(std::span<const Region> regions, BooleanOperation operation, const Progress& progress) {
  for (const Region& region : regions)
    if (region.loops.empty() || hasSplines(region)) return std::nullopt;
  if (regions.empty()) return std::nullopt;
  switch (operation) {
    case BooleanOperation::Union:
      return united(regions, progress);
    case BooleanOperation::Intersection:
      return inCommon(regions, progress);
    case BooleanOperation::Difference:
      break;
  }
  if (regions.size() == 1) return regions.front();
  const auto others = united(regions.subspan(1), progress.part(0, 0.6));
  return others ? combinedTwo(regions.front(), *others, BooleanOperation::Difference, progress.part(0.6, 1)) : std::nullopt;
}

}  // namespace blossom
