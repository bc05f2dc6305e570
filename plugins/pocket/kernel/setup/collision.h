#pragma once
#include <cstddef>
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/box_tree.h"
#include "kernel/path/obstacle.h"
#include "kernel/setup/tool_stages.h"

namespace blossom::pocket {

/// Triangles that a tool must not enter, in the coordinates of the moves.
class Obstacles {
 public:
  explicit Obstacles(Triangles, const Progress& = Progress::none());

  [[nodiscard]] const Triangles& triangles() const { return triangles_; }
  [[nodiscard]] const BoxTree<3>& tree() const { return tree_; }

 private:
  Triangles triangles_;
  BoxTree<3> tree_;
};

struct CollisionOptions {
  double allowed = 0.01;  ///< mm, how deep the tool may enter; above 0
};

/// The first contact of a part of the tool during a move.
struct Collision {
  std::size_t move = 0;
  ToolPart part = ToolPart::Flutes;
  Vec3 tip = Vec3::Zero();   ///< position of the tool's tip
  std::size_t obstacle = 0;  ///< number of the triangle
  friend bool operator==(const Collision&, const Collision&) = default;
};

/// All moves during which the flutes, the shank or the holder enter an obstacle by more than is allowed, at most one
/// collision for each move and part of the tool, in order. Arcs are followed within a quarter of what is allowed.
///
/// Along a straight piece of a move the distance of a convex stage of the tool to a triangle is a convex function; values at
/// the ends and between bound it from below, so that no contact is stepped over: none deeper than 1.25 times what is allowed
/// is missed, none that is less deep than 0.75 times of it is told. A solid is noticed where its surface is crossed.
/// O((moves + triangles) log n). @throws Error InvalidParameter, Cancelled.
std::vector<Collision> collisionsOf(const Toolpath&, const ToolAssembly&, const Obstacles&, const CollisionOptions&,
                                    const Progress& = Progress::none());

}  // namespace blossom::pocket
