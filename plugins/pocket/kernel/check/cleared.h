#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/values/box.h"
#include "kernel/stroke/tool_moves.h"

namespace blossom::pocket {

/// The material that cuts have taken away so far, and whether the tool can go somewhere without touching what is left.
///
/// A cut takes what the tool sweeps, and all above it. Squares over the tool's plan are quartered until each lies within
/// what one cut took or shows a point that none did; at several heights where the tool is not a cylinder.
class Cleared {
 public:
  /// Material lies below `top`, within the stock when it is known, else everywhere.
  Cleared(const Cutter&, double top, const Bounds& stock);

  void cut(const Vec3& from, const ToolMove&);
  /// Whether the tool goes more than twice the margin into material on this move; the moves of one path in their order.
  [[nodiscard]] bool isHit(const Vec3& from, const ToolMove&, const Progress&) const;

 private:
  struct Cut {
    MoveBelow move;
    Vec2 low, high;  ///< of its way
    double deepest;
  };
  /// A way at one height, and how wide it was cut there.
  struct Swept {
    Stroke way;
    double radius;
  };
  [[nodiscard]] bool isHit(const MoveBelow&, const Progress&) const;
  [[nodiscard]] bool reaches(const Stroke& way, double radius, double height) const;
  [[nodiscard]] std::vector<Swept> sweptNear(const Stroke& way, double radius, double height) const;
  void addAt(const Cut&, double height, std::vector<Swept>&) const;
  [[nodiscard]] bool mayLieInStock(const Vec2& middle, double reach) const;
  [[nodiscard]] bool liesInStock(const Vec2& p) const;

  Cutter cutter_;
  double margin_;  ///< mm; less cannot be told from rounding
  double top_;
  Bounds stock_;
  std::vector<double> heights_;  ///< above the tip, where the tool is looked at
  std::vector<Cut> cuts_;
};

}  // namespace blossom::pocket
