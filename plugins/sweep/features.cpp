#include <algorithm>

#include "feature/plugin.h"
#include "feature_types.h"
#include "isolate/in_worker.h"

namespace blossom::sweep {

namespace {

/// OCCT walks along the wires of a B-rep and converts their curves; of drawings and curves it sees nothing.
bool readsWires(const Value&, const Inputs& inputs) {
  const auto holdsBrep = [&](std::size_t spec) {
    const auto shapes = inputs.of(spec);
    return std::any_of(shapes.begin(), shapes.end(), [](const Shape& each) { return each.kind() == ShapeKind::Brep; });
  };
  return holdsBrep(0) || holdsBrep(1);
}

}  // namespace

}  // namespace blossom::sweep

BLOSSOM_PLUGIN(registry) {
  using namespace blossom;
  using namespace blossom::sweep;
  registry.add(primitiveFeature());
  registry.add(inWorker(frameFeature(), {.activity = "for the sweep along the curve", .when = readsWires}));
  registry.add(sweepFeature());
  // Edits of a motion stay in this process: they are called for every movement of the mouse.
  registry.addAll(pullFeature(), twistFeature(), factorsFeature(), refineFeature(), growthFeature());
}
