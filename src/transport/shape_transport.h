#pragma once
#include <filesystem>
#include <string>

#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom {

/// Hands a shape to another process of the same build: B-reps, meshes, medial axes and toolpaths as binary files in `folder`
/// whose names start with `name`, sequences as their frames, everything else as JSON. Names, colours, layers and the
/// structure of assemblies are kept, numbers are exact, sub-shapes keep their numbers. Not an exchange format.
/// @throws Error InvalidInput for empty shapes and toolpaths with a function `gougeOf`, FileUnwritable.
Value saveShape(const Shape&, const std::filesystem::path& folder, const std::string& name);

/// Inverse of saveShape. @throws Error Internal when a file is not what saveShape writes.
Shape loadShape(const Value&, const std::filesystem::path& folder);

}  // namespace blossom
