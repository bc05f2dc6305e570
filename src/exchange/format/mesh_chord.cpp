#include "exchange/format/mesh_chord.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/units.h"
#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom {

MeshChord affordableChord(const Shape& shape, double wanted, const Progress& progress) {
  constexpr double maximumTriangles = 500'000;
  const bool curved = shape.kind() == ShapeKind::Brep || shape.kind() == ShapeKind::Surface;
  const double size = curved ? bounds(shape).diagonal() : 0;
  const double fineEnough = size / 2000, coarse = size / 500;
  if (!(wanted > 0) || !(wanted < fineEnough)) return {wanted, {}};
  // Across a surface bent two ways, triangles are as many as the chord is short; bent one way, they are fewer.
  const double few = static_cast<double>(tessellate(shape, {.chord = coarse}, progress).triangles.size());
  if (few * coarse / wanted <= maximumTriangles) return {wanted, {}};
  const double chord = std::clamp(coarse * few / maximumTriangles, wanted, fineEnough);
  return {chord,
          fmt::format("The shape is {} mm in size and was divided with a chord of {} mm instead of {} mm, which would "
                      "have made some {} thousand triangles; give a chord to decide it yourself.",
                      formatNumber(size), formatNumber(chord), formatNumber(wanted),
                      static_cast<long long>(few * coarse / wanted / 1000))};
}

}  // namespace blossom
