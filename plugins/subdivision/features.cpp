#include <algorithm>

#include "feature/plugin.h"
#include "feature_types.h"
#include "isolate/in_worker.h"

namespace blossom::subdivision {

namespace {

/// Faces of a mesh are sewn by OCCT; everything else that is made of a cage is our own.
bool sewsFaces(const Value& parameters, const Inputs& inputs) {
  return parameters.value("as", "") == "faces" && inputs.of(0)[0].kind() == ShapeKind::Mesh;
}

/// The edges of a target that is a solid are OCCT's as well.
bool sewsOrFollowsEdges(const Value& parameters, const Inputs& inputs) {
  const auto targets = inputs.of(1);
  return sewsFaces(parameters, inputs) ||
         std::any_of(targets.begin(), targets.end(), [](const Shape& target) { return target.kind() == ShapeKind::Brep; });
}

}  // namespace

}  // namespace blossom::subdivision

BLOSSOM_PLUGIN(registry) {
  using namespace blossom;
  using namespace blossom::subdivision;
  // What OCCT may hang or crash in leaves this process; cages, limit meshes and curves are too cheap for another.
  registry.add(inWorker(subdivideFeature(), {.activity = "for the faces of the cage", .when = sewsFaces}));
  registry.add(inWorker(deformFeature(), {.activity = "for the deformation", .when = sewsOrFollowsEdges}));
  registry.add(strokeFeature());
}
