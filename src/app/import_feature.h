#pragma once
#include <filesystem>
#include <string_view>

#include "exchange/format/format.h"
#include "feature/registry.h"

namespace blossom {

/// The feature type `exchange.import` (command `import`): a shape read from a file. Its parameters are `file` and, for every
/// format with read options, a record of them named by the id of the format: `control-points` {"degree-u", "degree-v"}.
FeatureType importFeature(const FormatRegistry&);

/// Whether a parameter of the import affects that file: false for the options of other formats.
bool importUses(const FormatRegistry&, std::string_view parameter, const std::filesystem::path& file);

}  // namespace blossom
