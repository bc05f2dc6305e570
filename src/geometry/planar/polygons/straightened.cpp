#include "geometry/planar/polygons/straightened.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"

namespace blossom::planar {
namespace {

/// How far away the numbers are from which the ends of a segment are rounded, beyond these ends.
double reachOf(const Segment& segment) {
  const auto* arc = std::get_if<Arc2>(&segment);
  return arc ? arc->center.norm() + arc->radius : 0;
}

}  // namespace

void straighten(Path& path, double tolerance) {
  constexpr double large = 1e4, share = 1e-3, mostOf = 0.1, roundings = 4e-16;
  const double size = boxAround({&path, 1}).sizes().maxCoeff();
  const std::size_t count = path.segments.size();
  for (std::size_t k = 0; k < count; ++k) {
    Segment& segment = path.segments[k];
    const auto* arc = std::get_if<Arc2>(&segment);
    if (!arc || arc->radius < large * size) continue;
    const double bow = 2 * arc->radius * std::pow(std::sin(arc->sweep / 4), 2);
    if (bow > std::max(share * tolerance, std::min(mostOf * tolerance, roundings * reachOf(segment)))) continue;
    const bool hasBefore = count > 1 && (path.closed || k > 0), hasNext = count > 1 && (path.closed || k + 1 < count);
    const Segment &before = path.segments[(k + count - 1) % count], &next = path.segments[(k + 1) % count];
    const bool beginsThere = hasBefore && reachOf(before) <= reachOf(segment);
    const bool endsThere = hasNext && reachOf(next) <= reachOf(segment);
    segment = Line2{beginsThere ? endPoint(before) : startPoint(segment), endsThere ? startPoint(next) : endPoint(segment)};
  }
}

}  // namespace blossom::planar
