#pragma once
#include <vector>

namespace blossom {

class Shape;

/// Shapes over time, for animations.
struct Sequence {
  std::vector<Shape> frames;
  std::vector<double> times;  ///< one per frame, non-decreasing, usually 0..1
};

}  // namespace blossom
