#pragma once
#include <filesystem>

#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom {

/// Hands a shape to another process of the same build: regions, curves and motions as JSON, B-reps and meshes as binary
/// files in `folder` whose names start with `name`, sequences as their frames. Names, colours and layers stay behind;
/// numbers are exact, sub-shapes keep their numbers.
/// @throws Error InvalidInput for kinds that are not handed over, FileUnwritable.
Value saveShape(const Shape&, const std::filesystem::path& folder, const std::string& name);
Shape loadShape(const Value&, const std::filesystem::path& folder);

}  // namespace blossom
