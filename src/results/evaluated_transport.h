#pragma once
#include <filesystem>

#include "feature/feature_type.h"

namespace blossom {

/// A result of a feature as JSON and files in `folder` whose names start with `name`: its shape, statistics, warnings and
/// figures. @throws Error as saveShape.
Value saveEvaluated(const Evaluated&, const std::filesystem::path& folder, const std::string& name);
/// @throws Error Internal, nlohmann::json::exception when it is not what saveEvaluated writes.
Evaluated loadEvaluated(const Value&, const std::filesystem::path& folder);

}  // namespace blossom
