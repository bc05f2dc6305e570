#pragma once
#include <cstddef>
#include <vector>

namespace blossom {

class Shape;

/// As many frames as a sequence may have.
inline constexpr std::size_t maximumFrames = 10'000;

/// Shapes over time, for animations. Its frames are no sequences themselves.
struct Sequence {
  std::vector<Shape> frames;
  std::vector<double> times;  ///< one per frame, non-decreasing, usually 0..1
};

}  // namespace blossom
