#include "manipulators/comparison_labels.h"

#include <vtkProp.h>

#include <map>
#include <string>

#include "geometry/planar/segment_box.h"
#include "ui/look/text.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

/// Of a comparison over frames, the first one.
const Curves* pictureOf(const Shape& shape) {
  if (const auto* sequence = shape.get<Sequence>())
    return sequence->frames.empty() ? nullptr : sequence->frames.front().get<Curves>();
  return shape.get<Curves>();
}

/// Around the outlines of each layer; what is open belongs to the chart of areas.
std::map<std::string, Box2> boxesByLayer(const Curves& drawing) {
  std::map<std::string, Box2> boxes;
  for (const Path& path : drawing.paths)
    if (path.closed)
      for (const Segment& segment : path.segments) boxes[path.layer].extend(boxAround(segment));
  return boxes;
}

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> comparisonLabels(const ui::OverlayContext& context) {
  std::vector<vtkSmartPointer<vtkProp>> labels;
  const Curves* drawing = pictureOf(context.result);
  if (!drawing) return labels;
  for (const auto& [layer, box] : boxesByLayer(*drawing)) {
    if (layer.empty()) continue;
    const Vec3 place(box.min().x(), box.max().y(), 0);
    labels.push_back(
        ui::labelProp(ui::qt(layer), place, ui::labelLook(context.look, context.look.curve, context.pixelRatio)));
  }
  return labels;
}

}  // namespace blossom::minkowski
