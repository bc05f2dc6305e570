#include <algorithm>
#include <cmath>

#include "geometry/bspline/bspline.h"
#include "kernel/edit/seam_v.h"

namespace blossom::sweep {

namespace {

/// How far ends may lie apart, as a share of what poles differ by and, where they differ by little, of their size.
constexpr double togetherOfSpread = 1e-9, togetherOfSize = 1e-14;
/// The same for derivatives, by the error of poles that would explain it. It is smaller, because in short spans errors of
/// poles explain much.
constexpr double smoothOfSpread = 1e-11;
/// A ratio this near to 1 or -1 is meant to be that.
constexpr double sameLength = 1e-12;

/// The curves along v of one factor.
using Lines = std::vector<Curve>;

Lines linesOf(const Surface& surface) {
  Lines lines;
  for (std::size_t i = 0; i < surface.countU(); ++i) {
    const auto row = surface.poles.begin() + static_cast<std::ptrdiff_t>(i * surface.countV());
    lines.push_back({surface.degreeV, surface.knotsV, {row, row + static_cast<std::ptrdiff_t>(surface.countV())}});
  }
  return lines;
}

bool isClamped(const Curve& line) {
  const std::size_t p = static_cast<std::size_t>(line.degree);
  return line.knots.front() == line.knots[p] && line.knots.back() == line.knots[line.poles.size()];
}

/// The largest pole, and the largest distance of one from the start of its line.
struct Extent {
  double size = 0, spread = 0;
};

Extent extentOf(const Lines& lines) {
  Extent extent;
  for (const Curve& line : lines)
    for (const Vec4& pole : line.poles) {
      extent.size = std::max(extent.size, pole.norm());
      extent.spread = std::max(extent.spread, (pole - line.poles.front()).norm());
    }
  return extent;
}

bool changes(const Lines& lines) {
  const Extent extent = extentOf(lines);
  return extent.spread > togetherOfSize * extent.size;
}

double ratioOf(const Lines& lines) {
  double product = 0, square = 0;
  for (const Curve& line : lines) {
    product += line.poles.back().dot(line.poles.front());
    square += line.poles.front().squaredNorm();
  }
  const double ratio = square > 0 ? product / square : 0;
  return std::abs(std::abs(ratio) - 1) <= sameLength ? std::copysign(1.0, ratio) : ratio;
}

/// The shorter one of the first and the last span.
double spanAtEnds(const Curve& line) {
  const std::size_t p = static_cast<std::size_t>(line.degree), n = line.poles.size();
  return std::min(line.knots[p + 1] - line.knots[p], line.knots[n] - line.knots[n - 1]);
}

std::optional<JoinedEnds> joinedEnds(const Lines& lines) {
  const Curve& any = lines.front();
  const double ratio = ratioOf(lines);
  if (!isClamped(any) || ratio == 0) return {};
  const Extent extent = extentOf(lines);
  const auto [first, last] = any.domain();
  JoinedEnds ends{ratio, any.degree - 1};
  bool meet = true;
  for (const Curve& line : lines) {
    const std::vector<Vec4> start = derivatives(line, first, any.degree - 1), end = derivatives(line, last, any.degree - 1);
    double growth = 1;  // of errors of poles in the derivative
    for (int k = 0; k <= ends.continuity; ++k) {
      const auto order = static_cast<std::size_t>(k);
      const double share = k == 0 ? togetherOfSpread : smoothOfSpread;
      const double allowed = growth * std::max(share * extent.spread, togetherOfSize * extent.size);
      if ((end[order] - ratio * start[order]).norm() > allowed) {
        meet = meet && k > 0;
        ends.continuity = k - 1;
      }
      growth *= (any.degree - k) / spanAtEnds(any);
    }
  }
  return meet ? std::optional(ends) : std::nullopt;
}

}  // namespace

std::optional<JoinedFactors> joinedInV(const Motion& motion) {
  const Lines trajectory{motion.trajectory}, orientation = linesOf(motion.orientation), scaling = linesOf(motion.scaling);
  if (!changes(trajectory) && !changes(orientation) && !changes(scaling)) return {};
  const auto t = joinedEnds(trajectory);
  if (!t) return {};
  const auto r = joinedEnds(orientation), s = joinedEnds(scaling);
  if (!r || !s) return {};
  return JoinedFactors{*t, *r, *s};
}

MotionSeams seamsInV(const Motion& motion) {
  const auto joined = joinedInV(motion);
  if (!joined) return {};
  return {SeamV(motion.trajectory, joined->trajectory), SeamV(spaceInV(motion.orientation), joined->orientation),
          SeamV(spaceInV(motion.scaling), joined->scaling)};
}

}  // namespace blossom::sweep
