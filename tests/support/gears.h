#pragma once
#include <cmath>
#include <numbers>

#include "support/polyhedra.h"

/// Prisms along z whose walls lie in common planes: what sums of convex parts take longest over.
namespace blossom::test {

inline Mesh gear(int teeth, double height) {
  std::vector<Vec2> outline;
  for (int k = 0; k < teeth; ++k)
    for (const auto& [turn, radius] : {std::pair{0.0, 4.5}, {0.12, 6.0}, {0.38, 6.0}, {0.5, 4.5}}) {
      const double angle = 2 * std::numbers::pi * (k + turn) / teeth;
      outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  return prism(outline, 0, height);
}

inline Mesh uChannel() { return prism({{0, 0}, {7, 0}, {7, 5}, {6, 5}, {6, 1}, {1, 1}, {1, 5}, {0, 5}}, 0, 4); }

}  // namespace blossom::test
