#pragma once
#include <optional>
#include <string>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom {

/// Why the volume of a closed mesh (see measure) is not that of the space it encloses, as a sentence with a place. That
/// volume is the integral of the winding number, so it is right where that number is 0 or 1 everywhere: bodies that
/// intersect, bodies within others that look outwards like them, and bodies that are inside out are told; bodies that only
/// touch, however much, are not. Nothing for open meshes, which have no volume. O(n log n) and about O(log n) for every body
/// and every place where faces meet. @throws Error Cancelled.
std::optional<std::string> volumeDoubt(const Mesh&, const Progress& = Progress::none());

}  // namespace blossom
