#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// Findings about a written file.
struct ExportReport {
  std::optional<double> gouge;        ///< mm, measured on the program as written, when its part is known
  std::vector<std::string> warnings;  ///< full sentences
};

/// Writes a shape as writeShape and checks each of its files: a program is read back and measured against its part, and a
/// warning says when coordinates have too few digits for the position of the shape. Unless `chordGiven`, the chord of a
/// large shape is raised until the number of triangles is acceptable (see affordableChord).
/// @throws Error as writeShape and checkWritten.
ExportReport exportShape(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Value& options,
                         bool chordGiven, const Progress& = Progress::none());

}  // namespace blossom
