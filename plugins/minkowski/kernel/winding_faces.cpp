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

/// A sweep from left to right; CGAL's has no callback, so its comparisons and intersections come here.
class Sweeping {
 public:
  static constexpr double share = 0.8;  // of the time that faces take

  Sweeping(double left, double right, const Progress& progress, Effort& effort)
      : progress_(progress), effort_(effort), left_(left), right_(right) {}

  void ask() {
    if (++asked_ % 256 == 0) progress_.check();
  }
  /// @param x where the sweep is, at least
  void meet(double x) {
    ask();
    effort_.spend(1);
    reached_ = std::max(reached_, (x - left_) / std::max(right_ - left_, 1.0));
    if (++meetings_ % 64 == 0) progress_.report(share * reached_, "Finding the boundary");
    if (meetings_ > maximumMeetings)
      throw Error(ErrorCode::LimitExceeded, "The edges of this sum cross millions of times.",
                  "Raise the tolerance, so that curves get fewer corners, or make the shapes less spiky.");
  }

 private:
  static constexpr std::size_t maximumMeetings = 20'000'000;  // some gigabytes
  const Progress& progress_;
  Effort& effort_;
  double left_, right_, reached_ = 0;
  std::size_t asked_ = 0, meetings_ = 0;
};
thread_local Sweeping* sweeping = nullptr;

/// Segments whose comparisons and intersections ask whether to go on.
class PollingTraits : public CGAL::Arr_segment_traits_2<Kernel> {
 public:
  using Base = CGAL::Arr_segment_traits_2<Kernel>;
  class Compare_xy_2 {
   public:
    CGAL::Comparison_result operator()(const Point_2& a, const Point_2& b) const {
      if (sweeping) sweeping->ask();
      return CGAL::compare_xy(a, b);
    }
  };
  class Intersect_2 {
   public:
    explicit Intersect_2(Base::Intersect_2 base) : base_(std::move(base)) {}
    template <class Output>
    Output operator()(const X_monotone_curve_2& a, const X_monotone_curve_2& b, Output out) const {
      if (sweeping) sweeping->meet(std::max(leftOf(a), leftOf(b)));
      return base_(a, b, out);
    }

   private:
    static double leftOf(const X_monotone_curve_2& curve) { return CGAL::to_interval(curve.left().x()).first; }

    Base::Intersect_2 base_;
  };
  [[nodiscard]] Compare_xy_2 compare_xy_2_object() const { return {}; }
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
  explicit Watch(Sweeping& watched) { sweeping = &watched; }
  ~Watch() { sweeping = nullptr; }
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

bool isInside(int winding, Inside rule) {
  switch (rule) {
    case Inside::Positive:
      return winding > 0;
    case Inside::NonZero:
      return winding != 0;
    case Inside::Hollow:
      break;
  }
  return winding <= 0;
}

/// The unbounded face stays outside by every rule.
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
        across->set_data({true, isInside(winding, rule), winding, -1});
        open.push_back(across);
      } else if (across->data().winding != winding) {
        throw Error(ErrorCode::Internal, "The edges of a sum do not close.", "Please report this with the shapes.");
      }
    });
  }
}

bool inside(const Face& face) { return face->data().inside; }

int numberParts(Arrangement& arrangement, const Progress& progress) {
  int parts = 0;
  for (auto seed = arrangement.faces_begin(); seed != arrangement.faces_end(); ++seed) {
    if (!inside(seed) || seed->data().part >= 0) continue;
    std::vector<Face> open{seed};
    seed->data().part = parts;
    while (!open.empty()) {
      progress.check();
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
using Ring = std::vector<Vertex>;

Vec2 rounded(const Vertex& vertex) { return {CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y())}; }

/// Whether a ring that visits each vertex once runs counter-clockwise: by the turn at its lowest vertex, before rounding.
bool isOuter(const Ring& ring) {
  const auto lowest = static_cast<std::size_t>(
      std::min_element(ring.begin(), ring.end(),
                       [](const Vertex& a, const Vertex& b) { return CGAL::compare_xy(a->point(), b->point()) < 0; }) -
      ring.begin());
  const std::size_t n = ring.size();
  const Vertex &before = ring[(lowest + n - 1) % n], &after = ring[(lowest + 1) % n];
  return CGAL::orientation(before->point(), ring[lowest]->point(), after->point()) == CGAL::LEFT_TURN;
}

void addRing(const Ring& ring, Polygon& part, const Progress& progress) {
  Loop loop;
  loop.reserve(ring.size());
  for (const Vertex& vertex : ring) {
    progress.check();
    loop.push_back(rounded(vertex));
  }
  if (!isOuter(ring)) {
    part.holes.push_back(std::move(loop));
  } else if (part.outer.empty()) {
    part.outer = std::move(loop);
  } else {
    throw Error(ErrorCode::Internal, "A part of a sum has two outlines.", "Please report this with the shapes.");
  }
}

/// Cuts a walk that comes back to a vertex into rings that visit each vertex once.
void addRings(const Ring& walk, Polygon& part, const Progress& progress) {
  Ring open;
  std::unordered_map<const void*, std::size_t> places;
  for (const Vertex& vertex : walk) {
    const auto seen = places.find(&*vertex);
    if (seen == places.end()) {
      places.emplace(&*vertex, open.size());
      open.push_back(vertex);
      continue;
    }
    const std::size_t from = seen->second;
    addRing({open.begin() + static_cast<std::ptrdiff_t>(from), open.end()}, part, progress);
    for (std::size_t i = from + 1; i < open.size(); ++i) places.erase(&*open[i]);
    open.resize(from + 1);
  }
  addRing(open, part, progress);
}

Polygons boundaries(Arrangement& arrangement, const Progress& progress) {
  Polygons parts(static_cast<std::size_t>(numberParts(arrangement, progress)));
  std::unordered_set<const void*> done;
  std::size_t passed = 0;
  const auto all = static_cast<double>(arrangement.number_of_halfedges());
  for (auto start = arrangement.halfedges_begin(); start != arrangement.halfedges_end(); ++start) {
    if (++passed % 1024 == 0)
      progress.report(Sweeping::share + (1 - Sweeping::share) * static_cast<double>(passed) / all, "Reading the boundary");
    if (!isBoundary(start) || done.contains(&*start)) continue;
    Ring walk;
    for (Halfedge edge = start; done.insert(&*edge).second; edge = following(edge)) {
      progress.check();
      walk.push_back(edge->source());
    }
    addRings(walk, parts[static_cast<std::size_t>(start->face()->data().part)], progress);
  }
  return parts;
}

void build(Arrangement& arrangement, std::span<const CountedEdge> given, Inside rule, const Progress& progress,
           Effort& effort) {
  std::vector<CountedEdge> edges(given.begin(), given.end());
  joinOverlapping(edges);  // CGAL's sweep fails on some that lie over one another
  if (edges.empty()) return;
  // Else crossings of nearly parallel edges are only right to five digits.
  Kernel::FT::set_relative_precision_of_to_double(1e-15);
  const auto at = [](const GridPoint& p) { return Kernel::Point_2(static_cast<double>(p.x), static_cast<double>(p.y)); };
  std::vector<Traits::X_monotone_curve_2> curves;
  curves.reserve(edges.size());
  std::int64_t left = edges.front().from.x, right = left;
  for (const CountedEdge& edge : edges) {
    progress.check();
    left = std::min(left, edge.from.x);  // the lower point is no farther to the right
    right = std::max(right, edge.to.x);
    curves.emplace_back(PollingTraits::X_monotone_curve_2(at(edge.from), at(edge.to)), edge.count);
  }
  effort.spend(edges.size());
  Sweeping swept(static_cast<double>(left), static_cast<double>(right), progress, effort);
  {
    const Watch watch(swept);
    CGAL::insert(arrangement, curves.begin(), curves.end());
  }
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

Polygons windingFaces(std::span<const CountedEdge> edges, const Progress& progress, Inside rule, Effort& effort) {
  if (edges.empty()) return {};
  Arrangement arrangement;
  build(arrangement, edges, rule, progress, effort);
  return boundaries(arrangement, progress);
}

Polygons windingFaces(std::span<const CountedEdge> edges, const Progress& progress, Inside rule) {
  Effort unlimited;
  return windingFaces(edges, progress, rule, unlimited);
}

std::optional<Vec2> misplacedFace(std::span<const CountedEdge> edges, double width, const Progress& progress) {
  Arrangement arrangement;
  Effort effort;
  build(arrangement, edges, Inside::NonZero, progress, effort);
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    const int winding = face->data().winding;
    if (face->is_unbounded() || winding == 0 || winding == 1 || widthOf(face) <= width) continue;
    return rounded((*face->outer_ccbs_begin())->source());
  }
  return std::nullopt;
}

}  // namespace blossom::minkowski
