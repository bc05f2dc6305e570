#include "kernel/begin/smooth_curve.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/numeric/gauss.h"
#include "kernel/begin/bernstein_zero.h"

namespace blossom::sweep {

namespace {

/// Derivatives shorter than this share of the longest one vanish.
constexpr double vanishingShare = 1e-8;

std::string placeOnCurve(double t, const Vec3& at) {
  return fmt::format("v = {:.6g}, at ({:.6g}, {:.6g}, {:.6g})", t, at.x(), at.y(), at.z());
}

Curve overUnitInterval(const Curve& given) {
  validate(given);
  if (!(smallestWeight(given) > 0))
    throw Error(ErrorCode::InvalidInput, "A weight of the curve is not above 0.", "Give all its poles positive weights.");
  Curve curve = clamped(given);
  const auto [from, to] = curve.domain();
  for (double& knot : curve.knots) knot = knot == to ? 1.0 : (knot - from) / (to - from);
  return curve;
}

double boxDiagonal(const Curve& curve) {
  Eigen::AlignedBox3d box;
  for (const Vec4& pole : curve.poles) box.extend(Vec3(pole.head<3>() / pole.w()));
  return box.diagonal().norm();
}

double weightRatio(const BezierCurve& bezier, std::size_t piece) {
  const auto order = static_cast<std::size_t>(bezier.degree) + 1;
  const auto first = bezier.poles.begin() + static_cast<std::ptrdiff_t>(piece * order);
  const auto [least, most] = std::minmax_element(first, first + static_cast<std::ptrdiff_t>(order),
                                                 [](const Vec4& a, const Vec4& b) { return a.w() < b.w(); });
  return most->w() / least->w();
}

/// Pieces in which weights differ by some times at most, however much they do along the curve.
BezierCurve withEvenWeights(Curve curve) {
  constexpr double even = 4;
  constexpr int halvings = 24;
  BezierCurve bezier = toBezier(curve);
  for (int round = 0; round < halvings; ++round) {
    std::vector<double> middles;
    for (std::size_t k = 0; k + 1 < bezier.breaks.size(); ++k)
      if (weightRatio(bezier, k) > even) middles.push_back((bezier.breaks[k] + bezier.breaks[k + 1]) / 2);
    if (middles.empty()) break;
    curve = insertKnots(curve, middles);
    bezier = toBezier(curve);
  }
  return bezier;
}

/// The derivative per unit of the parameter but for a factor of some times: the numerator A' w - A w' for the curve A / w,
/// divided by the square of the largest weight of its piece.
BernsteinPieces hodograph(const BezierCurve& bezier) {
  const auto p = static_cast<std::size_t>(bezier.degree);
  BernsteinPieces result{2 * p - 1, bezier.breaks, {}};
  for (std::size_t k = 0; k < result.pieces(); ++k) {
    const double scale = static_cast<double>(p) / (bezier.breaks[k + 1] - bezier.breaks[k]);
    double weight = 0;
    for (std::size_t i = 0; i <= p; ++i) weight = std::max(weight, bezier.poles[k * (p + 1) + i].w());
    std::array<std::vector<double>, 4> value, slope;
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t i = 0; i <= p; ++i) {
        value[c].push_back(bezier.poles[k * (p + 1) + i][static_cast<Eigen::Index>(c)] / weight);
        if (i > 0) slope[c].push_back(scale * (value[c][i] - value[c][i - 1]));
      }
    std::vector<Vec3> numerator(2 * p);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = bernsteinProduct(slope[c], value[3]), b = bernsteinProduct(slope[3], value[c]);
      for (std::size_t i = 0; i < 2 * p; ++i) numerator[i][static_cast<Eigen::Index>(c)] = a[i] - b[i];
    }
    result.coefficients.insert(result.coefficients.end(), numerator.begin(), numerator.end());
  }
  return result;
}

}  // namespace

SmoothCurve::SmoothCurve(const Curve& given) : curve_(overUnitInterval(given)), size_(boxDiagonal(curve_)) {
  const BezierCurve bezier = toBezier(curve_);
  breaks_ = bezier.breaks;
  const std::size_t order = static_cast<std::size_t>(bezier.degree) + 1;
  for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
    Curve piece{bezier.degree, std::vector<double>(order, breaks_[k]), {}};
    piece.knots.insert(piece.knots.end(), order, breaks_[k + 1]);
    const auto first = bezier.poles.begin() + static_cast<std::ptrdiff_t>(k * order);
    piece.poles.assign(first, first + static_cast<std::ptrdiff_t>(order));
    pieces_.push_back(std::move(piece));
  }
  refuseCusps();
  refuseCorners();
  const CurvePoint start = at(0, 0), end = at(1, pieces_.size() - 1);
  if (!((end.point - start.point).norm() <= 1e-9 * size_)) return;
  const Vec3 a = end.tangent(), b = start.tangent();
  cornerAtEnds_ = std::atan2(a.cross(b).norm(), a.dot(b));
  closed_ = cornerAtEnds_ <= corner;
}

void SmoothCurve::refuseCusps() const {
  const BernsteinPieces derivative = hodograph(withEvenWeights(curve_));
  double longest = 0;
  for (const Vec3& c : derivative.coefficients) longest = std::max(longest, c.norm());
  if (!(longest > 0)) throw Error(ErrorCode::Degenerate, "The curve is a single point.", "Give a curve that has a length.");
  if (const auto cusp = zeroOf(derivative, vanishingShare * longest))
    throw Error(ErrorCode::Degenerate,
                fmt::format("The curve stands still at {}: a cusp or a doubled pole has no tangent.",
                            placeOnCurve(*cusp, point(curve_, *cusp))),
                "Move the poles apart there, or end the curve before that place.");
}

void SmoothCurve::refuseCorners() const {
  for (std::size_t k = 1; k + 1 < breaks_.size(); ++k) {
    const CurvePoint before = at(breaks_[k], k - 1), after = at(breaks_[k], k);
    const Vec3 a = before.tangent(), b = after.tangent();
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (angle > corner)
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The curve has a corner of {:.4g} degrees at {}: the frames would jump.", toDegrees(angle),
                              placeOnCurve(breaks_[k], after.point)),
                  "Round the corner, or use the parts of the curve one by one.");
  }
}

std::size_t SmoothCurve::pieceOf(double t) const {
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t);
  return static_cast<std::size_t>(above - breaks_.begin()) - 1;
}

CurvePoint SmoothCurve::at(double t, std::size_t piece) const {
  const std::vector<Vec4> d = derivatives(pieces_[piece], t, 2);
  CurvePoint result;
  result.point = d[0].head<3>() / d[0].w();
  result.first = (d[1].head<3>() - d[1].w() * result.point) / d[0].w();
  result.second = (d[2].head<3>() - 2 * d[1].w() * result.first - d[2].w() * result.point) / d[0].w();
  return result;
}

int SmoothCurve::frameMultiplicity(std::size_t k) const {
  const auto [first, last] = std::equal_range(curve_.knots.begin(), curve_.knots.end(), breaks_[k]);
  if (curve_.degree - (last - first) >= 3) return 1;
  const Vec3 before = at(breaks_[k], k - 1).turning(), after = at(breaks_[k], k).turning();
  return (after - before).norm() > 1e-8 * (1 + before.norm() + after.norm()) ? 3 : 2;
}

double SmoothCurve::length(double from, double to) const {
  // Far from the origin, derivatives of points have no more digits: closer, the halving would not end.
  const double allowed = 1e-13 * size_ + 1e-15 * at(from).point.norm();
  double sum = 0;
  for (std::size_t k = pieceOf(from); k < pieces_.size() && breaks_[k] < to; ++k)
    sum += integrate([&](double t) { return at(t, k).first.norm(); }, std::max(from, breaks_[k]),
                     std::min(to, breaks_[k + 1]), allowed);
  return sum;
}

}  // namespace blossom::sweep
