#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "exchange/format/format.h"
#include "exchange/gcode/gcode_program.h"
#include "exchange/gcode/gcode_write.h"
#include "geometry/planar/planar.h"
#include "parameter/wording.h"

/// G-code as a format: programs are read as contours or as toolpaths, toolpaths are written.
namespace blossom {
namespace {

Arc2 arcOf(const GcodeMove& move) {
  const Vec2 first = move.from.head<2>() - move.center, last = move.to.head<2>() - move.center;
  const bool clockwise = move.motion == GcodeMotion::Clockwise;
  const double start = std::atan2(first.y(), first.x());
  double sweep = std::atan2(last.y(), last.x()) - start;
  constexpr double pi = std::numbers::pi;
  if (clockwise && sweep >= -1e-12) sweep -= 2 * pi;
  if (!clockwise && sweep <= 1e-12) sweep += 2 * pi;
  return {move.center, first.norm(), start, sweep};
}

/// Maximum distance of polylines from G5.2 curves in toolpaths, mm.
constexpr double nurbsChord = 1e-3;

/// Where a height is not told, the tool is as high as the program ever takes it; above its zero in any case, for nobody
/// starts a program in the material.
double highest(const GcodeProgram& program) {
  constexpr double aboveZero = 1;
  double top = -1;
  for (const GcodeMove& move : program.moves)
    if (!move.unknown[2]) top = std::max(top, move.to.z());
  return top > 0 ? top : aboveZero;
}

/// How many leading rapids there are until x and y were both named: until then the tool may be anywhere.
std::size_t leadingRapids(const GcodeProgram& program) {
  std::size_t i = 0;
  while (i < program.moves.size() && program.moves[i].motion == GcodeMotion::Rapid &&
         (i == 0 || program.moves[i - 1].unknown[0] || program.moves[i - 1].unknown[1]))
    ++i;
  return i;
}

/// The number of moves without those that end the program at heights of the machine's own.
std::size_t lastAtWork(const GcodeProgram& program) {
  std::size_t count = program.moves.size();
  while (count > 0 && program.moves[count - 1].motion == GcodeMotion::Rapid && program.moves[count - 1].unknown[2]) --count;
  return count;
}

/// Programs of earlier Blossoms tell their stock, which lay evenly around the part, and not where the part's zero is; where
/// the work's zero is that of the drawing both are the same.
bool isCentred(const GcodeProgram& program) {
  if (!program.isBlossoms || program.task || program.stock.empty) return false;
  constexpr double near = 1e-6;
  const Bounds& stock = program.stock;
  return stock.low.head<2>().cwiseAbs().maxCoeff() < near || stock.center().head<2>().cwiseAbs().maxCoeff() < near ||
         std::abs(stock.low.z()) < near;
}

/// Controls differ in how they bridge such a difference of an arc's two radii; a spiral is in the middle of it.
constexpr double roundEnough = 0.005;

class ToolpathMaker {
 public:
  explicit ToolpathMaker(const GcodeProgram& program) : program_(program), top_(highest(program)) {}

  Toolpath make() {
    path_.cutter = program_.cutter;
    path_.stock = program_.stock;
    path_.passes = program_.passes;
    path_.workOffset = program_.workOffset;
    path_.blending = program_.blending;
    path_.flood = program_.flood;
    path_.mist = program_.mist;
    path_.task = program_.task;
    path_.centred = isCentred(program_);
    const std::size_t first = leadingRapids(program_), last = lastAtWork(program_);
    if (first > 0) begin(program_.moves[first - 1]);
    for (std::size_t i = first; i < last; ++i) add(program_.moves[i]);
    if (path_.moves.empty())
      throw Error(ErrorCode::FormatDamaged, "The program does not move the tool.", "Check that the file is complete.");
    return std::move(path_);
  }

 private:
  [[nodiscard]] Vec3 endOf(const GcodeMove& move) const {
    return {move.to.x(), move.to.y(), move.unknown[2] ? top_ : move.to.z()};
  }

  /// Comes down from above: that rapid may go through material.
  void begin(const GcodeMove& last) {
    const Vec3 end = endOf(last);
    path_.start = at_ = {end.x(), end.y(), top_};
    if (end.z() < top_) append({.kind = MoveKind::Rapid, .to = end, .line = last.line});
  }

  void append(const ToolMove& move) {
    path_.moves.push_back(move);
    at_ = move.to;
  }

  void add(const GcodeMove& move) {
    const bool round = move.motion == GcodeMotion::Clockwise || move.motion == GcodeMotion::Counterclockwise;
    ToolMove made;
    made.to = endOf(move);
    made.line = move.line;
    if (made.to == at_ && !round) return;
    made.feed = move.motion == GcodeMotion::Rapid ? 0 : move.feed;
    constexpr double level = 1e-9;
    made.kind = move.motion == GcodeMotion::Rapid ? MoveKind::Rapid
                : made.to.z() < at_.z() - level   ? MoveKind::Plunge
                                                  : MoveKind::Feed;
    if (move.motion == GcodeMotion::Nurbs) return addCurve(program_.splines[move.spline], made);
    if (!round) return append(made);
    made.turn = move.motion == GcodeMotion::Clockwise ? -1 : 1;
    made.center = move.center;
    const double begins = (at_.head<2>() - made.center).norm(), ends = (made.to.head<2>() - made.center).norm();
    if (std::abs(begins - ends) <= roundEnough) return append(made);
    addSpiral(made);
  }

  void addCurve(const Spline2& spline, ToolMove made) {
    for (const Vec2& p : flatten(Segment(spline), nurbsChord)) {
      made.to = {p.x(), p.y(), made.to.z()};
      append(made);
    }
  }

  void addSpiral(ToolMove made) {
    const std::vector<Vec3> points = polylineOf(at_, made, nurbsChord);
    made.turn = 0;
    made.center = Vec2::Zero();
    for (const Vec3& p : points) {
      if (p == at_) continue;
      made.to = p;
      append(made);
    }
  }

  const GcodeProgram& program_;
  double top_;
  Vec3 at_ = Vec3::Zero();
  Toolpath path_;
};

std::string sentence(const std::string& doubt) {
  std::string text = doubt + ".";
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(doubt.front())));
  return text;
}

/// What is to be known of a program that is read as moves.
std::vector<std::string> doubtsOf(const GcodeProgram& program) {
  std::vector<std::string> sentences;
  if (!program.turnsSpindle && !program.namesTool && !(program.cutter.diameter > 0))
    sentences.emplace_back(
        "The program neither starts a spindle (M3) nor names a tool (T); its moves are followed all the same.");
  for (const std::string& doubt : program.doubts) sentences.push_back(sentence(doubt));
  if (!program.notKept.empty())
    sentences.push_back(
        fmt::format("A program that is written from it is without its {}.", enumerated(program.notKept, "and")));
  return sentences;
}

/// .. and of one that is read as a drawing; `meant` is whether a toolpath was requested.
std::vector<std::string> drawingDoubtsOf(const GcodeProgram& program, bool meant) {
  std::vector<std::string> sentences;
  if (program.unrolled)
    sentences.push_back(
        fmt::format("Line {}: {} and other O-words (subroutines, loops, branches) are not run: what stands in them is read "
                    "once, as it stands.",
                    program.unrolled->first, program.unrolled->second));
  const bool told = program.unrolled && program.obstacle && program.obstacle->first == program.unrolled->first;
  if (program.obstacle && meant)
    sentences.push_back(fmt::format("The program is read as contours: line {} holds {}, which cannot be followed.",
                                    program.obstacle->first, program.obstacle->second));
  else if (program.obstacle && !told)
    sentences.push_back(
        fmt::format("Line {} holds {}, which is not followed.", program.obstacle->first, program.obstacle->second));
  for (const std::string& doubt : program.drawingDoubts) sentences.push_back(sentence(doubt));
  return sentences;
}

}  // namespace

Curves contoursOf(const GcodeProgram& program) {
  Curves drawing;
  Path path;
  const auto finish = [&](const Vec3& at) {
    if (path.segments.empty()) return;
    path.closed = (startPoint(path) - at.head<2>()).norm() < 1e-6;
    drawing.paths.push_back(std::move(path));
    path = {};
  };
  for (const GcodeMove& move : program.moves) {
    if (!move.inPlane) continue;
    const Vec2 from = move.from.head<2>(), to = move.to.head<2>();
    switch (move.motion) {
      case GcodeMotion::None:
        break;
      case GcodeMotion::Rapid:
        finish(move.from);
        break;
      case GcodeMotion::Line:
        if (to != from) path.segments.emplace_back(Line2{from, to});
        break;
      case GcodeMotion::Clockwise:
      case GcodeMotion::Counterclockwise:
        path.segments.emplace_back(arcOf(move));
        break;
      case GcodeMotion::Nurbs:
        path.segments.emplace_back(program.splines[move.spline]);
        break;
    }
  }
  if (!program.moves.empty()) finish(program.moves.back().to);
  return drawing;
}

Toolpath toolpathOf(const GcodeProgram& program) {
  if (program.obstacle)
    throw Error(ErrorCode::FormatDamaged,
                fmt::format("Line {}: {} cannot be followed.", program.obstacle->first, program.obstacle->second),
                "Write the program without it, with plain moves in one work offset.");
  return ToolpathMaker(program).make();
}

Format gcodeFormat() {
  Format format;
  format.id = "gcode";
  format.title = "G-code (LinuxCNC, GRBL)";
  format.extensions = {"ngc", "nc", "gcode", "tap"};
  ParameterSpec as = choice({"auto", "contours", "toolpath"});
  as.name = "as";
  as.fallback = "auto";
  as.help =
      "Read what the tool draws in the plane, or every move of it; auto: the moves when the program turns the spindle or "
      "names a tool and moves in z.";
  format.readOptions = {as};
  format.read = [](const std::filesystem::path& path, const Value& options, const Progress& progress) {
    GcodeProgram program = parseGcode(readFile(path), progress);
    const std::string wanted = options.value("as", "auto");
    const bool whole = wanted == "toolpath" || (wanted == "auto" && isMachining(program) && !program.obstacle);
    Imported imported;
    imported.warnings = whole ? doubtsOf(program) : drawingDoubtsOf(program, wanted == "auto" && isMachining(program));
    imported.shape = whole ? Shape(toolpathOf(program)) : Shape(contoursOf(program));
    for (const auto& [name, count] : program.counts.items()) imported.entities[name] = count;
    imported.skipped = std::move(program.skipped);
    return imported;
  };
  format.writes = {ShapeKind::Toolpath};
  format.writeOptions = gcodeWriteOptions();
  format.write = [](const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
    writeGcode(*shape.get<Toolpath>(), path, options, progress);
  };
  return format;
}

}  // namespace blossom
