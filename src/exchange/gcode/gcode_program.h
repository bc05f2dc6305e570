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
  double feed = 0;                              ///< mm/min
  std::size_t spline = 0;                       ///< of a G5.2 curve: its index in `splines`
  std::size_t line = 0;                         ///< of the file
  bool inPlane = false;                         ///< X, Y or the centre of an arc is given
  std::bitset<3> unknown;                       ///< axes whose position is unknown at the end of the move
};

struct GcodeProgram {
  std::vector<GcodeMove> moves;
  std::vector<Spline2> splines;
  Value counts = Value::object();   ///< number of moves by their code
  Value skipped = Value::object();  ///< number of codes that are not read
  bool turnsSpindle = false, namesTool = false, movesInZ = false, cut = false;
  Cutter cutter;  ///< at the first cut: from T, M6, S and M3, and from the comments of programs written by Blossom
  Bounds stock;   ///< from those comments
  std::size_t passes = 0;
  std::string workOffset = "G54";
  double blending = 0;               ///< mm, of G64 P
  bool flood = false, mist = false;  ///< at the first cut
  std::optional<PocketTask> task;    ///< from the comments of programs written by Blossom
  bool isBlossoms = false;
  std::optional<std::pair<std::size_t, std::string>> obstacle;  ///< the first line that a toolpath cannot represent, and why
  std::optional<std::pair<std::size_t, std::string>> unrolled;  ///< the first O-word, which is not executed, and its line
  std::vector<std::string> drawingDoubts;                       ///< the doubts that also concern a drawing
  std::vector<std::string> doubts;   ///< what the operator should check, although a toolpath can be made
  std::vector<std::string> notKept;  ///< "stops (M0)": what a program written from the toolpath does not do
};

/// @throws Error FormatDamaged that names the line, Cancelled.
GcodeProgram parseGcode(std::string_view text, const Progress&);

/// Whether the program is a machining program rather than a drawing: it starts the spindle or names a tool, and it moves in
/// z.
bool isMachining(const GcodeProgram&);
/// The paths of G1, G2, G3 and G5.2 seen from above; a rapid starts a new path.
Curves contoursOf(const GcodeProgram&);
/// All moves; G5.2 curves as lines. @throws Error FormatDamaged when the program contains what cannot be followed
/// (subroutines, canned cycles, cutter compensation, several work offsets).
Toolpath toolpathOf(const GcodeProgram&);

}  // namespace blossom
