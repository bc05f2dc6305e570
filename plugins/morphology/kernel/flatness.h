#pragma once

namespace blossom::morphology {

/// Fractions of a solid's size up to which a bend counts as rounding. Operands are rounded to doubles or to a
/// grid of 2^-44 of their size, which bends the faces of a tilted box by 3e-13; each later step allows for what the step
/// before may have added.
inline constexpr double joinedFacesFlatness = 2e-12;  ///< for triangles of one face and vertices of one edge
inline constexpr double hullFlatness = 4e-12;         ///< a solid with dents up to this is replaced by its hull
/// Bodies, voids and gaps that are thinner may come from rounding, and be turned inside out by it: they go without a word.
inline constexpr double thicknessOfRounding = 1e-12;

}  // namespace blossom::morphology
