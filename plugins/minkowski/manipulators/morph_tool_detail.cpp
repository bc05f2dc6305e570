// What follows the hand where the morph itself takes too long.
#include <vtkProp.h>

#include <algorithm>

#include "feature/registry.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/morph/point_shape.h"
#include "manipulators/coarse_morph.h"
#include "manipulators/morph_tool.h"

namespace blossom::minkowski {

using namespace planar;

/// In mm, as coarse as every control shape allows where it is not scaled up.
double MorphTool::coarseTolerance() const {
  double finest = coarsestTolerance;
  for (std::size_t i = 0; i < controls_.size(); ++i)
    if (!controls_[i].region.loops.empty() && !pointIn(controls_[i].region))
      finest = std::min(finest, timesAsCoarse * std::min(1.0, placements_[i].scale) * defaultTolerance(controls_[i].region));
  return finest;
}

/// Frames that others take stay as many as they are, for these may take those of another sequence beside them.
Document MorphTool::coarser(const Document& exact) const {
  const int most = drawingPath_ ? ghostFrames : fewFrames;
  Feature morph = exact.at(feature());
  const auto& features = exact.features();
  const bool taken = std::any_of(features.begin(), features.end(), [&](const auto& other) {
    return std::find(other->inputs.begin(), other->inputs.end(), feature()) != other->inputs.end();
  });
  const Value parameters = completed(host().registry().at(morph.type)->parameters, morph.parameters);
  morph.parameters = coarseParameters(parameters, coarseTolerance());
  const int frames = parameters.at("frames").get<int>();
  if (frames > most && !taken)
    morph.parameters = fewerFrames(morph.parameters, most, host().shownFrame(frames), host().shownFrame(most));
  return exact.with(std::move(morph));
}

}  // namespace blossom::minkowski
