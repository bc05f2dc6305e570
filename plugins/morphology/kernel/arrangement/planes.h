#pragma once
#include <vector>

#include "kernel/arrangement/number_table.h"
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
  Planes() = default;
  /// Those of `base`, and what one part of the work adds to them: with numbers of its own, so that parts can work beside
  /// each other. @pre the base outlives it and stays as it is meanwhile
  explicit Planes(const Planes* base) : base_(base), first_(static_cast<int>(base->size())) {}
  Planes(const Planes&) = delete;
  Planes& operator=(const Planes&) = delete;
  Planes(Planes&&) = default;
  Planes& operator=(Planes&&) = default;

  struct Added {
    int plane = 0;
    bool sameWay = true;  ///< the normal of the plane has the direction of the one that was given
  };
  /// A plane to be added; what costs most of that is done, and needs no other planes.
  struct Directed {
    Plane plane;
    std::uint64_t hash = 0;
    bool sameWay = true;
  };
  /// @pre normal is not 0
  static Directed directed(const Normal3& normal, const Grid3& point);
  Added add(const Directed&);
  Added add(const Normal3& normal, const Grid3& point) { return add(directed(normal, point)); }
  /// The plane through an edge along an axis. @pre the edge is not parallel to the axis
  int upright(const Grid3& from, const Grid3& to, std::size_t axis);

  /// The number here of a plane of a part that was based on these.
  int take(const Planes& part, int plane);

  [[nodiscard]] const Plane& operator[](int plane) const {
    return plane < first_ ? (*base_)[plane] : planes_[static_cast<std::size_t>(plane - first_)];
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(first_) + planes_.size(); }
  [[nodiscard]] int sizeOfBase() const { return first_; }

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
  /// The number of the same plane; -1 when there is none.
  [[nodiscard]] int find(std::uint64_t hash, const Plane&) const;
  int insert(const Plane&, std::uint64_t hash);

  const Planes* base_ = nullptr;
  int first_ = 0;  ///< number of the first plane that is not of the base
  std::vector<Plane> planes_;
  NumberTable index_;  ///< by normal and offset
};

}  // namespace blossom::morphology::arrangement
