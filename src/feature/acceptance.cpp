#include "feature/acceptance.h"

#include <TopExp_Explorer.hxx>
#include <algorithm>

#include "geometry/brep.h"

namespace blossom {
namespace {

bool mayBoundRegion(const Shape& shape) {
  if (const Brep* brep = shape.get<Brep>()) return !TopExp_Explorer(brep->shape(), TopAbs_SOLID).More();
  return shape.kind() == ShapeKind::Curves;
}

}  // namespace

bool accepts(const InputSpec& spec, const Shape& shape) {
  const auto takes = [&](ShapeKind kind) {
    return spec.kinds.empty() || std::find(spec.kinds.begin(), spec.kinds.end(), kind) != spec.kinds.end();
  };
  return !shape.empty() && (takes(shape.kind()) || (takes(ShapeKind::Region) && mayBoundRegion(shape)));
}

}  // namespace blossom
