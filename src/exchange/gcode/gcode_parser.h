#pragma once
#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/gcode/gcode_arcs.h"
#include "exchange/gcode/gcode_program.h"
#include "exchange/gcode/gcode_watch.h"
#include "exchange/gcode/gcode_words.h"

namespace blossom {

/// Reads RS-274 in LinuxCNC's dialect: G0 G1, G2 and G3 in the planes G17, G18 and G19, and G5.2 NURBS. The implementation
/// is divided into gcode_parse.cpp, gcode_modes.cpp, gcode_machine.cpp and gcode_motion.cpp.
class GcodeParser {
 public:
  GcodeProgram read(std::string_view text, const Progress& progress);

 private:
  /// The words of one line.
  struct Block {
    std::optional<double> x, y, z, i, j, k, radius, weight, order;
    bool unknownZ = false;
    bool machine = false;   ///< in machine coordinates, whose zero the file does not contain
    bool over = false;      ///< G28, G30: by way of the given point
    bool dwell = false;     ///< G4
    bool scaling = false;   ///< G50: with words it does not end scaling
    bool extended = false;  ///< G54.1: P names the offset
    bool blends = false;    ///< G64
    bool saysP = false;
    bool length = false;  ///< G43
    std::optional<int> lengthNumber;
    [[nodiscard]] bool names(int axis) const { return std::array{x, y, z}[static_cast<std::size_t>(axis)].has_value(); }
    [[nodiscard]] bool namesAny() const { return x || y || z; }
  };

  // gcode_parse.cpp: lines and words.
  void settleDoubts(const Progress& progress);
  [[noreturn]] void damaged(const std::string& what) const;
  static void count(Value& counts, const std::string& name);
  /// Records an obstacle: contours can be read without it, but a toolpath would be wrong.
  void cannotFollow(const std::string& what);
  void readLine(std::string_view raw);
  /// "%" on a line of its own: a program that begins with one ends at the next.
  void tapeMark();
  void end(std::string by);
  /// Executes a line. Modes come first, whatever their position: "X1 Y1 G20" goes to one inch.
  void run(const std::vector<GcodeWord>& line);
  void place(const GcodeWord& word, Block& block);
  void setting(const GcodeWord& word);
  double number(const GcodeWord& word) const;
  double coordinate(const GcodeWord& word) const;

  // gcode_modes.cpp: G codes.
  void watchModes(const Block& block);
  void mode(double code, Block& block);
  void modeBesideMotion(int tenths, Block& block);
  void otherMode(int tenths);
  void setWorkOffset(const std::string& name);

  // gcode_machine.cpp: spindle, tool, coolant.
  void machine(double given);
  /// Records coolant. Coolant that is on from before the first cut until after the last is kept in the toolpath.
  void cool(int code);
  void noteCoolant();
  /// The wait for a spindle that was just started is not lost, because writing the program adds it again.
  void dwell(const Block& block);
  /// T without M6 may prepare a tool while the one before still cuts.
  void chooseTool(int number);
  void changeTool();
  void setSpeed(double speed);
  /// Takes over the state of the spindle at the first cut.
  void settleSpindle();
  void beginCutting();
  void noteLost(const std::string& what);

  // gcode_motion.cpp: moves of the tool.
  [[nodiscard]] Vec3 target(const Block& b) const;
  void countMove();
  void motionOf(const Block& block);
  /// Adds an arc in G18 or G19 as lines, because the moves of a toolpath are arcs only in the XY plane.
  void addUprightArc(const Block& block, const Vec3& to);
  /// A move to a fixed machine position by way of the given point (G28, G30). Ends the current path.
  void overTheMachine(const Block& block);
  /// Refuses an incremental move from an unknown position.
  void refuseFromNowhere(const Block& block);
  void addMove(GcodeMotion motion, const Vec3& to, const Vec2& center, bool inPlane);
  using Offsets = std::pair<std::optional<double>, std::optional<double>>;
  /// Centre of an arc in its plane, whose first two axes turn counter-clockwise seen from the third.
  [[nodiscard]] Vec2 center(const Block& b, const Vec2& from, const Vec2& to, const Offsets& offsets);
  void addNurbs(const Block& b, bool plane);
  void finishNurbs();

  GcodeMotion motion_ = GcodeMotion::None;
  int normal_ = 2;  ///< axis normal to the plane of arcs: 2 is G17
  double unit_ = 1;
  double feed_ = 0;
  bool absolute_ = true;
  bool absoluteCenters_ = false;
  bool begun_ = false, ended_ = false;
  std::string ending_;   ///< what ended it
  bool opened_ = false;  ///< by "%"
  Vec3 at_ = Vec3::Zero();
  Vec3 nurbsEnd_ = Vec3::Zero();
  std::bitset<3> unknown_{0b111};  ///< axes with an unknown position
  bool atWork_ = false;            ///< the tool has moved to a position in work coordinates
  bool left_ = false;              ///< the tool was sent to a machine position
  bool turning_ = false, changes_ = false, justStarted_ = false;
  bool mist_ = false, flood_ = false;
  double speed_ = 0;
  std::optional<int> chosen_;
  int order_ = 3;
  std::vector<Vec3> nurbs_;
  GcodeProgram program_;
  GcodeWatch watch_;
  GcodeArcs arcs_;
  std::size_t lineNumber_ = 0;
};

}  // namespace blossom
