#include "geometry/planar/sums/set_operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/refusal.h"
#include "geometry/planar/sums/complement.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/set_sum.h"
#include "geometry/planar/sums/thin_room.h"

namespace blossom::planar {
namespace {

bool areAreas(std::span<const PlanarSet> sets) {
  return std::all_of(sets.begin(), sets.end(), [](const PlanarSet& set) { return set.isArea(); });
}

std::vector<Region> areasOf(std::span<const PlanarSet> sets) {
  std::vector<Region> areas;
  for (const PlanarSet& set : sets) areas.push_back(set.area);
  return areas;
}

SetSumResult asSets(RegionSumResult result) { return {{std::move(result.region)}, result.sums, std::move(result.warnings)}; }

std::string shapeName(std::size_t i) { return fmt::format("shape {}", i + 1); }

/// Where a sum of two curves begins.
Vec2 startOf(const SoundSet& set) {
  if (!set.curves.empty()) return startPoint(set.curves.front());
  return set.points.empty() ? Vec2(Vec2::Zero()) : set.points.front();
}

[[noreturn]] void refuseSumWithoutArea(const SoundSet& a, const SoundSet& b) {
  throw Error(ErrorCode::Degenerate,
              fmt::format("The curves run along one direction: from {} on their sum is a line, which has no area.",
                          at(startOf(a) + startOf(b))),
              "Turn one of them, or add a shape with an area.");
}

/// Those with a weight other than 0, areas first: what is added to an area has an area everywhere.
std::vector<SoundSet> weightedSets(std::span<const PlanarSet> sets, const RegionSumOptions& options, Effort& effort,
                                   const Progress& progress) {
  std::vector<SoundSet> result;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const double weight = weightOf(options, i);
    SoundSet set = soundSet(sets[i],
                            {.tolerance = options.tolerance,
                             .share = 1.0 / (static_cast<double>(sets.size()) * std::max(1.0, std::abs(weight))),
                             .effort = &effort},
                            shapeName(i), progress);
    if (weight != 0) result.push_back(weight == 1 ? std::move(set) : scaled(set, weight));
  }
  std::stable_partition(result.begin(), result.end(), [](const SoundSet& set) { return set.isArea(); });
  return result;
}

/// Adding what is empty leaves nothing.
std::optional<std::size_t> emptySummand(std::span<const PlanarSet> sets, const RegionSumOptions& options) {
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (sets[i].empty() && weightOf(options, i) != 0) return i;
  return std::nullopt;
}

/// Curves that nearly close are told, for they may have been meant as outlines.
std::vector<std::string> nearlyClosed(std::span<const PlanarSet> sets) {
  constexpr double nearly = 0.02;  // of the length
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const Path& curve : sets[i].curves) {
      const Vec2 end = endPoint(curve);
      const double gap = (startPoint(curve) - end).norm();
      if (gap > 0 && curve.segments.size() > 1 && gap <= nearly * length(curve))
        warnings.push_back(
            fmt::format("Shape {} is open at {}, by a gap of {:.3g} mm: it is taken as a curve, without the area inside.",
                        i + 1, at(end), gap));
    }
  return warnings;
}

bool drawsSplines(const PlanarSet& set) { return hasSplines(set.area) || hasSplines(Region{set.curves}); }

PlanarSet asPlanarSet(const SoundSet& set) { return {set.area.region, set.curves, set.points}; }

void checkFirst(const PlanarSet& first, SetSumResult& result) {
  if (first.area.loops.empty())
    throw Error(ErrorCode::InvalidInput,
                fmt::format("Shape 1 has no area: what is drawn at {} is open and has no room inside.",
                            at(first.curves.empty() ? first.points.front() : startPoint(first.curves.front()))),
                "Close its outline; open curves may be what has to fit inside.");
  if (!first.curves.empty() || !first.points.empty())
    result.warnings.emplace_back("The open curves and points of shape 1 have no room inside and are left out.");
}

}  // namespace

SetSumResult setSum(std::span<const PlanarSet> sets, const RegionSumOptions& options, const Progress& progress) {
  if (areAreas(sets)) return asSets(minkowskiSum(areasOf(sets), options, progress));
  checkSummands(sets.size(), options);
  if (const auto empty = emptySummand(sets, options))
    return {{}, 0, {fmt::format("Shape {} is empty, and so is the sum.", *empty + 1)}};
  Effort effort(options.maximumWork);
  const std::vector<SoundSet> summands = weightedSets(sets, options, effort, progress);
  SoundSet total = summands.front();
  const auto count = static_cast<double>(summands.size() - 1);
  for (std::size_t i = 1; i < summands.size(); ++i) {
    const auto before = static_cast<double>(i - 1);
    progress.report(before / count, "Adding shapes");
    effort.expect(summands.size() - i);
    const Progress part = progress.part(before / count, (before + 1) / count);
    SoundSet next = sum(total, summands[i], part, effort);
    const bool isLast = i + 1 == summands.size();
    if (isLast && next.empty()) refuseSumWithoutArea(total, summands[i]);
    if (!isLast && !total.isArea() && !summands[i].isArea() && !total.isPoints() && !summands[i].isPoints())
      addThinSum(total, summands[i], next, part, effort);
    total = std::move(next);
  }
  SetSumResult result{asPlanarSet(total), summands.size() - 1, nearlyClosed(sets)};
  bool splines = false;
  for (std::size_t i = 0; i < sets.size(); ++i) splines = splines || (weightOf(options, i) != 0 && drawsSplines(sets[i]));
  warnOfLines(splines, result.set.area, options.tolerance, result.warnings);
  return result;
}

namespace {

SetSumResult regularDifference(std::span<const PlanarSet> sets, const RegionSumOptions& options, const Progress& progress) {
  if (areAreas(sets)) return asSets(minkowskiDifference(areasOf(sets), options, progress));
  checkSummands(sets.size(), {});
  for (std::size_t i = 1; i < sets.size(); ++i)
    if (sets[i].empty())
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("Shape {} is empty: it fits everywhere, so the difference is the whole plane.", i + 1),
                  "Give a shape that has to fit inside.");
  if (sets.front().empty()) return {{}, 0, {"Shape 1 is empty, and so is the difference."}};
  SetSumResult result{{}, 0, nearlyClosed(sets)};
  checkFirst(sets.front(), result);
  Effort effort(options.maximumWork);
  const FlatteningOptions flattening{
      .tolerance = options.tolerance, .share = 1 / static_cast<double>(sets.size()), .effort = &effort};
  SoundRegion room = soundRegion(sets.front().area, flattening, shapeName(0), progress);
  if (!room.plain && !hasSplines(room.region))  // touching loops have made lines of curves, on either side
    room = {
        toRegion(polygonsBeside({sets.front().area, room.tolerance}, Approximation::Inside, shapeName(0), progress, effort)),
        room.tolerance, false};
  const auto count = static_cast<double>(sets.size() - 1);
  for (std::size_t i = 1; i < sets.size() && !room.region.loops.empty(); ++i) {
    const auto before = static_cast<double>(i - 1);
    const Progress part = progress.part(before / count, (before + 1) / count);
    effort.expect(sets.size() - i);
    room = difference(room, soundSet(sets[i], flattening, shapeName(i), part), part, effort);
    ++result.sums;
  }
  result.set.area = std::move(room.region);
  if (result.set.empty()) result.warnings.push_back(nothingLeft(std::nullopt));
  const bool splinesFit = std::any_of(sets.begin() + 1, sets.end(), drawsSplines);
  warnOfLines(splinesBoundRoom(sets.front().area, splinesFit), result.set.area, options.tolerance, result.warnings);
  return result;
}

/// Curves as lines within the tolerance.
SoundSet drawnByLines(const PlanarSet& set, const FlatteningOptions& flattening, const std::string& name,
                      const Progress& progress) {
  const SoundSet sound = soundSet(set, flattening, name, progress);
  SoundSet lines{{}, {}, sound.points, sound.tolerance};
  if (!set.area.loops.empty()) lines.area = {toRegion(flattened(set.area, flattening, name, progress)), sound.tolerance};
  for (const Path& curve : sound.curves) {
    Path& path = lines.curves.emplace_back();
    const std::vector<Vec2> points = flatten(curve, sound.tolerance);
    for (std::size_t i = 1; i < points.size(); ++i)
      if (points[i - 1] != points[i]) path.segments.emplace_back(Line2{points[i - 1], points[i]});
  }
  return lines;
}

/// By how much a shape is grown so that what fits exactly has some width: beyond all rounding, or beyond the polygons.
double slackFor(const SoundSet& a, const SoundSet& b, bool curved) {
  constexpr double beyondPolygons = 1.25;
  if (curved) return beyondPolygons * (a.tolerance + b.tolerance);
  const Box2 boxA = extentOf(a), boxB = extentOf(b);
  double reach = 0;
  for (const Box2& box : {boxA, boxB})
    reach = std::max({reach, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
  return std::ldexp((boxA.sizes() + boxB.sizes()).maxCoeff(), -36) + std::ldexp(reach, -44);
}

/// Corners of the wider room lie off those of the room by multiples of the slack, so twice the slack tells how far.
ThinRoom withoutSlack(ThinRoom once, const ThinRoom& twice, double slack) {
  std::vector<Vec2> places = twice.points;
  for (const Path& curve : twice.curves)
    for (const Segment& segment : curve.segments) places.insert(places.end(), {startPoint(segment), endPoint(segment)});
  const auto move = [&](Vec2& p) {
    constexpr double reach = 32;  // times the slack
    const auto nearer = [&](const Vec2& q, const Vec2& r) { return (q - p).squaredNorm() < (r - p).squaredNorm(); };
    const auto nearest = std::min_element(places.begin(), places.end(), nearer);
    if (nearest != places.end() && (*nearest - p).norm() <= reach * slack) p -= *nearest - p;
  };
  for (Vec2& point : once.points) move(point);
  for (Path& curve : once.curves)
    for (Segment& segment : curve.segments)
      if (auto* line = std::get_if<Line2>(&segment)) move(line->from), move(line->to);
  return once;
}

/// What `regular` leaves out because it has no width.
void addThinRoom(std::span<const PlanarSet> sets, const RegionSumOptions& options, SetSumResult& regular,
                 const Progress& progress) {
  Effort effort(options.maximumWork);
  const FlatteningOptions flattening{.tolerance = options.tolerance, .share = 0.5, .effort = &effort};
  const bool curved = std::any_of(sets.begin(), sets.end(),
                                  [](const PlanarSet& set) { return hasCurves(set.area) || hasCurves(Region{set.curves}); });
  const SoundSet a = drawnByLines({sets[0].area}, flattening, shapeName(0), progress),
                 b = drawnByLines(sets[1], flattening, shapeName(1), progress);
  const double slack = slackFor(a, b, curved);
  const auto found = [&](double by, const Progress& part) {
    const SoundRegion grown{toRegion(grownBy(toPolygons(a.area), by, part.part(0, 0.3), effort)), a.tolerance};
    return thinParts(toPolygons(difference(grown, b, part.part(0.3, 0.9), effort)), regular.set.area, {by, curved}, part);
  };
  ThinRoom thin = found(slack, progress.part(0, 0.5));
  if (thin.curves.empty() && thin.points.empty()) return;
  if (!curved) thin = withoutSlack(thin, found(2 * slack, progress.part(0.5, 1)), slack);
  if (regular.set.empty()) regular.warnings.clear();  // which said that nothing is left
  regular.set.curves = std::move(thin.curves);
  regular.set.points = std::move(thin.points);
  if (curved)
    regular.warnings.push_back(
        fmt::format("Room without width was looked for within {:.2g} mm, because the shapes have curves.", slack));
}

}  // namespace

SetSumResult setDifference(std::span<const PlanarSet> sets, const RegionSumOptions& options, const Progress& progress) {
  if (!options.keepDegenerate) return regularDifference(sets, options, progress);
  if (sets.size() > 2)
    throw Error(ErrorCode::InvalidParameter,
                "Room without width can be kept where one shape has to fit inside, not several.",
                "Add those shapes first: A - B - C is A - (B + C).");
  SetSumResult result = regularDifference(sets, options, progress.part(0, 0.5));
  if (!sets.front().empty()) addThinRoom(sets, options, result, progress.part(0.5, 1));
  return result;
}

namespace {

/// What the first of two steps took and warned of, unless the second one says the same.
void addFirst(const SetSumResult& first, SetSumResult& second) {
  second.sums += first.sums;
  std::vector<std::string> warnings = first.warnings;
  for (std::string& warning : second.warnings)
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(std::move(warning));
  second.warnings = std::move(warnings);
}

}  // namespace

namespace {

/// What is wrong with the room is wrong with no shape that was given.
SetSumResult sumWithRoom(const PlanarSet& room, const PlanarSet& b, const RegionSumOptions& options,
                         const Progress& progress) {
  try {
    return setSum(std::vector{room, b}, options, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput) throw;
    throw Error(ErrorCode::Degenerate, "Some places of shape 1 are hardly wider than the other shape, within rounding.",
                "Make shape 1 larger there, or the other shape smaller.");
  }
}

}  // namespace

SetSumResult setOpening(const PlanarSet& a, const PlanarSet& b, const RegionSumOptions& options, const Progress& progress) {
  SetSumResult room = setDifference(std::vector{a, b}, options, progress.part(0, 0.5));
  if (room.set.empty()) return room;
  SetSumResult result = sumWithRoom(room.set, b, options, progress.part(0.5, 1));
  addFirst(room, result);
  return result;
}

SetSumResult setClosing(const PlanarSet& a, const PlanarSet& b, const RegionSumOptions& options, const Progress& progress) {
  const SetSumResult grown = setSum(std::vector{a, b}, options, progress.part(0, 0.5));
  SetSumResult result = setDifference(std::vector{grown.set, b}, options, progress.part(0.5, 1));
  addFirst(grown, result);
  return result;
}

}  // namespace blossom::planar
