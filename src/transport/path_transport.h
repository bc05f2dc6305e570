#pragma once
#include <filesystem>
#include <string>

#include "geometry/planar/medial_axis.h"
#include "geometry/shape/toolpath.h"
#include "parameter/value.h"

namespace blossom {

/// A toolpath as JSON and a binary file in `folder` whose name starts with `name`. All but `gougeOf`, which is a function.
/// @throws Error FileUnwritable.
Value saveToolpath(const Toolpath&, const std::filesystem::path& folder, const std::string& name);
/// @throws Error Internal when a file is not what saveToolpath writes.
Toolpath loadToolpath(const Value&, const std::filesystem::path& folder);

/// A medial axis in the same way.
Value saveMedialAxis(const MedialAxis&, const std::filesystem::path& folder, const std::string& name);
MedialAxis loadMedialAxis(const Value&, const std::filesystem::path& folder);

}  // namespace blossom
