#pragma once
#include "feature/registry.h"
#include "kernel/morphology.h"

namespace blossom::morphology {

void registerBall(Registry&);
void registerSums(Registry&);
void registerMorph(Registry&);
void registerGrowth(Registry&);

/// The solids as one mesh, or as a sequence when `times` is not empty.
Evaluated evaluatedFrom(MorphologyResult, const std::vector<double>& times = {});

/// Help text of the deviation parameter of every feature with solids as inputs.
inline constexpr const char* deviationHelp =
    "Largest distance between a curved solid or curve and the polyhedron made of it.";

/// 0, 1/(n-1), .., 1.
std::vector<double> frameTimes(int frames);

}  // namespace blossom::morphology
