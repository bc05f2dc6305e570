#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// What a file is worth that was just written.
struct WrittenCheck {
  double gouge = 0;                   ///< mm, by the program as it stands in the file
  std::vector<std::string> warnings;  ///< full sentences
};

/// Reads a program back from its file and measures it against the part that its toolpath was made for; nothing for other
/// shapes, and where the part is not known.
/// @throws Error as readShape does, Cancelled.
std::optional<WrittenCheck> checkWritten(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Progress&);

}  // namespace blossom
