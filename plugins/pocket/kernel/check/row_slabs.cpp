#include "kernel/check/row_slabs.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace blossom::pocket {

namespace {

constexpr double quarterTurn = fullTurn / 4;

void addArcRims(const Vec2& center, double radius, double start, double sweep, std::vector<Rim>& rims) {
  const double first = std::min(start, start + sweep), last = std::max(start, start + sweep);
  double from = first;
  for (double quarter = std::floor(first / quarterTurn) + 1; from < last; ++quarter) {
    const double to = std::min(last, quarter * quarterTurn);
    const double a = center.y() + radius * std::sin(from), b = center.y() + radius * std::sin(to);
    const double side = std::cos((from + to) / 2) < 0 ? -1 : 1;
    rims.push_back({std::min(a, b), std::max(a, b), {center, 0, radius, side}});
    from = to;
  }
}

void addLineRim(const Vec2& a, const Vec2& b, std::vector<Rim>& rims) {
  if (a.y() == b.y()) return;
  rims.push_back({std::min(a.y(), b.y()), std::max(a.y(), b.y()), {a, (b.x() - a.x()) / (b.y() - a.y()), 0, 1}});
}

Vec2 directionOf(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Ends of rims that follow one another differ by rounding, up to this.
double sameHeight(const std::vector<Rim>& rims) {
  double size = 0;
  for (const Rim& rim : rims) size = std::max({size, std::abs(rim.low), std::abs(rim.high)});
  return 1e-14 * (1 + size);
}

/// An upright rim wherever an odd number of intervals of y, given by their ends, lie on one another.
void addWalls(double x, std::vector<double>& ends, double same, std::vector<Rim>& rims) {
  std::sort(ends.begin(), ends.end());
  const std::size_t first = rims.size();
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    if (ends[i + 1] - ends[i] <= same) continue;
    if (rims.size() > first && ends[i] - rims.back().high <= same)
      rims.back().high = ends[i + 1];
    else
      rims.push_back({ends[i], ends[i + 1], {{x, ends[i]}, 0, 0, 1}});
  }
}

}  // namespace

double RowCurve::at(double y) const {
  if (radius == 0) return through.x() + slope * (y - through.y());
  const double up = y - through.y();
  return through.x() + side * std::sqrt(std::max(0.0, (radius - up) * (radius + up)));
}

double RowCurve::bulge(double a, double b, double xa, double xb) const {
  if (radius == 0 || !(b > a)) return 0;
  // The height of the circle's segment over its chord, seen along the row.
  const double chord = std::min(std::hypot(b - a, xb - xa), 2 * radius);
  const double height = chord * chord / 4 / (radius + std::sqrt(std::max(0.0, radius * radius - chord * chord / 4)));
  return std::min(height * chord / (b - a), std::abs(xb - xa));
}

void addRims(const Stroke& stroke, std::vector<Rim>& rims) {
  if (stroke.round)
    addArcRims(stroke.center, stroke.radius, stroke.start, stroke.sweep, rims);
  else
    addLineRim(stroke.from, stroke.to, rims);
}

double Rim::heightAt(double x) const {
  double y = curve.through.y();
  const double aside = x - curve.through.x();
  if (curve.radius == 0)
    y += curve.slope == 0 ? 0 : aside / curve.slope;
  else  // within a quarter of the circle, so all of it lies above or all of it below the centre
    y += (low + high < 2 * y ? -1 : 1) * std::sqrt(std::max(0.0, (curve.radius - aside) * (curve.radius + aside)));
  return std::clamp(y, low, high);
}

SplitRims splitAtHeight(const std::vector<Rim>& rims, double y) {
  SplitRims split;
  for (const Rim& rim : rims) {
    if (rim.low < y) split.before.push_back({rim.low, std::min(rim.high, y), rim.curve});
    if (rim.high > y) split.after.push_back({std::max(rim.low, y), rim.high, rim.curve});
  }
  return split;
}

SplitRims splitAtLine(const std::vector<Rim>& rims, double x) {
  SplitRims split;
  // What lies beyond the line is pushed onto it: every row still crosses an even number of rims.
  std::vector<double> pushedBack, pushedOn;
  const auto addBefore = [&](const Rim& rim) {
    split.before.push_back(rim);
    pushedOn.insert(pushedOn.end(), {rim.low, rim.high});
  };
  const auto addAfter = [&](const Rim& rim) {
    split.after.push_back(rim);
    pushedBack.insert(pushedBack.end(), {rim.low, rim.high});
  };
  for (const Rim& rim : rims) {
    const double a = rim.curve.at(rim.low), b = rim.curve.at(rim.high);
    if (std::max(a, b) <= x) {
      addBefore(rim);
    } else if (std::min(a, b) >= x) {
      addAfter(rim);
    } else {
      const double y = rim.heightAt(x);
      const Rim lower{rim.low, y, rim.curve}, upper{y, rim.high, rim.curve};
      addBefore(a < x ? lower : upper);
      addAfter(a < x ? upper : lower);
    }
  }
  const double same = sameHeight(rims);
  addWalls(x, pushedBack, same, split.before);
  addWalls(x, pushedOn, same, split.after);
  return split;
}

std::vector<Slab> slabsOf(const std::vector<Rim>& rims) {
  std::vector<double> levels;
  std::vector<const Rim*> waiting, active;
  for (const Rim& rim : rims) {
    levels.push_back(rim.low);
    levels.push_back(rim.high);
    waiting.push_back(&rim);
  }
  std::sort(levels.begin(), levels.end());
  std::sort(waiting.begin(), waiting.end(), [](const Rim* a, const Rim* b) { return a->low > b->low; });
  const double same = sameHeight(rims);
  std::vector<Slab> slabs;
  std::vector<std::pair<double, const Rim*>> crossed;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const double low = levels[i], high = levels[i + 1];
    if (high - low <= same) continue;
    const double middle = (low + high) / 2;
    for (; !waiting.empty() && waiting.back()->low < middle; waiting.pop_back()) active.push_back(waiting.back());
    std::erase_if(active, [&](const Rim* rim) { return rim->high <= middle; });
    crossed.clear();
    for (const Rim* rim : active) crossed.emplace_back(rim->curve.at(middle), rim);
    std::sort(crossed.begin(), crossed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k + 1 < crossed.size(); k += 2)
      slabs.push_back({low, high, crossed[k].second->curve, crossed[k + 1].second->curve});
  }
  return slabs;
}

std::vector<Slab> sweptSlabs(const Stroke& way, double radius) {
  std::vector<Rim> rims;
  if (!way.round) {
    const Vec2 along = way.to - way.from;
    if (along.squaredNorm() == 0) return {};
    const Vec2 aside = radius * Vec2(-along.y(), along.x()).normalized();
    const Vec2 corners[4] = {way.from + aside, way.from - aside, way.to - aside, way.to + aside};
    for (int i = 0; i < 4; ++i) addLineRim(corners[i], corners[(i + 1) % 4], rims);
    return slabsOf(rims);
  }
  const double outer = way.radius + radius, inner = std::max(0.0, way.radius - radius);
  const bool whole = std::abs(way.sweep) >= fullTurn * (1 - 1e-12);
  const double sweep = whole ? fullTurn : way.sweep;
  addArcRims(way.center, outer, way.start, sweep, rims);
  if (inner > 0) addArcRims(way.center, inner, way.start, sweep, rims);
  if (!whole)
    for (const double angle : {way.start, way.start + way.sweep})
      addLineRim(way.center + inner * directionOf(angle), way.center + outer * directionOf(angle), rims);
  return slabsOf(rims);
}

std::vector<Slab> discSlabs(const Vec2& center, double radius) {
  std::vector<Rim> rims;
  addArcRims(center, radius, 0, fullTurn, rims);
  return slabsOf(rims);
}

}  // namespace blossom::pocket
