#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "core/units.h"
#include "feature_groups.h"
#include "kernel/pocket_path.h"
#include "kernel/simulate.h"
#include "part_input.h"
#include "toolpath_place.h"

namespace blossom::pocket {

namespace {

enum class Direction { Climb, Conventional };
enum class Zero { Drawing, Corner, Center };
enum class ZeroHeight { Top, Bottom };
enum class WorkOffset { G54, G55, G56, G57, G58, G59 };

struct PocketParameters {
  double toolDiameter = 6, toolCorner = 0;
  int toolNumber = 1;
  double depth = 5, stepdown = 0;
  std::string stepover = "45%";
  Direction direction = Direction::Climb;
  Entry entry = Entry::Ramp;
  double rampAngle = 3;
  double leaveWall = 0, leaveFloor = 0, finish = 0;
  double feed = 800, plungeFeed = 200, spindle = 12000;
  double safeHeight = 5, approach = 1;
  double stockMargin = 5, stockThickness = 0;
  Zero zero = Zero::Drawing;
  ZeroHeight zeroHeight = ZeroHeight::Top;
  WorkOffset workOffset = WorkOffset::G54;
  double tolerance = 0.005;
  SubShapeValue face;
  bool skipOpen = false;
};

/// "45%" of the tool's diameter, or a length.
double stepoverOf(const std::string& text, double diameter) {
  const std::size_t mark = text.find('%');
  const bool percent = mark != std::string::npos;
  double step = 0;
  try {
    step = percent ? parseNumber(text.substr(0, mark)) / 100 * diameter : parseLength(text);
  } catch (const Error& error) {
    throw Error(ErrorCode::InvalidParameter, fmt::format("The stepover \"{}\" is no number: {}", text, error.message()),
                "Write a share of the tool's diameter such as 45%, or a length such as 2.5 mm.");
  }
  if (percent && text.find_first_not_of(" \t", mark + 1) != std::string::npos)
    throw Error(ErrorCode::InvalidParameter, fmt::format("The stepover \"{}\" goes on after the %.", text),
                "Write 45% or 2.5 mm.");
  if (!(step > 0) || !std::isfinite(step))
    throw Error(ErrorCode::InvalidParameter, fmt::format("The stepover must be above 0; it is \"{}\".", text),
                "40% to 50% of the diameter is usual.");
  return step;
}

PocketOptions optionsOf(const PocketParameters& p) {
  PocketOptions o;
  o.cutter = {
      .diameter = p.toolDiameter, .cornerRadius = p.toolCorner, .vAngle = 0, .number = p.toolNumber, .spindle = p.spindle};
  o.depth = p.depth;
  o.stepdown = p.stepdown;
  o.stepover = stepoverOf(p.stepover, p.toolDiameter);
  o.climb = p.direction == Direction::Climb;
  o.entry = p.entry;
  o.rampAngle = toRadians(p.rampAngle);
  o.leaveWall = p.leaveWall;
  o.leaveFloor = p.leaveFloor;
  o.finish = p.finish;
  o.safeHeight = p.safeHeight;
  o.approach = p.approach;
  o.feed = p.feed;
  o.plungeFeed = p.plungeFeed;
  o.tolerance = p.tolerance;
  return o;
}

/// The stock around the part, its top at z = 0.
Bounds stockOf(const PocketParameters& p, const Region& region) {
  const auto [low, high] = boxOf(region);
  constexpr double below = 2;  // mm left under the pocket when nothing is said
  const double thickness = p.stockThickness > 0 ? p.stockThickness : p.depth + below;
  if (thickness < p.depth)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The stock is {} mm thick, and the pocket would be {} mm deep.", formatNumber(thickness),
                            formatNumber(p.depth)),
                "Use thicker stock, or 0 for as thick as needed.");
  Bounds stock;
  stock.add({low.x() - p.stockMargin, low.y() - p.stockMargin, -thickness});
  stock.add({high.x() + p.stockMargin, high.y() + p.stockMargin, 0});
  return stock;
}

/// From where the drawing has its zero to where the work has it.
Vec3 toWorkZero(const PocketParameters& p, const Part& part, const Bounds& stock) {
  Vec3 by = Vec3::Zero();
  if (p.zero == Zero::Corner) by.head<2>() = -stock.low.head<2>();
  if (p.zero == Zero::Center) by.head<2>() = -stock.center().head<2>();
  if (p.zeroHeight == ZeroHeight::Bottom) by.z() = -stock.low.z();
  const bool looksUp = part.placing.Form() == gp_Identity || part.placing.Form() == gp_Translation;
  if (p.zero == Zero::Drawing && p.zeroHeight == ZeroHeight::Top && looksUp)
    by.z() = part.placing.TranslationPart().Z();  // a face keeps its height
  return by;
}

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

/// Nothing leaves here that was not driven through once.
void addSimulation(const PocketParameters& p, const Region& region, Toolpath& path, Evaluated& out,
                   const Progress& progress) {
  const SimulationOptions options{.depth = p.depth - p.leaveFloor, .leave = p.leaveWall};
  const SimulationResult simulated = simulate(path, region, options, progress);
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
  for (const Vec2& place : simulated.residueAt) path.marks.emplace_back(place.x(), place.y(), -p.depth + p.leaveFloor);
  if (simulated.residue && *simulated.residue > 0)
    out.warnings.push_back(
        fmt::format("{:.3f} mm² that the tool could reach are left; marks show where.", *simulated.residue));
}

Evaluated pocketOf(const PocketParameters& p, const Inputs& inputs, const Progress& progress) {
  const Part part = partOf(inputs.of(0)[0], p.face, p.skipOpen ? OpenLines::LeaveOut : OpenLines::RefuseForNow);
  const PocketOptions options = optionsOf(p);
  PocketResult made = pocketPath(part.region, options, progress.part(0, 0.6));
  Evaluated out;
  out.warnings = part.warnings;
  warnOfNarrow(made, out.warnings);
  warnOfRidges(options, out.warnings);
  if (made.plunged > 0)
    out.warnings.push_back(fmt::format("{} entr{} no room for a {}: the tool plunges there.", made.plunged,
                                       made.plunged == 1 ? "y has" : "ies have",
                                       p.entry == Entry::Helix ? "helix" : "ramp"));
  Toolpath path = std::move(made.path);
  addSimulation(p, part.region, path, out, progress.part(0.6, 1));
  path.stock = stockOf(p, part.region);
  path.workOffset = fmt::format("G{}", 54 + static_cast<int>(p.workOffset));
  out.stats["depths"] = made.depths;
  out.stats["loops"] = made.loops;
  out.stats["spokes"] = made.spokes;
  out.stats["entries"] = made.entries;
  out.stats["moves"] = path.moves.size();
  const Vec3 by = toWorkZero(p, part, path.stock);
  out.shape = translated(std::move(path), by);
  return out;
}

ParameterSpec rampAngle() {
  ParameterSpec spec = angle();
  spec.least = 0;
  spec.aboveLeast = true;
  spec.greatest = 90;
  return spec;
}

ParameterSpec feedRate() {
  ParameterSpec spec = number(0, 1e6);
  spec.aboveLeast = true;
  return spec;
}

FeatureType pocketFeature() {
  using P = PocketParameters;
  return feature<P>("pocket.pocket", "Pocket", "A toolpath that clears a part down to a depth, islands left standing.")
      .icon("pocket")
      .gives({ShapeKind::Toolpath})
      .input(partInput())
      .parameter("tool-diameter", &P::toolDiameter, positiveLength(), "Diameter of the end mill.")
      .parameter("depth", &P::depth, positiveLength(), "How deep the pocket is.")
      .parameter("stepover", &P::stepover, text(), "From pass to pass: a share of the diameter (45%) or a length.")
      .parameter("stepdown", &P::stepdown, lengthFromZero(),
                 "Most that one depth lies below the last; all are evenly deep. 0: half the diameter.")
      .parameter("direction", &P::direction, choice({"climb", "conventional"}),
                 "On which side of the tool the material lies: climb cuts it from thick to thin.")
      .parameter("entry", &P::entry, choice({"ramp", "helix", "plunge"}), "How the tool gets down into the material.")
      .parameter("ramp-angle", &P::rampAngle, rampAngle(), "How steeply ramp and helix fall.")
      .parameter("finish", &P::finish, lengthFromZero(),
                 "What the passes leave on the walls for a last pass at full depth; 0: no such pass.")
      .parameter("leave-wall", &P::leaveWall, lengthFromZero(), "What stays on the walls in the end.")
      .parameter("leave-floor", &P::leaveFloor, lengthFromZero(), "What stays on the floor.")
      .parameter("feed", &P::feed, feedRate(), "Speed of cutting in mm a minute.")
      .parameter("plunge-feed", &P::plungeFeed, feedRate(), "Speed of going down in mm a minute.")
      .parameter("spindle", &P::spindle, number(0, 1e6), "Revolutions a minute; 0: the program does not turn the spindle.")
      .parameter("safe-height", &P::safeHeight, positiveLength(), "Above the stock, where the tool crosses it.")
      .parameter("approach", &P::approach, positiveLength(), "Above the material, where rapids down end.")
      .parameter("zero", &P::zero, choice({"drawing", "corner", "center"}),
                 "The work's zero: that of the drawing, or the stock's lower left corner or centre.")
      .parameter("zero-height", &P::zeroHeight, choice({"top", "bottom"}), "The height of zero: the stock's top or bottom.")
      .parameter("work-offset", &P::workOffset, choice({"G54", "G55", "G56", "G57", "G58", "G59"}),
                 "The memory of the control that holds the work's zero.")
      .parameter("stock-margin", &P::stockMargin, lengthFromZero(), "How far the stock reaches beyond the part.")
      .parameter("stock-thickness", &P::stockThickness, lengthFromZero(), "0: 2 mm more than the pocket is deep.")
      .parameter("tool-corner", &P::toolCorner, lengthFromZero(), "Radius of the end mill's corners.")
      .parameter("tool-number", &P::toolNumber, count(1, 9999), "Place in the tool changer.")
      .parameter("tolerance", &P::tolerance, positiveLength(), "Most that the path may be off.")
      .parameter("face", &P::face, partFace(), partFaceHelp)
      .parameter("skip-open", &P::skipOpen, flag(), skipOpenHelp)
      .example("blossom pocket plate.dxf --tool-diameter 6 --depth 10 --stepdown 2.5 -o plate.ngc")
      .example("blossom pocket cover.step --face 4 --tool-diameter 1/8in --depth 3 --entry helix -o cover.ngc")
      .example(
          "blossom pocket --text Blossom --font \"DejaVu Serif\" --text.height 40 --tool-diameter 3 --depth 2 -o name.ngc")
      .example("blossom pocket sign.svg --tool-diameter 3 --depth 2 --finish 0.2 --post grbl -o sign.nc")
      .evaluate(pocketOf);
}

}  // namespace

void registerPocketFeatures(Registry& registry) { registry.addAll(pocketFeature(), simulateFeature()); }

}  // namespace blossom::pocket
