#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/units.h"
#include "exchange/gcode_arcs.h"
#include "exchange/gcode_codes.h"
#include "exchange/gcode_comments.h"
#include "exchange/gcode_program.h"
#include "exchange/gcode_watch.h"
#include "exchange/gcode_words.h"

/// Reads RS-274 in LinuxCNC's dialect: G0 G1, G2 and G3 in the planes G17, G18 and G19, and G5.2 NURBS.
namespace blossom {
namespace {

constexpr std::size_t largestLine = 10000;

class GcodeParser {
 public:
  GcodeProgram read(std::string_view text, const Progress& progress) {
    std::size_t begin = 0;
    while (begin < text.size() && !ended_) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      watch_.at(++lineNumber_);
      if (lineNumber_ % 4096 == 0)
        progress.report(static_cast<double>(begin) / static_cast<double>(text.size()), "Reading G-code");
      readLine(text.substr(begin, end - begin));
      begin = end + 1;
    }
    finishNurbs();
    settleSpindle();
    settleDoubts(progress);
    if (program_.counts.empty()) damaged("the file holds no motion (G0, G1, G2, G3 or G5.2)");
    return std::move(program_);
  }

 private:
  /// What one line says.
  struct Block {
    std::optional<double> x, y, z, i, j, k, radius, weight, order;
    bool unknownZ = false;
    bool machine = false;   ///< by way of the machine's coordinates, which a file does not tell
    bool over = false;      ///< G28, G30: over the place that is named
    bool dwell = false;     ///< G4
    bool scaling = false;   ///< G50: with words, no longer the end of scaling
    bool extended = false;  ///< G54.1: P names the offset
    bool blends = false;    ///< G64
    bool saysP = false;
    bool length = false;  ///< G43
    std::optional<int> lengthNumber;
    [[nodiscard]] bool names(int axis) const { return std::array{x, y, z}[static_cast<std::size_t>(axis)].has_value(); }
    [[nodiscard]] bool namesAny() const { return x || y || z; }
  };

  [[noreturn]] void damaged(const std::string& what) const {
    throw Error(ErrorCode::FormatDamaged, fmt::format("Line {}: {}.", lineNumber_, what),
                "Check that the file is G-code and complete.");
  }

  static void count(Value& counts, const std::string& name) { counts[name] = counts.value(name, 0) + 1; }

  /// What contours do not mind, but a toolpath would be wrong without.
  void cannotFollow(const std::string& what) {
    if (!program_.obstacle) program_.obstacle = {lineNumber_, what};
  }

  void readLine(std::string_view raw) {
    if (raw.size() > largestLine) damaged("the line is longer than 10,000 characters");
    const GcodeLine read = withoutComments(raw);
    for (const std::string& comment : read.comments) readComment(comment, program_);
    if (read.nested) cannotFollow("a comment within a comment");
    const std::string& line = read.code;
    if (line.empty()) return;
    if (line.front() == '/') return cannotFollow("a line that may be left out (/)");
    if (line.front() == '#') {
      const auto isSystem = [&] { return line.size() > 4 && line[1] == '5' && line.find('=') >= 5; };
      if (isSystem()) cannotFollow("a parameter of the control that is set");  // #5221 and its like move the zero
      return count(program_.skipped, "parameter");
    }
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (line.front() == 'O' && line.size() > 1 && std::all_of(line.begin() + 1, line.end(), isDigit)) return;  // its number
    if (line.front() == 'O') {
      cannotFollow("a subroutine or a loop (O)");
      if (!program_.unrolled) program_.unrolled = {lineNumber_, line.substr(0, 24)};
      return count(program_.skipped, "subroutine");
    }
    const GcodeWords said = gcodeWords(line);
    if (!said.damage.empty()) damaged(said.damage);
    if (said.polar) cannotFollow("polar coordinates");
    for (const GcodeWord& word : said.words)
      if (isLength(word.letter) && word.value) arcs_.number(word.digits, unit_);
    run(said.words);
  }

  /// Modes come first, wherever they stand: "X1 Y1 G20" goes to one inch.
  void run(const std::vector<GcodeWord>& line) {
    Block block;
    for (const GcodeWord& word : line)
      if (word.letter == 'G') mode(number(word), block);
    for (const GcodeWord& word : line) place(word, block);
    for (const GcodeWord& word : line)
      if (word.letter == 'M') machine(word.value.value_or(-1));
    if (block.extended) setWorkOffset(fmt::format("G54.1 P{:g}", block.weight.value_or(1)));
    if (block.scaling && block.namesAny()) cannotFollow("scaling or a moved zero (G50)");
    if (block.dwell && block.namesAny()) return cannotFollow("a dwell that is given by an axis (G4)");
    if (block.dwell) dwell();
    watchModes(block);
    motionOf(block);
  }

  void place(const GcodeWord& word, Block& block) {
    switch (word.letter) {
      case 'X':
        block.x = coordinate(word);
        break;
      case 'Y':
        block.y = coordinate(word);
        break;
      case 'Z':
        if (word.value)
          block.z = coordinate(word);
        else
          block.unknownZ = true;
        break;
      case 'I':
        block.i = coordinate(word);
        break;
      case 'J':
        block.j = coordinate(word);
        break;
      case 'R':
        block.radius = coordinate(word);
        break;
      case 'K':
        if (word.value) block.k = coordinate(word);
        break;
      case 'H':
        if (word.value && *word.value >= 0 && *word.value < 1e6) block.lengthNumber = static_cast<int>(*word.value);
        break;
      case 'P':
        block.weight = word.value;
        block.saysP = true;
        break;
      case 'L':
        block.order = word.value;
        break;
      default:
        setting(word);
    }
  }

  void setting(const GcodeWord& word) {
    switch (word.letter) {
      case 'F':
        if (word.value) feed_ = *word.value * unit_;
        break;
      case 'S':
        if (word.value) setSpeed(std::max(0.0, *word.value));
        break;
      case 'T':
        program_.namesTool = true;
        if (word.value && *word.value >= 0 && *word.value < 1e6) chooseTool(static_cast<int>(*word.value));
        break;
      case 'A':
      case 'B':
      case 'C':
        cannotFollow("a rotary axis");
        break;
      case 'U':
      case 'V':
      case 'W':
        cannotFollow("an axis beside X, Y and Z");
        count(program_.skipped, std::string(1, word.letter));
        break;
      case 'G':
      case 'M':
      case 'N':
      case 'D':
      case 'Q':
      case 'E':
        break;
      default:
        count(program_.skipped, std::string(1, word.letter));
    }
  }

  void machine(double given) {
    const int code = given >= 0 && given < 1000 ? static_cast<int>(given) : -1;
    if (const auto obstacle = obstacleOfMachine(code)) cannotFollow(*obstacle);
    noteLost(notKept('M', code));
    if (code == 3 || code == 4) {
      program_.turnsSpindle = turning_ = justStarted_ = true;
      watch_.spindleTurns();
    }
    if (code == 5 || code == 19) {
      turning_ = false;
      watch_.spindleStops();
    }
    if (code == 6) changeTool();
    if (code >= 7 && code <= 9) cool(code);
    if (code == 2 || code == 30) ended_ = true;
  }

  /// Coolant that runs from before the first cut to after the last is kept.
  void cool(int code) {
    if (code == 7) mist_ = true;
    if (code == 8) flood_ = true;
    if (code == 9) mist_ = flood_ = false;
  }
  void noteCoolant() {
    if (program_.cut && (mist_ != program_.mist || flood_ != program_.flood))
      noteLost("changes of the coolant (M7, M8, M9)");
  }

  /// The wait for a spindle that was just started is written anew.
  void dwell() {
    if (!justStarted_) noteLost(notKept('G', 4));
  }

  void watchModes(const Block& block) {
    if (block.length)
      watch_.lengthFrom(block.lengthNumber);
    else if (block.lengthNumber)
      watch_.lengthNumber(*block.lengthNumber);
    if (!block.blends) return;
    const bool evaluated = block.weight || !block.saysP;
    if (evaluated && !(block.weight.value_or(0) > 0)) watch_.blendsWithoutLimit();
    if (block.weight) program_.blending = std::max(program_.blending, *block.weight * unit_);
  }

  void settleDoubts(const Progress& progress) {
    for (std::string& doubt : watch_.doubts()) program_.doubts.push_back(std::move(doubt));
    for (std::string& doubt : arcs_.doubts(progress)) program_.doubts.push_back(std::move(doubt));
    program_.drawingDoubts = watch_.drawingDoubts();
  }

  /// T alone may be a tool that is made ready while the one before still cuts.
  void chooseTool(int number) {
    if (program_.cut && !changes_ && number != program_.cutter.number) cannotFollow("a second tool");
    chosen_ = number;
    watch_.toolMade(number);
    if (!program_.cut && !changes_) program_.cutter.number = number;
  }

  void changeTool() {
    program_.namesTool = true;
    const int number = chosen_.value_or(program_.cutter.number);
    if (program_.cut && number != program_.cutter.number) cannotFollow("a second tool");
    if (!program_.cut) program_.cutter.number = number;
    changes_ = true;
    watch_.toolChanged();
  }

  void setSpeed(double speed) {
    if (program_.cut && turning_ && speed > 0 && speed != program_.cutter.spindle)
      noteLost("a change of the spindle's speed (S)");
    speed_ = speed;
  }

  /// What the first cut finds counts.
  void settleSpindle() {
    if (!program_.cut) program_.cutter.spindle = speed_;
  }

  void beginCutting() {
    if (program_.cut) return;
    program_.cut = true;
    program_.mist = mist_;
    program_.flood = flood_;
    if (unknown_.any())
      program_.doubts.push_back(
          fmt::format("line {} cuts before X, Y and Z were all named; what was not is taken as 0", lineNumber_));
    program_.cutter.spindle = turning_ || !program_.turnsSpindle ? speed_ : 0;
    if (turning_ && speed_ == 0)
      program_.doubts.push_back(fmt::format("line {} cuts before the spindle has a speed (S)", lineNumber_));
  }

  void noteLost(const std::string& what) {
    if (!what.empty() && std::find(program_.notKept.begin(), program_.notKept.end(), what) == program_.notKept.end())
      program_.notKept.push_back(what);
  }

  double number(const GcodeWord& word) const {
    if (!word.value)
      damaged(fmt::format("the word {} is a parameter or an expression, which is not evaluated here", word.letter));
    return *word.value;
  }

  double coordinate(const GcodeWord& word) const {
    const double mm = number(word) * unit_;
    if (std::abs(mm) > farthestInGcode) damaged(fmt::format("the word {} is farther away than 10 km", word.letter));
    return mm;
  }

  void mode(double code, Block& block) {
    const int tenths = std::abs(code) < 1000 ? static_cast<int>(std::lround(code * 10)) : -1;
    if (motion_ == GcodeMotion::Nurbs && tenths != 52) finishNurbs();
    switch (tenths) {
      case 0:
        motion_ = GcodeMotion::Rapid;
        break;
      case 10:
        motion_ = GcodeMotion::Line;
        break;
      case 20:
        motion_ = GcodeMotion::Clockwise;
        break;
      case 30:
        motion_ = GcodeMotion::Counterclockwise;
        break;
      case 52:
        motion_ = GcodeMotion::Nurbs;
        break;
      case 800:
        motion_ = GcodeMotion::None;
        break;
      case 280:
      case 300:
        block.over = block.machine = true;
        break;
      case 530:
        block.machine = true;
        break;
      case 40:
        block.dwell = true;
        break;
      case 640:
        block.blends = true;
        break;
      case 430:
      case 440:
        block.length = true;
        break;
      case 490:
        watch_.noLength();
        break;
      case 500:
        block.scaling = true;
        break;
      case 541:
        block.extended = true;
        break;
      case 170:
        normal_ = 2;
        break;
      case 180:
        normal_ = 1;
        break;
      case 190:
        normal_ = 0;
        break;
      case 200:
        unit_ = millimetresPerInch;
        watch_.unitsSaid();
        break;
      case 210:
        unit_ = 1;
        watch_.unitsSaid();
        break;
      case 900:
        absolute_ = true;
        break;
      case 910:
        absolute_ = false;
        break;
      case 901:
        absoluteCenters_ = true;
        break;
      case 911:
        absoluteCenters_ = false;
        break;
      default:
        otherMode(tenths);  // offsets, path modes and other settings do not change the contour
    }
  }

  void otherMode(int tenths) {
    if (tenths >= 540 && tenths <= 593) return setWorkOffset(modeName(tenths));
    if (const auto obstacle = obstacleOfMode(tenths)) cannotFollow(*obstacle);
  }

  void setWorkOffset(const std::string& name) {
    if (atWork_ && name != program_.workOffset) cannotFollow("a second work offset");
    program_.workOffset = name;
  }

  [[nodiscard]] Vec3 target(const Block& b) const {
    if (absolute_) return {b.x.value_or(at_.x()), b.y.value_or(at_.y()), b.z.value_or(at_.z())};
    return at_ + Vec3(b.x.value_or(0), b.y.value_or(0), b.z.value_or(0));
  }

  void countMove() {
    static constexpr const char* names[] = {"", "G0", "G1", "G2", "G3", "G5.2"};
    if (motion_ != GcodeMotion::None) count(program_.counts, names[static_cast<int>(motion_)]);
  }

  void motionOf(const Block& block) {
    const bool plane = block.x || block.y;
    if (block.machine) return overTheMachine(block);
    if (block.unknownZ) cannotFollow("a height that is a parameter or an expression");
    if (block.namesAny() || block.i || block.j) watch_.moves();
    if (motion_ == GcodeMotion::Nurbs) return addNurbs(block, plane);
    const bool round = motion_ == GcodeMotion::Clockwise || motion_ == GcodeMotion::Counterclockwise;
    const bool upright = round && normal_ != 2;
    const bool centred = plane || block.i || block.j || (upright && (block.z || block.k));
    if (!centred && !block.z && !block.unknownZ) return;
    countMove();
    if (motion_ == GcodeMotion::None) {
      if (centred) damaged("coordinates without a motion (G0, G1, ..)");
      return cannotFollow("a height without a motion");
    }
    if (!absolute_) refuseFromNowhere(block);
    atWork_ = true;
    const Vec3 to = target(block);
    for (int axis = 0; axis < 3; ++axis)
      if (block.names(axis)) unknown_.reset(static_cast<std::size_t>(axis));
    if (round && !centred) damaged("an arc needs I, J or R");
    if (round && (block.weight.value_or(1) != 1 || block.order)) cannotFollow("an arc of several turns (P, L)");
    if (motion_ != GcodeMotion::Rapid) {
      if (left_ && unknown_.any()) cannotFollow("a cut from a place that the file does not tell (after G28, G30 or G53)");
      beginCutting();
      noteCoolant();
      watch_.cuts();
    }
    justStarted_ = justStarted_ && motion_ == GcodeMotion::Rapid;
    if (upright) return addUprightArc(block, to);
    const Vec2 middle = round ? center(block, at_.head<2>(), to.head<2>(), {block.i, block.j}) : Vec2(0, 0);
    if (round)
      arcs_.arc(lineNumber_, at_.head<2>(), to.head<2>(), middle, motion_ == GcodeMotion::Counterclockwise, !block.radius);
    else
      arcs_.straight(at_.head<2>(), to.head<2>());
    addMove(motion_, to, middle, centred);
  }

  /// An arc in G18 or G19: as lines, for a tool's moves are round only in plan.
  void addUprightArc(const Block& block, const Vec3& to) {
    const int a = (normal_ + 1) % 3, b = (normal_ + 2) % 3;
    const std::array<std::optional<double>, 3> offsets{block.i, block.j, block.k};
    const auto index = [](int axis) { return static_cast<std::size_t>(axis); };
    const auto flat = [&](const Vec3& p) { return Vec2(p[a], p[b]); };
    const Vec3 from = at_;
    const Vec2 middle = center(block, flat(from), flat(to), {offsets[index(a)], offsets[index(b)]});
    arcs_.straight(from.head<2>(), from.head<2>());  // its neighbours lie in another plane
    arcs_.arc(lineNumber_, flat(from), flat(to), middle, motion_ == GcodeMotion::Counterclockwise, !block.radius);
    arcs_.straight(from.head<2>(), from.head<2>());
    ToolMove turn;
    turn.to = {to[a], to[b], to[normal_]};
    turn.turn = motion_ == GcodeMotion::Clockwise ? -1 : 1;
    turn.center = middle;
    constexpr double chord = 1e-3;
    const GcodeMotion whole = std::exchange(motion_, GcodeMotion::Line);
    for (const Vec3& p : polylineOf({from[a], from[b], from[normal_]}, turn, chord)) {
      Vec3 next = at_;
      next[a] = p.x();
      next[b] = p.y();
      next[normal_] = p.z();
      if (next != at_) addMove(GcodeMotion::Line, next, {}, true);
    }
    motion_ = whole;
  }

  /// To the machine's own places: somewhere else, over the place that is named (G28, G30). A path that was begun ends here.
  void overTheMachine(const Block& block) {
    count(program_.skipped, "machine coordinates");
    if (!block.over && motion_ != GcodeMotion::Rapid && block.namesAny())
      cannotFollow("a cut in the machine's coordinates (G53)");
    const Vec3 to = block.over && block.namesAny() ? target(block) : at_;
    addMove(GcodeMotion::Rapid, to, {}, true);
    for (int axis = 0; axis < 3; ++axis)
      if (block.names(axis) || !block.namesAny()) unknown_.set(static_cast<std::size_t>(axis));
    program_.moves.back().unknown = unknown_;
    left_ = true;
  }

  /// By so much from where nobody knows.
  void refuseFromNowhere(const Block& block) {
    for (int axis = 0; axis < 3; ++axis)
      if (block.names(axis) && unknown_.test(static_cast<std::size_t>(axis)))
        cannotFollow("a relative move (G91) from a place that the file does not tell");
  }

  void addMove(GcodeMotion motion, const Vec3& to, const Vec2& center, bool inPlane) {
    GcodeMove move{motion, at_, to, center, feed_, 0, lineNumber_, inPlane, unknown_};
    program_.movesInZ = program_.movesInZ || at_.z() != to.z();
    program_.moves.push_back(move);
    at_ = to;
  }

  using Offsets = std::pair<std::optional<double>, std::optional<double>>;

  /// Of an arc in its plane, whose first two axes turn counter-clockwise seen from the third.
  [[nodiscard]] Vec2 center(const Block& b, const Vec2& from, const Vec2& to, const Offsets& offsets) {
    const auto& [first, second] = offsets;
    const bool clockwise = motion_ == GcodeMotion::Clockwise;
    if (b.radius) {
      const Vec2 chord = to - from;
      const double half = chord.norm() / 2;
      if (half == 0 || half > std::abs(*b.radius) * (1 + 1e-4)) damaged("the arc's radius R does not reach its end");
      const double height = std::sqrt(std::max(0.0, *b.radius * *b.radius - half * half));
      const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
      return from + chord / 2 + left * height * ((clockwise != (*b.radius < 0)) ? -1 : 1);
    }
    if (!first && !second) damaged("an arc needs I, J or R");
    const Vec2 middle = absoluteCenters_ ? Vec2(first.value_or(from.x()), second.value_or(from.y()))
                                         : Vec2(from + Vec2(first.value_or(0), second.value_or(0)));
    const double radius = (from - middle).norm(), mismatch = std::abs((to - middle).norm() - radius);
    if (radius == 0) damaged("the arc has no radius");
    // What machines refuse: GRBL and LinuxCNC alike.
    if (mismatch > 0.5 || (mismatch > 0.005 && mismatch > 1e-3 * radius)) cannotFollow("an arc that misses its end");
    return middle;
  }

  void addNurbs(const Block& b, bool plane) {
    if (nurbs_.empty()) {
      count(program_.counts, "G5.2");
      nurbs_.emplace_back(at_.x(), at_.y(), 1);  // the curve starts where the tool is
      order_ = 3;
    }
    if (b.order) order_ = static_cast<int>(std::clamp(*b.order, 2.0, 26.0));
    if (!plane) return;
    const Vec3 pole = target(b);
    const double w = b.weight.value_or(1);
    if (!(w > 0)) damaged("the weight P must be above 0");
    nurbs_.emplace_back(pole.x() * w, pole.y() * w, w);
    nurbsEnd_ = {pole.x(), pole.y(), at_.z()};
  }

  void finishNurbs() {
    if (motion_ == GcodeMotion::Nurbs) motion_ = GcodeMotion::None;
    if (nurbs_.empty()) return;
    if (nurbs_.size() < 2) damaged("a G5.2 curve needs at least two control points");
    Spline2 spline;
    spline.degree = std::min(order_, static_cast<int>(nurbs_.size())) - 1;
    const auto poles = static_cast<int>(nurbs_.size());
    for (int k = 0; k <= poles + spline.degree; ++k)
      spline.knots.push_back(std::clamp(k - spline.degree, 0, poles - spline.degree));
    spline.poles = std::move(nurbs_);
    nurbs_.clear();
    addMove(GcodeMotion::Nurbs, nurbsEnd_, {}, true);
    program_.moves.back().spline = program_.splines.size();
    program_.splines.push_back(std::move(spline));
  }

  GcodeMotion motion_ = GcodeMotion::None;
  int normal_ = 2;  ///< the axis that the plane of arcs is seen along: 2 is G17
  double unit_ = 1;
  double feed_ = 0;
  bool absolute_ = true;
  bool absoluteCenters_ = false;
  bool ended_ = false;
  Vec3 at_ = Vec3::Zero();
  Vec3 nurbsEnd_ = Vec3::Zero();
  std::bitset<3> unknown_{0b111};  ///< axes whose place the file does not tell
  bool atWork_ = false;            ///< it moved to a place in the work's coordinates
  bool left_ = false;              ///< the tool was sent to a place of the machine's
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

}  // namespace

GcodeProgram parseGcode(std::string_view text, const Progress& progress) { return GcodeParser().read(text, progress); }

bool isMachining(const GcodeProgram& program) {
  return program.movesInZ && (program.turnsSpindle || program.namesTool || program.cutter.diameter > 0) &&
         program.splines.empty();
}

}  // namespace blossom
