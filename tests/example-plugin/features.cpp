#include "example.h"
#include "feature/plugin.h"
#include "isolate/in_worker.h"

namespace {

using namespace blossom;
using example::Gear;

Evaluated gear(const Gear& gear, const Inputs&, const Progress& progress) {
  progress.check();
  return {example::gearOutline(gear), {{"pitch_diameter", gear.module * gear.teeth}}, {}};
}

FeatureType gearFeature() {
  return feature<Gear>("example.gear", "Gear", "The outline of a toothed wheel with straight flanks.")
      .produces({ShapeKind::Region})
      .parameter("teeth", &Gear::teeth, count(5, 1000), "Number of teeth.")
      .parameter("module", &Gear::module, positiveLength(), "Pitch diameter over number of teeth.")
      .parameter("pressure-angle", &Gear::pressureAngle, angle(), "Slope of the flanks.")
      .parameter("bore", &Gear::bore, length(), "Diameter of the hole in the middle; 0 for none.")
      .example("blossom gear --teeth 24 --module 1.5 -o gear.dxf")
      .evaluate(gear);
}

}  // namespace

BLOSSOM_PLUGIN(registry) {
  // In the worker process: what may hang or crash can be cancelled there and does no harm. Without inWorker, in this one.
  registry.add(inWorker(gearFeature(), {.activity = "for the gear"}));
  registry.add(example::plotterFormat());
}
