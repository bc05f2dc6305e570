#include "setup_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/units.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/shape.h"
#include "kernel/setup/collision.h"
#include "kernel/setup/stock_sweep.h"
#include "shape_triangles.h"

namespace blossom::pocket {

namespace {

constexpr double clampsMayBe = 1e-3;  // mm, touching is no collision

const char* nameOf(ToolPart part) {
  switch (part) {
    case ToolPart::Shank:
      return "shank";
    case ToolPart::Holder:
      return "holder";
    case ToolPart::Flutes:
      break;
  }
  return "cutter";
}

std::string placeText(const Vec3& at) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", at.x(), at.y(), at.z()); }

std::string lineOf(const Toolpath& path, std::size_t move) {
  const std::size_t line = path.moves[move].line;
  return line > 0 ? fmt::format(", line {}", line) : std::string();
}

std::string othersOf(std::size_t count) {
  if (count <= 1) return ".";
  return fmt::format(", and in {} more move{}.", count - 1, count == 2 ? "" : "s");
}

class SetupChecker {
 public:
  SetupChecker(const Toolpath& path, const ToolAssembly& tool) : path_(path), tool_(tool) {}

  void sweep(const std::string& what, Triangles triangles, double allowed, const Progress& progress) {
    const auto found = collisionsOf(path_, tool_, Obstacles(std::move(triangles), progress), {allowed}, progress);
    tell(found, [&](const Collision& first) {
      return fmt::format("The {} runs into {} with the tip at {}", nameOf(first.part), what, placeText(first.tip));
    });
    for (const Collision& each : found) mark(each.tip, each.move);
  }

  void carveStock(const Shape& solid, const Progress& progress) {
    constexpr double allowed = 0.02;  // mm
    StockField stock(bounds(solid), cellsFor(bounds(solid)));
    if (path_.cutter.diameter <= 2 * stock.cell())
      findings_.notes.push_back(fmt::format(
          "Rapids through the stock are not looked for: the cutter is thinner than two cells of {:.2f} mm.", stock.cell()));
    stock.lowerTo(trianglesOf(solid, progress));
    const double before = stock.volume();
    const auto found = carve(stock, path_, tool_, allowed, progress);
    findings_.removed += before - stock.volume();
    tell(found, [&](const StockHit& first) {
      const std::string what =
          first.part == ToolPart::Flutes ? "A rapid goes through" : fmt::format("The {} runs into", nameOf(first.part));
      return fmt::format("{} the stock at {}", what, placeText(first.at));
    });
    for (const StockHit& each : found) mark(each.at, each.move);
  }

  void compareWith(const Bounds& travel) {
    if (travel.empty) return;
    constexpr double within = 1e-6, chordOfTravel = 0.005;
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      Bounds box;
      for (const Vec3& at : polylineOf(startOf(path_, i), path_.moves[i], chordOfTravel)) box.add(at);
      const bool isInside =
          ((box.low - travel.low).array() > -within).all() && ((travel.high - box.high).array() > -within).all();
      if (isInside) continue;
      if (!first) first = i;
      ++findings_.outside;
    }
    if (first)
      findings_.told.push_back(fmt::format("The tool leaves the machine's travel on its way to {}{}{}",
                                           placeText(path_.moves[*first].to), lineOf(path_, *first),
                                           othersOf(findings_.outside)));
  }

  SetupFindings result() {
    std::sort(moves_.begin(), moves_.end());
    findings_.collisions = static_cast<std::size_t>(std::unique(moves_.begin(), moves_.end()) - moves_.begin());
    return std::move(findings_);
  }

 private:
  static constexpr std::size_t mostMarks = 500;

  /// A sentence for each part of the tool, the holder first, of the first of its hits.
  template <class Hit, class Sentence>
  void tell(const std::vector<Hit>& hits, const Sentence& sentence) {
    for (const ToolPart part : {ToolPart::Holder, ToolPart::Shank, ToolPart::Flutes}) {
      const auto isOfPart = [&](const Hit& each) { return each.part == part; };
      const auto first = std::find_if(hits.begin(), hits.end(), isOfPart);
      if (first == hits.end()) continue;
      const auto count = static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), isOfPart));
      findings_.told.push_back(sentence(*first) + lineOf(path_, first->move) + othersOf(count));
    }
  }

  /// So many that six cells go across the cutter, where that is not too many.
  [[nodiscard]] std::size_t cellsFor(const Bounds& stock) const {
    constexpr double fewest = 250'000, most = 4'000'000;
    const Vec3 size = stock.high - stock.low;
    const double wanted = 36 * size.x() * size.y() / (path_.cutter.diameter * path_.cutter.diameter);
    return static_cast<std::size_t>(std::clamp(wanted, fewest, most));
  }

  void mark(const Vec3& at, std::size_t move) {
    if (findings_.marks.size() < mostMarks) findings_.marks.push_back({at, MarkKind::Gouge});
    moves_.push_back(move);
  }

  const Toolpath& path_;
  const ToolAssembly& tool_;
  std::vector<std::size_t> moves_;
  SetupFindings findings_;
};

}  // namespace

ToolAssembly assemblyOf(const Cutter& cutter, const HolderParameters& p) {
  return {cutter, p.fluteLength, p.shankDiameter, p.stickOut, p.holderDiameter, p.holderLength};
}

namespace {

/// A holder cannot be where the flutes are.
void refuseContradiction(const ToolAssembly& tool) {
  if (tool.stickOut > 0 && tool.fluteLength > tool.stickOut)
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The tool sticks out by {} mm, and its flutes are {} mm long.", formatNumber(tool.stickOut),
                            formatNumber(tool.fluteLength)),
                "The stick-out goes from the tip to the holder: give at least the length of the flutes.");
}

std::vector<std::string> leftOut(const ToolAssembly& tool) {
  std::vector<std::string> notes;
  if (tool.shankDiameter > 0 && tool.fluteLength == 0)
    notes.emplace_back("The shank is not looked at: the length of the flutes is not given.");
  if (tool.holderDiameter > 0 && tool.stickOut == 0)
    notes.emplace_back("The holder is not looked at: it is not given how far the tool sticks out.");
  return notes;
}

}  // namespace

SetupFindings findingsIn(const Setup& setup, const Toolpath& path, const ToolAssembly& tool, double allowed,
                         const Progress& progress) {
  refuseContradiction(tool);
  SetupChecker checker(path, tool);
  for (const Shape& part : setup.part)
    checker.sweep("the part", trianglesOf(part, progress), allowed + 2 * chordOf(part), progress.part(0, 0.5));
  for (const Shape& stock : setup.stock) checker.carveStock(stock, progress.part(0.5, 0.7));
  for (std::size_t i = 0; i < setup.clamps.size(); ++i)
    checker.sweep(fmt::format("clamp {}", i + 1), trianglesOf(setup.clamps[i]), clampsMayBe,
                  progress.part(0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(setup.clamps.size()), 1));
  checker.compareWith(setup.travel);
  SetupFindings findings = checker.result();
  for (std::string& note : leftOut(tool)) findings.notes.push_back(std::move(note));
  if (findings.removed == 0)
    findings.notes.emplace_back("The program cuts nothing of the stock: is its zero that of the setup?");
  return findings;
}

}  // namespace blossom::pocket
