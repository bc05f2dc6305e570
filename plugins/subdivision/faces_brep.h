#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/brep.h"
#include "geometry/surface.h"

namespace blossom::subdivision {

/// Faces sewn together where they meet; a solid when they close. @throws Error Degenerate when OCCT fails, Cancelled.
Brep brepOf(const std::vector<Surface>&, const std::string& name, const Progress&);

}  // namespace blossom::subdivision
