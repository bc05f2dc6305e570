#include "kernel/free_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace blossom::subdivision {
namespace {

/// A foot found by iteration misses a corner of its patch by rounding; weights that exist only for that do not count.
constexpr double negligible = 1e-12;

/// Index of the point that is farthest by `distance`.
template <class Distance>
std::size_t farthest(std::span<const Vec3> points, const Distance& distance) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (distance(points[i]) > distance(points[best])) best = i;
  return best;
}

int nearestTo(const Vec3& place, std::span<const Vec3> points, std::span<const int> among) {
  return *std::min_element(among.begin(), among.end(), [&](int a, int b) {
    return (points[static_cast<std::size_t>(a)] - place).squaredNorm() <
           (points[static_cast<std::size_t>(b)] - place).squaredNorm();
  });
}

std::vector<int> sortedOnce(std::vector<int> list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::vector<int> all(std::size_t count) {
  std::vector<int> list(count);
  for (std::size_t i = 0; i < count; ++i) list[i] = static_cast<int>(i);
  return list;
}

std::vector<int> onSide(std::span<const Vec3> points, const Vec3& origin, const Vec3& side) {
  std::vector<int> list;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i] - origin).dot(side) > 0) list.push_back(static_cast<int>(i));
  if (list.empty())
    throw Error(ErrorCode::InvalidInput,
                "The target lies beyond the local range: no control point is on the side that it bulges to.",
                "Choose the support, or rings:1, as the rule for free points, or bring the target nearer.");
  return list;
}

double reach(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  return box.diagonal().norm();
}

}  // namespace

std::vector<int> supportOf(std::span<const Row> rows) {
  std::vector<int> list;
  for (const Row& row : rows)
    for (std::size_t k = 0; k < row.indices.size(); ++k)
      if (std::abs(row.weights[k]) > negligible) list.push_back(row.indices[k]);
  return sortedOnce(std::move(list));
}

std::vector<int> grown(std::vector<int> chosen, std::span<const std::pair<int, int>> edges, std::size_t count, int rings) {
  std::vector<bool> in(count);
  for (const int i : chosen) in[static_cast<std::size_t>(i)] = true;
  const bool outward = rings > 0;
  for (int ring = 0; ring != rings; ring += outward ? 1 : -1) {
    std::vector<bool> next = in;
    for (const auto& [from, to] : edges) {
      const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
      if (in[a] != in[b]) next[a] = next[b] = outward;
    }
    if (next == in) break;
    in = std::move(next);
  }
  chosen.clear();
  for (std::size_t i = 0; i < count; ++i)
    if (in[i]) chosen.push_back(static_cast<int>(i));
  return chosen;
}

std::vector<int> paperRuleOnCurve(std::span<const Vec3> samples, std::span<const Vec3> points) {
  const Vec3& from = samples.front();
  const Vec3& to = samples.back();
  const double length = (to - from).norm();
  if (!(length > 1e-9 * reach(samples)))
    throw Error(ErrorCode::InvalidInput, "The target begins where it ends, so that no line runs through its ends.",
                "Choose the support as the rule for free points, or give an open target.");
  const Vec3 along = (to - from) / length;
  const auto offset = [&](const Vec3& p) -> Vec3 { return (p - from) - (p - from).dot(along) * along; };
  const Vec3 side = offset(samples[farthest(samples, [&](const Vec3& p) { return offset(p).norm(); })]);
  if (!(side.norm() > 1e-9 * length))
    throw Error(ErrorCode::InvalidInput, "The target is a straight line: it bulges to no side.",
                "Choose the support as the rule for free points.");
  const std::vector<int> chosen = onSide(points, from, side);
  std::vector<int> between;
  for (const int i : chosen)
    if (const double s = (points[static_cast<std::size_t>(i)] - from).dot(along); s >= 0 && s <= length)
      between.push_back(i);
  if (!between.empty()) return between;
  const std::vector<int> every = all(points.size());
  return sortedOnce({nearestTo(from, points, every), nearestTo(to, points, every)});
}

std::vector<int> paperRuleOnSurface(std::span<const Vec3> samples, std::span<const Vec3> footPoints,
                                    std::span<const Vec3> points) {
  const Vec3 a = samples[farthest(samples, [&](const Vec3& p) { return (p - samples[0]).norm(); })];
  const Vec3 b = samples[farthest(samples, [&](const Vec3& p) { return (p - a).norm(); })];
  const double length = (b - a).norm();
  const Vec3 x = length > 0 ? Vec3((b - a) / length) : Vec3::Zero();
  const auto aside = [&](const Vec3& p) { return x.cross(p - a).norm(); };
  const Vec3 c = samples[farthest(samples, aside)];
  if (!(aside(c) > 1e-9 * length) || length == 0)
    throw Error(ErrorCode::InvalidInput, "The samples of the target lie on one line, so that no plane runs through three.",
                "Choose the support as the rule for free points.");
  const Vec3 normal = x.cross(c - a).normalized();
  const Vec3 y = normal.cross(x);
  const auto height = [&](const Vec3& p) { return (p - a).dot(normal); };
  double bulge = height(samples[farthest(samples, [&](const Vec3& p) { return std::abs(height(p)); })]);
  if (std::abs(bulge) <= 1e-9 * length)
    bulge = height(footPoints[farthest(footPoints, [&](const Vec3& p) { return std::abs(height(p)); })]);
  const std::vector<int> chosen = onSide(points, a, bulge * normal);
  Eigen::AlignedBox2d box;
  const auto flat = [&](const Vec3& p) { return Vec2((p - a).dot(x), (p - a).dot(y)); };
  for (const Vec3& p : samples) box.extend(flat(p));
  std::vector<int> inside;
  for (const int i : chosen)
    if (box.contains(flat(points[static_cast<std::size_t>(i)]))) inside.push_back(i);
  if (!inside.empty()) return inside;
  const std::vector<int> every = all(points.size());
  std::vector<int> nearest;
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight, Eigen::AlignedBox2d::TopLeft,
                            Eigen::AlignedBox2d::TopRight}) {
    const Vec2 at = box.corner(corner);
    nearest.push_back(nearestTo(a + at.x() * x + at.y() * y, points, every));
  }
  return sortedOnce(std::move(nearest));
}

namespace {

std::vector<int> byPapersRule(const Wanted& wanted, std::span<const Vec3> points, bool isCurve) {
  const std::size_t drawn = wanted.drawn > 0 ? wanted.drawn : wanted.samples.size();
  const auto samples = wanted.samples.first(drawn);
  std::vector<int> chosen;
  if (isCurve) {
    chosen = paperRuleOnCurve(samples, points);
  } else {
    std::vector<Vec3> feet;
    for (const Row& row : wanted.rows.first(drawn)) feet.push_back(combined(row, points));
    chosen = paperRuleOnSurface(samples, feet, points);
  }
  const std::vector<int> pulled = supportOf(wanted.rows.subspan(drawn));
  chosen.insert(chosen.end(), pulled.begin(), pulled.end());
  return sortedOnce(std::move(chosen));
}

}  // namespace

std::vector<int> freePoints(const FreeRule& rule, const Wanted& wanted, std::span<const Vec3> points,
                            std::span<const std::pair<int, int>> edges, bool isCurve) {
  std::vector<int> free =
      rule.paper ? byPapersRule(wanted, points, isCurve) : grown(supportOf(wanted.rows), edges, points.size(), rule.rings);
  if (free.empty()) throw Error(ErrorCode::InvalidInput, "No control point is left free to move.", "Take fewer rings away.");
  return free;
}

Resistance resistanceOf(std::span<const Row> rows, std::span<const int> free) {
  constexpr double most = 1e4;
  constexpr double whole = 0.15;  // sum of squares of all weights of a limit point, at the least, where faces are quads
  std::vector<double> influence(free.size());
  double dependence = 0;
  for (const Row& row : rows) {
    double ofRow = 0;
    for (std::size_t k = 0; k < row.indices.size(); ++k) {
      const auto found = std::lower_bound(free.begin(), free.end(), row.indices[k]);
      if (found == free.end() || *found != row.indices[k]) continue;
      const double square = row.weights[k] * row.weights[k];
      influence[static_cast<std::size_t>(found - free.begin())] += square;
      ofRow += square;
    }
    dependence = std::max(dependence, ofRow);
  }
  Resistance resistance{1, std::vector<double>(free.size(), 1.0)};
  const double strongest = influence.empty() ? 0 : *std::max_element(influence.begin(), influence.end());
  if (!(strongest > negligible * negligible)) return resistance;
  const double missing = std::max(1.0, whole / dependence);
  resistance.strongest = strongest * std::pow(missing, 4);  // what hardly depends on them must not drive them
  for (std::size_t i = 0; i < free.size(); ++i)
    if (influence[i] > negligible * negligible) resistance.shares[i] = std::min(most, strongest / influence[i]);
  return resistance;
}

}  // namespace blossom::subdivision
