#pragma once
#include <filesystem>
#include <string_view>

#include "exchange/format/format.h"
#include "feature/registry.h"

namespace blossom {

/// The feature type `exchange.import` (command `import`): a shape read from a file. Parameter `file`, and for every format
/// whose reader has options a record of them under the id of the format: `control-points` {"degree-u", "degree-v"}.
FeatureType importFeature(const FormatRegistry&);

/// Whether a parameter of the import says anything about that file: false for the options of another format.
bool importUses(const FormatRegistry&, std::string_view parameter, const std::filesystem::path& file);

}  // namespace blossom
