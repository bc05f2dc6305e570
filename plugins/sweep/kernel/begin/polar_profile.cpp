#include "kernel/begin/polar_profile.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "geometry/bspline/bspline.h"
#include "kernel/begin/bernstein_zero.h"
#include "kernel/begin/curve_chain.h"
#include "kernel/begin/profile_plane.h"

namespace blossom::sweep {

namespace {

/// Larger steps of the angle could hide that a ray meets a piece twice.
constexpr double largestPieceAngle = fullTurn / 5;

double cross2(const Vec4& a, const Vec4& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

PolarProfile::PolarProfile(const Curve& given, const std::optional<Vec3>& centre) {
  validate(given);
  if (!(smallestWeight(given) > 0)) refuseProfile("a weight is not above 0.", "Give all its poles positive weights.");
  const Curve curve = clamped(given);
  const ProfilePlane plane = profilePlane(curve);
  Curve flat = flattened(curve, plane, plane.origin);
  const Vec3 moments = areaAndMoments(flat);
  const double x = 2 * moments.y() / (3 * moments.x()), y = 2 * moments.z() / (3 * moments.x());
  centre_ = centre.value_or(plane.origin + x * plane.x + y * plane.y);
  flat = flattened(curve, plane, centre_);
  if (moments.x() < 0) flat = turnedRound(flat);
  double farthest = 0;
  for (const Vec4& pole : flat.poles) farthest = std::max(farthest, pole.head<2>().norm() / pole.w());
  const Vec4 &first = flat.poles.front(), &last = flat.poles.back();
  const double gap = (first.head<2>() / first.w() - last.head<2>() / last.w()).norm();
  if (gap > 1e-6 * farthest)
    refuseProfile(fmt::format("it is open, its ends are {:.3g} mm apart.", gap), "Give a closed outline.");
  cutPieces(flat);
  reach_ = largestRadius();
  requireStar();
  starts_.push_back(std::atan2(pieces_[0].poles[0].y(), pieces_[0].poles[0].x()));
  for (const Curve& piece : pieces_) {
    const Vec4 &a = piece.poles.front(), &b = piece.poles.back();
    starts_.push_back(starts_.back() + std::atan2(cross2(a, b), a.x() * b.x() + a.y() * b.y()));
  }
  if (std::abs(starts_.back() - starts_.front() - fullTurn) > 1e-3)
    refuseProfile("it does not run around its centre once.", "Give an outline without loops.");
  starts_.back() = starts_.front() + fullTurn;
  findJoints(toBezier(flat).breaks);
}

void PolarProfile::cutPieces(const Curve& flat) {
  Curve fine = flat;
  for (int halvings = 0; halvings < 20; ++halvings) {
    const BezierCurve bezier = toBezier(fine);
    const std::size_t order = static_cast<std::size_t>(bezier.degree) + 1;
    std::vector<double> middles;
    pieces_.clear();
    for (std::size_t k = 0; k + 1 < bezier.breaks.size(); ++k) {
      Curve piece{bezier.degree, std::vector<double>(order, bezier.breaks[k]), {}};
      piece.knots.insert(piece.knots.end(), order, bezier.breaks[k + 1]);
      const auto first = bezier.poles.begin() + static_cast<std::ptrdiff_t>(k * order);
      piece.poles.assign(first, first + static_cast<std::ptrdiff_t>(order));
      double angle = 0;
      for (std::size_t i = 1; i < order; ++i)
        angle += std::abs(std::atan2(cross2(piece.poles[i - 1], piece.poles[i]),
                                     piece.poles[i - 1].head<2>().dot(piece.poles[i].head<2>())));
      if (angle > largestPieceAngle) middles.push_back((bezier.breaks[k] + bezier.breaks[k + 1]) / 2);
      pieces_.push_back(std::move(piece));
    }
    if (middles.empty()) return;
    fine = insertKnots(fine, middles);
  }
  refuseProfile("its centre lies on it or nearly so.", "Choose a centre well inside the outline.");
}

double PolarProfile::largestRadius() const {
  constexpr int samples = 32;  // of a piece, which is a fifth of the turn at most
  double largest = 0;
  for (const Curve& piece : pieces_) {
    const double from = piece.knots.front(), step = (piece.knots.back() - from) / samples;
    const auto radius = [&](double t) { return point(piece, t).norm(); };
    int best = 0;
    for (int i = 1; i <= samples; ++i)
      if (radius(from + i * step) > radius(from + best * step)) best = i;
    double low = from + std::max(best - 1, 0) * step, high = from + std::min(best + 1, samples) * step;
    largest = std::max(largest, radius(from + best * step));
    for (int k = 0; k < 40; ++k) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (radius(a) < radius(b) ? low : high) = radius(a) < radius(b) ? a : b;
    }
    largest = std::max(largest, radius((low + high) / 2));
  }
  return largest;
}

void PolarProfile::requireStar() const {
  BernsteinPieces turning;  // x y' - y x' of the numerators: the speed of the angle, but for a positive factor
  turning.degree = static_cast<std::size_t>(2 * pieces_[0].degree - 1);
  turning.breaks.push_back(pieces_.front().knots.front());
  for (const Curve& piece : pieces_) {
    turning.breaks.push_back(piece.knots.back());
    std::array<std::vector<double>, 2> value, slope;
    double weight = 0;  // the largest; the numerators carry it squared
    for (const Vec4& pole : piece.poles) weight = std::max(weight, pole.w());
    for (std::size_t c = 0; c < 2; ++c)
      for (std::size_t i = 0; i < piece.poles.size(); ++i) {
        value[c].push_back(piece.poles[i][static_cast<Eigen::Index>(c)] / weight);
        if (i > 0) slope[c].push_back(piece.degree * (value[c][i] - value[c][i - 1]));
      }
    const auto a = bernsteinProduct(value[0], slope[1]), b = bernsteinProduct(value[1], slope[0]);
    for (std::size_t i = 0; i < a.size(); ++i) turning.coefficients.emplace_back(a[i] - b[i], 0, 0);
  }
  const double least = 1e-10 * reach_ * reach_ / static_cast<double>(pieces_.size());
  std::optional<double> at = zeroOf(turning, least);
  // At a corner the sense may change without passing zero.
  for (std::size_t k = 0; !at && k < turning.pieces(); ++k)
    if (turning.coefficients[k * (turning.degree + 1)].x() < 0) at = turning.breaks[k];
  if (!at) return;
  const std::size_t k = std::min<std::size_t>(
      static_cast<std::size_t>(std::upper_bound(turning.breaks.begin() + 1, turning.breaks.end() - 1, *at) -
                               turning.breaks.begin()) -
          1,
      pieces_.size() - 1);
  const Vec3 place = point(pieces_[k], *at);
  refuseProfile(fmt::format("it is not star-shaped. Seen from its centre ({:.6g}, {:.6g}, {:.6g}), it turns back {:.6g} mm "
                            "to the right and {:.6g} mm up.",
                            centre_.x(), centre_.y(), centre_.z(), place.x(), place.y()),
                "Choose another centre, or an outline that every ray from its centre meets once.");
}

double PolarProfile::slopeOf(const Curve& piece, double t) const {
  const auto d = derivatives(piece, t, 1);
  const Vec2 arm = d[0].head<2>() / d[0].w(), speed = (d[1].head<2>() - d[1].w() * arm) / d[0].w();
  return arm.norm() * arm.dot(speed) / cross(arm, speed);
}

void PolarProfile::findJoints(const std::vector<double>& breaks) {
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const double t = pieces_[k].knots.front();
    if (!std::binary_search(breaks.begin(), breaks.end(), t)) continue;
    const Curve& before = pieces_[(k + pieces_.size() - 1) % pieces_.size()];
    const Vec4& pole = pieces_[k].poles.front();
    const double turns = std::floor(starts_[k] / fullTurn);
    Joint joint{starts_[k] - turns * fullTurn, false, {}};
    joint.value = {pole.head<2>().norm() / pole.w(), slopeOf(before, before.knots.back()), slopeOf(pieces_[k], t)};
    joint.corner = std::abs(joint.value.slopeRight - joint.value.slopeLeft) > 1e-6 * reach_;
    joints_.push_back(joint);
  }
  std::sort(joints_.begin(), joints_.end(), [](const Joint& a, const Joint& b) { return a.angle < b.angle; });
}

PolarProfile::Value PolarProfile::at(double angle) const {
  const double wrapped = angle - fullTurn * std::floor((angle - starts_.front()) / fullTurn);
  const auto above = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, wrapped);
  const Curve& piece = pieces_[static_cast<std::size_t>(above - starts_.begin()) - 1];
  const Vec4 ray(std::cos(wrapped), std::sin(wrapped), 0, 0);
  double low = piece.knots.front(), high = piece.knots.back(), t = (low + high) / 2;
  for (int step = 0; step < 100; ++step) {
    const auto d = derivatives(piece, t, 1);
    const double side = cross2(ray, d[0]);
    (side < 0 ? low : high) = t;
    double next = t - side / cross2(ray, d[1]);
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool settled = std::abs(next - t) <= 4e-16 * (piece.knots.back() - piece.knots.front() + std::abs(t));
    t = next;
    if (settled) break;
  }
  const Vec3 arm = point(piece, t);
  const double slope = slopeOf(piece, t);
  return {arm.norm(), slope, slope};
}

}  // namespace blossom::sweep
