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

/// The solids as one mesh, or as a sequence over `times` when there are any.
Evaluated evaluatedFrom(MorphologyResult, const std::vector<double>& times = {});

/// For every feature that takes solids: how far a curved one may lie from its polyhedron.
inline constexpr const char* deviationHelp =
    "Largest distance between a curved solid or curve and the polyhedron made of it.";

/// 0, 1/(n-1), .., 1.
std::vector<double> frameTimes(int frames);

}  // namespace blossom::morphology
