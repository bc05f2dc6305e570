#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

/// A letter and its number.
struct GcodeWord {
  char letter;
  std::optional<double> value;  ///< empty for parameters and expressions, which are not evaluated
  std::string_view digits;      ///< as written
};

struct GcodeWords {
  std::vector<GcodeWord> words;
  bool polar = false;  ///< LinuxCNC's @ and ^ were among them
  std::string damage;  ///< why the line cannot be read; empty when it can
};

/// The words of a line without blanks and comments. Their `digits` are views of the line.
GcodeWords gcodeWords(std::string_view line);

/// Whether the number after this letter is a length.
inline bool isLength(char letter) { return std::string_view("XYZIJKR").find(letter) != std::string_view::npos; }

}  // namespace blossom
