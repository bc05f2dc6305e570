#pragma once
#include "geometry/measure/measure_between.h"
#include "geometry/measure/part_form.h"

namespace blossom {

/// Adds the figures of two parts other than their distance: angle, distances of planes, axes and centres. Where the parts
/// touch at an angle, the angle comes first and is drawn.
void addRelation(Measurement&, const PartGeometry&, const PartGeometry&, const FootPoints&);

}  // namespace blossom
