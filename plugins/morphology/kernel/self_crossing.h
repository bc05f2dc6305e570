#pragma once
#include <string>

#include "core/progress.h"
#include "kernel/solid_check.h"

namespace blossom::morphology {

/// The same closed surface without triangles that have no area: their edges are flipped or collapsed.
/// @throws Error InvalidInput with the place where that is impossible.
Mesh withoutDegenerate(const Mesh& triangles, const Subject& subject);

/// Looks for triangles that cross or touch each other elsewhere than in common vertices and edges, exactly. Bodies that
/// overlap each other as wholes are marked by a warning, their triangles stay as they are. O(n log n) and the crossings.
/// @throws Error InvalidInput with the place of the first crossing within a shell, or with the shell of a void.
void refuseCrossing(CheckedSolid&, const Subject& subject, const Progress&);

}  // namespace blossom::morphology
