#include "kernel/row_slabs.h"

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

std::vector<Slab> slabsOf(const std::vector<Rim>& rims) {
  std::vector<double> levels;
  double size = 0;
  for (const Rim& rim : rims) {
    levels.push_back(rim.low);
    levels.push_back(rim.high);
    size = std::max({size, std::abs(rim.low), std::abs(rim.high)});
  }
  std::sort(levels.begin(), levels.end());
  const double same = 1e-14 * (1 + size);  // ends of rims that follow one another differ by rounding
  std::vector<Slab> slabs;
  std::vector<std::pair<double, const Rim*>> crossed;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const double low = levels[i], high = levels[i + 1];
    if (high - low <= same) continue;
    const double middle = (low + high) / 2;
    crossed.clear();
    for (const Rim& rim : rims)
      if (rim.low < middle && middle < rim.high) crossed.emplace_back(rim.curve.at(middle), &rim);
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
