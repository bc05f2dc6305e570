// The only file that includes CGAL's exact kernels: it takes most of a minute to compile.
#include "kernel/winding_faces.h"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <functional>
#include <unordered_map>
#include <unordered_set>

#include "core/error.h"

namespace blossom::minkowski {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// CGAL's sweep has no callback; its intersections ask here.
thread_local const Progress* watched = nullptr;
thread_local std::size_t meetings = 0;
constexpr std::size_t mostMeetings = 20'000'000;  // some gigabytes

/// Segments that ask now and then whether to go on.
class PollingTraits : public CGAL::Arr_segment_traits_2<Kernel> {
 public:
  using Base = CGAL::Arr_segment_traits_2<Kernel>;
  class Intersect_2 {
   public:
    explicit Intersect_2(Base::Intersect_2 base) : base_(std::move(base)) {}
    template <class Output>
    Output operator()(const X_monotone_curve_2& a, const X_monotone_curve_2& b, Output out) const {
      if (++meetings % 256 == 0 && watched) watched->check();
      if (meetings > mostMeetings)
        throw Error(ErrorCode::LimitExceeded, "The edges of this sum cross millions of times.",
                    "Raise the tolerance, so that curves get fewer corners, or make the shapes less spiky.");
      return base_(a, b, out);
    }

   private:
    Base::Intersect_2 base_;
  };
  [[nodiscard]] Intersect_2 intersect_2_object() const { return Intersect_2(Base::intersect_2_object()); }
};

/// The data of a segment: how often it counts from its lower to its higher point.
using Traits = CGAL::Arr_curve_data_traits_2<PollingTraits, int, std::plus<>>;

struct FaceData {
  bool reached = false;
  bool inside = false;
  int winding = 0;
  int part = -1;  ///< number of the connected part of the inside
};
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, FaceData>>;
using Face = Arrangement::Face_handle;
using Halfedge = Arrangement::Halfedge_handle;

class Watch {
 public:
  explicit Watch(const Progress& progress) {
    watched = &progress;
    meetings = 0;
  }
  ~Watch() { watched = nullptr; }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
};

/// What a halfedge's face has more than the face across.
int step(const Halfedge& edge) {
  const int count = edge->curve().data();
  return edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? count : -count;
}

template <class F>
void forEachEdge(const Face& face, F f) {
  const auto around = [&](Arrangement::Ccb_halfedge_circulator first) {
    auto edge = first;
    do f(Halfedge(edge));
    while (++edge != first);
  };
  for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) around(*outer);
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) around(*inner);
}

void findWindings(Arrangement& arrangement, Inside rule, const Progress& progress) {
  std::vector<Face> open{arrangement.unbounded_face()};
  open.front()->set_data({true, false, 0, -1});
  while (!open.empty()) {
    const Face face = open.back();
    open.pop_back();
    progress.check();
    forEachEdge(face, [&](const Halfedge& edge) {
      const Face across = edge->twin()->face();
      const int winding = face->data().winding - step(edge);
      if (!across->data().reached) {
        across->set_data({true, rule == Inside::Positive ? winding > 0 : winding != 0, winding, -1});
        open.push_back(across);
      } else if (across->data().winding != winding) {
        throw Error(ErrorCode::Internal, "The edges of a sum do not close.", "Please report this with the shapes.");
      }
    });
  }
}

bool inside(const Face& face) { return face->data().inside; }

int numberParts(Arrangement& arrangement) {
  int parts = 0;
  for (auto seed = arrangement.faces_begin(); seed != arrangement.faces_end(); ++seed) {
    if (!inside(seed) || seed->data().part >= 0) continue;
    std::vector<Face> open{seed};
    seed->data().part = parts;
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      forEachEdge(face, [&](const Halfedge& edge) {
        const Face across = edge->twin()->face();
        if (!inside(across) || across->data().part >= 0) return;
        across->data().part = parts;
        open.push_back(across);
      });
    }
    ++parts;
  }
  return parts;
}

bool isBoundary(const Halfedge& edge) { return inside(edge->face()) && !inside(edge->twin()->face()); }

/// The boundary edge that follows around the same corner of the inside.
Halfedge following(Halfedge edge) {
  edge = edge->next();
  while (!isBoundary(edge)) edge = edge->twin()->next();
  return edge;
}

using Vertex = Arrangement::Vertex_const_handle;

Vec2 rounded(const Vertex& vertex) { return {CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y())}; }

/// Cuts a walk that comes back to a vertex into loops that visit each vertex once.
void addLoops(const std::vector<Vertex>& walk, std::vector<Loop>& loops) {
  std::vector<Vertex> open;
  std::unordered_map<const void*, std::size_t> places;
  for (const Vertex& vertex : walk) {
    const auto seen = places.find(&*vertex);
    if (seen != places.end()) {
      Loop& loop = loops.emplace_back();
      const std::size_t from = seen->second;
      for (std::size_t i = from; i < open.size(); ++i) {
        loop.push_back(rounded(open[i]));
        if (i > from) places.erase(&*open[i]);
      }
      open.resize(from + 1);
    } else {
      places.emplace(&*vertex, open.size());
      open.push_back(vertex);
    }
  }
  Loop& last = loops.emplace_back();
  for (const Vertex& vertex : open) last.push_back(rounded(vertex));
}

/// The loops of one connected part. A part has one outer loop; only rounding can make crumbs of it.
void addPart(std::vector<Loop>& loops, Polygons& polygons) {
  const std::size_t first = polygons.size();
  for (Loop& loop : loops)
    if (signedArea(loop) > 0) polygons.push_back({std::move(loop), {}});
  for (Loop& loop : loops) {
    if (loop.empty() || polygons.size() == first) continue;
    std::size_t owner = first;
    for (std::size_t i = first; i < polygons.size(); ++i)
      if (encloses(polygons[i].outer, loop.front())) owner = i;
    polygons[owner].holes.push_back(std::move(loop));
  }
}

Polygons boundaries(Arrangement& arrangement, const Progress& progress) {
  std::vector<std::vector<Loop>> parts(static_cast<std::size_t>(numberParts(arrangement)));
  std::unordered_set<const void*> done;
  for (auto start = arrangement.halfedges_begin(); start != arrangement.halfedges_end(); ++start) {
    if (!isBoundary(start) || done.contains(&*start)) continue;
    progress.check();
    std::vector<Vertex> walk;
    for (Halfedge edge = start; done.insert(&*edge).second; edge = following(edge)) walk.push_back(edge->source());
    addLoops(walk, parts[static_cast<std::size_t>(start->face()->data().part)]);
  }
  Polygons polygons;
  for (std::vector<Loop>& loops : parts) addPart(loops, polygons);
  return polygons;
}

void build(Arrangement& arrangement, std::span<const CountedEdge> edges, Inside rule, const Progress& progress) {
  // Else crossings of nearly parallel edges are only right to five digits.
  Kernel::FT::set_relative_precision_of_to_double(1e-15);
  const auto at = [](const GridPoint& p) { return Kernel::Point_2(static_cast<double>(p.x), static_cast<double>(p.y)); };
  std::vector<Traits::X_monotone_curve_2> curves;
  curves.reserve(edges.size());
  for (const CountedEdge& edge : edges)
    curves.emplace_back(PollingTraits::X_monotone_curve_2(at(edge.from), at(edge.to)), edge.count);
  const Watch watch(progress);
  CGAL::insert(arrangement, curves.begin(), curves.end());
  findWindings(arrangement, rule, progress);
}

/// Twice the area over the perimeter, of the outer boundary.
double widthOf(const Face& face) {
  Loop loop;
  const auto first = *face->outer_ccbs_begin();
  auto edge = first;
  do loop.push_back(rounded(edge->source()));
  while (++edge != first);
  double perimeter = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) perimeter += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return 2 * std::abs(signedArea(loop)) / perimeter;
}

}  // namespace

Polygons windingFaces(std::span<const CountedEdge> edges, const Progress& progress, Inside rule) {
  if (edges.empty()) return {};
  Arrangement arrangement;
  build(arrangement, edges, rule, progress);
  return boundaries(arrangement, progress);
}

std::optional<Vec2> misplacedFace(std::span<const CountedEdge> edges, double width, const Progress& progress) {
  Arrangement arrangement;
  build(arrangement, edges, Inside::NonZero, progress);
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    const int winding = face->data().winding;
    if (face->is_unbounded() || winding == 0 || winding == 1 || widthOf(face) <= width) continue;
    return rounded((*face->outer_ccbs_begin())->source());
  }
  return std::nullopt;
}

}  // namespace blossom::minkowski
