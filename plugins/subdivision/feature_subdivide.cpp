#include "cage_input.h"
#include "feature_types.h"
#include "present.h"

namespace blossom::subdivision {
namespace {

struct SubdivideParameters {
  SchemeChoice scheme = SchemeChoice::CatmullClark;
  int levels = 2;
  As as = As::Cage;
  double tolerance = 0.01;
};

Evaluated subdivideEvaluate(const SubdivideParameters& p, const Inputs& inputs, const Progress& progress) {
  const Shape cage = cageOf(inputs.of(0)[0]);
  checkScheme(cage, p.scheme);
  Evaluated out;
  if (p.as != As::Faces) out.stats["levels"] = p.levels;
  const PresentOptions options{p.scheme, p.as, p.levels, p.levels, p.tolerance};
  if (const Mesh* mesh = cage.get<Mesh>()) {
    out.stats["cage_faces"] = mesh->faceCount();
    present(closedCage(*mesh, p.scheme, out, progress), options, out, progress);
  } else if (auto polygon = polygonOf(cage, p.scheme)) {
    tellIfPoles(cage, out);
    out.stats["cage_points"] = polygon->points.size();
    present(std::move(*polygon), cage, options, out, progress);
  } else {
    out.stats["cage_points"] = splineOf(cage).poles.size();
    present(splineOf(cage), options, out, progress);
  }
  return out;
}

}  // namespace

FeatureType subdivideFeature() {
  using P = SubdivideParameters;
  return feature<P>("subdivision.subdivide", "Subdivide", "A coarse cage refined to a smooth surface or curve.")
      .command("subdivide")
      .icon("subdivide")
      .produces({ShapeKind::Mesh, ShapeKind::Curve, ShapeKind::Curves, ShapeKind::Brep})
      .input({.name = "cage",
              .help = "A mesh, with its creases, or a control polygon.",
              .kinds = cageKinds,
              .use = InputUse::Control,
              .asks = "a cage to smooth"})
      .parameter("scheme", &P::scheme, schemeChoice(), kSchemeHelp)
      .parameter("levels", &P::levels, onlyFor(count(0, 10), "as", {"cage", "limit"}),
                 "Number of refinements; each multiplies the faces by four.")
      .parameter("as", &P::as, asChoice(), kAsHelp)
      .parameter("tolerance", &P::tolerance, onlyFor(positiveLength(), "as", {"faces"}),
                 "Distance of B-spline faces from the limit surface near extraordinary points; elsewhere they are exact.")
      .byOutput(asByOutput())
      .example("blossom subdivide cage.obj --levels 3 -o smooth.obj")
      .example("blossom subdivide cage.obj -o smooth.step")
      .example("blossom subdivide triangles.obj --scheme loop --as limit -o smooth.stl")
      .example("blossom subdivide polygon.dxf --scheme cubic --levels 5 --as limit -o curve.dxf")
      .evaluate(subdivideEvaluate);
}

}  // namespace blossom::subdivision
