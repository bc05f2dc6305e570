#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "feature_groups.h"
#include "gouge_check.h"
#include "kernel/check/simulate.h"
#include "kernel/path/pocket_path.h"
#include "part_input.h"
#include "pocket_advice.h"
#include "pocket_heights.h"
#include "pocket_parameters.h"
#include "pocket_place.h"
#include "residue_report.h"
#include "toolpath_place.h"
#include "uncut_report.h"

namespace blossom::pocket {

namespace {

void warnOfNarrow(const PocketResult& made, std::vector<std::string>& warnings) {
  if (made.tooNarrow.empty()) return;
  const Vec2& at = made.tooNarrow.front();
  warnings.push_back(fmt::format("{} of the pockets {} too narrow for the tool and left out, the first at ({:.2f}, {:.2f}).",
                                 made.tooNarrow.size(), made.tooNarrow.size() == 1 ? "is" : "are", at.x(), at.y()));
}

/// Round corners leave ridges between passes that lie further apart than the flat of the tool is wide.
void warnOfRidges(const PocketOptions& o, std::vector<std::string>& warnings) {
  const double corner = o.cutter.cornerRadius;
  const double beside = (o.stepover - (o.cutter.diameter - 2 * corner)) / 2;
  if (corner <= 0 || beside <= 0) return;
  const double height = corner - std::sqrt(std::max(0.0, corner * corner - beside * beside));
  warnings.push_back(fmt::format("The tool's round corners leave ridges of {:.3f} mm on the floor between passes.", height));
}

/// Programs are written up to a kilometre from the work's zero.
void warnOfDistance(const Toolpath& path, std::vector<std::string>& warnings) {
  constexpr double farthest = 1e6;
  double most = 0;
  for (const ToolMove& move : path.moves) most = std::max(most, move.to.cwiseAbs().maxCoeff());
  if (most < farthest) return;
  warnings.push_back(
      fmt::format("The path lies {:.0f} mm from the work's zero, farther than G-code is written (1,000,000 mm): "
                  "set the zero to the stock's corner or centre (--zero corner).",
                  most));
}

SimulationOptions checkOf(const PocketParameters& p) { return {.depth = p.depth - p.leaveFloor, .leave = p.leaveWall}; }

/// The most by which a control may round corners of the way; it counts among the gouges of the simulation.
double blendingOf(const PocketParameters& p) { return std::min(0.005, p.tolerance); }

/// Nothing leaves here that was not driven through once.
SimulationResult addSimulation(const PocketParameters& p, const Region& region, Toolpath& path, Evaluated& out,
                               const Progress& progress) {
  SimulationResult simulated = simulate(path, region, checkOf(p), progress);
  path.gouge = simulated.gouge;
  path.residue = simulated.residue;
  out.stats["reachable_mm2"] = simulated.reachable;
  out.stats["simulation_resolution_mm"] = simulated.resolution;
  constexpr double rounding = 1e-3;
  if (simulated.gouge > p.tolerance + rounding || simulated.rapidsInStock > 0) {
    const bool gouges = simulated.rapidsInStock == 0;
    const Vec3& at = gouges ? simulated.gougeAt : simulated.rapidAt;
    throw Error(ErrorCode::Internal,
                gouges ? fmt::format("The path would cut {:.4f} mm into the part near ({:.2f}, {:.2f}).", simulated.gouge,
                                     at.x(), at.y())
                       : fmt::format("A rapid would run through material to ({:.2f}, {:.2f}).", at.x(), at.y()),
                "Try a smaller tolerance, and please report the drawing.");
  }
  reportResidue(simulated, {0, 0, -p.depth + p.leaveFloor}, path, out);
  return simulated;
}

/// Into the part, a clamp or beyond the machine's travel.
void refuseCollisions(const PocketParameters& p, const Setup& setup, const Toolpath& path, Evaluated& out,
                      const Progress& progress) {
  const SetupFindings found = findingsIn(setup, path, assemblyOf(path.cutter, p), p.tolerance, progress);
  out.stats["collisions"] = found.collisions;
  out.stats["removed_mm3"] = found.removed;
  out.warnings.insert(out.warnings.end(), found.notes.begin(), found.notes.end());
  if (found.told.empty()) return;
  const bool cutsPart = found.told.front().starts_with("The cutter runs into the part");
  throw Error(ErrorCode::InvalidInput, found.told.front(),
              cutsPart
                  ? "The part of a setup is what is to be made, with its pocket in it; what it is cut from is the stock."
                  : "Move the clamp, let the tool stick out farther, or choose another tool or zero.");
}

Evaluated pocketOf(const PocketParameters& given, const Inputs& inputs, const Progress& progress) {
  const Shape& input = inputs.of(0)[0];
  const Part part = partOf(input, given.face, given.skipOpen ? OpenLines::LeaveOut : OpenLines::RefuseForNow);
  Evaluated out;
  out.warnings = part.warnings;
  PocketHeights heights =
      heightsOf(input, given.face, part, {given.depth, given.faceIs, given.tolerance}, out.warnings, progress.part(0, 0.1));
  const Setup* setup = inputs.of(1).empty() ? nullptr : inputs.of(1)[0].get<Setup>();
  const PocketPlace place = setup ? placeInSetup(*setup, part, heights) : placeOfItsOwn(given, part, heights);
  PocketParameters p = given;
  p.depth = heights.depth;
  PocketOptions options = optionsOf(p);
  options.safeHeight += heights.above;
  PocketResult made = pocketPath(part.region, options, progress.part(0.1, 0.6));
  refuseHits(made.path, heights, part, p.tolerance, progress);
  warnOfNarrow(made, out.warnings);
  warnOfRidges(options, out.warnings);
  if (made.plunged > 0)
    out.warnings.push_back(fmt::format("{} entr{} no room for a {}: the tool plunges there.", made.plunged,
                                       made.plunged == 1 ? "y has" : "ies have",
                                       p.entry == Entry::Helix ? "helix" : "ramp"));
  for (std::string& each : adviceOn(optionsOf(p))) out.warnings.push_back(std::move(each));
  Toolpath path = std::move(made.path);
  path.blending = blendingOf(p);
  const SimulationResult simulated = addSimulation(p, part.region, path, out, progress.part(0.6, 0.85));
  const double floor = -p.depth + p.leaveFloor;
  const Uncut uncut = uncutOf(part.region, path, {.floor = floor, .tolerance = 2 * p.tolerance}, progress.part(0.85, 0.95));
  const CoverageOptions measured{p.toolDiameter / 2, p.leaveWall, checkOf(p).tolerance};
  reportCoverage(coverageOf(part.region, uncut, simulated, measured, progress.part(0.95, 0.98)), out);
  reportUncut(uncut, part.region, measured, floor, path, out, progress.part(0.98, 1));
  path.stock = place.stock;
  path.workOffset = fmt::format("G{}", 54 + static_cast<int>(p.workOffset));
  out.stats["depths"] = made.depths;
  out.stats["loops"] = made.loops;
  out.stats["spokes"] = made.spokes;
  out.stats["entries"] = made.entries;
  out.stats["moves"] = path.moves.size();
  path.task = PocketTask{.depth = p.depth, .leaveWall = p.leaveWall, .leaveFloor = p.leaveFloor};
  path.gougeOf = gougeOf(part.region, place.toWork, checkOf(p));
  path = translated(std::move(path), place.toWork);
  warnOfDistance(path, out.warnings);
  if (setup) refuseCollisions(p, *setup, path, out, progress);
  out.shape = std::move(path);
  return out;
}

ParameterSpec rampAngle() {
  ParameterSpec spec = angle();
  spec.minimum = 0;
  spec.aboveMinimum = true;
  spec.maximum = 90;
  return spec;
}

ParameterSpec feedRate() {
  ParameterSpec spec = number(0, 1e6);
  spec.aboveMinimum = true;
  return spec;
}

/// How the tool cuts.
void declareCutting(FeatureBuilder<PocketParameters>& type) {
  using P = PocketParameters;
  type.parameter("tool-diameter", &P::toolDiameter, positiveLength(), "Diameter of the end mill.")
      .parameter("depth", &P::depth, positiveLength(), "Depth of the pocket; unused when its floor is picked.")
      .parameter("stepover", &P::stepover, text(), "Distance between passes: a share of the diameter (45%) or a length.")
      .parameter("stepdown", &P::stepdown, lengthFromZero(),
                 "Largest depth of one step; all steps are equal. 0: half the diameter.")
      .parameter("direction", &P::direction, choice({"climb", "conventional"}),
                 "The side of the tool with the material: climb cuts from thick to thin chips.")
      .parameter("entry", &P::entry, choice({"ramp", "helix", "plunge"}), "How the tool gets down into the material.")
      .parameter("ramp-angle", &P::rampAngle, onlyFor(rampAngle(), "entry", {"ramp", "helix"}), "Angle of ramp and helix.")
      .parameter("finish", &P::finish, lengthFromZero(),
                 "Stock that the passes leave on the walls for a last pass at full depth; 0: no such pass.")
      .parameter("leave-wall", &P::leaveWall, lengthFromZero(), "Stock to leave on the walls.")
      .parameter("leave-floor", &P::leaveFloor, lengthFromZero(), "Stock to leave on the floor.")
      .parameter("feed", &P::feed, feedRate(), "Cutting feed in mm/min.")
      .parameter("plunge-feed", &P::plungeFeed, feedRate(), "Plunge feed in mm/min.")
      .parameter("spindle", &P::spindle, number(0, 1e6),
                 "Revolutions per minute; 0: the program does not start the spindle.")
      .parameter("safe-height", &P::safeHeight, positiveLength(),
                 "Height above the stock and the whole solid at which the tool crosses.")
      .parameter("approach", &P::approach, positiveLength(), "Height above the material at which rapids down end.");
}

/// Where the part lies, and the tool in the changer.
void declarePlace(FeatureBuilder<PocketParameters>& type) {
  using P = PocketParameters;
  type.parameter("zero", &P::zero, onlyWithout(choice({"drawing", "corner", "center"}), "setup"),
                 "The work's zero: that of the drawing, or the stock's lower left corner or centre.")
      .parameter("zero-height", &P::zeroHeight, onlyWithout(choice({"top", "bottom"}), "setup"),
                 "The height of zero: the stock's top or bottom.")
      .parameter("work-offset", &P::workOffset, choice({"G54", "G55", "G56", "G57", "G58", "G59"}),
                 "The work offset of the control with the work's zero.")
      .parameter("stock-margin", &P::stockMargin, onlyWithout(lengthFromZero(), "setup"),
                 "Distance by which the stock exceeds the part.")
      .parameter("stock-thickness", &P::stockThickness, onlyWithout(lengthFromZero(), "setup"),
                 "0: 2 mm more than the pocket is deep, or as thick as the solid.")
      .parameter("tool-corner", &P::toolCorner, lengthFromZero(), "Radius of the end mill's corners.")
      .parameter("tool-number", &P::toolNumber, count(1, 9999), "Place in the tool changer.")
      .parameter("tolerance", &P::tolerance, positiveLength(), "Largest deviation of the path.")
      .parameter("face", &P::face, partFace(), partFaceHelp)
      .parameter("face-is", &P::faceIs, choice({"automatic", "top", "floor"}),
                 "Role of the picked face; automatic: the floor when walls rise all around it.")
      .parameter("skip-open", &P::skipOpen, flag(), skipOpenHelp);
}

FeatureType pocketFeature() {
  auto type =
      feature<PocketParameters>("pocket.pocket", "Pocket",
                                "A toolpath that clears a part down to a depth, islands left standing.")
          .icon("pocket")
          .keywords({"mill", "cam", "toolpath", "g-code", "clear"})
          .produces({ShapeKind::Toolpath})
          .input(partInput("an outline or solid to cut a pocket into"))
          .input(
              {.name = "setup",
               .help = "How the part is held: it gives the stock, the zero and the heights, and nothing in it may be hit.",
               .kinds = {ShapeKind::Setup},
               .minimum = 0,
               .asks = "the setup that the part is cut in"});
  declareCutting(type);
  declarePlace(type);
  type.example("blossom pocket plate.dxf --tool-diameter 6 --depth 10 --stepdown 2.5 -o plate.ngc")
      .example("blossom pocket cover.step --face 4 --tool-diameter 1/8in --depth 3 --entry helix -o cover.ngc")
      .example(
          "blossom pocket --text Blossom --font \"DejaVu Serif\" --text.height 40 --tool-diameter 3 --depth 2 -o "
          "name.ngc")
      .example("blossom pocket sign.svg --tool-diameter 3 --depth 2 --finish 0.2 --post grbl -o sign.nc")
      .example(
          "blossom pocket cover.step --setup job.blossom#setup --face 4 --depth 3 --flute-length 15 --stick-out 25 "
          "--holder-diameter 40 -o cover.ngc");
  return withHolder(type).evaluate(pocketOf);
}

}  // namespace

void registerPocketFeatures(Registry& registry) {
  registry.addAll(setupFeature(), pocketFeature(), simulateFeature(), carveFeature());
}

}  // namespace blossom::pocket
