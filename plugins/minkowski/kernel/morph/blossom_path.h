#pragma once
#include <cstddef>
#include <span>

#include "kernel/morph/evaluation_order.h"

namespace blossom::minkowski {

/// A path t_1(u) .. t_n(u) through the arguments of a blossom: straight from each point to the next, and as long on each of
/// these ways as on every other, whatever their lengths.
/// @throws Error InvalidParameter: a point that has not one number for each shape after the first, numbers outside 0..1.
void checkPath(std::span<const Arguments> points, std::size_t shapes);

/// The point at u, 0 at the first and 1 at the last. Points themselves come out as they are, and numbers that are equal at
/// both ends of a way stay equal along it, so a path on the diagonal gives the ordinary morph. @pre there is a point
/// @throws Error InvalidParameter for a u outside 0..1. O(n)
Arguments pointOfPath(std::span<const Arguments> points, double u);

}  // namespace blossom::minkowski
