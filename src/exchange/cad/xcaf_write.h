#pragma once
#include <TDocStd_Document.hxx>

#include "geometry/shape/brep.h"
#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom {

/// The Brep of a shape that a STEP, IGES or BREP file can store: faces for surfaces, regions and meshes, edges and wires for
/// curves. A surface becomes one face with the same parametrisation and knots, a medial axis polylines in space (see
/// heightsOption).
/// @throws Error LimitExceeded for a mesh of more than 100,000 faces; OutputNotSupported for other kinds; errors of toOcct.
Brep toBrep(const Shape&, const Value& options);
/// The kinds that toBrep takes.
std::vector<ShapeKind> brepKinds();

/// An XCAF document with the structure, names and colours of a Brep; lengths in mm. Parts without geometry are left out.
/// @throws Error InvalidInput when there is no geometry at all.
Handle(TDocStd_Document) toDocument(const Brep&);

}  // namespace blossom
