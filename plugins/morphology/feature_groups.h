#pragma once
#include <functional>

#include "feature/registry.h"
#include "kernel/morphology.h"

namespace blossom::morphology {

void registerBall(Registry&);
void registerSums(Registry&);
void registerMorph(Registry&);
void registerGrowth(Registry&);

/// Evaluated in a worker, for exact arithmetic cannot poll: the way that `make` makes it for the first, and beside it for
/// the second when that takes long.
FeatureType inWorkers(const std::function<FeatureType(Way)>& make, std::string activity);

/// The solids as one mesh, or as a sequence when `times` is not empty.
Evaluated evaluatedFrom(MorphologyResult, const std::vector<double>& times = {});

/// Help text of the deviation parameter of every feature with solids as inputs.
inline constexpr const char* deviationHelp =
    "Largest distance between a curved solid or curve and the polyhedron made of it.";

/// 0, 1/(n-1), .., 1.
std::vector<double> frameTimes(int frames);

}  // namespace blossom::morphology
