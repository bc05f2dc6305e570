#pragma once
#include <optional>
#include <string>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom {

/// Why the volume of a closed mesh (see measure) is not that of the space it encloses, as a sentence with a place: faces
/// that intersect, or a body that lies within another and looks outwards like it, so that its space counts twice. Nothing
/// for open meshes, which have no volume. O(n log n), and O(n) more for every body whose box lies within that of another.
/// @throws Error Cancelled.
std::optional<std::string> countedTwice(const Mesh&, const Progress& = Progress::none());

}  // namespace blossom
