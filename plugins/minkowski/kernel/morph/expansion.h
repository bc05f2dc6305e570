#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/sound_region.h"
#include "kernel/morph/evaluation_order.h"
#include "kernel/morph/repetition.h"

namespace blossom::minkowski {

using namespace planar;

struct InBetween {
  SoundRegion shape;
  double deviation = 0;  ///< mm, at most, from the exact shape of the control shapes
};

/// The explicit form of a morph: a sum of multiples of [k]A_i. Where a shape or its copies are so small that their hull is
/// within the tolerance, it stands for them: A is at most R from its hull, the circumradius, and no [k]A, k >= 2, is farther
/// than [2]A is, at most sqrt(2) R (see region_repeat.h).
class Expansion {
 public:
  /// @param tolerance that an in-between may differ, mm; beside points in proportion to what the others' shares add up to
  Expansion(std::span<const SoundRegion> shapes, double tolerance, Adder& add)
      : shapes_(shapes), tolerance_(tolerance), add_(add), hulls_(shapes.size()) {}

  /// The repetitions for an in-between, which stay for others.
  void repeatFor(std::span<const double> t, const Progress&);
  /// Several threads may ask at the same time.
  /// @pre its repetitions are there
  [[nodiscard]] InBetween at(std::span<const double> t, const Progress&) const;
  /// What an in-between may differ, mm.
  [[nodiscard]] double toleranceAt(std::span<const double> t) const;

 private:
  struct Term {
    std::size_t shape;
    double weight;
    std::size_t count;
  };
  struct Hull {
    SoundRegion shape;
    double ofOne = 0;     ///< distance of the shape from it, at most
    double distance = 0;  ///< from repetitions, at most
    bool isMeasured = false;
  };

  Hull& hullOf(std::size_t i, const Progress&);
  /// What taking the hull for a term may change, mm.
  double errorOf(const Term&, const Progress&);
  /// Those that are computed as they are.
  const std::vector<Term>& termsOf(std::span<const double> t, const Progress&);

  std::span<const SoundRegion> shapes_;
  double tolerance_;
  Adder& add_;
  std::vector<std::optional<Hull>> hulls_;
  std::map<Arguments, std::vector<Term>> termsFor_, hullsFor_;
  std::map<std::pair<std::size_t, std::size_t>, SoundRegion> repetitions_;
  std::map<Arguments, double> errorOfHulls_;
};

}  // namespace blossom::minkowski
