#include "kernel/sharp_end.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/bspline/bspline.h"
#include "kernel/end_poles.h"

namespace blossom::sweep {

namespace {

/// The direction in which the poles lie farthest apart.
Vec3 lineThrough(const std::vector<Vec4>& poles, const Vec3& middle) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vec4& pole : poles) scatter += (euclidean(pole) - middle) * (euclidean(pole) - middle).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
}

/// How far along its line an end lies at u.
class AlongEnd {
 public:
  AlongEnd(const Surface& surface, bool atEnd)
      : curve_(isoV(surface, atEnd ? surface.domainV().second : surface.domainV().first)) {
    const std::vector<Vec4> poles = endPoles(surface, atEnd);
    middle_ = middleOf(poles);
    way_ = lineThrough(poles, middle_);
  }
  [[nodiscard]] double at(double u) const { return way_.dot(point(curve_, u) - middle_); }
  [[nodiscard]] Vec3 placeAt(double u) const { return point(curve_, u); }

 private:
  Curve curve_;
  Vec3 middle_{0, 0, 0}, way_{0, 0, 0};
};

std::vector<double> samplesOf(const Surface& surface) {
  constexpr int inSpan = 32;
  const auto [low, high] = surface.domainU();
  std::vector<double> us;
  for (std::size_t k = 0; k + 1 < surface.knotsU.size(); ++k) {
    const double from = surface.knotsU[k], to = surface.knotsU[k + 1];
    if (!(from < to) || from < low || to > high) continue;
    for (int i = 0; i < inSpan; ++i) us.push_back(from + (to - from) * i / inSpan);
  }
  us.push_back(high);
  return us;
}

/// The largest value between two parameters, by a search that keeps a third of the interval out at a time.
double highest(const AlongEnd& end, double low, double high, double sign) {
  constexpr int rounds = 80;
  for (int k = 0; k < rounds; ++k) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (sign * end.at(a) < sign * end.at(b))
      low = a;
    else
      high = b;
  }
  return (low + high) / 2;
}

/// Where the end reaches farthest, one way or the other.
double turnOf(const AlongEnd& end, const std::vector<double>& us, double sign) {
  const auto best =
      std::max_element(us.begin(), us.end(), [&](double a, double b) { return sign * end.at(a) < sign * end.at(b); });
  if (best == us.begin() || best + 1 == us.end()) return *best;
  const double between = highest(end, *(best - 1), *(best + 1), sign);
  return sign * end.at(between) > sign * end.at(*best) ? between : *best;  // a corner is a sample already
}

/// Where the end is as far along as at the seam, between the two turns, by halving.
double oppositeSeam(const AlongEnd& end, double seam, double low, double high) {
  constexpr int halvings = 60;
  const double wanted = end.at(seam);
  const bool rises = end.at(low) < end.at(high);
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    if ((end.at(middle) < wanted) == rises)
      low = middle;
    else
      high = middle;
  }
  return (low + high) / 2;
}

/// Whether an end goes one way alone between parameters, but for rounding.
bool goesOneWay(const AlongEnd& end, const std::vector<double>& us, double low, double high, double rounding) {
  const double sign = end.at(low) < end.at(high) ? 1 : -1;
  double reached = sign * end.at(low);
  for (const double u : us) {
    if (u <= low || u >= high) continue;
    const double now = sign * end.at(u);
    if (now < reached - rounding) return false;
    reached = std::max(reached, now);
  }
  return true;
}

/// The ends of the domain and the cuts between them, those beside a knot moved there.
std::vector<double> bordersOf(const Surface& surface, const std::vector<double>& cuts) {
  constexpr double beside = 1e-10;  // of the domain
  const auto [first, last] = surface.domainU();
  std::vector<double> borders{first};
  for (const double u : cuts) {
    const double knot = *std::min_element(surface.knotsU.begin(), surface.knotsU.end(),
                                          [u](double a, double b) { return std::abs(a - u) < std::abs(b - u); });
    const double at = std::abs(knot - u) < beside * (last - first) ? knot : u;
    if (at > borders.back() && at < last) borders.push_back(at);
  }
  borders.push_back(last);
  return borders;
}

/// Between two knots, or ends of the domain, at which the surface need not be smooth: its poles pass through both.
Surface partBetween(const Surface& surface, double low, double high) {
  const std::vector<double>& knots = surface.knotsU;
  const auto from = std::upper_bound(knots.begin(), knots.end(), low), to = std::lower_bound(from, knots.end(), high);
  const auto order = static_cast<std::size_t>(surface.degreeU) + 1;
  Surface part{surface.degreeU, surface.degreeV, {from, to}, surface.knotsV, {}};
  part.knotsU.insert(part.knotsU.begin(), order, low);
  part.knotsU.insert(part.knotsU.end(), order, high);
  const std::size_t row = static_cast<std::size_t>(from - knots.begin()) - order;
  for (std::size_t i = 0; i < part.countU(); ++i)
    for (std::size_t j = 0; j < surface.countV(); ++j) part.poles.push_back(surface.pole(row + i, j));
  return part;
}

}  // namespace

bool isSharpEnd(const Surface& surface, bool atEnd, double near) {
  const std::vector<Vec4> poles = endPoles(surface, atEnd);
  const Vec3 middle = middleOf(poles);
  if (isPoint(poles, middle, near)) return false;
  const Vec3 way = lineThrough(poles, middle);
  return std::all_of(poles.begin(), poles.end(), [&](const Vec4& pole) {
    const Vec3 p = euclidean(pole) - middle;
    return (p - way.dot(p) * way).norm() <= nearAt(pole, near);
  });
}

std::vector<double> cutsOfSharpEnd(const Surface& surface, bool atEnd) {
  constexpr double rounding = 1e-9;  // of the length of the edge
  constexpr double atSeam = 1e-5;    // of the domain: a turn moves by the square of it
  const AlongEnd end(surface, atEnd);
  const std::vector<double> us = samplesOf(surface);
  const auto [seam, period] = surface.domainU();
  const auto [a, b] = std::minmax({turnOf(end, us, 1), turnOf(end, us, -1)});
  const double off = rounding * std::abs(end.at(a) - end.at(b));
  if (!goesOneWay(end, us, a, b, off) || !goesOneWay(end, us, seam, a, off) || !goesOneWay(end, us, b, period, off))
    throw Error(ErrorCode::Degenerate,
                fmt::format("The sweep ends in the edge from {} to {}, which its last section runs along more than once "
                            "each way.",
                            placeText(end.placeAt(a)), placeText(end.placeAt(b))),
                "Scale the section there down to a point, keep it wider, or leave out --solid.");
  if (a - seam < atSeam * (period - seam)) return {b};
  if (period - b < atSeam * (period - seam)) return {a};
  return {a, oppositeSeam(end, seam, a, b), b};
}

std::vector<Surface> cutAlongV(const Surface& surface, const std::vector<double>& cuts) {
  const Surface whole = clamped(surface);
  const std::vector<double> borders = bordersOf(whole, cuts);
  std::vector<double> inserted;
  for (std::size_t k = 1; k + 1 < borders.size(); ++k) {
    const auto there = std::count(whole.knotsU.begin(), whole.knotsU.end(), borders[k]);
    for (auto times = there; times < whole.degreeU; ++times) inserted.push_back(borders[k]);
  }
  const Surface finer = insertKnotsU(whole, inserted);
  std::vector<Surface> parts;
  for (std::size_t k = 0; k + 1 < borders.size(); ++k) parts.push_back(partBetween(finer, borders[k], borders[k + 1]));
  return parts;
}

}  // namespace blossom::sweep
