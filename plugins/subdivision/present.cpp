#include "present.h"

#include <fmt/format.h>

#include "cage_input.h"
#include "core/angle.h"
#include "core/error.h"
#include "core/units.h"
#include "faces_brep.h"
#include "geometry/bspline/bspline.h"
#include "kernel/bspline_faces.h"
#include "kernel/rims.h"
#include "kernel/subdivide.h"

namespace blossom::subdivision {
namespace {

/// The same curve with a knot in the middle of every span, so that its poles come nearer.
Curve refinedSpline(Curve curve, int levels, const Progress& progress) {
  for (int level = 0; level < levels; ++level) {
    progress.check();
    std::vector<double> knots;
    for (auto k = static_cast<std::size_t>(curve.degree); k < curve.poles.size(); ++k)
      if (curve.knots[k + 1] > curve.knots[k]) knots.push_back((curve.knots[k] + curve.knots[k + 1]) / 2);
    curve = insertKnots(curve, knots);
  }
  return curve;
}

ControlPolygon refinedPolygon(ControlPolygon polygon, CurveScheme scheme, int levels, const Progress& progress) {
  constexpr std::size_t maximumPoints = 10'000'000;
  for (int level = 0; level < levels; ++level) {
    progress.check();
    if (polygon.points.size() > maximumPoints / 2)
      throw Error(ErrorCode::LimitExceeded, fmt::format("{} levels would make more than ten million points.", levels),
                  fmt::format("This polygon can be refined {} times.", level));
    polygon = refined(polygon, scheme);
  }
  return polygon;
}

void presentFaces(const Mesh& cage, const PresentOptions& options, Evaluated& out, const Progress& progress) {
  if (options.scheme == SchemeChoice::Loop)
    throw Error(ErrorCode::InvalidInput, "The surfaces of Loop's scheme are no bicubic B-splines.",
                "Take a limit mesh, or the scheme catmull-clark.");
  const FacesResult made = bsplineFaces(cage, {.tolerance = options.tolerance}, progress.part(0, 0.6));
  out.shape = brepOf(made.faces, cage.name, cage.color, progress.part(0.6, 1));
  out.stats["faces"] = made.faces.size();
  out.stats["exact_faces"] = made.exactFaces;
  out.stats["deviation_mm"] = made.deviation;
  out.stats["normal_deviation"] = toDegrees(made.normalDeviation);
  if (made.exactFaces < made.faces.size())
    out.warnings.push_back(
        fmt::format("Near extraordinary points the faces lie up to {:.2g} mm and {:.2g}° off the limit surface.",
                    made.deviation - made.sharpened, toDegrees(made.normalDeviation)));
  if (made.sharpened > 0)
    out.warnings.push_back(fmt::format(
        "Edges that are sharp for some levels only are sharp in the faces: up to {:.2g} mm off the limit surface.",
        made.sharpened));
  if (made.deviation > options.tolerance)
    out.warnings.emplace_back("That is more than the tolerance; refine the cage once and try again.");
}

}  // namespace

ParameterSpec asChoice() { return choice({"cage", "limit", "faces"}); }

ChoiceByOutput asByOutput() { return {"as", {{"step iges brep", "faces"}, {"stl ply off", "limit"}}}; }

void present(Mesh cage, const PresentOptions& options, Evaluated& out, const Progress& progress) {
  if (options.as == As::Faces) return presentFaces(cage, options, out, progress);
  const bool limit = options.as == As::Limit;
  const int levels = limit ? options.limitLevels : options.cageLevels;
  if (levels == 0 && !limit) {
    out.shape = std::move(cage);
    return;
  }
  out.shape = subdivide(cage, {.scheme = surfaceScheme(options.scheme), .levels = levels, .limit = limit}, progress).mesh;
}

Mesh closedCage(const Mesh& mesh, SchemeChoice scheme, Evaluated& out, const Progress& progress) {
  JoinedRims joined = joinedCage(mesh, surfaceScheme(scheme), progress);
  if (joined.joined > 0)
    out.warnings.push_back(fmt::format(
        "Rims of the cage lie on each other; they were joined at {} vertices, so that the surface is closed there.",
        joined.joined));
  return std::move(joined.mesh);
}

void tellIfPoles(const Shape& cage, Evaluated& out) {
  if (const auto* curve = cage.get<Curve>(); curve && curve->degree > 1)
    out.warnings.push_back(
        fmt::format("The scheme does not make the B-spline curve of degree {} itself; its {} poles are the control polygon.",
                    curve->degree, curve->poles.size()));
}

void present(ControlPolygon polygon, const Shape& like, const PresentOptions& options, Evaluated& out,
             const Progress& progress) {
  const CurveScheme scheme = curveScheme(options.scheme);
  if (options.as == As::Faces) {
    if (scheme == CurveScheme::FourPoint)
      throw Error(ErrorCode::InvalidInput, "The limit curve of the four-point scheme is no B-spline.",
                  "Take a limit polygon, or the scheme cubic.");
    out.shape = splineOfPolygon(polygon, scheme);
    return;
  }
  if (options.as == As::Cage)
    out.shape = shapeOf(refinedPolygon(std::move(polygon), scheme, options.cageLevels, progress), like);
  else
    out.shape = shapeOf(onLimit(refinedPolygon(std::move(polygon), scheme, options.limitLevels, progress), scheme), like);
}

void present(Curve curve, const PresentOptions& options, Evaluated& out, const Progress& progress) {
  out.shape = refinedSpline(std::move(curve), options.as == As::Cage ? options.cageLevels : 0, progress);
}

}  // namespace blossom::subdivision
