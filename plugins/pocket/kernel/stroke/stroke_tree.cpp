#include "kernel/stroke/stroke_tree.h"

namespace blossom::pocket {

namespace {

Box2 boxOf(const Stroke& stroke) {
  const auto [low, high] = stroke.box();
  return {low, high};
}

}  // namespace

StrokeTree::StrokeTree(std::vector<Stroke> strokes) : strokes_(std::move(strokes)) {
  std::vector<Box2> boxes;
  boxes.reserve(strokes_.size());
  for (const Stroke& stroke : strokes_) boxes.push_back(boxOf(stroke));
  tree_ = BoxTree<2>(boxes);
}

template <class Wanted, class DistanceTo>
StrokeTree::Nearest StrokeTree::search(const Wanted& wanted, double bound, const DistanceTo& distanceTo) const {
  Nearest best{bound, strokes_.size()};
  const auto visit = [&](std::size_t i) {
    if (const double d = distance(strokes_[i], wanted); d < best.distance) best = {d, i};
  };
  tree_.walk(distanceTo, visit, [&](double d) { return d < best.distance; });
  return best;
}

StrokeTree::Nearest StrokeTree::nearest(const Vec2& p, double bound) const {
  return search(p, bound, [&](const Box2& box) { return boxDistance(box, p); });
}

StrokeTree::Nearest StrokeTree::nearest(const Stroke& wanted, double bound) const {
  const Box2 around = boxOf(wanted);
  return search(wanted, bound, [&](const Box2& box) { return boxDistance(box, around); });
}

}  // namespace blossom::pocket
