#include "kernel/four_point.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace blossom::subdivision {
namespace {

constexpr int depth = 40, tangentDepth = 12;

/// The points -2 .. 3 round the left end of an edge, each as a combination of the six that were there at first.
using Window = Eigen::Matrix<double, 6, 6>;

/// The windows of the halves of the edge; `low` and `high` are the ends of an open polygon, counted from the left end of the
/// edge.
Window half(const Window& window, bool right, long low, long high) {
  const auto at = [&](long i) { return window.row(i + 2); };
  Window next;
  const long first = right ? -1 : -2;  // counted in halves of the edge
  const auto child = [&](long i) -> Eigen::Matrix<double, 1, 6> {
    const long below = i >= 0 ? i / 2 : -((1 - i) / 2);
    if (i % 2 == 0) return at(i / 2);
    return (9 * (at(below) + at(below + 1)) - at(below - 1) - at(below + 2)) / 16;
  };
  for (long k = 0; k < 6; ++k)
    if (const long i = first + k; i >= 2 * low && i <= 2 * high) next.row(k) = child(i);
  // Beyond an end, points mirror those within.
  for (long k = 0; k < 6; ++k) {
    const long i = first + k;
    if (i < 2 * low) next.row(k) = 2 * next.row(2 * low - first) - next.row(4 * low - i - first);
    if (i > 2 * high) next.row(k) = 2 * next.row(2 * high - first) - next.row(4 * high - i - first);
  }
  return next;
}

Row rowOf(const Eigen::Matrix<double, 1, 6>& weights, const std::array<std::map<int, double>, 6>& base) {
  std::map<int, double> sum;
  for (int k = 0; k < 6; ++k)
    for (const auto& [index, weight] : base[static_cast<std::size_t>(k)]) sum[index] += weights[k] * weight;
  Row row;
  for (const auto& [index, weight] : sum) {
    if (weight == 0) continue;
    row.indices.push_back(index);
    row.weights.push_back(weight);
  }
  return row;
}

}  // namespace

FourPointCurve::FourPointCurve(const ControlPolygon& polygon)
    : count_(static_cast<long>(polygon.points.size())),
      spans_(polygon.closed ? count_ : count_ - 1),
      closed_(polygon.closed) {
  (void)refined(polygon, CurveScheme::FourPoint);  // refuses what is no polygon
}

FourPointCurve::Rows FourPointCurve::rows(double u) const {
  const double along = u * static_cast<double>(spans_);
  const long edge = std::clamp(static_cast<long>(std::floor(along)), 0L, spans_ - 1);
  double rest = along - static_cast<double>(edge);
  std::array<std::map<int, double>, 6> base;
  const long last = count_ - 1;
  for (long k = 0; k < 6; ++k) {
    long i = edge - 2 + k;
    std::map<int, double>& row = base[static_cast<std::size_t>(k)];
    double sign = 1;
    while (!closed_ && (i < 0 || i > last)) {  // 2 P(end) - P(mirrored)
      row[static_cast<int>(i < 0 ? 0 : last)] += 2 * sign;
      sign = -sign;
      i = i < 0 ? -i : 2 * last - i;
    }
    row[static_cast<int>(((i % count_) + count_) % count_)] += sign;
  }
  // Ends far off need no rule.
  constexpr long far = 1000;
  long low = closed_ ? -far : std::max(-edge, -far), high = closed_ ? far : std::min(last - edge, far);
  Window window = Window::Identity();
  Rows result;
  double scale = static_cast<double>(spans_);
  for (int level = 0; level < depth; ++level) {
    if (level == tangentDepth) {
      const auto slope = [&](long i) -> Eigen::Matrix<double, 1, 6> {
        return (window.row(i) - 8 * window.row(i + 1) + 8 * window.row(i + 3) - window.row(i + 4)) / 12;
      };
      result.tangent = rowOf(scale * ((1 - rest) * slope(0) + rest * slope(1)), base);
    }
    const bool right = rest >= 0.5;
    window = half(window, right, low, high);
    rest = 2 * rest - (right ? 1 : 0);
    low = std::max(2 * low - (right ? 1 : 0), -far);
    high = std::min(2 * high - (right ? 1 : 0), far);
    scale *= 2;
  }
  result.at = rowOf((1 - rest) * window.row(2) + rest * window.row(3), base);
  return result;
}

Row FourPointCurve::row(const Foot& foot) const { return rows(foot.u).at; }

Frame FourPointCurve::frame(const Foot& foot, std::span<const Vec3> points) const {
  const Rows here = rows(foot.u);
  Frame frame;
  frame.at = combined(here.at, points);
  frame.du = combined(here.tangent, points);
  return frame;
}

std::vector<Foot> FourPointCurve::seeds() const {
  constexpr long perSpan = 8;
  std::vector<Foot> feet;
  for (long k = 0; k < perSpan * spans_; ++k)
    feet.push_back({0, (static_cast<double>(k) + 0.5) / static_cast<double>(perSpan * spans_), 0});
  return feet;
}

std::vector<std::pair<int, int>> FourPointCurve::edges() const {
  std::vector<std::pair<int, int>> list;
  for (int i = 0; i < spans_; ++i) list.emplace_back(i, (i + 1) % static_cast<int>(count_));
  return list;
}

}  // namespace blossom::subdivision
