#include "geometry/planar/boundary_tree.h"

#include <algorithm>
#include <limits>

#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"
#include "geometry/planar/segment_point.h"

namespace blossom {
namespace {

std::vector<Segment> segmentsAndBridges(const Region& region) {
  std::vector<Segment> all;
  for (const Path& loop : region.loops)
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
      const Segment &segment = loop.segments[i], &next = loop.segments[(i + 1) % loop.segments.size()];
      all.push_back(segment);
      const Line2 bridge{endPoint(segment), startPoint(next)};
      if (bridge.from != bridge.to) all.emplace_back(bridge);
    }
  return all;
}

std::vector<Box2> boxesAround(const std::vector<Segment>& segments) {
  std::vector<Box2> boxes;
  boxes.reserve(segments.size());
  for (const Segment& segment : segments) boxes.push_back(boxAround(segment));
  return boxes;
}

}  // namespace

BoundaryTree::BoundaryTree(const Region& region, const Progress& progress)
    : segments_(segmentsAndBridges(region)), tree_(boxesAround(segments_), 4, progress) {}

double BoundaryTree::distanceTo(const Vec2& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  tree_.walk([&](const Box2& box) { return boxDistance(box, p); },
             [&](std::size_t i) { nearest = std::min(nearest, blossom::distanceTo(segments_[i], p)); },
             [&](double distance) { return distance < nearest; });
  return nearest;
}

int BoundaryTree::windingNumber(const Vec2& p) const {
  const Box2 ray(p, Vec2(std::numeric_limits<double>::infinity(), p.y()));
  int sum = 0;
  tree_.meeting(ray, [&](std::size_t i) { sum += crossingsToTheRight(segments_[i], p); });
  return sum;
}

}  // namespace blossom
