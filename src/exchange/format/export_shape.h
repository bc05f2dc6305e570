#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// What is to be said about a file that was written.
struct ExportReport {
  std::optional<double> gouge;        ///< mm, of a program as it stands in the file, where the part is known
  std::vector<std::string> warnings;  ///< full sentences
};

/// Writes a shape as writeShape does and tells what the file is worth: a program is read back and measured against its
/// part; numbers too short for where a shape lies are told; unless `chordGiven`, the chord of a large shape is raised until
/// its triangles stay affordable (see affordableChord).
/// @throws Error as writeShape and checkWritten do.
ExportReport exportShape(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Value& options,
                         bool chordGiven, const Progress& = Progress::none());

}  // namespace blossom
