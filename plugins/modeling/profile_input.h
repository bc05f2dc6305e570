#pragma once
#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

#include "geometry/shape/shape.h"
#include "parameter/binding.h"

namespace blossom::modeling {

/// The profile of a sweeping feature: faces when `fill` and the outline is closed, else wires. `face` chooses the face of a
/// B-rep with solids; -1 means the whole of a sheet.
/// @throws Error InvalidInput naming the place where an outline crosses itself or is open among closed ones.
TopoDS_Shape profileShape(const Shape&, const SubShapeValue& face, bool fill);

/// Replaces the free-form parts of a drawing by chords, with a warning that states the deviation, because only sides of
/// lines and arcs can be tapered exactly. (Arcs would be fewer, but OCCT takes minutes where cones nearly touch.) Other
/// shapes are unchanged.
Shape withoutSplines(const Shape&, std::vector<std::string>& warnings);

}  // namespace blossom::modeling
