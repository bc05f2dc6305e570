#pragma once
#include "core/progress.h"
#include "geometry/mesh/mesh.h"

namespace blossom::morphology {

/// Faces over shared points: equal places are one vertex, and faces that have lost their area that way are gone, as are two
/// that lie on each other back to back. Some points may be unused. O(n log n). @throws Error Cancelled.
Mesh collapsed(const Mesh&, const Progress& = Progress::none());

}  // namespace blossom::morphology
