#pragma once
#include <filesystem>
#include <string>

#include "geometry/shape/brep.h"
#include "parameter/value.h"

namespace blossom {

/// A B-rep as one binary file NAME.brep of OCCT in `folder` (sharing is kept), with names, colours and the structure of
/// assemblies in the value that names the file. Fast: 1 to 2 ms per MB of STEP.
/// @throws Error InvalidInput when it is empty, FileUnwritable.
Value saveBrep(const Brep&, const std::filesystem::path& folder, const std::string& name);
/// @throws Error Internal when the file is not what saveBrep writes.
Brep loadBrep(const Value&, const std::filesystem::path& folder);

/// Rows of the 3x4 matrix; null for the identity.
Value locationValue(const gp_Trsf&);
gp_Trsf toLocation(const Value&);

}  // namespace blossom
