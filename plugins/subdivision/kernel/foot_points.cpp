#include "kernel/foot_points.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "kernel/near_places.h"

namespace blossom::subdivision {
namespace {

/// How many patches Newton's method is tried on.
constexpr std::size_t candidates = 6;

double clampUnit(double t) { return std::clamp(t, 0.0, 1.0); }

/// The nearest parameters within the patch.
Vec2 within(Domain domain, const Vec2& at) {
  switch (domain) {
    case Domain::Interval:
      return {clampUnit(at.x()), 0};
    case Domain::Circle:
      return {at.x() - std::floor(at.x()), 0};
    case Domain::Square:
      return {clampUnit(at.x()), clampUnit(at.y())};
    case Domain::Triangle:
      break;
  }
  if (at.x() >= 0 && at.y() >= 0 && at.sum() <= 1) return at;
  const double along = clampUnit((at.x() - at.y() + 1) / 2);
  const std::array<Vec2, 3> onSides{{{clampUnit(at.x()), 0}, {0, clampUnit(at.y())}, {along, 1 - along}}};
  return *std::min_element(onSides.begin(), onSides.end(),
                           [&](const Vec2& a, const Vec2& b) { return (a - at).norm() < (b - at).norm(); });
}

/// Columns: the directions in which the distance may still fall, sides left out that it pushes against.
Eigen::Matrix2Xd freeDirections(Domain domain, const Vec2& at, const Vec2& gradient) {
  if (domain == Domain::Circle) return Vec2(1, 0);
  std::vector<Vec2> outward;
  const auto side = [&](bool on, const Vec2& normal) {
    if (on && gradient.dot(normal) < 0) outward.push_back(normal);
  };
  side(at.x() <= 0, {-1, 0});
  if (domain != Domain::Triangle) side(at.x() >= 1, {1, 0});
  if (domain == Domain::Interval) return outward.empty() ? Eigen::Matrix2Xd(Vec2(1, 0)) : Eigen::Matrix2Xd(2, 0);
  side(at.y() <= 0, {0, -1});
  if (domain == Domain::Square) side(at.y() >= 1, {0, 1});
  if (domain == Domain::Triangle) side(at.sum() >= 1, {1, 1});
  if (outward.empty()) return Eigen::Matrix2d::Identity();
  if (outward.size() > 1) return {2, 0};
  return Vec2(-outward[0].y(), outward[0].x());
}

/// Newton's step; Gauss and Newton's, damped, where the distance is not convex.
Vec2 stepOf(const Frame& frame, const Vec3& r, const Eigen::Matrix2Xd& directions) {
  const Vec2 gradient(frame.du.dot(r), frame.dv.dot(r));
  Eigen::Matrix2d gauss, hesse;
  gauss << frame.du.squaredNorm(), frame.du.dot(frame.dv), frame.du.dot(frame.dv), frame.dv.squaredNorm();
  hesse << frame.duu.dot(r), frame.duv.dot(r), frame.duv.dot(r), frame.dvv.dot(r);
  hesse += gauss;
  const Eigen::VectorXd reduced = directions.transpose() * gradient;
  Eigen::MatrixXd matrix = directions.transpose() * hesse * directions;
  Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) {
    matrix = directions.transpose() * gauss * directions;
    matrix.diagonal().array() += 1e-6 * gauss.trace() + 1e-300;
    factor.compute(matrix);
  }
  return -directions * factor.solve(reduced);
}

}  // namespace

Foot descend(const LimitShape& shape, std::span<const Vec3> points, const Vec3& sample, Foot start) {
  constexpr int most = 40;
  const Domain domain = shape.domain(start.patch);
  Vec2 at(start.u, start.v);
  Frame frame = shape.frame(start, points);
  double distance = (frame.at - sample).squaredNorm();
  for (int i = 0; i < most; ++i) {
    const Vec3 r = frame.at - sample;
    const Vec2 gradient(frame.du.dot(r), frame.dv.dot(r));
    const Eigen::Matrix2Xd directions = freeDirections(domain, at, gradient);
    if (directions.cols() == 0) break;
    const Vec2 step = stepOf(frame, r, directions);
    bool better = false;
    for (double share = 1; share > 1e-4 && !better; share /= 2) {
      const Vec2 next = within(domain, at + share * step);
      if (!((next - at).norm() > 1e-14)) break;
      const Frame there = shape.frame({start.patch, next.x(), next.y()}, points);
      const double shorter = (there.at - sample).squaredNorm();
      if (shorter >= distance) continue;
      better = true;
      at = next;
      frame = there;
      distance = shorter;
    }
    if (!better || (at - Vec2(start.u, start.v)).norm() > 1e6) break;
  }
  return {start.patch, at.x(), at.y()};
}

FootFinder::FootFinder(const LimitShape& shape, const Progress& progress) : shape_(shape), seeds_(shape.seeds()) {
  rows_.resize(seeds_.size());
  parallelFor(seeds_.size(), 256, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rows_[i] = shape_.row(seeds_[i]);
  });
}

std::vector<Foot> FootFinder::feet(std::span<const Vec3> samples, std::span<const Vec3> points, std::span<const Foot> before,
                                   const Progress& progress) const {
  std::vector<Vec3> places(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) places[i] = combined(rows_[i], points);
  const NearPlaces tree(places);
  std::vector<Foot> feet(samples.size());
  parallelFor(samples.size(), 4, progress, [&](std::size_t begin, std::size_t end) {
    std::vector<NearPlaces::Near> nearest;
    for (std::size_t s = begin; s < end; ++s) {
      progress.check();
      const Vec3& sample = samples[s];
      // A few more than patches wanted, because neighbours lie on the same one.
      tree.nearest(sample, 4 * candidates, nearest);
      std::vector<Foot> starts;
      if (!before.empty()) starts.push_back(before[s]);
      std::vector<int> tried;
      for (auto each = nearest.begin(); each != nearest.end() && tried.size() < candidates; ++each) {
        const Foot& start = seeds_[each->second];
        if (!shape_.isCurve() && std::find(tried.begin(), tried.end(), start.patch) != tried.end()) continue;
        tried.push_back(start.patch);
        starts.push_back(start);
      }
      double best = std::numeric_limits<double>::infinity();
      for (const Foot& start : starts) {
        const Foot foot = descend(shape_, points, sample, start);
        const double distance = (shape_.frame(foot, points).at - sample).squaredNorm();
        if (distance >= best) continue;
        best = distance;
        feet[s] = foot;
      }
    }
  });
  return feet;
}

}  // namespace blossom::subdivision
