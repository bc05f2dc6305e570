#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

#include "kernel/arrangement/planes.h"

namespace blossom::morphology::arrangement {

/// All points of an arrangement, each once: points of the grid, intersections of an edge with a plane, and of three planes
/// (Attene, "Indirect predicates for geometric constructions", 2020). Points are never rounded; equal ones have one number.
class Points {
 public:
  explicit Points(const Planes& planes) : planes_(planes) {}

  int at(const Grid3&);
  /// Where the edge between two points of the grid meets a plane. @pre they lie on different sides of it
  int onEdge(int from, int to, int plane);
  /// @pre the planes meet in one point
  int onThree(int first, int second, int third);

  [[nodiscard]] const Bounded3& about(int point) const { return entry(point).about; }
  [[nodiscard]] bool isOfGrid(int point) const { return entry(point).kind == Kind::Grid; }
  [[nodiscard]] const Grid3& grid(int point) const { return entry(point).grid; }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

  /// Remembers that a point lies on a plane, which saves the exact test.
  void note(int point, int plane);
  /// On which side of a plane: 1, -1, or 0 on it.
  [[nodiscard]] int side(int plane, int point);
  /// The sign of b - a along an axis.
  [[nodiscard]] int order(std::size_t axis, int a, int b);
  /// Whether three points of a plane turn counter-clockwise in its drawing: 1; clockwise: -1; or lie on a line: 0.
  [[nodiscard]] int turn(int plane, int a, int b, int c);
  /// The same in a drawing with any two axes, for any three points.
  [[nodiscard]] int turn(std::size_t u, std::size_t v, int a, int b, int c);

  /// Rounded from the exact value.
  [[nodiscard]] std::array<double, 3> nearest(int point);

 private:
  enum class Kind : std::uint8_t { Grid, Edge, Planes };
  /// Coordinates x / w with w > 0.
  struct Exact {
    std::array<Whole, 3> x;
    Whole w;
  };
  struct Entry {
    Kind kind = Kind::Grid;
    std::array<int, 3> from{};  ///< two points and a plane, or three planes
    Grid3 grid{};
    Bounded3 about;
    std::vector<int> planes;  ///< some of those that it lies on
    std::unique_ptr<Exact> exact;
  };
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const std::array<std::int64_t, 3>&) const;
    std::size_t operator()(const std::array<int, 4>&) const;
  };

  [[nodiscard]] const Entry& entry(int point) const { return entries_[static_cast<std::size_t>(point)]; }
  [[nodiscard]] Bounded3 aboutOf(const Entry&) const;
  [[nodiscard]] Exact computed(const Entry&) const;
  const Exact& exact(Entry&) const;
  const Exact& exact(int point) { return exact(entries_[static_cast<std::size_t>(point)]); }
  [[nodiscard]] bool same(Entry&, Entry&) const;
  int insert(Entry);
  int found(const std::array<int, 4>& key, Entry);

  const Planes& planes_;
  std::vector<Entry> entries_;
  std::unordered_map<std::array<int, 4>, int, Hash> byOrigin_;
  std::unordered_multimap<Cell, int, Hash> byPlace_;
};

}  // namespace blossom::morphology::arrangement
