#pragma once
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Whether triangles are the surface of a convex solid, seen from outside counter-clockwise, and each of their points one of
/// its corners: then they are closed, cross nowhere and are their own hull. All signs are exact, so rounding that makes the
/// surface ever so slightly hollow makes it false; it may also be false where all faces are slivers. O(n log n), in place of
/// the hull itself.
///
/// Seen from a point behind all faces, closed and oriented triangles cover the sphere of directions everywhere equally
/// often; if a ray meets one face only, inside and with no other one's edge on it, they do so once and cross nowhere. With
/// no reflex edge they are convex (Mehlhorn, Naeher, Schilz, Schirra, Seel, Seidel & Uhrig, "Checking geometric programs or
/// verification of geometric structures", 1999).
bool isConvexSurface(const Mesh&);

}  // namespace blossom::morphology
