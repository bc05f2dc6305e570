#include "kernel/edit/motion_symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "kernel/edit/place_row.h"
#include "kernel/edit/section_rows.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

using Eigen::Matrix3d;

/// How far rows may be from copies of each other, as a share of their length: what decimals of a file leave open.
constexpr double sameRow = 1e-9;

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
    throw Error(ErrorCode::Degenerate, fmt::format("The orientation of this motion vanishes around v = {}.", v));
  return sum / length;
}

void requireParts(const char* factor, const Surface& surface, int fold) {
  if (rowsPerPart(surface, fold) > 0) return;
  const std::size_t rows = surface.countU() - static_cast<std::size_t>(surface.degreeU);
  refuse(
      rows % static_cast<std::size_t>(fold) != 0
          ? fmt::format("The {} of this motion has {} rows around, which cannot be parted in {} alike.", factor, rows, fold)
          : fmt::format("The knots in u of the {} do not come back after one {}th of the period.", factor, fold),
      "Ask for a fold that divides the rows, or give the motion evenly spaced rows whose number the fold divides.");
}

/// g of the header, from the rows of the section.
Vec4 stepOf(const Motion& motion, double v, int fold) {
  const std::vector<Vec4> rows = sectionRows(motion.orientation, v);
  const std::size_t free = rows.size() - static_cast<std::size_t>(motion.orientation.degreeU),
                    part = free / static_cast<std::size_t>(fold);
  const auto shifted = [&](std::size_t i) -> Vec4 {
    return i + part < free ? rows[i + part] : Vec4(closureOfOrientation(motion) * rows[i + part - free]);
  };
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < free; ++i) sum += times(shifted(i), conjugate(rows[i]));
  Vec4 step = unit(sum, v);
  double off = 0;
  for (std::size_t i = 0; i < free; ++i) off += (shifted(i) - times(step, rows[i])).squaredNorm();
  if (off > sameRow * sameRow * squareSum(rows))
    refuse(fmt::format("This motion is not {}-fold at v = {}: its frames are not the same turn apart after each {}th of the "
                       "period.",
                       fold, v, fold),
           "Begin with a motion that has this symmetry there, and edit it with the same fold.");
  return step;
}

/// The rotations G^k about one axis.
std::vector<Matrix3d> foldTurns(const Motion& motion, double v, int fold) {
  if (fold == 1) return {Matrix3d::Identity()};
  if (motion.closedU == ClosedU::No)
    refuse("Only a motion that is closed in u can be edited at several places around it.",
           "Close it with \"closed_u\", or leave the fold at 1.");
  requireParts("orientation", motion.orientation, fold);
  requireParts("scaling", motion.scaling, fold);
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

/// Rows of the scaling read backwards stand for reflected vectors, reflected along one axis of the frame.
bool scalingIsMirrored(const Motion& motion, const std::vector<Vec4>& rows, Eigen::Index axis) {
  const double allowed = sameRow * std::sqrt(squareSum(rows));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec4& other = rows[rows.size() - 1 - i];
    for (Eigen::Index k = 0; k < 4; ++k) {
      if (k < 3 && motion.point[k] == 0) continue;
      if (std::abs(other[k] - (k == axis ? -1 : 1) * rows[i][k]) > allowed) return false;
    }
  }
  return true;
}

/// n of the header for an axis e of the frame, when there is one.
std::optional<Vec3> mirrorNormal(const std::vector<Vec4>& rows, Eigen::Index axis, double v) {
  Vec4 e = Vec4::Zero();
  e[axis + 1] = 1;
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i)
    sum += times(times(rows[rows.size() - 1 - i], conjugate(e)), conjugate(rows[i]));
  const double all = squareSum(rows);
  if (!(sum.norm() > sameRow * all)) return std::nullopt;
  const Vec4 normal = unit(sum, v);
  double off = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    off += (rows[rows.size() - 1 - i] - times(times(normal, rows[i]), e)).squaredNorm();
  if (off > sameRow * sameRow * all || std::abs(normal[0]) > sameRow) return std::nullopt;
  return normal.tail<3>().normalized();
}

Matrix3d reflection(const Motion& motion, double v) {
  if (!knotsAreMirrored(motion.orientation) || !knotsAreMirrored(motion.scaling))
    refuse("The knots in u of this motion are not the same read backwards, so that nothing can be mirrored.",
           "Give the motion evenly spaced rows, or leave out the mirror.");
  const std::vector<Vec4> rows = sectionRows(motion.orientation, v), scales = sectionRows(motion.scaling, v);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!scalingIsMirrored(motion, scales, axis)) continue;
    if (const auto normal = mirrorNormal(rows, axis, v)) return Matrix3d::Identity() - 2 * *normal * normal->transpose();
  }
  refuse(
      fmt::format("This motion is not its own mirror image at v = {}: read backwards in u, its frames or scalings are not "
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
