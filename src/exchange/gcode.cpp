#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/file.h"
#include "exchange/format.h"
#include "exchange/gcode_program.h"
#include "exchange/gcode_write.h"
#include "geometry/planar.h"

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

/// Polylines stand for G5.2 curves in toolpaths within this distance.
constexpr double nurbsChord = 1e-3;

/// The leading rapids tell where the tool begins: until each of x, y and z was named it may be anywhere.
std::size_t firstKnown(const GcodeProgram& program) {
  bool plane = false, height = false;
  std::size_t i = 0;
  for (; i < program.moves.size() && program.moves[i].motion == GcodeMotion::Rapid && !(plane && height); ++i) {
    plane = plane || program.moves[i].inPlane;
    height = height || program.moves[i].from.z() != program.moves[i].to.z();
  }
  return i;
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
  Toolpath path;
  path.cutter = program.cutter;
  path.stock = program.stock;
  path.passes = program.passes;
  path.workOffset = program.workOffset;
  const std::size_t first = firstKnown(program);
  path.start = first > 0 ? program.moves[first - 1].to : Vec3(Vec3::Zero());
  for (std::size_t i = first; i < program.moves.size(); ++i) {
    const GcodeMove& move = program.moves[i];
    const bool round = move.motion == GcodeMotion::Clockwise || move.motion == GcodeMotion::Counterclockwise;
    if (move.to == move.from && !round) continue;
    ToolMove made;
    made.to = move.to;
    made.feed = move.motion == GcodeMotion::Rapid ? 0 : move.feed;
    constexpr double level = 1e-9;
    made.kind = move.motion == GcodeMotion::Rapid     ? MoveKind::Rapid
                : move.to.z() < move.from.z() - level ? MoveKind::Plunge
                                                      : MoveKind::Feed;
    made.turn = !round ? 0 : move.motion == GcodeMotion::Clockwise ? -1 : 1;
    made.center = round ? move.center : Vec2(Vec2::Zero());
    if (move.motion == GcodeMotion::Nurbs) {
      for (const Vec2& p : flatten(Segment(program.splines[move.spline]), nurbsChord)) {
        made.to = {p.x(), p.y(), move.to.z()};
        path.moves.push_back(made);
      }
      continue;
    }
    path.moves.push_back(made);
  }
  if (path.moves.empty())
    throw Error(ErrorCode::FormatDamaged, "The program does not move the tool.", "Check that the file is complete.");
  return path;
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
    if (wanted == "auto" && isMachining(program) && program.obstacle)
      imported.warnings.push_back(fmt::format("The program is read as contours: line {} holds {}, which cannot be followed.",
                                              program.obstacle->first, program.obstacle->second));
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
