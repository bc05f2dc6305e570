#pragma once
#include <filesystem>

#include "app/app.h"

/// Samples as documents, whose trees hold the edits.
namespace blossom::sweep::samples {

/// Yoon & Lee 2009, Fig. 7 a to f, and the same way as frames.
void writeFigureSeven(const App&, const std::filesystem::path& folder);
/// Figs. 1 and 3 to 6; Fig. 2 is the motion file `swept-point.json`, which must be in the folder.
void writeFigures(const App&, const std::filesystem::path& folder);
/// A tower, a blade with its hub, a scarf.
void writeThings(const App&, const std::filesystem::path& folder);

}  // namespace blossom::sweep::samples
