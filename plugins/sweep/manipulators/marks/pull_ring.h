#pragma once
#include <QImage>
#include <vector>

#include "manipulators/pull_mode.h"
#include "ui/tools/view_props.h"

namespace blossom::sweep {

/// A plane that faces the viewer, and its scale.
struct Facing {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ();
  double pixel = 1;  ///< mm in a logical pixel
};
/// @param towards the line of sight, unit length
Facing facing(const Vec3& towards, double millimetresPerPixel);

inline constexpr double ringReach = 47;  ///< pixels from the centre within which the ring and its letters lie

/// The ring around a point: an arc for each of the shares T, R, S of a pull, with its letter on a plate, so that it is seen
/// on a surface of any colour. Square; the point is in its middle.
QImage ringPicture(const PullWeights&, const Look&, double pixelRatio);

/// What a twist does to an arm from a point of the trajectory.
struct TwistArc {
  Vec3 centre, axis, arm;
  double degrees = 0;
};
/// From the foot of the arm on the axis along the arc and back. Where the arm has no length, the arc has `radius`.
std::vector<Vec3> arcOf(const TwistArc&, double radius);

/// A square that faces the viewer; `half` of its side in pixels.
std::vector<Vec3> squareOnScreen(const Vec3& centre, const Facing&, double half);
/// Copies of lines, one device pixel from each other, that make lines of a width together. @param width logical pixels
std::vector<std::vector<Vec3>> thickened(const std::vector<std::vector<Vec3>>& lines, const Facing&, double width,
                                         double pixelRatio);
/// Copies of lines to both sides, above and below, `pixels` away on the screen.
std::vector<std::vector<Vec3>> besides(const std::vector<std::vector<Vec3>>& lines, const Facing&, double pixels);

}  // namespace blossom::sweep
