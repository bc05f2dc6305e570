#pragma once
#include "geometry/measure/measure_between.h"
#include "geometry/measure/part_form.h"

namespace blossom {

/// Adds what two parts are to one another beside their distance: angle, distances of planes, axes and centres. Where they
/// touch at an angle, the angle comes first and is drawn.
void addRelation(Measurement&, const PartGeometry&, const PartGeometry&, const FootPoints&);

}  // namespace blossom
