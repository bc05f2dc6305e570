#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "geometry/planar/polygons/polygons.h"

/// Solids over a flat section, whose sums are those of their sections and of their heights: what is extruded along an axis
/// of the coordinates, plates, bars and boxes among it.
namespace blossom::morphology {

struct Prism {
  int axis = 2;              ///< 0, 1, 2: along x, y, z
  planar::Polygons section;  ///< of the two coordinates after that of the axis, in turn: y, z for x
  double low = 0, high = 0;  ///< mm, where the ends are along the axis
};

/// The solid as a prism along every axis along which it is one: its faces are flat ends and walls parallel to the axis,
/// within two steps, which is what rounding does to them, and no parts or gaps of it are thinner than some. Sections are
/// rounded to multiples of `step`. O(n log n).
/// @pre closed, oriented triangles without crossings, with coordinates of at most 2^46 steps
std::vector<Prism> prismsOf(const Mesh& triangles, double step, const Progress& = Progress::none());

/// Times a factor above 0, about the origin.
Prism scaled(const Prism&, double factor);

/// A + B of prisms along one axis. O(s) for the planar sum of the sections. @throws Error as planar::sum
Prism sum(const Prism& a, const Prism& b, const Progress& = Progress::none());

/// {x : x + B inside A}; nothing where that has no volume. @throws Error as planar::difference
std::optional<Prism> difference(const Prism& a, const Prism& b, const Progress& = Progress::none());

/// Closed, oriented triangles, each corner of the section once at either end. O(n log n).
Mesh trianglesOf(const Prism&, const Progress& = Progress::none());

}  // namespace blossom::morphology
