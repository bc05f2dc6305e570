#include "kernel/edit/motion_symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "kernel/edit/edit_level.h"
#include "kernel/edit/place_row.h"
#include "kernel/edit/section_values.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

using Eigen::Matrix3d;

/// How far values may be from copies of each other, as a share of their length: what decimals of a file leave open.
constexpr double sameValue = 1e-9;

[[noreturn]] void refuse(const std::string& message, const char* hint) {
  throw Error(ErrorCode::InvalidInput, message, hint);
}

double squareSum(const std::vector<Vec4>& rows) {
  double sum = 0;
  for (const Vec4& row : rows) sum += row.squaredNorm();
  return sum;
}

Vec4 unit(const Vec4& sum, double v) {
  const double length = sum.norm();
  if (!(length > 0))
    throw Error(ErrorCode::Degenerate, fmt::format("The orientation of this motion vanishes around v = {:.6g}.", v));
  return sum / length;
}

/// The functions that level 0 changes: knots that edits of finer levels added do not count.
SplineSpace baseSpaceU(const Surface& factor, double closure, const std::array<std::vector<double>, 2>& base) {
  return withInnerKnots(spaceInU(factor, closure), base[0]);
}

void requireParts(const char* factor, const SplineSpace& space, int fold) {
  if (knotsRepeat(space, fold)) return;
  refuse(
      space.size() % static_cast<std::size_t>(fold) != 0
          ? fmt::format("The {} of this motion has {} rows around, which cannot be parted in {} alike.", factor,
                        space.size(), fold)
          : fmt::format("The knots in u of the {} do not come back after one {}th of the period.", factor, fold),
      "Ask for a fold that divides the rows, or give the motion evenly spaced rows whose number the fold divides. Rows that "
      "edits of finer levels add do not matter; those inserted by hand do.");
}

/// How far values may be from copies of each other, as a share of their length: sameValue, and what the rounding of
/// the parameters makes of them where these are much larger than the domain.
double allowedOff(const Surface& factor) {
  const auto [first, last] = factor.domainU();
  return sameValue + 100 * (sameKnot({first, last}) / (last - first) - 1e-12);
}

/// g of the header, from values of the section.
Vec4 stepOf(const Motion& motion, double v, int fold) {
  const Surface& r = motion.orientation;
  const auto [first, last] = r.domainU();
  std::vector<double> at = placesToCompare(r, fold);
  const std::vector<Vec4> values = sectionValues(r, v, at, closureOfOrientation(motion));
  for (double& u : at) u += (last - first) / fold;
  const std::vector<Vec4> next = sectionValues(r, v, at, closureOfOrientation(motion));
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < values.size(); ++i) sum += times(next[i], conjugate(values[i]));
  Vec4 step = unit(sum, v);
  double off = 0;
  for (std::size_t i = 0; i < values.size(); ++i) off += (next[i] - times(step, values[i])).squaredNorm();
  if (off > allowedOff(r) * allowedOff(r) * squareSum(values))
    refuse(fmt::format(
               "This motion is not {}-fold at v = {:.6g}: its frames are not the same turn apart after each {}th of the "
               "period.",
               fold, v, fold),
           "Begin with a motion that has this symmetry there, and edit it with the same fold; a single edit that reaches "
           "this v takes the symmetry away.");
  return step;
}

/// The rotations G^k about one axis.
std::vector<Matrix3d> foldTurns(const Motion& motion, double v, int fold) {
  if (fold == 1) return {Matrix3d::Identity()};
  if (motion.closedU == ClosedU::No)
    refuse("Only a motion that is closed in u can be edited at several places around it.",
           "Close it with \"closed_u\", or leave the fold at 1.");
  const BaseKnots base = baseKnots(motion);
  requireParts("orientation", baseSpaceU(motion.orientation, closureOfOrientation(motion), base.orientation), fold);
  requireParts("scaling", baseSpaceU(motion.scaling, closureOfScaling(motion), base.scaling), fold);
  const Vec4 step = stepOf(motion, v, fold);
  const double length = step.tail<3>().norm();
  const long parts = std::lround(std::atan2(length, step[0]) * fold / std::numbers::pi);
  if (parts % fold == 0)
    refuse(fmt::format("The frame of this motion is turned as before after each {}th of the period: copies of an edit would "
                       "all have the same target.",
                       fold),
           "A symmetric edit needs a frame that turns along u.");
  std::vector<Matrix3d> turns;
  turns.reserve(static_cast<std::size_t>(fold));
  for (int k = 0; k < fold; ++k)
    turns.push_back(
        Eigen::AngleAxisd(2 * std::numbers::pi * static_cast<double>(k * parts % fold) / fold, step.tail<3>() / length)
            .toRotationMatrix());
  return turns;
}

/// A section, and the same read backwards.
struct BothWays {
  std::vector<Vec4> value, back;
  double allowed;  ///< see allowedOff
};

BothWays bothWays(const Surface& factor, double v, double closure) {
  const auto [first, last] = factor.domainU();
  std::vector<double> at = placesToCompareMirrored(factor);
  BothWays result{sectionValues(factor, v, at, closure), {}, allowedOff(factor)};
  for (double& u : at) u = first + last - u;
  result.back = sectionValues(factor, v, at, closure);
  return result;
}

/// The scaling read backwards stands for reflected vectors, reflected along one axis of the frame.
bool scalingIsMirrored(const Motion& motion, const BothWays& s, Eigen::Index axis) {
  const double allowed = s.allowed * std::sqrt(squareSum(s.value));
  for (std::size_t i = 0; i < s.value.size(); ++i)
    for (Eigen::Index k = 0; k < 4; ++k) {
      if (k < 3 && motion.point[k] == 0) continue;
      if (std::abs(s.back[i][k] - (k == axis ? -1 : 1) * s.value[i][k]) > allowed) return false;
    }
  return true;
}

/// n of the header for an axis e of the frame, when there is one.
std::optional<Vec3> mirrorNormal(const BothWays& r, Eigen::Index axis, double v) {
  Vec4 e = Vec4::Zero();
  e[axis + 1] = 1;
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < r.value.size(); ++i) sum += times(times(r.back[i], conjugate(e)), conjugate(r.value[i]));
  const double all = squareSum(r.value);
  if (!(sum.norm() > r.allowed * all)) return std::nullopt;
  const Vec4 normal = unit(sum, v);
  double off = 0;
  for (std::size_t i = 0; i < r.value.size(); ++i) off += (r.back[i] - times(times(normal, r.value[i]), e)).squaredNorm();
  if (off > r.allowed * r.allowed * all || std::abs(normal[0]) > r.allowed) return std::nullopt;
  return normal.tail<3>().normalized();
}

Matrix3d reflection(const Motion& motion, double v) {
  const double closureR = closureOfOrientation(motion), closureS = closureOfScaling(motion);
  const BaseKnots base = baseKnots(motion);
  if (!knotsAreMirrored(baseSpaceU(motion.orientation, closureR, base.orientation)) ||
      !knotsAreMirrored(baseSpaceU(motion.scaling, closureS, base.scaling)))
    refuse("The knots in u of this motion are not the same read backwards, so that nothing can be mirrored.",
           "Give the motion evenly spaced rows, or leave out the mirror.");
  const BothWays r = bothWays(motion.orientation, v, closureR), s = bothWays(motion.scaling, v, closureS);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!scalingIsMirrored(motion, s, axis)) continue;
    if (const auto normal = mirrorNormal(r, axis, v)) return Matrix3d::Identity() - 2 * *normal * normal->transpose();
  }
  refuse(fmt::format(
             "This motion is not its own mirror image at v = {:.6g}: read backwards in u, its frames or scalings are not "
             "reflected in one plane.",
             v),
         "Begin with a motion that is mirrored over its seam, or over its middle when it is open.");
}

}  // namespace

double insidePeriod(const Motion& motion, double u) {
  const auto [first, last] = motion.domainU();
  if (motion.closedU == ClosedU::No || (u >= first && u <= last)) return u;
  const double over = std::fmod(u - first, last - first);
  return std::clamp(first + (over < 0 ? over + (last - first) : over), first, last);
}

std::vector<SymmetricPlace> symmetricPlaces(const Motion& motion, const MotionPlace& place, const EditSymmetry& symmetry) {
  const auto [first, last] = motion.domainU();
  std::vector<SymmetricPlace> places;
  const std::vector<Matrix3d> turns = foldTurns(motion, place.v, symmetry.fold);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const double u = place.u + (last - first) * static_cast<double>(k) / symmetry.fold;
    places.push_back({{insidePeriod(motion, u), place.v}, turns[k]});
  }
  if (!symmetry.mirror) return places;
  const Matrix3d mirror = reflection(motion, place.v);
  for (std::size_t k = 0; k < turns.size(); ++k)
    places.push_back({{insidePeriod(motion, first + last - places[k].at.u), place.v}, mirror * turns[k]});
  return places;
}

}  // namespace blossom::sweep
