#include "kernel/morph/thinning.h"

#include <algorithm>
#include <utility>

#include "kernel/shallow_dents.h"

namespace blossom::minkowski {

SoundRegion Thinning::operator()(SoundRegion shape, const Progress& progress) {
  constexpr std::size_t many = 2000;
  if (hasCurves(shape.region)) return shape;
  const Polygons polygons = toPolygons(shape);
  if (edgeCount(polygons) < many) return shape;
  const FilledDents filled = withoutShallowDents(polygons, depth_, Progress(progress.token()));
  if (filled.depth == 0) return shape;
  deepest_ = std::max(deepest_, filled.depth);
  return {toRegion(filled.shape), shape.tolerance};
}

}  // namespace blossom::minkowski
