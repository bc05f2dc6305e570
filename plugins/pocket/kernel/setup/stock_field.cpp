#include "kernel/setup/stock_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blossom::pocket {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Height of the cutter's surface above its tip at a distance from its axis.
double riseOf(const Cutter& cutter, double across) {
  const double radius = cutter.diameter / 2;
  if (across > radius) return never;
  if (cutter.vAngle > 0) return across / std::tan(cutter.vAngle / 2);
  const double beyond = across - (radius - cutter.cornerRadius);
  if (beyond <= 0) return 0;
  return cutter.cornerRadius - std::sqrt(std::max(0.0, cutter.cornerRadius * cutter.cornerRadius - beyond * beyond));
}

/// A straight way of the tip, seen from above.
class Way {
 public:
  Way(const Vec3& from, const Vec3& to) : from_(from), along_(to - from), length_(along_.head<2>().norm()) {}

  /// The shares of the way at which the tip is within a distance of a place, first and last; empty when it never is.
  [[nodiscard]] std::optional<std::pair<double, double>> near(const Vec2& place, double distance) const {
    const Vec2 offset = place - from_.head<2>();
    if (length_ == 0) return offset.norm() <= distance ? std::optional(std::pair(0.0, 1.0)) : std::nullopt;
    const double foot = offset.dot(along_.head<2>()) / length_;
    const double aside = std::abs(cross(Vec2(along_.head<2>()), offset)) / length_;
    if (aside > distance) return {};
    const double half = std::sqrt(distance * distance - aside * aside);
    const double first = std::max(0.0, (foot - half) / length_), last = std::min(1.0, (foot + half) / length_);
    return first <= last ? std::optional(std::pair(first, last)) : std::nullopt;
  }
  [[nodiscard]] double heightAt(double share) const { return from_.z() + share * along_.z(); }
  [[nodiscard]] double distanceAt(double share, const Vec2& place) const {
    return (from_.head<2>() + share * along_.head<2>() - place).norm();
  }
  [[nodiscard]] double nearest(const Vec2& place) const {
    if (length_ == 0) return 0;
    return std::clamp((place - from_.head<2>()).dot(along_.head<2>()) / (length_ * length_), 0.0, 1.0);
  }
  [[nodiscard]] bool isLevel() const { return along_.z() == 0; }
  [[nodiscard]] double low() const { return std::min(from_.z(), from_.z() + along_.z()); }
  [[nodiscard]] Box2 around(double margin) const {
    const Vec2 a = from_.head<2>(), b = a + along_.head<2>();
    return {a.cwiseMin(b).array() - margin, a.cwiseMax(b).array() + margin};
  }

 private:
  Vec3 from_, along_;
  double length_;
};

/// The lowest that a cutter comes over a place; of a round one on a slope the least of nine samples between the place where
/// its axis is nearest and the lower end of its stay.
double lowestOver(const Cutter& cutter, const Way& way, const Vec2& place) {
  const auto stay = way.near(place, cutter.diameter / 2);
  if (!stay) return never;
  const double nearest = std::clamp(way.nearest(place), stay->first, stay->second);
  if (way.isLevel()) return way.heightAt(nearest) + riseOf(cutter, way.distanceAt(nearest, place));
  const double lowEnd = way.heightAt(stay->first) < way.heightAt(stay->second) ? stay->first : stay->second;
  if (cutter.cornerRadius == 0 && cutter.vAngle == 0) return way.heightAt(lowEnd);
  constexpr int steps = 8;
  double lowest = never;
  for (int i = 0; i <= steps; ++i) {
    const double share = nearest + (lowEnd - nearest) * i / steps;
    const double across = std::min(way.distanceAt(share, place), cutter.diameter / 2);
    lowest = std::min(lowest, way.heightAt(share) + riseOf(cutter, across));
  }
  return lowest;
}

}  // namespace

StockField::StockField(const Bounds& box, std::size_t cells) : corner_(box.low.head<2>()), bottom_(box.low.z()) {
  const Vec2 size = (box.high - box.low).head<2>();
  cell_ = std::sqrt(size.x() * size.y() / static_cast<double>(std::max<std::size_t>(1, cells)));
  columns_ = static_cast<std::size_t>(std::max(1.0, std::ceil(size.x() / cell_ - 1e-9)));
  rows_ = static_cast<std::size_t>(std::max(1.0, std::ceil(size.y() / cell_ - 1e-9)));
  tileColumns_ = (columns_ + tile - 1) / tile;
  heights_.assign(columns_ * rows_, box.high.z());
  highest_.assign(tileColumns_ * ((rows_ + tile - 1) / tile), box.high.z());
}

Vec2 StockField::middleOf(std::size_t column, std::size_t row) const {
  return corner_ + cell_ * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

StockField::Span StockField::columnsWithin(double low, double high) const {
  const auto clamped = [&](double v) { return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(columns_))); };
  return {clamped(std::ceil((low - corner_.x()) / cell_ - 0.5)),
          clamped(std::floor((high - corner_.x()) / cell_ - 0.5) + 1)};
}

StockField::Span StockField::rowsWithin(double low, double high) const {
  const auto clamped = [&](double v) { return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(rows_))); };
  return {clamped(std::ceil((low - corner_.y()) / cell_ - 0.5)),
          clamped(std::floor((high - corner_.y()) / cell_ - 0.5) + 1)};
}

template <class Visit>
void StockField::overTiles(const Box2& around, double height, const Visit& visit) const {
  const Span columns = columnsWithin(around.min().x(), around.max().x());
  const Span rows = rowsWithin(around.min().y(), around.max().y());
  if (columns.from >= columns.to || rows.from >= rows.to) return;
  for (std::size_t down = rows.from / tile; down <= (rows.to - 1) / tile; ++down)
    for (std::size_t across = columns.from / tile; across <= (columns.to - 1) / tile; ++across) {
      const std::size_t number = down * tileColumns_ + across;
      if (highest_[number] <= height) continue;
      const Span within{std::max(columns.from, across * tile), std::min(columns.to, (across + 1) * tile)};
      for (std::size_t row = std::max(rows.from, down * tile); row < std::min(rows.to, (down + 1) * tile); ++row)
        if (!visit(row, within, number)) return;
    }
}

void StockField::measureTile(std::size_t number) {
  const std::size_t row = number / tileColumns_ * tile, column = number % tileColumns_ * tile;
  double most = bottom_;
  for (std::size_t r = row; r < std::min(rows_, row + tile); ++r)
    for (std::size_t c = column; c < std::min(columns_, column + tile); ++c) most = std::max(most, heightAt(c, r));
  highest_[number] = most;
}

void StockField::lowerTo(const Triangles& triangles) {
  std::vector<double> tops(heights_.size(), bottom_);
  for (const auto& t : triangles) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    if (normal.z() == 0) continue;
    const double side = normal.z() > 0 ? 1 : -1;
    const auto [west, east] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
    const auto [south, north] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
    const Span columns = columnsWithin(west, east), rows = rowsWithin(south, north);
    for (std::size_t row = rows.from; row < rows.to; ++row)
      for (std::size_t column = columns.from; column < columns.to; ++column) {
        const Vec2 at = middleOf(column, row);
        bool isOver = true;
        for (std::size_t i = 0; i < 3 && isOver; ++i) {
          const Vec2 a = t[i].head<2>(), b = t[(i + 1) % 3].head<2>();
          isOver = side * cross(Vec2(b - a), Vec2(at - a)) >= 0;
        }
        if (!isOver) continue;
        const double height = t[0].z() - ((at - t[0].head<2>()).dot(normal.head<2>())) / normal.z();
        tops[row * columns_ + column] = std::max(tops[row * columns_ + column], height);
      }
  }
  for (std::size_t i = 0; i < heights_.size(); ++i) heights_[i] = std::min(heights_[i], tops[i]);
  for (std::size_t number = 0; number < highest_.size(); ++number) measureTile(number);
}

void StockField::cut(const Cutter& cutter, const Vec3& from, const Vec3& to) {
  const Way way(from, to);
  std::vector<std::size_t> changed;
  overTiles(way.around(cutter.diameter / 2), way.low(), [&](std::size_t row, const Span& columns, std::size_t number) {
    bool isLower = false;
    for (std::size_t column = columns.from; column < columns.to; ++column) {
      double& height = heights_[row * columns_ + column];
      if (height <= way.low()) continue;
      const double floor = std::max(bottom_, lowestOver(cutter, way, middleOf(column, row)));
      if (floor >= height) continue;
      height = floor;
      isLower = true;
    }
    if (isLower && (changed.empty() || changed.back() != number)) changed.push_back(number);
    return true;
  });
  for (const std::size_t number : changed) measureTile(number);
}

template <class Lowest>
std::optional<Vec3> StockField::standing(const Box2& around, double low, const Lowest& lowest) const {
  std::optional<Vec3> found;
  overTiles(around, low, [&](std::size_t row, const Span& columns, std::size_t) {
    for (std::size_t column = columns.from; column < columns.to; ++column) {
      const double height = heightAt(column, row);
      if (height <= low) continue;
      const Vec2 at = middleOf(column, row);
      if (height <= lowest(at)) continue;
      found = Vec3(at.x(), at.y(), height);
      return false;
    }
    return true;
  });
  return found;
}

std::optional<Vec3> StockField::metBy(const Cutter& cutter, const Vec3& from, const Vec3& to, double allowed) const {
  Cutter inner = cutter;
  inner.diameter -= 2 * cell_;
  if (inner.diameter <= 0) return {};
  inner.cornerRadius = std::max(0.0, cutter.cornerRadius - cell_);
  if (cutter.vAngle > 0) allowed += cell_ / std::tan(cutter.vAngle / 2);
  const Way way(from, to);
  return standing(way.around(inner.diameter / 2), way.low() + allowed,
                  [&](const Vec2& at) { return lowestOver(inner, way, at) + allowed; });
}

std::optional<Vec3> StockField::metBy(const ToolStage& stage, const Vec3& from, const Vec3& to, double allowed) const {
  const double reach = stage.reach() - cell_, above = stage.low() + allowed;
  if (reach <= 0) return {};
  const Way way(from, to);
  return standing(way.around(reach), way.low() + above, [&](const Vec2& at) {
    const auto stay = way.near(at, reach);
    return stay ? std::min(way.heightAt(stay->first), way.heightAt(stay->second)) + above : never;
  });
}

double StockField::volume() const {
  double sum = 0;
  for (const double height : heights_) sum += height - bottom_;
  return sum * cell_ * cell_;
}

}  // namespace blossom::pocket
