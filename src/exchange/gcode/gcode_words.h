#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

/// A letter and what follows it.
struct GcodeWord {
  char letter;
  std::optional<double> value;  ///< empty for parameters and expressions, which are not evaluated
  std::string_view digits;      ///< as they stand in the line
};

struct GcodeWords {
  std::vector<GcodeWord> words;
  bool polar = false;  ///< LinuxCNC's @ and ^ were among them
  std::string damage;  ///< why the line is none; empty when it is
};

/// The words of a line without blanks and comments; their digits are views of it.
GcodeWords gcodeWords(std::string_view line);

/// Whether the letter's number is a length.
inline bool isLength(char letter) { return std::string_view("XYZIJKR").find(letter) != std::string_view::npos; }

}  // namespace blossom
