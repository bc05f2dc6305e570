#pragma once
#include "app/app.h"
#include "document/document.h"

/// The figures 1 to 6 of Lee, Lee, Kim & Kim 2002 as documents. Figures 5 (f) and 7 are phi-to-flower and triangle-to-star.
namespace blossom::samples {

/// A + A is 2 A for a triangle, but not for a star.
Document figure1(const App&);
/// A star added to itself 1 to 10 times, divided by as much: it tends to its hull.
Document figure2(const App&);
/// How the sum of a flower and a butterfly comes about: swept along the outer boundary and along the hole.
Document figure3(const App&);
/// A triangle becomes a square; its centre runs along the line between the centres.
Document figure4(const App&);
/// Five pairs: convex ones, a convex and a concave one, turned stars, a flipped one, a turned one without symmetry.
Document figure5(const App&);
/// A triangle becomes a square, rounded on its way by a circle, with the three morphs of two shapes beside.
Document figure6(const App&);

}  // namespace blossom::samples
