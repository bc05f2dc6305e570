#pragma once
#include <optional>

#include "kernel/medial/boundary.h"
#include "kernel/medial/voronoi_graph.h"

namespace blossom::pocket {

/// An object that a disc touches: a true curve near a parameter, or a point.
struct Contact {
  const TrueCurve* curve = nullptr;  ///< nullptr: the point
  double parameter = 0;
  Vec2 point = Vec2::Zero();
  double margin = 0;  ///< range of the parameter beyond the ends of the curve in which a foot is accepted
};

/// The contact of a disc around x that touches this site of the flattened boundary. Vertices added by the flattening, and
/// those where one curve continues another smoothly, belong to the curve that begins there.
Contact contactOf(const Boundary&, const Site&, const Vec2& x);

/// Foot of x on the contact; updates the contact's parameter.
Vec2 footOn(Contact&, const Vec2& x);

/// The point at distance d from both contacts near the guess, by Newton's iteration in the plane. Empty when it does not
/// converge within `reach` mm, as where the contacts have nearly the same direction.
std::optional<Vec2> pointAtDistance(Contact a, Contact b, double d, const Vec2& guess, double reach);

/// The point near the guess that is equidistant from a and b, moved perpendicular to the bisector.
std::optional<Vec2> pointBetween(Contact a, Contact b, const Vec2& guess, double reach);

struct Disc {
  Vec2 center;
  double radius = 0;
};
/// The disc that touches all contacts (three or more; by least squares when there are more than three).
std::optional<Disc> discTouching(std::vector<Contact> contacts, const Disc& guess, double reach);

}  // namespace blossom::pocket
