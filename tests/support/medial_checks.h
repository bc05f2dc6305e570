#pragma once
#include <fmt/format.h>

#include <random>
#include <string>

#include "geometry/planar/medial_axis.h"
#include "support/true_distance.h"

namespace blossom::test {

/// A medial axis against its part, by an independent search on the true curves.
class AxisCheck {
 public:
  AxisCheck(const Region& part, const MedialAxis& axis) : part_(part), axis_(axis), truth_(part.loops) {}

  struct Report {
    std::size_t points = 0, outside = 0;
    double worstClearance = 0;   ///< mm between the clearance told and the distance to the boundary
    double worstSecondFoot = 0;  ///< mm by which the boundary away from the nearest foot stays out of the disc
    Vec2 at = Vec2::Zero();      ///< where the second foot is worst
    [[nodiscard]] std::string text() const {
      return fmt::format("{} points, {} outside, clearance off by {:.3g}, second foot by {:.3g}, at ({:.4f}, {:.4f})",
                         points, outside, worstClearance, worstSecondFoot, at.x(), at.y());
    }
  };

  /// Ends and middles of all straight bits. How fast the clearance r rises along the edge gives the angle between the feet:
  /// they are 2 r sqrt(1 - (dr/ds)^2) apart, and a disc that touches the boundary but once touches nothing a quarter as far
  /// off.
  [[nodiscard]] Report all() const {
    Report report;
    for (const MedialEdge& edge : axis_.edges)
      for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
        const Vec3 middle = (edge.points[i] + edge.points[i + 1]) / 2;
        add(report, edge.points[i], 0);
        const double rise = riseAround(edge, i);
        add(report, middle, middle.z() / 2 * std::sqrt(1 - rise * rise));
      }
    for (const MedialVertex& v : axis_.vertices) add(report, {v.at.x(), v.at.y(), v.clearance}, 0);
    return report;
  }

  /// mm by which random points of the part lie out of all discs of the axis.
  [[nodiscard]] double maximumUncovered(int count, std::mt19937_64& random) const {
    Vec2 low = startPoint(part_.loops[0]);
    Vec2 high = low;
    for (const Path& loop : part_.loops)
      for (const Vec2& p : flatten(loop, 0.1)) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    std::uniform_real_distribution<double> share(0, 1);
    double most = 0;
    for (int i = 0; i < count;) {
      const Vec2 x = low + (high - low).cwiseProduct(Vec2(share(random), share(random)));
      if (windingAround(part_.loops, x) != 1) continue;
      ++i;
      double best = std::numeric_limits<double>::infinity();
      for (const MedialVertex& v : axis_.vertices) best = std::min(best, (v.at - x).norm() - v.clearance);
      for (const MedialEdge& edge : axis_.edges)
        for (std::size_t k = 0; k + 1 < edge.points.size(); ++k)
          best = std::min(best, outOf(edge.points[k], edge.points[k + 1], x));
      most = std::max(most, best);
    }
    return most;
  }

 private:
  /// dr/ds around a straight bit, over a length well above the polyline's own tolerance; 1 where the edge is shorter.
  static double riseAround(const MedialEdge& edge, std::size_t i) {
    constexpr double enough = 0.05;  // mm
    std::size_t from = i;
    std::size_t to = i + 1;
    const auto stepOf = [&] { return (edge.points[to] - edge.points[from]).head<2>().norm(); };
    while (stepOf() < enough && (from > 0 || to + 1 < edge.points.size())) {
      if (from > 0) --from;
      if (to + 1 < edge.points.size()) ++to;
    }
    return stepOf() < enough ? 1 : std::min(1.0, std::abs(edge.points[to].z() - edge.points[from].z()) / stepOf());
  }

  /// How far x lies out of the discs between two, whose radii run straight: the least of a convex function.
  static double outOf(const Vec3& a, const Vec3& b, const Vec2& x) {
    double low = 0;
    double high = 1;
    const auto out = [&](double t) {
      const Vec3 p = a + t * (b - a);
      return (p.head<2>() - x).norm() - p.z();
    };
    for (int i = 0; i < 20; ++i) {
      const double third = (high - low) / 3;
      (out(low + third) < out(high - third) ? high : low) =
          out(low + third) < out(high - third) ? high - third : low + third;
    }
    return out((low + high) / 2);
  }

  void add(Report& report, const Vec3& p, double apart) const {
    const Vec2 x = p.head<2>();
    ++report.points;
    const TrueDistance::Foot foot = truth_.nearest(x);
    report.worstClearance = std::max(report.worstClearance, std::abs(foot.distance - p.z()));
    if (p.z() > 1e-2 && windingAround(part_.loops, x) != 1) ++report.outside;
    if (apart <= 0) return;
    const double second = truth_.nearestBeyond(x, foot.at, apart).distance - p.z();
    if (second > report.worstSecondFoot) report.at = x;
    report.worstSecondFoot = std::max(report.worstSecondFoot, second);
  }

  const Region& part_;
  const MedialAxis& axis_;
  TrueDistance truth_;
};

}  // namespace blossom::test
