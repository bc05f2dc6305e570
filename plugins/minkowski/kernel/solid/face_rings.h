#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

namespace blossom::minkowski {

/// A side of a face: number of the face and of two corners, with the face to its left seen from outside.
struct FaceSide {
  int face = 0, from = 0, to = 0;
  friend auto operator<=>(const FaceSide&, const FaceSide&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The boundary of faces as rings of corners, each corner once in a ring.
using CornerRing = std::vector<int>;
struct RingsOfFace {
  Vec3 normal = Vec3::Zero();  ///< its length is the area
  std::vector<CornerRing> rings;
};

/// Without sides of one face that run there and back.
std::vector<FaceSide> withoutPairs(std::vector<FaceSide>);
/// Faces that lie within `tolerance` of the plane of a larger one beside them become part of it.
void joinFlat(std::vector<FaceSide>&, std::span<const Vec3> points, double tolerance, const Progress&);
/// The rings of every face that has sides; where a face touches itself in a corner, its parts have rings of their own.
/// @throws Error Internal when sides do not close.
std::vector<RingsOfFace> ringsOf(std::span<const FaceSide>, std::span<const Vec3> points, const Progress&);
/// Leaves out corners that lie between just two others, on the straight line through them.
void dropStraightCorners(std::vector<RingsOfFace>&, std::span<const Vec3> points, double tolerance);
/// Removes rings that run along one another in opposite directions: what they bound has no thickness.
void dropBackToBack(std::vector<RingsOfFace>&);

}  // namespace blossom::minkowski
