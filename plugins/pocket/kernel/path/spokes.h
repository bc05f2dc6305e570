#pragma once
#include "kernel/path/pass.h"

namespace blossom::pocket {

/// Adds to the nodes the parts of the medial axis that no pass comes near enough to (see passTree).
void addSpokes(const ClearanceDiagram&, const PassOptions&, PassTree&, const Progress&);

}  // namespace blossom::pocket
