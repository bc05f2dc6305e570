#pragma once
#include <TopoDS_Shape.hxx>

#include "geometry/shape.h"
#include "parameter/binding.h"

namespace blossom::modeling {

/// What a sweeping feature moves: faces when `fill` and the outline is closed, else wires. Of a B-rep with solids `face`
/// says which face; -1 takes the whole of a sheet.
/// @throws Error InvalidInput naming the place where an outline crosses itself or is open among closed ones.
TopoDS_Shape profileShape(const Shape&, const SubShapeValue& face, bool fill);

/// The numbers of sub-shapes picked on the one input of a feature.
std::vector<int> numbersOf(const std::vector<SubShapeValue>&);

}  // namespace blossom::modeling
