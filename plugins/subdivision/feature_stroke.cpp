#include "core/error.h"
#include "feature_types.h"
#include "kernel/curve_through.h"

namespace blossom::subdivision {
namespace {

struct StrokeParameters {
  std::vector<Vec3> points = {{0, 0, 0}, {10, 0, 0}};
  bool smooth = true;
};

Evaluated strokeEvaluate(const StrokeParameters& p, const Inputs&, const Progress& progress) {
  std::vector<Vec3> points;
  for (const Vec3& at : p.points)
    if (points.empty() || (at - points.back()).norm() > 1e-9) points.push_back(at);
  if (points.size() < 2)
    throw Error(ErrorCode::InvalidParameter, "The stroke has fewer than two points that differ.",
                "Give two points or more.");
  progress.check();
  Evaluated out;
  out.shape = p.smooth && points.size() > 2 ? splineThrough(points) : polylineThrough(points);
  return out;
}

}  // namespace

FeatureType strokeFeature() {
  using P = StrokeParameters;
  return feature<P>("subdivision.stroke", "Target stroke",
                    "A curve through points in space, drawn over a shape as its target.")
      .command("stroke")
      .icon("target-stroke")
      .produces({ShapeKind::Curve})
      .parameter("points", &P::points, list(point()), "The points, first to last.")
      .parameter("smooth", &P::smooth, flag(), "A smooth curve through the points; else straight lines.")
      .example("blossom stroke --points \"0,0,0; 5,0,2; 10,0,0\" -o stroke.step")
      .evaluate(strokeEvaluate);
}

}  // namespace blossom::subdivision
