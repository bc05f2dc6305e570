#pragma once
#include "kernel/operations/work.h"

namespace blossom::morphology {

/// {x : x + element inside solid} as triangles about the difference of their centres; without faces when nothing of volume
/// remains. @pre the bodies of the solid do not meet
Mesh eroded(Work&, const Prepared& solid, const Prepared& element, const CommonGrid&, double from, double to);

}  // namespace blossom::morphology
