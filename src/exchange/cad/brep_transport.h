#pragma once
#include <filesystem>

#include "geometry/shape/brep.h"
#include "parameter/value.h"

namespace blossom {

/// Writes a Brep to a folder, from which another process can load it: the shapes as one binary file of OCCT (sharing is
/// kept), names, colours and assembly structure as JSON that points into it. Fast: 1 to 2 ms per MB of STEP. Not an exchange
/// format: both sides must be of the same build.
void saveBrep(const Brep&, const std::filesystem::path& folder);

/// Inverse of saveBrep. @throws Error Internal when the files are not what saveBrep writes.
Brep loadBrep(const std::filesystem::path& folder);

/// What is in a Brep, each part counted once however often it is used: {"part": n, "assembly": n, "solid": n, "face": n,
/// ..}; kinds that do not occur are left out.
Value countEntities(const Brep&);

}  // namespace blossom
