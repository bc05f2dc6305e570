#include "uncut_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blossom::pocket {

namespace {

double hatchLength(const Uncut& uncut) {
  double sum = 0;
  for (const UncutPlace& place : uncut.places)
    for (const auto& [from, to] : place.hatch) sum += (to - from).norm();
  return sum;
}

/// Dots along the rows of each place, its deepest point first.
void addDots(const Uncut& uncut, double radius, double floor, std::vector<Vec3>& marks) {
  constexpr double maximumDots = 4000;
  const double apart = std::max(radius / 4, hatchLength(uncut) / maximumDots);
  for (const UncutPlace& place : uncut.places) {
    marks.emplace_back(place.at.x(), place.at.y(), floor);
    for (const auto& [from, to] : place.hatch) {
      const int steps = static_cast<int>((to - from).norm() / apart);
      for (int i = 1; i < steps; ++i) {
        const Vec2 at = from + (to - from) * i / steps;
        marks.emplace_back(at.x(), at.y(), floor);
      }
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
  warnings.push_back(
      (places == 1
           ? fmt::format("{:.2f} mm² stay uncut near ({:.2f}, {:.2f}), where the tool does not get in; dots show where.",
                         area, at.x(), at.y())
           : fmt::format("{:.2f} mm² stay uncut at {} places where the tool does not get in, the largest ({:.2f} mm²) near "
                         "({:.2f}, {:.2f}); dots show where.",
                         area, places, largest->area, at.x(), at.y())) +
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

void reportUncut(const Uncut& uncut, double leave, double floor, Toolpath& path, Evaluated& out) {
  const double radius = path.cutter.diameter / 2;
  out.figures.push_back({"uncut_mm2", uncut.area, MeasureUnit::Area});
  out.stats["uncut_within_mm2"] = uncut.within;
  out.stats["uncut_places"] = uncut.places.size();
  addDots(uncut, radius, floor, path.marks);
  warnOfPlaces(uncut, radius, leave, out.warnings);
}

}  // namespace blossom::pocket
