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

/// What turns in the spindle. Lengths in mm, angles in radians.
struct Cutter {
  double diameter = 0;
  double cornerRadius = 0;  ///< 0: flat end; diameter / 2: ball
  double vAngle = 0;        ///< full angle of a V bit; 0: no V
  int number = 1;           ///< place in the tool changer
  double spindle = 0;       ///< revolutions per minute; 0: the program does not turn it
  friend bool operator==(const Cutter&, const Cutter&) = default;
};

/// A rapid crosses air, a plunge goes down into material, a feed cuts.
enum class MoveKind { Rapid, Plunge, Feed };

/// One move of the tool's tip from where it is.
struct ToolMove {
  MoveKind kind = MoveKind::Rapid;
  Vec3 to = Vec3::Zero();
  int turn = 0;  ///< 0: straight; +1 an arc counter-clockwise seen from above, -1 clockwise; a helix when z changes
  Vec2 center = Vec2::Zero();  ///< of the arc
  double feed = 0;             ///< mm a minute; unused by rapids
  std::size_t line = 0;        ///< of the program that it was read from; 0: it was not
  friend bool operator==(const ToolMove&, const ToolMove&) = default;
};

/// What a toolpath was made to do, which its moves alone do not tell. In the coordinates of its moves, mm.
struct PocketTask {
  Vec3 zero = Vec3::Zero();              ///< where the part's drawing has its zero, at the height of the part's top
  double depth = 0;                      ///< below the top
  double leaveWall = 0, leaveFloor = 0;  ///< what is to stay
  friend bool operator==(const PocketTask&, const PocketTask&) = default;
};

struct Toolpath;
/// mm of the deepest cut into the part that a toolpath was made for, by other moves that are to do the same: those of a
/// program as it was written, rounded and all. @throws Error Cancelled.
using GougeOf = std::function<double(const Toolpath&, const Progress&)>;

/// The way of a tool through its work, in mm from the work's zero.
struct Toolpath {
  Cutter cutter;
  Vec3 start = Vec3::Zero();
  std::vector<ToolMove> moves;
  double rapidFeed = 5000;  ///< mm a minute, for the estimate of time
  Bounds stock;             ///< may be empty
  std::string workOffset = "G54";
  double blending = 0;               ///< mm by which the control may round corners of the way to keep its speed
  bool flood = false, mist = false;  ///< coolant that runs while it cuts
  std::optional<PocketTask> task;
  bool centred = false;           ///< read from a program of an earlier Blossom: its part lies in the middle of the stock
  std::size_t passes = 0;         ///< depths it is cut at
  std::optional<double> gouge;    ///< mm, the deepest cut into the part, as simulated
  std::optional<double> residue;  ///< mm2 that the tool could have reached and did not, as simulated
  std::vector<Vec3> marks;        ///< where a simulation found gouge or residue
  GougeOf gougeOf;                ///< may be empty
};

/// Where move i begins.
Vec3 startOf(const Toolpath&, std::size_t i);
/// Angle in radians that an arc sweeps, signed; a full turn when it ends where it begins. 0 of a straight move.
double sweepOf(const Vec3& from, const ToolMove&);
/// mm along the move.
double lengthOf(const Vec3& from, const ToolMove&);
/// The move as a polyline within `chord` mm, both ends included.
std::vector<Vec3> polylineOf(const Vec3& from, const ToolMove&, double chord);
/// mm of all moves.
double lengthOf(const Toolpath&);
/// Estimate in seconds: lengths over feeds, without acceleration.
double secondsOf(const Toolpath&);
/// What cuts (feeds and plunges), seen from above: what a drawing of it holds.
Curves drawingOf(const Toolpath&);

}  // namespace blossom
