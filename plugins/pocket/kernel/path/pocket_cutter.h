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

/// Makes the path of one pocket: clears it pass by pass at each depth, then finishes the walls. The parts of this work stand
/// in pocket_cutter.cpp, pocket_entry.cpp and pocket_finish.cpp.
class PocketCutter {
 public:
  PocketCutter(const Region& region, const PocketOptions& options, const Progress& progress);
  PocketResult cut();  ///< once

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
  /// Diameter of the tool that just gets into the widest place.
  [[nodiscard]] double widestTool() const;
  /// To be told: tried, and within a thousandth.
  [[nodiscard]] double largestThatFits();
  void refuseLargeTool();
  [[noreturn]] void refuseTool();
  /// Parts of the region that no pass lies in.
  void findNarrow(const PassTree& tree);
  std::size_t takeNearest(std::vector<std::size_t>& roots) const;
  /// Clears what lies within a node, then along its own passes. Walks the tree without recursion: narrow steps make it deep.
  void clear(const PassTree& tree, std::size_t root);
  void clearPasses(const PassNode& node);
  /// Which of the passes is nearest to where the tool is; the first one when it is above the stock.
  [[nodiscard]] std::pair<std::size_t, Pass::Foot> nearestOf(const PassNode& node,
                                                             const std::vector<std::size_t>& passes) const;
  /// Once around a pass, out along its spokes and back on the way.
  void runAround(const PassNode& node, std::size_t index, double from);

  // pocket_entry.cpp: how the tool gets down, and from pass to pass.
  double linked(const Pass::Foot& foot);
  /// The tool's centre stays where it may be, and the way is so short that it hardly cuts more than the pass it leads to.
  [[nodiscard]] bool mayStayDown(const Vec2& from, const Vec2& to) const;
  /// Gets down to the floor somewhere on the pass and tells where.
  double entered(const Pass& pass);
  /// Down by a helix in the largest disc of the node, to where the nearest pass can be reached straight; false when there is
  /// no room for one.
  bool helix(const PassNode& node);
  /// The vertex of the medial axis with the largest clearance in a node.
  std::pair<Vec2, double> widest(const PassNode& node);

  // pocket_finish.cpp: the last pass along the walls.
  /// Takes off what the passes left on the walls.
  void finish();
  /// Whether any of the clearing passes lies within a loop along the walls.
  [[nodiscard]] bool isCleared(std::size_t root) const;
  void finish(const PassNode& node, std::size_t index);
  /// Where a pass is nearest to those that cleared, and how far from them it goes.
  [[nodiscard]] std::pair<Beside, double> besidePasses(const Pass& pass) const;
  /// Down to the floor in what the passes cleared, yet slowly: no pass need have been exactly here.
  void plungeBeside(const Vec2& p);
  /// Once around at the floor, by quarter circles from and to what the passes cleared; where there is room for none,
  /// straight from the nearest place on them.
  void finish(const Pass& pass, double nearest);
  /// Where on a pass a quarter circle leads in and out within what the passes cleared; the side is +1 to the left.
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
