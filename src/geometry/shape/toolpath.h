#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"
#include "geometry/planar/region.h"
#include "geometry/values/box.h"

namespace blossom {

/// The tool in the spindle. Lengths in mm, angles in radians.
struct Cutter {
  double diameter = 0;
  double cornerRadius = 0;  ///< 0: flat end; diameter / 2: ball
  double vAngle = 0;        ///< full angle of a V bit; 0: no V
  int number = 1;           ///< place in the tool changer
  double spindle = 0;       ///< revolutions per minute; 0: the program does not start the spindle
  friend bool operator==(const Cutter&, const Cutter&) = default;
};

/// A rapid moves through air, a plunge goes down into material, a feed cuts.
enum class MoveKind { Rapid, Plunge, Feed };

/// One move of the tool tip, from its current position.
struct ToolMove {
  MoveKind kind = MoveKind::Rapid;
  Vec3 to = Vec3::Zero();
  int turn = 0;  ///< 0: straight; +1 an arc counter-clockwise seen from above, -1 clockwise; a helix when z changes
  Vec2 center = Vec2::Zero();  ///< of the arc
  double feed = 0;             ///< mm/min; unused by rapids
  std::size_t line = 0;        ///< line of the program it was read from; 0: not read from a program
  friend bool operator==(const ToolMove&, const ToolMove&) = default;
};

/// The task of a toolpath, which cannot be derived from its moves. In the coordinates of the moves, mm.
struct PocketTask {
  Vec3 zero = Vec3::Zero();              ///< zero of the part's drawing, at the height of the part's top
  double depth = 0;                      ///< below the top
  double leaveWall = 0, leaveFloor = 0;  ///< stock to leave
  friend bool operator==(const PocketTask&, const PocketTask&) = default;
};

/// What is wrong with a place, or why it is not cut: missed places are within reach of the tool, those left were asked to
/// be.
enum class MarkKind { Gouge, Missed, Unreachable, Left };

/// A place that the simulation found.
struct ToolMark {
  Vec3 at = Vec3::Zero();
  MarkKind kind = MarkKind::Missed;
  friend bool operator==(const ToolMark&, const ToolMark&) = default;
};

struct Toolpath;
/// Depth in mm of the deepest gouge into the part when the task of this toolpath is done by other moves: those of a program
/// as written, with rounded coordinates. @throws Error Cancelled.
using GougeOf = std::function<double(const Toolpath&, const Progress&)>;

/// The path of a tool, in mm from the zero of the workpiece.
struct Toolpath {
  Cutter cutter;
  Vec3 start = Vec3::Zero();
  std::vector<ToolMove> moves;
  double rapidFeed = 5000;  ///< mm/min, for the estimate of time
  Bounds stock;             ///< may be empty
  std::string workOffset = "G54";
  double blending = 0;               ///< mm, path deviation that the control may use to keep its speed in corners
  bool flood = false, mist = false;  ///< coolant while cutting
  std::optional<PocketTask> task;
  bool centred = false;           ///< read from a program of an earlier Blossom, with the part in the middle of the stock
  std::size_t passes = 0;         ///< number of depths
  std::optional<double> gouge;    ///< mm, depth of the deepest gouge into the part, as simulated
  std::optional<double> residue;  ///< mm2 of material within reach of the tool that was left, as simulated
  std::vector<ToolMark> marks;
  GougeOf gougeOf;  ///< may be empty
};

/// Start point of move i.
Vec3 startOf(const Toolpath&, std::size_t i);
/// Signed angle of an arc in radians; a full turn when it ends where it starts, 0 for a straight move.
double sweepOf(const Vec3& from, const ToolMove&);
/// Length of the move in mm.
double lengthOf(const Vec3& from, const ToolMove&);
/// The move as a polyline within `chord` mm, both ends included.
std::vector<Vec3> polylineOf(const Vec3& from, const ToolMove&, double chord);
/// Total length of the moves in mm.
double lengthOf(const Toolpath&);
/// Estimated time in seconds: lengths over feeds, without acceleration. Nothing when a cut has no feed.
std::optional<double> secondsOf(const Toolpath&);
/// The cutting moves (feeds and plunges) seen from above, for drawings.
Curves drawingOf(const Toolpath&);

}  // namespace blossom
