#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/arrangement/number_table.h"
#include "kernel/arrangement/planes.h"

namespace blossom::morphology::arrangement {

/// All points of an arrangement, each once: points of the grid, intersections of an edge with a plane, and of three planes
/// (Attene, "Indirect predicates for geometric constructions", 2020). Points are never rounded; equal ones have one number.
class Points {
 public:
  explicit Points(const Planes& planes) : planes_(planes) {}
  /// Those of `base`, and what one part of the work adds to them; see Planes. What is noted and computed of points of the
  /// base stays in the part.
  Points(const Planes& planes, const Points* base) : planes_(planes), base_(base), first_(static_cast<int>(base->size())) {}

  int at(const Grid3&);
  /// Where the edge between two points of the grid meets a plane. @pre they lie on different sides of it
  int onEdge(int from, int to, int plane);
  /// @pre the planes meet in one point
  int onThree(int first, int second, int third);

  [[nodiscard]] const Bounded3& about(int point) const { return entry(point).about; }
  [[nodiscard]] bool isOfGrid(int point) const { return entry(point).kind == Kind::Grid; }
  [[nodiscard]] const Grid3& grid(int point) const { return entry(point).grid; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(first_) + entries_.size(); }

  /// The number here of a point of a part that was based on these. @param numberOf that of each plane of the part
  int take(Points& part, int point, const std::function<int(int)>& numberOf);
  /// What a part has noted of points and planes that both have.
  void takeNotes(const Points& part, int planes);

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

    [[nodiscard]] bool isOn(int plane) const { return std::find(planes.begin(), planes.end(), plane) != planes.end(); }
  };
  /// What is known of a point of the base in addition.
  struct Addition {
    std::vector<int> planes;
    std::unique_ptr<Exact> exact;
  };
  /// Two points and a plane, or three planes, and which of both it is.
  using Origin = std::array<int, 4>;
  using Cell = std::array<std::int64_t, 3>;

  [[nodiscard]] bool isOfBase(int point) const { return point < first_; }
  [[nodiscard]] const Entry& entry(int point) const {
    return isOfBase(point) ? base_->entry(point) : entries_[static_cast<std::size_t>(point - first_)];
  }
  [[nodiscard]] Entry& own(int point) { return entries_[static_cast<std::size_t>(point - first_)]; }
  [[nodiscard]] bool isKnownOn(int point, int plane) const;
  [[nodiscard]] std::optional<int> turnInDoubles(std::size_t u, std::size_t v, int a, int b, int c) const;
  [[nodiscard]] int exactTurn(std::size_t u, std::size_t v, int a, int b, int c);
  [[nodiscard]] bool shareAnotherPlane(int plane, int a, int b, int c) const;
  [[nodiscard]] Bounded3 aboutOf(const Entry&) const;
  [[nodiscard]] Exact computed(const Entry&) const;
  const Exact& exact(std::unique_ptr<Exact>& kept, const Entry&) const;
  const Exact& exact(int point);
  [[nodiscard]] bool same(Entry&, int other);
  void place(Entry&) const;
  [[nodiscard]] std::optional<int> find(const Origin&) const;
  [[nodiscard]] int findAmong(const Points&, const std::array<std::array<std::int64_t, 2>, 3>& cells, Entry&);
  int insert(Entry);
  int found(const Origin&, Entry);
  static Origin originOf(const Entry&);

  const Planes& planes_;
  const Points* base_ = nullptr;
  int first_ = 0;  ///< number of the first point that is not of the base
  std::unordered_map<int, Addition> additions_;
  std::vector<int> taken_;  ///< numbers of its own points in what has taken them
  std::vector<Entry> entries_;
  std::vector<std::pair<Origin, int>> origins_;  ///< with the number of the point; a point can have several
  NumberTable byOrigin_;                         ///< of `origins_`
  NumberTable byPlace_;                          ///< by cell
};

}  // namespace blossom::morphology::arrangement
