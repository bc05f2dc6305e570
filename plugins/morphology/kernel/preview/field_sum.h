#pragma once
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// A shape times a factor above 0, for a preview: closed triangles, or pieces of what is thinner.
struct PreviewTerm {
  const Mesh& triangles;
  std::span<const std::vector<Vec3>> pieces;
  double factor = 1;
};

/// About where a + b is, for pictures while something is dragged: the contour of
///
///     min( min over b on the boundary of B of d_A(x - b),  min over a on the boundary of A of d_B(x - a) ),
///
/// where d is a signed distance, on a grid of so many cells along the longest side. A place belongs to the sum when the
/// boundary of one shape, reflected and moved there, meets the other shape. Samples of the boundaries lie a cell apart and
/// are searched in trees of balls, as distances change no faster than places. Off by about a cell; what is thinner than that
/// may be lost where both shapes are so thin. Triangles of the solid a; b may be thin.
/// O(cells^3 + faces + samples). @throws Error Cancelled.
Mesh fieldSum(const PreviewTerm& a, const PreviewTerm& b, int cells, const Progress&);

}  // namespace blossom::morphology
