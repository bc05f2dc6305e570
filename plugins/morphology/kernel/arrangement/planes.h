#pragma once
#include <unordered_map>
#include <vector>

#include "kernel/arrangement/numbers.h"

namespace blossom::morphology::arrangement {

/// A plane with a normal that has no common divisor and whose first component that is not 0 is positive.
struct Plane {
  Normal3 normal{};
  Grid3 point{};
  Bounded3 about;            ///< the normal in doubles
  std::size_t axis = 0;      ///< of the largest component of the normal: the plane is drawn without it
  std::size_t u = 1, v = 2;  ///< axes of the drawing, in which counter-clockwise is so seen against the normal
};

/// All planes of an arrangement, each once.
class Planes {
 public:
  struct Added {
    int plane = 0;
    bool sameWay = true;  ///< the normal of the plane has the direction of the one that was given
  };
  /// @pre normal is not 0
  Added add(const Normal3& normal, const Grid3& point);
  /// The plane through an edge along an axis. @pre the edge is not parallel to the axis
  int upright(const Grid3& from, const Grid3& to, std::size_t axis);

  [[nodiscard]] const Plane& operator[](int plane) const { return planes_[static_cast<std::size_t>(plane)]; }
  [[nodiscard]] std::size_t size() const { return planes_.size(); }

  /// On which side of a plane a point lies: 1 where the normal points to, -1, or 0 on it.
  [[nodiscard]] int side(int plane, const Grid3&) const;

  /// How a line runs in which two planes meet that are not parallel.
  struct Line {
    std::size_t axis = 0;  ///< of the largest component of the cross product of their normals
    int sign = 0;          ///< of that component
  };
  [[nodiscard]] Line line(int first, int second) const;
  /// The sign of one component of the cross product of the normals.
  [[nodiscard]] int crossSign(int first, int second, std::size_t axis) const;

 private:
  struct Key {
    Normal3 normal{};
    Int128 offset = 0;  ///< modulo 2^128
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key&) const;
  };

  std::vector<Plane> planes_;
  std::unordered_multimap<Key, int, Hash> index_;
};

}  // namespace blossom::morphology::arrangement
