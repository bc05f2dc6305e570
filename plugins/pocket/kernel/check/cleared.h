#pragma once
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/values/box.h"
#include "kernel/stroke/tool_moves.h"

namespace blossom::pocket {

/// The material removed by cuts so far; tests whether a move of the tool touches the rest.
///
/// A cut removes the volume that the tool sweeps and everything above it. Squares over the plan of the tool are quartered
/// until each lies within one cut or contains a point outside all cuts; at several heights when the tool is not a cylinder.
class Cleared {
 public:
  /// The material is below `top`, within the stock when it is known, else unbounded.
  Cleared(const Cutter&, double top, const Bounds& stock);

  void cut(const Vec3& from, const ToolMove&);
  /// Whether the tool goes more than twice the margin into material on this move. Call it for the moves of a path in their
  /// order.
  [[nodiscard]] bool isHit(const Vec3& from, const ToolMove&, const Progress&) const;

 private:
  struct Cut {
    MoveBelow move;
    Vec2 low, high;  ///< box of its path
    double deepest;
  };
  /// A path at one height, and the width of the cut there.
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
  double margin_;  ///< mm; smaller depths cannot be distinguished from rounding
  double top_;
  Bounds stock_;
  std::vector<double> heights_;  ///< heights above the tip at which the tool is tested
  std::vector<Cut> cuts_;
};

}  // namespace blossom::pocket
