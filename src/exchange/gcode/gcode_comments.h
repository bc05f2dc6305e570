#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "exchange/gcode/gcode_program.h"

/// Comments of G-code, and the data that Blossom writes into the comments of its own programs (see gcode_write.cpp).
namespace blossom {

/// mm, limit of coordinates and radii: no machine is larger, and arcs of such radii are straight up to rounding.
inline constexpr double maximumGcodeCoordinate = 1e7;

struct GcodeLine {
  std::string code;                   ///< upper case, without blanks
  std::vector<std::string> comments;  ///< texts in parentheses
  bool tapeMark = false;              ///< nothing but "%": begin or end of a program
  bool nested = false;                ///< nested parentheses: controls disagree about where such a comment ends
};

/// Splits a line into code and comments; comments are "(..)" and everything after ";" or "%".
GcodeLine withoutComments(std::string_view line);

/// Reads the data in a comment of Blossom's own programs: "tool T 1 diameter 6 corner 0 angle 0", "stock X 0 100 Y 0 60 Z -4
/// 0", "passes 3", "part X 0 Y 0 Z 0 depth 4 wall 0 floor 0". Ignores other comments.
void readComment(const std::string& comment, GcodeProgram&);

}  // namespace blossom
