#pragma once
#include <filesystem>
#include <string>

#include "geometry/mesh/mesh.h"
#include "parameter/value.h"

namespace blossom {

/// A mesh as a binary file NAME.mesh in `folder`, with its name, colour and further tags in the value that names the file.
/// @throws Error FileUnwritable.
Value saveMesh(const Mesh&, const std::filesystem::path& folder, const std::string& name);
/// @throws Error Internal when the file is not what saveMesh writes.
Mesh loadMesh(const Value&, const std::filesystem::path& folder);

}  // namespace blossom
