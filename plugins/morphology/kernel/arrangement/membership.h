#pragma once
#include <optional>

#include "core/progress.h"
#include "geometry/numeric/box_tree.h"
#include "kernel/arrangement/features.h"

namespace blossom::morphology::arrangement {

/// Whether places belong to the sum of two shapes, of which the first may be a solid inside out. It knows nothing of facets
/// and planes: it asks whether the first shape meets the second one reflected and moved to the place.
class Membership {
 public:
  /// @pre both outlive it
  Membership(const Features& a, const Features& b, bool insideOut, const Progress&);

  /// @pre a place off all facets of the sum. About O((n + m) log n).
  bool operator()(const Grid3& place) const;

 private:
  struct Placed {
    std::vector<Grid3> points;
    const Features& features;
  };
  [[nodiscard]] static bool anyEdgeMeets(const Placed& edges, const Placed& faces, const Progress&);
  [[nodiscard]] static bool holds(const Placed& solid, const Grid3& point, const Progress&);
  [[nodiscard]] static std::optional<int> turnsAlong(const Placed& solid, const Grid3& from, const Grid3& to);

  const Features &a_, &b_;
  bool insideOut_;
  const Progress& progress_;
};

}  // namespace blossom::morphology::arrangement
