#include "geometry/planar/sums/polygon_sum.h"

#include <algorithm>

#include "geometry/planar/polygons/grid.h"
#include "geometry/planar/polygons/snapped_operands.h"
#include "geometry/planar/sums/complement.h"
#include "geometry/planar/winding/convolution.h"
#include "geometry/planar/winding/edges_of_sum.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {
namespace {

bool isConvex(const std::vector<GridPolygon>& polygons) {
  if (polygons.size() != 1 || !polygons.front().holes.empty()) return false;
  const GridLoop& p = polygons.front().outer;
  const std::size_t n = p.size();
  int changes = 0;  // of the sign of dx: a convex loop has two, one that winds twice has four
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint in = p[(i + 1) % n] - p[i], out = p[(i + 2) % n] - p[(i + 1) % n];
    if (cross(in, out) <= 0) return false;
    const auto forward = [](const GridPoint& d) { return d.x > 0 || (d.x == 0 && d.y > 0); };
    if (forward(in) != forward(out)) ++changes;
  }
  return changes == 2;
}

GridLoop fromLowest(GridLoop loop) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

/// Both loops from their lowest points on, whose edges then come sorted by angle.
Loop mergedByAngle(const GridLoop& first, const GridLoop& second) {
  const GridLoop a = fromLowest(first), b = fromLowest(second);
  Loop sum;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const GridPoint corner = a[i % a.size()] + b[j % b.size()];
    sum.emplace_back(static_cast<double>(corner.x), static_cast<double>(corner.y));
    const GridPoint alongA = a[(i + 1) % a.size()] - a[i % a.size()], alongB = b[(j + 1) % b.size()] - b[j % b.size()];
    const auto forward = [](const GridPoint& d) { return d.x > 0 || (d.x == 0 && d.y > 0); };
    Wide order = cross(alongA, alongB);
    if (forward(alongA) != forward(alongB)) order = forward(alongA) ? 1 : -1;  // the lower chain comes first
    if (j == b.size() || (i < a.size() && order >= 0))
      ++i;
    else
      ++j;
  }
  return sum;
}

Polygons facesOfSum(const SnappedOperands& operands, Inside inside, const Progress& progress, Effort& effort) {
  const std::vector<GridPolygon> a = untangled(operands.a, progress), b = untangled(operands.b, progress);
  const std::vector<CountedEdge> edges = edgesOfSum(a, b, inside, progress.part(0, 0.1), effort);
  return onPlane(windingFaces(edges, progress.part(0.1, 1), inside, effort), operands.gridOfSum);
}

}  // namespace

Polygons sum(const Polygons& a, const Polygons& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.empty() || b.empty()) return {};
  const SnappedOperands operands = snappedTogether(a, b);
  if (isConvex(operands.a) && isConvex(operands.b))
    return onPlane({{mergedByAngle(operands.a.front().outer, operands.b.front().outer), {}}}, operands.gridOfSum);
  return facesOfSum(operands, Inside::Positive, progress, effort);
}

Polygons sum(const Polygons& a, const Polygons& b, const Progress& progress) {
  Effort unlimited;
  return sum(a, b, progress, unlimited);
}

Polygons grownBy(const Polygons& polygons, double by, const Progress& progress, Effort& effort) {
  return sum(polygons, {{{{-by, -by}, {by, -by}, {by, by}, {-by, by}}, {}}}, progress, effort);
}

Polygons difference(const Polygons& a, const Polygons& b, const Progress& progress, Effort& effort) {
  progress.check();
  if (a.empty()) return {};
  // What the sum leaves out is read off its winding numbers, where loops that touch lie in one another as they do.
  Polygons room = facesOfSum(snappedTogether(complement(a, boxOf(b).sizes(), progress), scaled(b, -1)), Inside::Hollow,
                             progress, effort);
  for (auto& [outer, holes] : room)
    std::rotate(outer.begin(), std::min_element(outer.begin(), outer.end(), fartherLeft), outer.end());
  return room;
}

}  // namespace blossom::planar
