#pragma once
#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

#include "geometry/shape/shape.h"
#include "parameter/binding.h"

namespace blossom::modeling {

/// What a sweeping feature moves: faces when `fill` and the outline is closed, else wires. Of a B-rep with solids `face`
/// says which face; -1 takes the whole of a sheet.
/// @throws Error InvalidInput naming the place where an outline crosses itself or is open among closed ones.
TopoDS_Shape profileShape(const Shape&, const SubShapeValue& face, bool fill);

/// For sides that can lean exactly over lines and arcs only: free-form parts of a drawing are made into chords, with a
/// warning that says how far off they are. (Arcs would be fewer, but OCCT takes minutes where cones nearly touch.) Other
/// shapes stay as they are.
Shape withoutSplines(const Shape&, std::vector<std::string>& warnings);

/// The numbers of sub-shapes picked on the one input of a feature.
std::vector<int> numbersOf(const std::vector<SubShapeValue>&);

}  // namespace blossom::modeling
