#pragma once
#include <vector>

#include "geometry/numeric/boxes.h"
#include "kernel/solid/loft_scene.h"

namespace blossom::minkowski {

/// The edges of the boundary of positive winding number that lie where two facets cross and are not level. Along the line of
/// a crossing everything that happens is sorted exactly; between two happenings the winding numbers around the line tell
/// which of its facets bound there.
class UprightEdges {
 public:
  explicit UprightEdges(const LoftScene&);
  /// Those on facet i whose other facet has a higher number; an edge of more facets belongs to the lowest two.
  /// @throws Error Internal when the facets are no cycles.
  void find(int i, std::vector<LoftSide>& out, const Progress&);
  /// What was compared so far, in pairs of edges as Effort counts them.
  [[nodiscard]] double work() const { return work_; }

 private:
  struct Event {
    enum class Kind { Level, End, Crossing };
    double t = 0, error = 0;
    Kind kind = Kind::Level;
    int line = 0, facet = 0, end = 0;
    int jump = 0;  ///< of the winding number upwards, where nothing but a plain crossing happens
    bool plain = false;
  };
  struct Window {
    double low = 0, high = 1;
  };
  /// A ray of a facet from the line, seen from above.
  struct Ray {
    int facet = 0;
    bool forward = true;
    int jump = 0;
  };

  void pair(int i, int j, std::vector<LoftSide>& out);
  [[nodiscard]] Window windowOf(int facet, int line) const;
  /// @return whether the ramp is zero everywhere
  bool addZero(const LoftRamp&, Event, std::vector<Event>&) const;
  [[nodiscard]] LoftPredicates::ExactRamp exactRamp(const Event&) const;
  [[nodiscard]] LoftTime timeOfEvent(const Event&) const;
  [[nodiscard]] int compareEvents(const Event&, const Event&) const;
  [[nodiscard]] LoftTime betweenEvents(const Event&, const Event&) const;
  /// Groups of events at one height.
  [[nodiscard]] std::vector<std::size_t> sortedGroups(std::vector<Event>&) const;
  void addOwnEvents();
  bool cutToCommonPart();
  [[nodiscard]] Box2 extentOf(int facet, double low, double high) const;
  [[nodiscard]] Box2 commonExtent(double low, double high) const;
  void addOtherEvents();
  void addCrossing(int k);
  [[nodiscard]] bool onFacet(int k, int line, const LoftTime&) const;
  [[nodiscard]] int lineFor(int k) const { return predicates_.turn(i_, k) != 0 ? i_ : j_; }
  [[nodiscard]] std::vector<int> facetsAt(const LoftTime&, int slab) const;
  [[nodiscard]] bool isOurs(const std::vector<int>& on) const;
  [[nodiscard]] std::vector<Ray> raysOf(const std::vector<int>& on, const LoftTime&) const;
  void emit(const std::vector<Ray>&, int winding, std::size_t group, std::vector<LoftSide>& out) const;
  void walk(std::vector<LoftSide>& out);

  const LoftScene& scene_;
  const LoftPredicates& predicates_;
  int i_ = 0, j_ = 0;
  std::vector<bool> nearJ_;
  std::vector<int> through_;  ///< facets whose planes hold the line, besides i and j
  std::vector<Event> events_;
  std::vector<std::size_t> groups_;
  double work_ = 0;
  Event low_, high_;  ///< where the common part of i and j begins and ends
};

}  // namespace blossom::minkowski
