#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// Result of the check of a written file.
struct WrittenCheck {
  double gouge = 0;                   ///< mm, measured on the program as written
  std::vector<std::string> warnings;  ///< full sentences
};

/// Reads a written program back and measures it against the part of its toolpath; empty for other shapes and when the part
/// is not known.
/// @throws Error as readShape, Cancelled.
std::optional<WrittenCheck> checkWritten(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Progress&);

}  // namespace blossom
