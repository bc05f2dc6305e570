#include <fmt/format.h>

#include <algorithm>

#include "feature_groups.h"
#include "kernel/medial/boundary.h"
#include "part_input.h"

namespace blossom::pocket {

namespace {

struct MedialAxisParameters {
  SubShapeValue face;
  bool skipOpen = false;
  double tolerance = 1e-3;
};

Evaluated medialAxisOf(const MedialAxisParameters& p, const Inputs& inputs, const Progress& progress) {
  const Part part = partOf(inputs.of(0)[0], p.face, p.skipOpen ? OpenLines::LeaveOut : OpenLines::RefuseForNow);
  const ClearanceDiagram diagram(part.region, {.tolerance = p.tolerance}, progress.part(0, 0.6));
  MedialAxis axis = diagram.medialAxis(progress.part(0.6, 1));
  Evaluated out;
  out.warnings = part.warnings;
  addDiagramStats(diagram, out.stats);
  const auto doubtful =
      std::find_if(axis.vertices.begin(), axis.vertices.end(), [](const MedialVertex& v) { return !v.certified; });
  if (doubtful != axis.vertices.end())
    out.warnings.push_back(fmt::format("The disc around the vertex at {} could not be certified to hold no boundary.",
                                       placeText(doubtful->at)));
  out.shape = std::move(axis);
  return out;
}

}  // namespace

FeatureType medialAxisFeature() {
  using P = MedialAxisParameters;
  return feature<P>("pocket.medial-axis", "Medial axis", "The centres of the largest discs that a part holds.")
      .icon("medial-axis")
      .produces({ShapeKind::MedialAxis})
      .input(partInput("an outline to find the medial axis of"))
      .parameter("face", &P::face, partFace(), partFaceHelp)
      .parameter("skip-open", &P::skipOpen, flag(), skipOpenHelp)
      .parameter("tolerance", &P::tolerance, positiveLength(),
                 "Largest error of the axis; lower bumps of a smooth outline have no branch.")
      .example("blossom medial-axis outline.svg -o axis.dxf")
      .example("blossom medial-axis text:Blossom -o axis.svg --json")
      .example("blossom medial-axis block.step --face 4 -o axis.svg")
      .evaluate(medialAxisOf);
}

}  // namespace blossom::pocket
