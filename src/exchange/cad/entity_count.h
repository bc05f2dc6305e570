#pragma once
#include "geometry/shape/brep.h"
#include "parameter/value.h"

namespace blossom {

/// What is in a Brep, each part counted once however often it is used: {"part": n, "assembly": n, "solid": n, "face": n,
/// ..}; kinds that do not occur are left out.
Value countEntities(const Brep&);

}  // namespace blossom
