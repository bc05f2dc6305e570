#pragma once
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>

#include <vector>

#include "geometry/planar/planar.h"
#include "geometry/planar/region.h"

/// Planar regions as CGAL's exact polygons, and CGAL's own Minkowski sums of them.
namespace blossom::test {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = CGAL::Point_2<Kernel>;
using Ring = CGAL::Polygon_2<Kernel>;
using Part = CGAL::Polygon_with_holes_2<Kernel>;
using Parts = std::vector<Part>;
using Set = CGAL::Polygon_set_2<Kernel>;
using Decomposition = CGAL::Polygon_vertical_decomposition_2<Kernel>;

inline Ring ringOf(const Path& path) {
  Ring ring;
  for (const Segment& segment : path.segments) ring.push_back({startPoint(segment).x(), startPoint(segment).y()});
  return ring;
}

inline Parts partsOf(const Region& region) {
  Parts parts;
  for (const RegionComponent& component : components(region)) {
    Part& part = parts.emplace_back(ringOf(region.loops[component.outer]));
    for (const std::size_t hole : component.holes) part.add_hole(ringOf(region.loops[hole]));
  }
  return parts;
}

inline Parts partsOf(const Set& set) {
  Parts parts;
  set.polygons_with_holes(std::back_inserter(parts));
  return parts;
}

/// Without the holes that the other fills: the filter of CGAL 5.5.1 walks over a container while it shrinks (CGAL's pull
/// request 7339), so it must find nothing to remove.
inline Part withoutFilledHoles(const Part& part, const Part& other) {
  Part kept(part.outer_boundary());
  const CGAL::Bbox_2 box = other.outer_boundary().bbox();
  for (const Ring& hole : part.holes()) {
    const CGAL::Bbox_2 room = hole.bbox();
    if (room.xmax() - room.xmin() > box.xmax() - box.xmin() && room.ymax() - room.ymin() > box.ymax() - box.ymin())
      kept.add_hole(hole);
  }
  return kept;
}

enum class Method { Decomposed, Convolved };

/// The parts' sums united. In planar_peer.cpp.
Set sumOf(const Parts& a, const Parts& b, Method method);

inline double areaOf(const Set& set) {
  Kernel::FT sum = 0;
  for (const Part& part : partsOf(set)) {
    sum += part.outer_boundary().area();
    for (const Ring& hole : part.holes()) sum += hole.area();
  }
  return CGAL::to_double(sum);
}

}  // namespace blossom::test
