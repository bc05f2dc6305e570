#pragma once
#include "geometry/planar/medial_axis.h"
#include "parameter/value.h"

namespace blossom {

/// {"vertices": [{"at", "clearance", "certified"}], "edges": [{"from", "to", "points": [[x, y, clearance]], "feet":
/// [[{"loop", "segment", "parameter", "at"}, ..]]}]}: of each point of an edge the feet to the left and to the right.
/// Numbers count from 0.
Value axisJson(const MedialAxis&);

}  // namespace blossom
