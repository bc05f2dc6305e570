#pragma once
#include <string>
#include <vector>

#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/winding/nesting.h"

/// What is refused of the loops of a shape. @param name of the shape, which begins the sentence
namespace blossom::planar {

[[noreturn]] void refuseTwice(const Vec2& place, const std::string& name);
void refuseTwice(const std::vector<Loop>&, const std::string& name);
void refuseStrayHole(const Nesting&, const std::vector<Loop>&, const std::string& name);
/// @param confusion mm, below which a width is none
void refuseEmptyLoops(const std::vector<Loop>&, double confusion, const std::string& name);
/// @param size mm, of the shape
void refuseCollapsed(const Nesting&, const std::vector<Loop>&, double size, const std::string& name);

}  // namespace blossom::planar
