#include "support/planar_peer.h"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "support/cgal_regions.h"

namespace blossom::test {

namespace {

using Segments = CGAL::Arr_segment_traits_2<Kernel>;
using Traits =
    CGAL::Arr_curve_data_traits_2<Segments, int, std::plus<>>;  // how often a segment counts from its lower end on
struct FaceState {
  bool reached = false, inside = false;
  int winding = 0, flood = -1;
};
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, FaceState>>;
using Face = Arrangement::Face_handle;
using Halfedge = Arrangement::Halfedge_handle;

/// Edges on one line, cut where others begin or end and joined: CGAL 5.5's sweep fails on some that lie over one another.
std::vector<planar::CountedEdge> withoutOverlaps(std::span<const planar::CountedEdge> edges) {
  using planar::CountedEdge, planar::GridPoint, planar::Wide;
  using Line = std::pair<GridPoint, Wide>;
  std::map<Line, std::map<GridPoint, int>> lines;  // by how much the count changes at each point
  for (const CountedEdge& edge : edges) {
    GridPoint along = edge.to - edge.from;
    const std::int64_t shared = std::gcd(along.x, along.y);
    along = {along.x / shared, along.y / shared};
    auto& changes = lines[{along, cross(along, edge.from)}];
    changes[edge.from] += edge.count;
    changes[edge.to] -= edge.count;
  }
  std::vector<CountedEdge> cut;
  for (const auto& [line, changes] : lines) {
    int count = 0;
    for (auto at = changes.begin(); at != changes.end(); ++at) {
      if (count != 0) cut.push_back({std::prev(at)->first, at->first, count});
      count += at->second;
    }
  }
  return cut;
}

template <class Visit>
void forEachEdge(const Face& face, Visit visit) {
  const auto around = [&](Arrangement::Ccb_halfedge_circulator first) {
    auto edge = first;
    do visit(Halfedge(edge));
    while (++edge != first);
  };
  for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) around(*outer);
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) around(*inner);
}

/// Calls visit for all faces that are reached from one across edges without leaving those that `within` accepts.
template <class Within, class Visit>
void flood(const Face& seed, Within within, Visit visit) {
  std::vector<Face> open{seed};
  visit(seed);
  while (!open.empty()) {
    const Face face = open.back();
    open.pop_back();
    forEachEdge(face, [&](const Halfedge& edge) {
      const Face across = edge->twin()->face();
      if (!within(across)) return;
      visit(across);
      open.push_back(across);
    });
  }
}

/// The unbounded face is outside by every rule.
void wind(Arrangement& arrangement, planar::Inside rule) {
  const Face unbounded = arrangement.unbounded_face();
  unbounded->set_data({true, false, 0, -1});
  std::vector<Face> open{unbounded};
  while (!open.empty()) {
    const Face face = open.back();
    open.pop_back();
    forEachEdge(face, [&](const Halfedge& edge) {
      const Face across = edge->twin()->face();
      if (across->data().reached) return;
      const int count = edge->curve().data();
      const int winding = face->data().winding - (edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? count : -count);
      const bool inside = rule == planar::Inside::Positive  ? winding > 0
                          : rule == planar::Inside::NonZero ? winding != 0
                                                            : winding <= 0;
      across->set_data({true, inside, winding, -1});
      open.push_back(across);
    });
  }
}

std::vector<Face> facesOf(Arrangement& arrangement) {
  std::vector<Face> faces;
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) faces.emplace_back(face);
  return faces;
}

/// Twice the area to the left of the edges of a face, about a point near them.
Kernel::FT doubleArea(const Face& face, const Kernel::Point_2& origin) {
  Kernel::FT sum = 0;
  forEachEdge(face, [&](const Halfedge& edge) {
    sum += CGAL::determinant(edge->source()->point() - origin, edge->target()->point() - origin);
  });
  return sum;
}

/// The parts of what does not belong to a part, as far as the part separates them by edges; the unbounded one is no hole.
std::size_t holesOf(std::vector<Face>& faces, int part, std::vector<int>& partOf) {
  std::map<const void*, std::size_t> number;
  for (std::size_t i = 0; i < faces.size(); ++i) number[&*faces[i]] = i;
  std::vector<bool> seen(faces.size(), false);
  std::size_t floods = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto open = [&](const Face& face) {
      const std::size_t k = number.at(&*face);
      return partOf[k] != part && !seen[k];
    };
    if (!open(faces[i])) continue;
    ++floods;
    flood(faces[i], open, [&](const Face& face) { seen[number.at(&*face)] = true; });
  }
  return floods - 1;
}

}  // namespace

ArrangedFaces arrangedFaces(std::span<const planar::CountedEdge> edges, planar::Inside rule) {
  const auto at = [](const planar::GridPoint& p) {
    return Kernel::Point_2(static_cast<double>(p.x), static_cast<double>(p.y));
  };
  std::vector<Traits::X_monotone_curve_2> curves;
  for (const planar::CountedEdge& edge : withoutOverlaps(edges))
    curves.emplace_back(Segments::X_monotone_curve_2(at(edge.from), at(edge.to)), edge.count);
  ArrangedFaces result;
  if (curves.empty()) return result;
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  wind(arrangement, rule);
  std::vector<Face> faces = facesOf(arrangement);
  const Kernel::Point_2 origin = arrangement.vertices_begin()->point();
  const auto rounded = [](const Kernel::Point_2& p) { return Vec2(CGAL::to_double(p.x()), CGAL::to_double(p.y())); };
  Kernel::FT area = 0;
  std::vector<int> partOf(faces.size(), -1);
  for (const Face& face : faces) {
    if (!face->data().inside) continue;
    area += doubleArea(face, origin);
    forEachEdge(face, [&](const Halfedge& edge) {
      if (!edge->twin()->face()->data().inside)
        result.boundary.emplace_back(rounded(edge->source()->point()), rounded(edge->target()->point()));
    });
    if (face->data().flood >= 0) continue;
    const int part = static_cast<int>(result.parts++);
    flood(
        face, [](const Face& next) { return next->data().inside && next->data().flood < 0; },
        [&](const Face& next) { next->data().flood = part; });
  }
  for (std::size_t i = 0; i < faces.size(); ++i) partOf[i] = faces[i]->data().flood;
  for (std::size_t part = 0; part < result.parts; ++part) result.holes += holesOf(faces, static_cast<int>(part), partOf);
  result.area = CGAL::to_double(area / 2);
  return result;
}

Set sumOf(const Parts& a, const Parts& b, Method method) {
  Set total;
  for (const Part& partA : a)
    for (const Part& partB : b) {
      const Part p = withoutFilledHoles(partA, partB), q = withoutFilledHoles(partB, partA);
      total.join(method == Method::Decomposed ? CGAL::minkowski_sum_2(p, q, Decomposition())
                                              : CGAL::minkowski_sum_by_reduced_convolution_2(p, q));
    }
  return total;
}

std::function<double()> reducedConvolution(const Region& a, const Region& b) {
  return [a = partsOf(a), b = partsOf(b)] {
    if (a.size() > 1 || b.size() > 1) return areaOf(sumOf(a, b, Method::Convolved));
    // Without the union of one.
    const Part sum = CGAL::minkowski_sum_by_reduced_convolution_2(withoutFilledHoles(a.front(), b.front()),
                                                                  withoutFilledHoles(b.front(), a.front()));
    Kernel::FT area = sum.outer_boundary().area();
    for (const Ring& hole : sum.holes()) area += hole.area();
    return CGAL::to_double(area);
  };
}

}  // namespace blossom::test
