#pragma once
#include <vector>

namespace blossom {

class Shape;

/// Shapes over time, as an animation or an onion skin shows them.
struct Sequence {
  std::vector<Shape> frames;
  std::vector<double> times;  ///< one per frame, non-decreasing, usually 0..1
};

}  // namespace blossom
