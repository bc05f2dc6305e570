#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tolerance.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/refusal.h"
#include "geometry/planar/polygons/straightened.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/sums/flattening.h"

namespace blossom::planar {
namespace {

constexpr double coarsestOfCurve = 0.05;  // share of its size
constexpr double mostPoints = 1e5;        // of all curves, when they are drawn as polygons

void checkCurve(const Path& curve, std::size_t number, const std::string& name) {
  if (curve.segments.empty())
    refuse(ErrorCode::InvalidInput, name, fmt::format("has an empty curve, number {}.", number), "Remove the curve.");
  refuseWhatIsNoNumber(curve, fmt::format("curve {}", number), name);
  for (std::size_t i = 0; i < curve.segments.size(); ++i) {
    refuseFarAway(startPoint(curve.segments[i]), name);
    refuseFarAway(endPoint(curve.segments[i]), name);
    if (i == 0) continue;
    const Vec2 from = endPoint(curve.segments[i - 1]), to = startPoint(curve.segments[i]);
    if ((from - to).norm() > Tolerance{}.joining)
      refuse(ErrorCode::InvalidInput, name,
             fmt::format("has a curve with a gap of {:.3g} mm at {}.", (from - to).norm(), at(from)),
             "Close the gap in the drawing, or draw two curves.");
  }
}

bool isStraight(const Path& curve) {
  return std::all_of(curve.segments.begin(), curve.segments.end(),
                     [](const Segment& segment) { return std::holds_alternative<Line2>(segment); });
}

double toleranceOfCurves(const std::vector<Path>& curves, const FlatteningOptions& options, const std::string& name) {
  constexpr double largest = 0.01, shareOfSize = 1e-4;
  const Box2 box = boxAround(curves);
  const double size = box.sizes().maxCoeff();
  const bool straight = std::all_of(curves.begin(), curves.end(), isStraight);
  const double tolerance =
      options.share * options.tolerance.value_or(straight ? largest : std::min(largest, shareOfSize * size));
  if (!straight && tolerance > coarsestOfCurve * size)
    refuse(ErrorCode::InvalidParameter, name,
           fmt::format("at {} is {:.3g} mm large; a tolerance of {:.3g} mm is too coarse for its curves.", at(box.center()),
                       size, *options.tolerance),
           smallerTolerance(coarsestOfCurve * size / options.share));
  return tolerance;
}

/// About so many sides: before they are made, for a tolerance may ask for billions.
void refuseTooFine(const std::vector<Path>& curves, double tolerance, const std::string& name) {
  double sides = 0;
  for (const Path& curve : curves)
    for (const Segment& segment : curve.segments) {
      ++sides;
      if (std::holds_alternative<Line2>(segment)) continue;
      sides += std::sqrt(boxAround(segment).sizes().norm() / tolerance);
    }
  if (sides > mostPoints)
    refuse(ErrorCode::LimitExceeded, name,
           fmt::format("needs more than {:.0f} points within {:.3g} mm.", mostPoints, tolerance), "Raise the tolerance.");
}

void dropShortSegments(Path& curve) {
  std::erase_if(curve.segments, [](const Segment& segment) { return length(segment) <= Tolerance{}.confusion; });
}

}  // namespace

SoundSet soundSet(const PlanarSet& set, const FlatteningOptions& options, const std::string& name,
                  const Progress& progress) {
  if (options.tolerance && (!(*options.tolerance > 0) || !std::isfinite(*options.tolerance)))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The tolerance must be above 0; it is {}.", *options.tolerance));
  SoundSet sound;
  if (!set.area.loops.empty()) {
    sound.area = soundRegion(set.area, options, name, progress);
    sound.tolerance = sound.area.tolerance;
  }
  for (const Vec2& point : set.points) {
    if (!point.allFinite())
      refuse(ErrorCode::InvalidInput, name, "has a point whose coordinates are not numbers.", "Repair the file.");
    refuseFarAway(point, name);
    sound.points.push_back(point);
  }
  for (std::size_t i = 0; i < set.curves.size(); ++i) {
    progress.check();
    checkCurve(set.curves[i], i + 1, name);
    Path curve = set.curves[i];
    const Vec2 start = startPoint(curve);
    curve.closed = false;
    dropShortSegments(curve);
    if (curve.segments.empty())
      sound.points.push_back(start);
    else
      sound.curves.push_back(std::move(curve));
  }
  if (!sound.curves.empty()) {
    const double tolerance = toleranceOfCurves(sound.curves, options, name);
    sound.tolerance = sound.area.region.loops.empty() ? tolerance : std::min(tolerance, sound.tolerance);
    sound.area.tolerance = sound.tolerance;
    for (Path& curve : sound.curves) straighten(curve, sound.tolerance);
    refuseTooFine(sound.curves, sound.tolerance, name);
  }
  return sound;
}

}  // namespace blossom::planar
