#include <fmt/format.h>

#include <algorithm>

#include "core/angle.h"
#include "core/error.h"
#include "feature_groups.h"
#include "kernel/simulate.h"
#include "part_input.h"
#include "toolpath_place.h"

namespace blossom::pocket {

namespace {

struct SimulateParameters {
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

/// Where the part lies in the work's coordinates: in the middle of the stock under its top, or as drawn when the program
/// does not know its stock.
Vec3 placeOf(const Toolpath& path, const Part& part) {
  if (path.stock.empty) return {0, 0, part.placing.TranslationPart().Z()};
  const auto [low, high] = boxOf(part.region);
  const Vec2 middle = (low + high) / 2;
  const Vec3 stock = path.stock.center();
  return {stock.x() - middle.x(), stock.y() - middle.y(), path.stock.high.z()};
}

std::string tipText(const Vec3& at) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", at.x(), at.y(), at.z()); }

/// What whoever stands at the machine would want to hear before the start.
void warnOfMoves(const Toolpath& path, std::vector<std::string>& warnings) {
  const auto cuts = [](const ToolMove& move) { return move.kind != MoveKind::Rapid; };
  const auto still = std::find_if(path.moves.begin(), path.moves.end(),
                                  [&](const ToolMove& move) { return cuts(move) && !(move.feed > 0); });
  if (still != path.moves.end()) warnings.push_back(fmt::format("A cut without a feed goes to {}.", tipText(still->to)));
  if (path.stock.empty) return;
  constexpr double visible = 1e-6;
  const auto deepest = std::min_element(path.moves.begin(), path.moves.end(),
                                        [](const ToolMove& a, const ToolMove& b) { return a.to.z() < b.to.z(); });
  if (deepest != path.moves.end() && deepest->to.z() < path.stock.low.z() - visible)
    warnings.push_back(fmt::format("The tool goes through the stock, which ends at z = {:.3f}, down to {}.",
                                   path.stock.low.z(), tipText(deepest->to)));
}

Evaluated simulated(const SimulateParameters& p, const Inputs& inputs, const Progress& progress) {
  const Part part = partOf(inputs.of(1)[0], p.face, p.skipOpen ? OpenLines::LeaveOut : OpenLines::RefuseForNow);
  Toolpath path = inputs.get<Toolpath>(0);
  chooseTool(p, path);
  const Vec3 place = placeOf(path, part);
  const SimulationOptions options{.depth = p.depth, .leave = p.leave, .tolerance = p.tolerance};
  const SimulationResult result = simulate(translated(path, -place), part.region, options, progress);
  path.gouge = result.gouge;
  path.residue = result.residue;
  path.marks.clear();
  Evaluated out;
  out.warnings = part.warnings;
  constexpr double visible = 1e-6;
  if (result.gouge > visible) {
    const Vec3 at = result.gougeAt + place;
    path.marks.push_back(at);
    out.stats["gouge_at"] = tipText(at);
    if (result.gouge > p.tolerance)
      out.warnings.push_back(fmt::format("The part is gouged by {:.3f} mm at {}.", result.gouge, tipText(at)));
  }
  for (const Vec2& at : result.residueAt) path.marks.emplace_back(at.x() + place.x(), at.y() + place.y(), place.z());
  out.stats["reachable_mm2"] = result.reachable;
  out.stats["rapids_in_stock"] = result.rapidsInStock;
  out.stats["simulation_resolution_mm"] = result.resolution;
  if (result.rapidsInStock > 0)
    out.warnings.push_back(fmt::format("{} rapid{} through material, the first to ({:.2f}, {:.2f}, {:.2f}).",
                                       result.rapidsInStock, result.rapidsInStock == 1 ? " runs" : "s run",
                                       result.rapidAt.x() + place.x(), result.rapidAt.y() + place.y(),
                                       result.rapidAt.z() + place.z()));
  warnOfMoves(path, out.warnings);
  if (!result.residue) out.warnings.emplace_back("The residue of V bits is not measured.");
  out.shape = std::move(path);
  return out;
}

}  // namespace

FeatureType simulateFeature() {
  using P = SimulateParameters;
  InputSpec part = partInput();
  part.name = "part";
  return feature<P>("pocket.simulate", "Simulate", "Sweeps a program's tool along its moves and measures gouge and residue.")
      .icon("simulate")
      .gives({ShapeKind::Toolpath})
      .input({.name = "program", .help = "A toolpath, or a G-code program that moves in z.", .kinds = {ShapeKind::Toolpath}})
      .input(part)
      .parameter("tool-diameter", &P::toolDiameter, lengthFromZero(), "0: the tool that the program names.")
      .parameter("tool-corner", &P::toolCorner, lengthFromZero(), "Radius of the corners of the tool given.")
      .parameter("depth", &P::depth, lengthFromZero(), "Depth of the part; 0: as deep as the program cuts.")
      .parameter("leave", &P::leave, lengthFromZero(), "What was to stay on the walls.")
      .parameter("tolerance", &P::tolerance, positiveLength(),
                 "Residue narrower than this does not count; a deeper gouge is a warning.")
      .parameter("face", &P::face, partFace(), partFaceHelp)
      .parameter("skip-open", &P::skipOpen, flag(), skipOpenHelp)
      .example("blossom simulate plate.ngc --part plate.dxf")
      .example("blossom simulate foreign.nc --part plate.dxf --tool-diameter 6 --depth 10 --json")
      .example("blossom simulate plate.ngc part.step --face 4")
      .evaluate(simulated);
}

}  // namespace blossom::pocket
