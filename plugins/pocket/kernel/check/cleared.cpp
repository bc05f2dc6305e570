#include "kernel/check/cleared.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/check/simulate.h"

namespace blossom::pocket {

namespace {

struct PlanSquare {
  Vec2 middle;
  double half;
};

constexpr double maximumMargin = 0.03;  // mm

/// Heights above the tip that represent the shape of a cutter.
std::vector<double> heightsOf(const Cutter& cutter) {
  const double whole = cutter.vAngle > 0 ? cutter.diameter / 2 / std::tan(cutter.vAngle / 2) : cutter.cornerRadius;
  if (!(whole > 0)) return {0};
  std::vector<double> heights;
  for (const double share : {0.01, 0.1, 0.3, 0.6, 1.0}) heights.push_back(share * whole);
  return heights;
}

}  // namespace

Cleared::Cleared(const Cutter& cutter, double top, const Bounds& stock)
    : cutter_(cutter),
      margin_(std::min(maximumMargin, cutter.diameter / 20)),
      top_(top),
      stock_(stock),
      heights_(heightsOf(cutter)) {}

void Cleared::cut(const Vec3& from, const ToolMove& move) {
  const auto part = below(from, move, top_);
  if (!part) return;
  const auto [low, high] = part->way.box();
  cuts_.push_back({*part, low, high, std::min(part->from.z(), part->to.z())});
}

bool Cleared::isHit(const Vec3& from, const ToolMove& move, const Progress& progress) const {
  const auto part = below(from, move, top_);
  if (!part) return false;
  const bool vertical = (part->to - part->from).head<2>().norm() < 1e-6;
  if (vertical && part->to.z() >= part->from.z()) return false;  // the way out is the way in
  return isHit(*part, progress);
}

/// Tests a whole move at the depth of its deepest point; when that hits, its halves, down to steps smaller than the margin.
bool Cleared::isHit(const MoveBelow& move, const Progress& progress) const {
  const double level = margin_ / 2;
  std::vector<MoveBelow> open{move};
  while (!open.empty()) {
    progress.check();
    const MoveBelow m = open.back();
    open.pop_back();
    const double low = std::min(m.from.z(), m.to.z());
    const bool vertical = m.way.length() < 1e-9;
    const bool hits = std::any_of(heights_.begin(), heights_.end(), [&](double height) {
      return reaches(m.way, radiusAt(cutter_, std::max(height, 1e-9)), low + height);
    });
    if (!hits) continue;
    if (vertical || std::abs(m.from.z() - m.to.z()) <= level) return true;
    const Vec2 middle = m.way.at(0.5);
    const Vec3 half(middle.x(), middle.y(), (m.from.z() + m.to.z()) / 2);
    open.push_back({m.from, half, m.way.part(0, 0.5)});
    open.push_back({half, m.to, m.way.part(0.5, 1)});
  }
  return false;
}

bool Cleared::mayLieInStock(const Vec2& middle, double reach) const {
  if (stock_.empty) return true;
  return ((middle - stock_.low.head<2>()).array() + reach > margin_).all() &&
         ((stock_.high.head<2>() - middle).array() + reach > margin_).all();
}

bool Cleared::liesInStock(const Vec2& p) const { return mayLieInStock(p, 0); }

/// The path of a cut at a height: all of a horizontal cut, of a descending one the pieces that are deep enough.
void Cleared::addAt(const Cut& cut, double height, std::vector<Swept>& swept) const {
  const Vec3 &from = cut.move.from, &to = cut.move.to;
  const double reached = height + margin_;
  const auto radiusFrom = [&](double tip) {
    return cutter_.vAngle > 0 || cutter_.cornerRadius > 0 ? radiusAt(cutter_, reached - tip) : cutter_.diameter / 2;
  };
  const double highest = std::max(from.z(), to.z());
  if (highest <= reached && (highest - cut.deepest < margin_ || heights_.size() == 1)) {
    swept.push_back({cut.move.way, radiusFrom(highest)});
    return;
  }
  const double fall = to.z() - from.z();
  double first = 0, last = 1;
  if (highest > reached) (fall < 0 ? first : last) = (reached - from.z()) / fall;
  const int pieces = heights_.size() == 1 ? 1 : 8;
  for (int i = 0; i < pieces; ++i) {
    const double a = first + (last - first) * i / pieces, b = first + (last - first) * (i + 1) / pieces;
    const double tip = from.z() + fall * (fall < 0 ? a : b);
    if (const double radius = radiusFrom(tip); radius > 0) swept.push_back({cut.move.way.part(a, b), radius});
  }
}

std::vector<Cleared::Swept> Cleared::sweptNear(const Stroke& way, double radius, double height) const {
  const auto [low, high] = way.box();
  const double reach = radius + cutter_.diameter / 2;
  std::vector<Swept> swept;
  for (const Cut& each : cuts_) {
    if (each.deepest > height + margin_) continue;
    if (((each.low - high).array() > reach).any() || ((low - each.high).array() > reach).any()) continue;
    addAt(each, height, swept);
  }
  return swept;
}

/// Whether a point within the tool's plan on its way, the margin less, lies farther than the margin from all that was cut.
bool Cleared::reaches(const Stroke& way, double radius, double height) const {
  const double own = radius - margin_;
  if (height >= top_ - margin_ || own <= 0) return false;
  const std::vector<Swept> swept = sweptNear(way, radius, height);
  const auto [low, high] = way.box();
  const Vec2 middle = (low + high) / 2;
  std::vector<PlanSquare> open{{middle, (high - low).maxCoeff() / 2 + own}};
  const double finest = margin_ / 4;
  while (!open.empty()) {
    const PlanSquare s = open.back();
    open.pop_back();
    const double reach = s.half * std::sqrt(2.0);
    const double away = distance(way, s.middle);
    if (away - reach > own || !mayLieInStock(s.middle, reach)) continue;
    double left = std::numeric_limits<double>::max();
    for (const Swept& each : swept) {
      left = std::min(left, distance(each.way, s.middle) - each.radius);
      if (left + reach <= margin_) break;
    }
    if (left + reach <= margin_) continue;
    if (away <= own && left > margin_ && liesInStock(s.middle)) return true;
    if (reach <= finest) continue;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) open.push_back({s.middle + s.half * Vec2(x, y), s.half / 2});
  }
  return false;
}

}  // namespace blossom::pocket
