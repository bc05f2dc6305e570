#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/offset/clearance_diagram.h"
#include "kernel/stroke/stroke_tree.h"

namespace blossom::pocket {

class SlotSearch;

/// A closed loop that the tool's centre runs along, by arc length; of no length where there is room for one point only.
class Pass {
 public:
  Pass() = default;
  explicit Pass(const std::vector<Stroke>& strokes);
  [[nodiscard]] const std::vector<Stroke>& strokes() const { return strokes_; }
  [[nodiscard]] double length() const { return ends_.empty() ? 0 : ends_.back(); }

  struct Foot {
    double at = 0;  ///< mm along the pass
    Vec2 point = Vec2::Zero();
    double distance = 1e300;
  };
  [[nodiscard]] Foot nearest(const Vec2&) const;
  /// Calls `visit(stroke)` for the part of the loop of length `distance` from arc length `from`; it may go around several
  /// times.
  template <class Visit>
  void walk(double from, double distance, const Visit& visit) const {
    if (!(length() > 0)) return;
    from = std::fmod(from, length());
    std::size_t i = strokeAt(from);
    double begin = i == 0 ? 0 : ends_[i - 1];
    double at = from;
    constexpr double nothing = 1e-9;
    while (distance > nothing) {
      const double whole = ends_[i] - begin;
      const double step = std::min(distance, ends_[i] - at);
      if (step > 0 && whole > 0)
        visit(strokes_[i].part((at - begin) / whole, step < ends_[i] - at ? (at + step - begin) / whole : 1));
      distance -= step;
      begin = ends_[i];
      if (++i == strokes_.size()) i = 0, begin = 0;
      at = begin;
    }
  }

 private:
  [[nodiscard]] std::size_t strokeAt(double length) const;
  std::vector<Stroke> strokes_;
  std::vector<double> ends_;  ///< length up to the end of each stroke
};

/// A path along the medial axis and back, from a foot on a pass, through an area that the neighbouring passes do not reach.
struct Spoke {
  std::size_t pass = 0;    ///< of its node
  Pass::Foot foot;         ///< where it starts from the pass
  std::vector<Vec2> walk;  ///< a closed path
};

/// The passes at one distance from the walls around one connected area: an outer one and those around islands.
struct PassNode {
  std::size_t level = 0;
  std::vector<Pass> passes;
  std::vector<Spoke> spokes;
  std::vector<std::size_t> inner;  ///< nodes of the next level within it
};

/// Passes from the walls inwards. Inner nodes come after the nodes that contain them.
struct PassTree {
  std::vector<PassNode> nodes;
  std::vector<std::size_t> roots;  ///< nodes along the walls
  std::size_t levels = 0;
};

struct PassOptions {
  double first = 0;   ///< mm from the walls to the outermost pass
  double step = 0;    ///< mm between passes
  double radius = 0;  ///< mm, of the tool
  bool climb = true;  ///< material is on the right of the tool
};

/// Whether there is any pass at a distance from the walls.
bool hasPass(const ClearanceDiagram&, SlotSearch&, double distance, const Progress&);

/// Every point of the opening lies within the tool's radius of a pass when the step is at most the radius, because uphill
/// from a wall the clearance grows at unit rate. With larger steps the missed points have clearances between a pass plus the
/// radius and the next pass, on lines that end on the medial axis; spokes along those parts of the axis clear them.
/// @throws Error LimitExceeded (more than 20,000 levels), Cancelled.
PassTree passTree(const ClearanceDiagram&, SlotSearch&, const PassOptions&, const Progress&);

}  // namespace blossom::pocket
