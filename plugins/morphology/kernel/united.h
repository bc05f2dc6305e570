#pragma once
#include "kernel/exact.h"

namespace blossom::morphology {

/// The same solid with overlapping bodies united, so that its surface has no intersections.
Solid united(const Solid&);

}  // namespace blossom::morphology
