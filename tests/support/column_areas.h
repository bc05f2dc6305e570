#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/planar/planar.h"
#include "geometry/shape/toolpath.h"

namespace blossom::test {

/// Intervals of y.
using Intervals = std::vector<std::pair<double, double>>;

/// Areas by columns of even width: at each, the sweeps of the moves and the part as intervals of y. Shares nothing with the
/// kernel: capsules around short lines, columns instead of rows, and no bounds.
class Columns {
 public:
  Columns(const Toolpath& path, double floor) : radius_(path.cutter.diameter / 2) {
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Vec3 from = startOf(path, i);
      if (path.moves[i].kind == MoveKind::Rapid || path.moves[i].to.z() > floor + 1e-9) continue;
      const std::vector<Vec3> points = from.z() > floor + 1e-9 ? std::vector<Vec3>{path.moves[i].to, path.moves[i].to}
                                                               : polylineOf(from, path.moves[i], 2e-5);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) lines_.emplace_back(points[k].head<2>(), points[k + 1].head<2>());
    }
    for (const auto& [a, b] : lines_) {
      low_ = std::min({low_, a.x() - radius_, b.x() - radius_});
      high_ = std::max({high_, a.x() + radius_, b.x() + radius_});
    }
  }

  [[nodiscard]] double cutArea() const {
    return summed(low_, high_, {}, [&](double x) {
      double sum = 0;
      for (const auto& [bottom, top] : united(cutAt(x))) sum += top - bottom;
      return sum;
    });
  }

  /// Of a part of straight lines.
  [[nodiscard]] double uncutArea(const Region& part, double low, double high) const {
    std::vector<double> corners;
    for (const Path& loop : part.loops)
      for (const Segment& segment : loop.segments) corners.push_back(startPoint(segment).x());
    return summed(low, high, corners, [&](double x) {
      const Intervals cut = united(cutAt(x));
      double sum = 0;
      for (const auto& [bottom, top] : partAt(part, x)) {
        sum += top - bottom;
        for (const auto& [a, b] : cut) sum -= std::max(0.0, std::min(b, top) - std::max(a, bottom));
      }
      return sum;
    });
  }

 private:
  /// The middle of columns that end wherever a height may jump: beside level and upright moves, and at corners.
  template <class Height>
  [[nodiscard]] double summed(double low, double high, std::vector<double> jumps, const Height& height) const {
    constexpr double shortPieces = 0.1;  // of arcs: one follows smoothly on the other
    for (const auto& [a, b] : lines_)
      if (const double length = (b - a).norm(); length == 0 || length > shortPieces)
        for (const double x : {a.x() - radius_, a.x() + radius_, b.x() - radius_, b.x() + radius_}) jumps.push_back(x);
    jumps.push_back(low);
    jumps.push_back(high);
    std::sort(jumps.begin(), jumps.end());
    const double widest = (high - low) / 3000;
    double sum = 0;
    for (std::size_t k = 0; k + 1 < jumps.size(); ++k) {
      const double from = std::max(low, jumps[k]), to = std::min(high, jumps[k + 1]);
      if (!(to > from)) continue;
      const int columns = static_cast<int>(std::ceil((to - from) / widest));
      for (int i = 0; i < columns; ++i) sum += height(from + (to - from) * (i + 0.5) / columns) * (to - from) / columns;
    }
    return sum;
  }

  [[nodiscard]] Intervals cutAt(double x) const {
    Intervals found;
    for (const auto& [a, b] : lines_) {
      if (x <= std::min(a.x(), b.x()) - radius_ || x >= std::max(a.x(), b.x()) + radius_) continue;
      double bottom = 1e300, top = -1e300;
      const auto take = [&](double y) { bottom = std::min(bottom, y), top = std::max(top, y); };
      for (const Vec2& p : {a, b})
        if (const double square = radius_ * radius_ - (x - p.x()) * (x - p.x()); square > 0) {
          take(p.y() - std::sqrt(square));
          take(p.y() + std::sqrt(square));
        }
      const Vec2 along = b - a;
      if (along.x() != 0)
        for (const double side : {-1.0, 1.0}) {
          const Vec2 shift = side * radius_ * Vec2(-along.y(), along.x()).normalized();
          const double t = (x - a.x() - shift.x()) / along.x();
          if (t >= 0 && t <= 1) take(a.y() + shift.y() + t * along.y());
        }
      if (top > bottom) found.emplace_back(bottom, top);
    }
    return found;
  }

  static Intervals united(Intervals all) {
    std::sort(all.begin(), all.end());
    Intervals out;
    for (const auto& each : all) {
      if (!out.empty() && each.first <= out.back().second)
        out.back().second = std::max(out.back().second, each.second);
      else
        out.push_back(each);
    }
    return out;
  }

  static Intervals partAt(const Region& part, double x) {
    std::vector<double> ys;
    for (const Path& loop : part.loops)
      for (const Segment& segment : loop.segments) {
        const auto& line = std::get<Line2>(segment);
        if ((line.from.x() < x) == (line.to.x() < x)) continue;
        ys.push_back(line.from.y() + (x - line.from.x()) / (line.to.x() - line.from.x()) * (line.to.y() - line.from.y()));
      }
    std::sort(ys.begin(), ys.end());
    Intervals out;
    for (std::size_t i = 0; i + 1 < ys.size(); i += 2) out.emplace_back(ys[i], ys[i + 1]);
    return out;
  }

  double radius_, low_ = 1e300, high_ = -1e300;
  std::vector<std::pair<Vec2, Vec2>> lines_;
};

}  // namespace blossom::test
