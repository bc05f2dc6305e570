// What the mouse finds among the shapes of the view.
#include <algorithm>
#include <limits>

#include "ui/view/items/view_items.h"

namespace blossom::ui {

namespace {

SubShapeKind kindOf(PickMode mode) {
  switch (mode) {
    case PickMode::Face:
      return SubShapeKind::Face;
    case PickMode::Edge:
      return SubShapeKind::Edge;
    case PickMode::Vertex:
      return SubShapeKind::Vertex;
    default:
      return SubShapeKind::Whole;
  }
}

bool fits(const SubPick& part, PickMode mode) {
  return mode == PickMode::Feature || mode == PickMode::Any || part.kind == kindOf(mode);
}

/// Points before edges before faces; of equal kind the nearer one.
int rank(const SubPick& part) {
  switch (part.kind) {
    case SubShapeKind::Vertex:
      return 0;
    case SubShapeKind::Edge:
      return 1;
    default:
      return 2;
  }
}

}  // namespace

// What has stepped back hides nothing and is found where there is nothing else.
Pick ViewItems::pick(const Ray& ray, const PickOptions& options, PickMode mode) const {
  if (mode == PickMode::None) return {};
  const Pick found = pickAmong(ray, options, mode, false);
  return found.feature.empty() ? pickAmong(ray, options, mode, true) : found;
}

Pick ViewItems::pickAmong(const Ray& ray, PickOptions options, PickMode mode, bool steppedBack) const {
  const auto counts = [&](const Shown& shown) { return (shown.presence == Presence::SteppedBack) == steppedBack; };
  const bool anything = mode == PickMode::Any || mode == PickMode::Feature;
  const bool wires = mode_ == DisplayMode::Wireframe;
  options.facesHide = !wires;
  options.faces = anything ? !wires : mode == PickMode::Face;
  options.edges = anything || mode == PickMode::Edge;
  options.vertices = mode == PickMode::Any || mode == PickMode::Vertex;
  // What lies on a face of another shape is in front of it.
  const auto slack = [&](double distance) { return options.tolerance + options.tolerancePerMm * distance; };

  double wall = std::numeric_limits<double>::infinity();
  if (!wires)
    for (const auto& [id, shown] : shown_)
      if (counts(shown)) wall = std::min(wall, shown.scene.picks->faceDistance(ray, options.cut));
  const auto hidden = [&](const SubPick& part) {
    const bool perspective = options.tolerancePerMm > 0;
    const Vec3 from = perspective ? ray.origin : Vec3(part.point - part.distance * ray.direction);
    const double distance = (part.point - from).norm();
    return std::any_of(shown_.begin(), shown_.end(), [&](const auto& entry) {
      const Ray sight{from, (part.point - from) / distance};
      return counts(entry.second) &&
             entry.second.scene.picks->faceDistance(sight, options.cut) < distance - slack(distance) / 4;
    });
  };
  Pick best;
  double bestDepth = 0;
  for (const auto& [id, shown] : shown_) {
    if (!counts(shown)) continue;
    PickOptions own = options;
    own.faces = options.faces || (wires && anything && shown.scene.planar);
    const auto part = shown.scene.picks->pick(ray, own);
    if (!part || !fits(*part, mode)) continue;
    if (part->distance > wall + slack(wall) && (rank(*part) == 2 || hidden(*part))) continue;
    const double depth = part->distance + (shown.presence == Presence::Beneath ? slack(part->distance) : 0);
    const bool nearer =
        best.feature.empty() || rank(*part) < rank(best.part) || (rank(*part) == rank(best.part) && depth < bestDepth);
    if (!nearer) continue;
    best = {id, *part};
    bestDepth = depth;
  }
  if (mode == PickMode::Feature && !best.feature.empty()) {
    best.part.kind = SubShapeKind::Whole;
    best.part.index = -1;
  }
  return best;
}

std::vector<Pick> ViewItems::within(const std::vector<CutPlane>& bounds, PickMode mode, bool crossing) const {
  std::vector<Pick> found;
  if (mode == PickMode::None) return found;
  const SubShapeKind kind = kindOf(mode);
  std::vector<CutPlane> all = bounds;
  if (section_) all.push_back(*section_);
  for (const auto& [id, shown] : shown_) {
    if (shown.presence == Presence::SteppedBack) continue;
    for (const int index : shown.scene.picks->within(crossing ? all : bounds, kind, crossing))
      found.push_back({id, {.kind = kind, .index = kind == SubShapeKind::Whole ? -1 : index}});
  }
  return found;
}

}  // namespace blossom::ui
