#pragma once
#include <vector>

#include "kernel/solid/loft_scene.h"

namespace blossom::minkowski {

/// The edges of the boundary of positive winding number that are level: those of the two ends of the loft, and those where
/// facets of one direction cross. Beyond an edge winding numbers come from the slab above and from the slab below.
class LevelEdges {
 public:
  explicit LevelEdges(const LoftScene& scene) : scene_(scene), predicates_(scene.predicates) {}
  /// Those on facet i; an edge of more facets belongs to the lowest. @throws Error Internal when the facets are no cycles.
  void find(int i, std::vector<LoftSide>& out, const Progress&);

 private:
  /// A half-plane from the line, upwards or downwards, or level.
  struct HalfPlane {
    int plane = 0;
    bool outsideLeft = false, forward = false;
    friend bool operator==(const HalfPlane&, const HalfPlane&) = default;
  };

  /// @param partner the lowest facet of another plane; -1 at the ends of the loft, where there is none
  void line(int i, int partner, const LoftTime&, std::vector<LoftSide>& out);
  void collect(int i, const LoftTime&);
  [[nodiscard]] std::vector<int> covering(int i, const PlaceOnLine& from, const PlaceOnLine& to, const LoftTime&) const;
  [[nodiscard]] bool isOurs(int i, int partner, const std::vector<int>& covering) const;
  [[nodiscard]] bool steeper(int a, int b) const;
  /// From the left of the line to its right; @return whether left and right are inside.
  std::pair<bool, bool> turnOver(std::vector<int> covering, int slab, int winding, bool upwards,
                                 std::vector<HalfPlane>& out) const;
  void interval(int i, int partner, const PlaceOnLine& from, const PlaceOnLine& to, const LoftTime&,
                std::vector<LoftSide>& out) const;
  [[nodiscard]] LoftPredicates::Place placeOf(int i, const PlaceOnLine&, const LoftTime&) const;

  const LoftScene& scene_;
  const LoftPredicates& predicates_;
  int above_ = -1, below_ = -1;  ///< the slabs next to the line, -1: none
  std::vector<int> along_;       ///< facets whose edge at this height lies on the line
  std::vector<PlaceOnLine> places_;
};

}  // namespace blossom::minkowski
