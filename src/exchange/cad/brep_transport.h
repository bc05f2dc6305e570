#pragma once
#include <filesystem>

#include "geometry/shape/brep.h"
#include "parameter/value.h"

namespace blossom {

/// Writes a Brep to a folder, from which another process loads it: the shapes as one binary file of OCCT (sharing is kept),
/// names, colours and assembly structure as JSON with indices into that file. Takes 1 to 2 ms per MB of STEP. Not an
/// exchange format: both processes must be of the same build.
void saveBrep(const Brep&, const std::filesystem::path& folder);

/// Inverse of saveBrep. @throws Error Internal when the files were not written by saveBrep.
Brep loadBrep(const std::filesystem::path& folder);

/// Number of entities of a Brep by type, each part counted once however often it is used: {"part": n, "assembly": n,
/// "solid": n, "face": n, ..}; types that do not occur are left out.
Value countEntities(const Brep&);

}  // namespace blossom
