#include "geometry/planar/interpolate.h"

#include <Eigen/Geometry>
#include <vector>

#include "geometry/numeric/cubic_slopes.h"

namespace blossom {
namespace {

std::vector<Vec2> distinct(std::span<const Vec2> points, bool closed) {
  std::vector<Vec2> kept;
  for (const Vec2& p : points)
    if (kept.empty() || p != kept.back()) kept.push_back(p);
  while (closed && kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

NumberRows slopesAt(const std::vector<Vec2>& p, const std::vector<double>& h, bool closed, const std::optional<Vec2>& start,
                    const std::optional<Vec2>& end) {
  const Eigen::Map<const NumberRows> rows(p.front().data(), static_cast<Eigen::Index>(p.size()), 2);
  if (closed) return periodicCubicSlopes(h, rows);
  const auto row = [](const std::optional<Vec2>& tangent) {
    return tangent ? std::optional<Eigen::RowVectorXd>(tangent->transpose()) : std::nullopt;
  };
  return cubicSlopes(h, rows, row(start), row(end));
}

}  // namespace

std::optional<Spline2> interpolated(std::span<const Vec2> points, bool closed, const std::optional<Vec2>& startTangent,
                                    const std::optional<Vec2>& endTangent) {
  std::vector<Vec2> p = distinct(points, closed);
  if (p.size() < 2) return {};
  if (p.size() < 3) closed = false;
  const std::size_t n = p.size(), spans = closed ? n : n - 1;
  std::vector<double> h(spans);
  for (std::size_t i = 0; i < spans; ++i) h[i] = (p[(i + 1) % n] - p[i]).norm();
  const NumberRows slopes = slopesAt(p, h, closed, startTangent, endTangent);
  const auto slope = [&](std::size_t i) -> Vec2 { return slopes.row(static_cast<Eigen::Index>(i)).transpose(); };

  Spline2 spline{3, {0, 0, 0, 0}, {p[0].homogeneous()}};
  double t = 0;
  for (std::size_t i = 0; i < spans; ++i) {
    const std::size_t next = (i + 1) % n;
    spline.poles.push_back(Vec2(p[i] + h[i] / 3 * slope(i)).homogeneous());
    spline.poles.push_back(Vec2(p[next] - h[i] / 3 * slope(next)).homogeneous());
    spline.poles.push_back(p[next].homogeneous());
    t += h[i];
    spline.knots.insert(spline.knots.end(), 3, t);
  }
  spline.knots.push_back(t);
  return spline;
}

}  // namespace blossom
