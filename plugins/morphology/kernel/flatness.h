#pragma once

namespace blossom::morphology {

/// Shares of a solid's size up to which a bend counts as rounding. Operands lie on a grid of 2^-44 of their size, which
/// bends the faces of a tilted box by 3e-13; each step after it allows for what the one before may have added.
inline constexpr double joinedPartsFlatness = 1e-12;  ///< two convex parts whose hull adds no more than this become one
inline constexpr double joinedFacesFlatness = 2e-12;  ///< triangles of one face, vertices of one edge
inline constexpr double hullFlatness = 4e-12;         ///< a solid dented by no more than this is taken for its hull

}  // namespace blossom::morphology
