#include "exchange/gcode/gcode_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace blossom {
namespace {

/// Dwells, exact stop, planes and offsets that are cancelled, path modes, feed a minute, retract levels of cycles.
constexpr std::array<int, 20> harmlessModes{40,  80,  90,  150, 170, 400, 430, 440, 490, 500,
                                            610, 611, 640, 690, 921, 922, 940, 970, 980, 990};

}  // namespace

std::string modeName(int tenths) {
  return tenths % 10 == 0 ? fmt::format("G{}", tenths / 10) : fmt::format("G{}.{}", tenths / 10, tenths % 10);
}

std::optional<std::string> obstacleOfMode(int tenths) {
  if (std::find(harmlessModes.begin(), harmlessModes.end(), tenths) != harmlessModes.end()) return std::nullopt;
  if (tenths == 50 || tenths == 51) return "a spline (G5, G5.1)";
  if (tenths == 410 || tenths == 420 || tenths == 411 || tenths == 421) return "cutter compensation";
  if (tenths == 330 || tenths == 760) return "a thread";
  if (tenths >= 380 && tenths < 390) return "a probe";
  if (tenths == 100 || tenths == 520 || tenths == 920 || tenths == 923) return "a moved zero (G10, G52, G92)";
  if (tenths == 730 || (tenths >= 810 && tenths <= 890)) return "a drilling cycle";
  if (tenths == 930 || tenths == 950) return "a feed that is not a minute's (G93, G95)";
  if (tenths == 160) return "polar coordinates";
  if (tenths == 431 || tenths == 432) return "a length of the tool in the program (G43.1)";
  if (tenths == 510 || tenths == 680) return fmt::format("scaling or rotation ({})", modeName(tenths));
  if (tenths == 650 || tenths == 660 || tenths == 670) return "a macro (G65, G66)";
  return fmt::format("a code that is not known here ({})", modeName(tenths));
}

std::optional<std::string> obstacleOfMachine(int code) {
  if (code >= 97 && code <= 99) return fmt::format("a subroutine (M{})", code);
  const bool known = (code >= 0 && code <= 11) || code == 19 || code == 30 || (code >= 48 && code <= 53) || code == 60 ||
                     (code >= 62 && code <= 68);
  if (known) return std::nullopt;
  if (code >= 100 && code < 200) return fmt::format("a code of one machine's own (M{})", code);
  return fmt::format("a code that is not known here (M{})", code);
}

std::string notKept(char letter, int code) {
  if (letter == 'G') return code == 4 ? "dwells (G4)" : "";
  switch (code) {
    case 0:
    case 1:
    case 60:
      return fmt::format("stops (M{})", code);
    case 4:
      return "a spindle that turns counter-clockwise (M4)";
    case 10:
    case 11:
      return "clamps (M10, M11)";
    default:
      return code >= 62 && code <= 68 ? fmt::format("outputs of the control (M{})", code) : "";
  }
}

}  // namespace blossom
