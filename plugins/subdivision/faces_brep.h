#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/bspline/surface.h"
#include "geometry/shape/brep.h"

namespace blossom::subdivision {

/// Faces sewn together where they meet; a solid when they close. @throws Error Degenerate when OCCT fails, Cancelled.
Brep brepOf(const std::vector<Surface>&, const std::string& name, const std::optional<Color>&, const Progress&);

}  // namespace blossom::subdivision
