#include <fmt/format.h>

#include <algorithm>

#include "core/angle.h"
#include "core/error.h"
#include "core/units.h"
#include "feature_groups.h"
#include "gouge_check.h"
#include "kernel/check/simulate.h"
#include "part_input.h"
#include "pocket_heights.h"
#include "pocket_place.h"
#include "residue_report.h"
#include "setup_check.h"
#include "toolpath_place.h"

namespace blossom::pocket {

namespace {

struct SimulateParameters : HolderParameters {
  double toolDiameter = 0, toolCorner = 0;
  double depth = 0, leave = 0;
  double tolerance = 0.01;
  SubShapeValue face;
  bool skipOpen = false;
};

void chooseTool(const SimulateParameters& p, Toolpath& path) {
  if (p.toolDiameter > 0) {
    path.cutter.diameter = p.toolDiameter;
    path.cutter.cornerRadius = p.toolCorner;
    path.cutter.vAngle = 0;
  }
  if (!(path.cutter.diameter > 0))
    throw Error(ErrorCode::InvalidInput, "The program does not say which tool it is for.",
                "Give the tool's diameter (--tool-diameter).");
  if (path.cutter.cornerRadius > path.cutter.diameter / 2)
    throw Error(ErrorCode::InvalidParameter, "The corner's radius is larger than the tool's.",
                "Give at most half the diameter.");
}

/// Where the part's drawing has its zero, at the part's top, in the work's coordinates: as the program's head tells; else as
/// it is drawn. A face of a solid keeps its height; where it is a pocket's floor, the top is where the pocket opens.
Vec3 placeOf(const Toolpath& path, const Part& part, double face, const Setup* setup) {
  if (path.task) return path.task->zero;
  if (const auto plane = setup ? planeIn(*setup, part) : std::nullopt) return *plane - Vec3(0, 0, face);
  if (!path.centred) return {0, 0, (part.looksUp ? part.height : part.placing.TranslationPart().Z()) - face};
  const auto [low, high] = boxOf(part.region);
  const Vec2 middle = (low + high) / 2;
  const Vec3 stock = path.stock.center();
  return {stock.x() - middle.x(), stock.y() - middle.y(), path.stock.high.z()};
}

/// What is given counts, then what the program's head or the part tells; 0 where nobody knows how deep the pocket is.
SimulationOptions optionsOf(const SimulateParameters& p, const Toolpath& path, const PocketHeights& heights) {
  SimulationOptions options{.depth = p.depth, .leave = p.leave, .tolerance = p.tolerance};
  if (options.depth == 0) options.depth = heights.depth;
  if (!path.task) return options;
  if (options.depth == 0) options.depth = path.task->depth;
  if (options.depth > path.task->leaveFloor) options.depth -= path.task->leaveFloor;
  if (options.leave == 0) options.leave = path.task->leaveWall;
  return options;
}

std::string tipText(const Vec3& at) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", at.x(), at.y(), at.z()); }

/// ", line 12" of the program that the move was read from.
std::string lineText(const Toolpath& path, std::size_t move) {
  const std::size_t line = path.moves[move].line;
  return line > 0 ? fmt::format(", line {}", line) : std::string();
}

void warnOfWalls(const Toolpath& path, const SimulationResult& result, const SimulationOptions& o, const Vec3& place,
                 std::vector<std::string>& warnings) {
  if (result.gouge > o.tolerance)
    warnings.push_back(fmt::format("The part is gouged by {:.3f} mm at {}{}.", result.gouge, tipText(result.gougeAt + place),
                                   lineText(path, result.gougeMove)));
  if (result.allowance > o.tolerance)
    warnings.push_back(fmt::format("{:.3f} mm of the {} mm that were to stay on the walls are cut away{}.", result.allowance,
                                   formatNumber(o.leave), lineText(path, result.allowanceMove)));
}

void warnOfRapids(const Toolpath& path, const SimulationResult& result, const Vec3& place,
                  std::vector<std::string>& warnings) {
  if (result.rapidsInStock > 0)
    warnings.push_back(fmt::format("{} rapid{} through material, the first to ({:.2f}, {:.2f}, {:.2f}){}.",
                                   result.rapidsInStock, result.rapidsInStock == 1 ? " runs" : "s run",
                                   result.rapidAt.x() + place.x(), result.rapidAt.y() + place.y(),
                                   result.rapidAt.z() + place.z(), lineText(path, result.rapidMove)));
}

void warnOfFloor(const Toolpath& path, const SimulationResult& result, const SimulationOptions& o, const Vec3& place,
                 std::vector<std::string>& warnings) {
  const ToolMove& deepest = path.moves[result.deepestMove];
  const std::string line = lineText(path, result.deepestMove);
  if (o.depth == 0)
    warnings.push_back(
        fmt::format("Neither the part nor the program tells how deep the pocket is: its floor is taken to be where the "
                    "deepest cut ends, at z = {:.3f}{}. Give the depth (--depth) to have it checked.",
                    deepest.to.z(), line));
  else if (result.missing > o.tolerance)
    warnings.push_back(fmt::format("The floor at z = {:.3f} is not reached: the deepest cut ends at z = {:.3f}{}.",
                                   place.z() - o.depth, deepest.to.z(), line));
}

/// Warnings for the operator of the machine.
void warnOfMoves(const Toolpath& path, std::vector<std::string>& warnings) {
  if (path.stock.empty) return;
  constexpr double visible = 1e-6;
  const auto deepest = std::min_element(path.moves.begin(), path.moves.end(),
                                        [](const ToolMove& a, const ToolMove& b) { return a.to.z() < b.to.z(); });
  if (deepest != path.moves.end() && deepest->to.z() < path.stock.low.z() - visible)
    warnings.push_back(fmt::format("The tool goes through the stock, which ends at z = {:.3f}, down to {}{}.",
                                   path.stock.low.z(), tipText(deepest->to),
                                   lineText(path, static_cast<std::size_t>(deepest - path.moves.begin()))));
}

/// A program knows where its part lies; the setup does, too.
void warnOfOtherZero(const Setup& setup, const Part& part, const Toolpath& path, std::vector<std::string>& warnings) {
  const auto plane = planeIn(setup, part);
  constexpr double same = 0.005;  // mm
  if (!path.task || !plane || (path.task->zero - *plane).head<2>().norm() <= same) return;
  const Vec3& zero = path.task->zero;
  warnings.push_back(fmt::format(
      "The program was written for another zero: its part lies at ({:.3f}, {:.3f}), that of the setup at ({:.3f}, "
      "{:.3f}).",
      zero.x(), zero.y(), plane->x(), plane->y()));
}

void checkSetup(const SimulateParameters& p, const Setup& setup, const Part& part, Toolpath& path, Evaluated& out,
                const Progress& progress) {
  warnOfOtherZero(setup, part, path, out.warnings);
  SetupFindings found = findingsIn(setup, path, assemblyOf(path.cutter, p), p.tolerance, progress);
  out.stats["collisions"] = found.collisions;
  out.stats["moves_outside_travel"] = found.outside;
  out.stats["removed_mm3"] = found.removed;
  path.marks.insert(path.marks.end(), found.marks.begin(), found.marks.end());
  for (std::string& each : found.told) out.warnings.push_back(std::move(each));
  for (std::string& each : found.notes) out.warnings.push_back(std::move(each));
}

Evaluated simulated(const SimulateParameters& p, const Inputs& inputs, const Progress& progress) {
  const Part part = partOf(inputs.of(1)[0], p.face, p.skipOpen ? OpenLines::LeaveOut : OpenLines::RefuseForNow);
  Toolpath path = inputs.get<Toolpath>(0);
  chooseTool(p, path);
  std::vector<std::string> ofHeights;
  const PocketHeights heights = path.task ? PocketHeights()
                                          : heightsOf(inputs.of(1)[0], p.face, part,
                                                      {.depth = p.depth, .tolerance = p.tolerance}, ofHeights, progress);
  const Setup* setup = inputs.of(2).empty() ? nullptr : inputs.of(2)[0].get<Setup>();
  const Vec3 place = placeOf(path, part, heights.face, setup);
  const SimulationOptions options = optionsOf(p, path, heights);
  const SimulationResult result = simulate(translated(path, -place), part.region, options, progress.part(0, 0.6));
  path.gouge = result.gouge;
  path.residue = result.residue;
  path.marks.clear();
  Evaluated out;
  out.warnings = part.warnings;
  if (p.depth > 0) out.warnings.insert(out.warnings.end(), ofHeights.begin(), ofHeights.end());
  constexpr double visible = 1e-6;
  if (result.gouge > visible) {
    const Vec3 at = result.gougeAt + place;
    path.marks.push_back({at, MarkKind::Gouge});
    out.stats["gouge_at"] = tipText(at);
  }
  warnOfWalls(path, result, options, place, out.warnings);
  if (!setup) warnOfRapids(path, result, place, out.warnings);  // else the stock tells
  warnOfFloor(path, result, options, place, out.warnings);
  reportResidue(result, place, path, out);
  out.stats["reachable_mm2"] = result.reachable;
  out.stats["rapids_in_stock"] = result.rapidsInStock;
  out.stats["simulation_resolution_mm"] = result.resolution;
  if (path.cutter.cornerRadius > 0) out.stats["ridge_mm"] = result.ridge;
  if (path.blending > 0) out.stats["blending_mm"] = path.blending;
  warnOfMoves(path, out.warnings);
  if (setup) checkSetup(p, *setup, part, path, out, progress.part(0.6, 1));
  if (!result.residue) out.warnings.emplace_back("The residue of V bits is not measured.");
  path.gougeOf = gougeOf(part.region, place, options);
  out.shape = std::move(path);
  return out;
}

}  // namespace

FeatureType simulateFeature() {
  using P = SimulateParameters;
  auto type =
      feature<P>("pocket.simulate", "Simulate", "Sweeps a program's tool along its moves and measures gouge and residue.")
          .icon("simulate")
          .produces({ShapeKind::Toolpath})
          .input(
              {.name = "program",
               .help =
                   "A toolpath or a G-code program. In a document, a program that starts no spindle (M3) and names no tool "
                   "(T) is one when it is imported as \"toolpath\".",
               .kinds = {ShapeKind::Toolpath},
               .asks = "a program to simulate",
               .importedWith = {{"gcode", {{"as", "toolpath"}}}}})
          .input(partInput("the part that it cuts"))
          .input(
              {.name = "setup",
               .help =
                   "How the part is held: the whole tool is swept against the solid and the clamps, from the work's zero.",
               .kinds = {ShapeKind::Setup},
               .minimum = 0,
               .asks = "the setup that it runs in"})
          .parameter("tool-diameter", &P::toolDiameter, lengthFromZero(), "0: the tool that the program names.")
          .parameter("tool-corner", &P::toolCorner, lengthFromZero(), "Corner radius of the given tool.")
          .parameter("depth", &P::depth, lengthFromZero(), "Depth of the pocket in the part; 0: as in the program's head.")
          .parameter("leave", &P::leave, lengthFromZero(), "Stock to leave on the walls; 0: as in the program's head.")
          .parameter("tolerance", &P::tolerance, positiveLength(),
                     "Residue narrower than this does not count; a deeper gouge is a warning.")
          .parameter("face", &P::face, partFace(), partFaceHelp)
          .parameter("skip-open", &P::skipOpen, flag(), skipOpenHelp)
          .example("blossom simulate plate.ngc --part plate.dxf")
          .example("blossom simulate foreign.nc --part plate.dxf --tool-diameter 6 --depth 10 --json")
          .example("blossom simulate plate.ngc part.step --face 4")
          .example(
              "blossom simulate plate.ngc --part part.step --face 4 --setup job.blossom#setup --flute-length 20 "
              "--stick-out 30 --holder-diameter 40");
  return withHolder(type).evaluate(simulated);
}

}  // namespace blossom::pocket
