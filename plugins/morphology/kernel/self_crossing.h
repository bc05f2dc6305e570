#pragma once
#include <string>

#include "core/progress.h"
#include "kernel/solid_check.h"

namespace blossom::morphology {

/// The same closed surface without triangles of zero area: their edges are flipped or collapsed.
/// @throws Error InvalidInput with the place where that is impossible.
Mesh withoutDegenerate(const Mesh& triangles, const Subject& subject);

/// Tests exactly whether triangles intersect outside common vertices and edges. Bodies that overlap each other, or have
/// faces within `near` of each other, only cause a warning; their triangles are unchanged. O(n log n) plus the number of
/// intersections.
/// @throws Error InvalidInput with the place of the first intersection within a shell, or with the shell of a void.
void refuseCrossing(CheckedSolid&, double near, const Subject& subject, const Progress&);

}  // namespace blossom::morphology
