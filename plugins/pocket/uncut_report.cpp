#include "uncut_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kernel/check/tool_reach.h"

namespace blossom::pocket {

namespace {

double hatchLength(const Uncut& uncut) {
  double sum = 0;
  for (const UncutPlace& place : uncut.places)
    for (const auto& [from, to] : place.hatch) sum += (to - from).norm();
  return sum;
}

/// Dots along the rows of each place, its deepest point first; of those that lie together, one. Where the simulation found
/// nothing missed, none is: rows go on across gaps as narrow as the path is rounded.
void addDots(const Uncut& uncut, const ToolReach& reach, double radius, double floor, Toolpath& path) {
  const bool isAllReached = path.residue.value_or(0) == 0;
  constexpr double maximumDots = 4000;
  const double apart = std::max(radius / 4, hatchLength(uncut) / maximumDots);
  std::set<std::pair<long, long>> taken;
  const auto add = [&](const Vec2& at) {
    const MarkKind kind = reach.at(at);
    if (kind == MarkKind::Missed && isAllReached) return;
    if (taken.emplace(std::lround(at.x() / apart), std::lround(at.y() / apart)).second)
      path.marks.push_back({Vec3(at.x(), at.y(), floor), kind});
  };
  for (const UncutPlace& place : uncut.places) {
    add(place.at);
    for (const auto& [from, to] : place.hatch) {
      const int steps = std::max(2, static_cast<int>((to - from).norm() / apart));
      for (int i = 1; i < steps; ++i) add(from + (to - from) * i / steps);
    }
  }
}

/// What stays besides deep places, so that the warning and the figures add up; nothing when they are all.
std::string restOf(const Uncut& uncut, double area, std::size_t places, double leave) {
  const std::size_t others = uncut.places.size() - places;
  if (others == 0) return "";
  return fmt::format(" The other {:.2f} of {:.2f} mm² lie at {} place{}: {}.", uncut.area - area, uncut.area, others,
                     others == 1 ? "" : "s",
                     leave > 0 ? "in corners that it rounds, and on the walls as asked" : "in corners that it rounds");
}

/// How much stays where the tool does not get in, and that the rest lies in corners.
void warnOfPlaces(const Uncut& uncut, double radius, double leave, std::vector<std::string>& warnings) {
  // In a square corner the tool leaves its radius times sqrt 2 - 1 as seen from what it cuts, a little rounding added.
  const double corner = 0.42 * radius + 1.42 * leave;
  double area = 0;
  std::size_t places = 0;
  const UncutPlace* largest = nullptr;
  for (const UncutPlace& place : uncut.places) {
    if (place.depth <= corner) continue;
    area += place.area;
    ++places;
    if (!largest) largest = &place;
  }
  if (!largest) return;
  const Vec2& at = largest->at;
  const char* const why =
      leave > 0 ? "where the tool does not get in or is kept from the walls" : "where the tool does not get in";
  warnings.push_back((places == 1 ? fmt::format("{:.2f} mm² stay uncut near ({:.2f}, {:.2f}), {}; dots show where.", area,
                                                at.x(), at.y(), why)
                                  : fmt::format("{:.2f} mm² stay uncut at {} places {}, the largest ({:.2f} mm²) near "
                                                "({:.2f}, {:.2f}); dots show where.",
                                                area, places, why, largest->area, at.x(), at.y())) +
                     restOf(uncut, area, places, leave));
}

}  // namespace

void reportCoverage(const Coverage& coverage, Evaluated& out) {
  const auto add = [&](const char* name, double area) { out.figures.push_back({name, area, MeasureUnit::Area}); };
  add("part_mm2", coverage.part);
  add("cut_mm2", coverage.cut);
  add("unreachable_mm2", coverage.unreachable);
  if (coverage.left > 0) add("left_mm2", coverage.left);
}

void reportUncut(const Uncut& uncut, const Region& part, const CoverageOptions& options, double floor, Toolpath& path,
                 Evaluated& out, const Progress& progress) {
  out.figures.push_back({"uncut_mm2", uncut.area, MeasureUnit::Area});
  out.stats["uncut_within_mm2"] = uncut.within;
  out.stats["uncut_places"] = uncut.places.size();
  if (uncut.places.empty()) return;
  addDots(uncut, ToolReach(part, options, progress), options.radius, floor, path);
  warnOfPlaces(uncut, options.radius, options.leave, out.warnings);
}

}  // namespace blossom::pocket
