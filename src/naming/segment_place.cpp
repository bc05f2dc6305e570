#include "naming/segment_place.h"

#include <algorithm>
#include <cmath>

namespace blossom {

namespace {

Vec2 bulgeOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return (line->from + line->to) / 2;
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double middle = arc->start + arc->sweep / 2;
    return arc->center + arc->radius * Vec2(std::cos(middle), std::sin(middle));
  }
  Vec2 sum = Vec2::Zero();
  const auto& poles = std::get<Spline2>(segment).poles;
  for (const Vec3& pole : poles) sum += pole.head<2>() / pole.z();
  return sum / static_cast<double>(std::max<std::size_t>(1, poles.size()));
}

SegmentPlace placeOf(const Segment& segment) {
  return {segment.index(), {startPoint(segment), bulgeOf(segment), endPoint(segment)}};
}

}  // namespace

bool SegmentPlace::isAt(const SegmentPlace& other, double tolerance) const {
  return form == other.form && std::equal(points.begin(), points.end(), other.points.begin(),
                                          [&](const Vec2& a, const Vec2& b) { return (a - b).norm() <= tolerance; });
}

const SegmentPlace* PlacedLoop::at(int k) const {
  if (closed) return &segments[static_cast<std::size_t>((k % size() + size()) % size())];
  return k >= 0 && k < size() ? &segments[static_cast<std::size_t>(k)] : nullptr;
}

std::vector<PlacedLoop> placedLoopsOf(const std::vector<Path>& paths) {
  std::vector<PlacedLoop> loops;
  int number = 0;
  for (const Path& path : paths) {
    PlacedLoop& loop = loops.emplace_back();
    loop.closed = path.closed;
    loop.first = number;
    for (const Segment& segment : path.segments) loop.segments.push_back(placeOf(segment));
    number += loop.size();
  }
  return loops;
}

Value toJson(const SegmentPlace* place) {
  if (!place) return {};
  Value json = Value::array({place->form});
  for (const Vec2& p : place->points) {
    json.push_back(p.x());
    json.push_back(p.y());
  }
  return json;
}

SegmentPlace segmentPlaceFrom(const Value& json) {
  SegmentPlace place;
  place.form = json.at(0).get<std::size_t>();
  for (std::size_t k = 0; k < 3; ++k)
    place.points.at(k) = {json.at(1 + 2 * k).get<double>(), json.at(2 + 2 * k).get<double>()};
  return place;
}

}  // namespace blossom
