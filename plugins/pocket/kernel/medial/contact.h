#pragma once
#include <optional>

#include "kernel/medial/boundary.h"
#include "kernel/medial/voronoi_graph.h"

namespace blossom::pocket {

/// What a disc touches: a true curve near a parameter, or a point.
struct Contact {
  const TrueCurve* curve = nullptr;  ///< nullptr: the point
  double parameter = 0;
  Vec2 point = Vec2::Zero();
  double margin = 0;  ///< parameters by which a foot may lie beyond the end of the curve
};

/// The contact of a disc around x that touches this site of the flattened boundary. Vertices which only the flattening made,
/// and those where one curve goes on as another, belong to the curve that begins there.
Contact contactOf(const Boundary&, const Site&, const Vec2& x);

/// Foot of x on the contact, whose parameter follows.
Vec2 footOn(Contact&, const Vec2& x);

/// The point at distance d from both contacts next to the guess, by Newton's iteration in the plane. Nothing when it does
/// not settle within `reach` mm, as where the contacts pull almost the same way.
std::optional<Vec2> pointAtDistance(Contact a, Contact b, double d, const Vec2& guess, double reach);

/// The point next to the guess that is as far from a as from b, moved straight across the bisector.
std::optional<Vec2> pointBetween(Contact a, Contact b, const Vec2& guess, double reach);

struct Disc {
  Vec2 center;
  double radius = 0;
};
/// The disc that touches all of the contacts (three or more; least squares when there are more).
std::optional<Disc> discTouching(std::vector<Contact> contacts, const Disc& guess, double reach);

}  // namespace blossom::pocket
