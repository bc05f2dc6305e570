#pragma once
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "geometry/shape/toolpath.h"
#include "parameter/value.h"

/// A G-code program (RS-274, LinuxCNC's dialect) as motions, from which contours or a toolpath are made. Read by hand
/// because LinuxCNC's own interpreter wants a machine with its tool table and parameters, which a file does not tell; tests
/// let it run what is written here.
namespace blossom {

enum class GcodeMotion { None, Rapid, Line, Clockwise, Counterclockwise, Nurbs };

struct GcodeMove {
  GcodeMotion motion = GcodeMotion::None;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< mm
  Vec2 center = Vec2::Zero();                   ///< of an arc
  double feed = 0;                              ///< mm a minute
  std::size_t spline = 0;                       ///< of a G5.2 curve: its place in `splines`
  std::size_t line = 0;                         ///< of the file
  bool inPlane = false;                         ///< X, Y or the centre of an arc is named
  std::bitset<3> unknown;                       ///< axes whose place the program has not told when the move ends
};

struct GcodeProgram {
  std::vector<GcodeMove> moves;
  std::vector<Spline2> splines;
  Value counts = Value::object();   ///< moves by their word
  Value skipped = Value::object();  ///< what is not read
  bool turnsSpindle = false, namesTool = false, movesInZ = false, cut = false;
  Cutter cutter;  ///< as the first cut finds it: from T, M6, S and M3, and from the comments of programs that Blossom wrote
  Bounds stock;   ///< from those comments
  std::size_t passes = 0;
  std::string workOffset = "G54";
  double blending = 0;               ///< mm, of G64 P
  bool flood = false, mist = false;  ///< as the first cut finds them
  std::optional<PocketTask> task;    ///< from the comments of programs that Blossom wrote
  bool isBlossoms = false;
  std::optional<std::pair<std::size_t, std::string>>
      obstacle;  ///< the first line that a toolpath cannot be made of, and why
  std::optional<std::pair<std::size_t, std::string>> unrolled;  ///< the first O-word, which is not run: its line, and it
  std::vector<std::string> drawingDoubts;                       ///< of the doubts, those of a drawing as well
  std::vector<std::string> doubts;   ///< what a toolpath can be made of, and whoever stands at the machine should look at
  std::vector<std::string> notKept;  ///< "stops (M0)": what a program that is written anew does not do
};

/// @throws Error FormatDamaged that names the line, Cancelled.
GcodeProgram parseGcode(std::string_view text, const Progress&);

/// Whether it is meant as the work of a tool rather than as a drawing: it turns the spindle or names a tool, and it moves in
/// z.
bool isMachining(const GcodeProgram&);
/// What G1, G2, G3 and G5.2 draw, seen from above; rapids begin a new path.
Curves contoursOf(const GcodeProgram&);
/// Every move; G5.2 curves as lines. @throws Error FormatDamaged when the program holds what it cannot follow (subroutines,
/// canned cycles, cutter compensation, several work offsets).
Toolpath toolpathOf(const GcodeProgram&);

}  // namespace blossom
