#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/polygons/sound_set.h"
#include "geometry/planar/sums/region_sum.h"

namespace blossom::planar {

struct SetSumResult {
  PlanarSet set;  ///< nothing at all: the empty set, of which a warning tells why
  std::size_t sums = 0;
  std::vector<std::string> warnings{};
};

/// As minkowskiSum of sets that may have open curves and points: A + curve is what A sweeps along it, A + {p} is A moved by
/// p, and the empty set absorbs. The area is regularised; curves and points come out only where one operand is points alone
/// (see set_sum.h). @throws as minkowskiSum; Degenerate where curves that run along one direction sweep no area.
SetSumResult setSum(std::span<const PlanarSet>, const RegionSumOptions& = {}, const Progress& = Progress::none());

/// As minkowskiDifference, with sets as what has to fit inside; with `keepDegenerate` of two sets also the room without
/// width, where B fits exactly: of polygons to within 2^-36 of their size, told to rounding, else within the tolerance,
/// which a warning tells.
/// @throws as minkowskiDifference; InvalidInput where the first set has no area or another one is empty; InvalidParameter
/// for `keepDegenerate` of more than two
SetSumResult setDifference(std::span<const PlanarSet>, const RegionSumOptions& = {}, const Progress& = Progress::none());

/// (A - B) + B and (A + B) - B, with `keepDegenerate` also of the room without width. @throws as setDifference
SetSumResult setOpening(const PlanarSet& a, const PlanarSet& b, const RegionSumOptions& = {},
                        const Progress& = Progress::none());
SetSumResult setClosing(const PlanarSet& a, const PlanarSet& b, const RegionSumOptions& = {},
                        const Progress& = Progress::none());

}  // namespace blossom::planar
