#pragma once
#include "core/vector.h"

namespace blossom {

/// Axis-aligned box.
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

}  // namespace blossom
