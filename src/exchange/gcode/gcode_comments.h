#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "exchange/gcode/gcode_program.h"

/// Comments of G-code, and what Blossom writes into those of its own programs (see gcode_write.cpp).
namespace blossom {

/// mm; no machine is larger, and arcs of such radii are straight to rounding.
inline constexpr double farthestInGcode = 1e7;

struct GcodeLine {
  std::string code;                   ///< without blanks, in capitals
  std::vector<std::string> comments;  ///< what stands in parentheses
  bool nested = false;                ///< a parenthesis within one: controls do not agree where such a comment ends
};

/// Takes "(..)" and everything after ";" or "%" out of a line.
GcodeLine withoutComments(std::string_view line);

/// "tool T 1 diameter 6 corner 0 angle 0", "stock X 0 100 Y 0 60 Z -4 0", "passes 3",
/// "part X 0 Y 0 Z 0 depth 4 wall 0 floor 0". Others are left alone.
void readComment(const std::string& comment, GcodeProgram&);

}  // namespace blossom
