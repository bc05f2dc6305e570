#pragma once
#include "kernel/operations/work.h"

namespace blossom::morphology {

/// {x : x + b inside a} of boxes; empty when b is as large as a.
Bounds minus(const Bounds& a, const Bounds& b);

/// What remains of a solid by different elements; what lies outside of it is taken apart once.
class Eroder {
 public:
  Eroder(Work&, Solid, const Bounds&);

  /// `reach` are the bounds of the element; nullptr when nothing remains.
  [[nodiscard]] Solid by(const Parts& element, const Bounds& reach, double grid, double from, double to);

 private:
  Work& work_;
  Solid solid_;
  Bounds bounds_;
  Parts outside_;
};

}  // namespace blossom::morphology
