#pragma once
#include "core/vector.h"
#include "geometry/shape.h"

namespace blossom {

struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  bool empty = true;

  void add(const Vec3& p) {
    low = empty ? p : low.cwiseMin(p);
    high = empty ? p : high.cwiseMax(p);
    empty = false;
  }
  void add(const Bounds& other) {
    if (other.empty) return;
    add(other.low);
    add(other.high);
  }
  [[nodiscard]] bool contains(const Vec3& p) const {
    return !empty && (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
  [[nodiscard]] double diagonal() const { return (high - low).norm(); }
  [[nodiscard]] Vec3 center() const { return (low + high) / 2; }
};

/// Axis-aligned box around a shape: exact for meshes, lines and arcs; for free-form curves and surfaces the box of their
/// poles, which may be somewhat larger. Good for fitting a view and for tolerances relative to the size. O(n).
Bounds bounds(const Shape&);

}  // namespace blossom
