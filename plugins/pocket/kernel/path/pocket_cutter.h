#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "kernel/offset/clearance_diagram.h"
#include "kernel/path/path_writer.h"
#include "kernel/path/pocket_path.h"
#include "kernel/path/slots.h"
#include "kernel/stroke/inside_test.h"

namespace blossom::pocket {

/// Computes the path of one pocket: clears it pass by pass at each depth, then finishes the walls. The implementation is
/// divided into pocket_cutter.cpp, pocket_entry.cpp and pocket_finish.cpp.
class PocketCutter {
 public:
  PocketCutter(const Region& region, const PocketOptions& options, const Progress& progress);
  PocketResult cut();  ///< call it once

 private:
  struct Beside {
    double at = 0, distance = 1e300;
  };

  // pocket_cutter.cpp: clears in passes.
  [[nodiscard]] PassTree passesFrom(double distance, const Progress& progress);
  template <class Cut>
  void atEachDepth(const Cut& cutOne) {
    const auto depths = static_cast<double>(result_.depths);
    for (std::size_t i = 0; i < result_.depths; ++i) {
      above_ = -total_ * static_cast<double>(i) / depths;
      floor_ = -total_ * static_cast<double>(i + 1) / depths;
      cutOne();
    }
  }
  /// Diameter of the largest tool that fits into the widest place.
  [[nodiscard]] double widestTool() const;
  /// To be told: tried, and within a thousandth.
  [[nodiscard]] double largestThatFits();
  void refuseLargeTool();
  [[noreturn]] void refuseTool();
  /// Parts of the region that no pass lies in.
  void findNarrow(const PassTree& tree);
  std::size_t takeNearest(std::vector<std::size_t>& roots) const;
  /// Clears the area inside a node, then along its own passes. Iterative, because narrow steps make the tree deep.
  void clear(const PassTree& tree, std::size_t root);
  void clearPasses(const PassNode& node);
  /// The pass nearest to the tool; the first one when the tool is above the stock.
  [[nodiscard]] std::pair<std::size_t, Pass::Foot> nearestOf(const PassNode& node,
                                                             const std::vector<std::size_t>& passes) const;
  /// Goes once around a pass, out along its spokes and back.
  void runAround(const PassNode& node, std::size_t index, double from);

  // pocket_entry.cpp: entries, and links from pass to pass.
  double linked(const Pass::Foot& foot);
  /// Whether the tool may move at depth: its centre stays in the allowed area, and the move is so short that it hardly cuts
  /// more than the pass it leads to.
  [[nodiscard]] bool mayStayDown(const Vec2& from, const Vec2& to) const;
  /// Enters to the floor somewhere on the pass and returns that position.
  double entered(const Pass& pass);
  /// Enters by a helix in the largest disc of the node, to where the nearest pass can be reached in a straight line; false
  /// when there is no room for one.
  bool helix(const PassNode& node);
  /// The vertex of the medial axis with the maximum clearance in a node.
  std::pair<Vec2, double> widest(const PassNode& node);

  /// Removes the stock that the passes left on the walls.
  void finish();
  /// Whether a clearing pass lies within a loop along the walls.
  [[nodiscard]] bool isCleared(std::size_t root) const;
  void finish(const PassNode& node, std::size_t index);
  /// The position on a pass nearest to the clearing passes, and the maximum distance of the pass from them.
  [[nodiscard]] std::pair<Beside, double> besidePasses(const Pass& pass) const;
  /// Plunges to the floor in the cleared area at the plunge feed, because no pass need have been exactly here.
  void plungeBeside(const Vec2& p);
  /// Goes once around at the floor, with quarter circles from and to the cleared area as lead-in and lead-out; where there
  /// is no room for them, straight from the nearest cleared position.
  void finish(const Pass& pass, double nearest);
  /// Position on a pass with room in the cleared area for quarter circles as lead-in and lead-out; the side is +1 for left.
  [[nodiscard]] std::optional<std::pair<double, double>> leadPlace(const Pass& pass, double radius) const;

  const PocketOptions o_;
  const Progress progress_;
  const double radius_;
  const ClearanceDiagram diagram_;
  SlotSearch slots_;
  PassTree tree_;   ///< clears
  PassTree walls_;  ///< along the walls, when a finishing pass is wanted
  StrokeTree rim_;
  InsideTest inside_;
  std::optional<MedialAxis> axis_;
  PocketResult result_;
  PathWriter writer_;
  double total_ = 0, above_ = 0, floor_ = 0;
};

}  // namespace blossom::pocket
