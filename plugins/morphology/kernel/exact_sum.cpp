#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/helpers.h>

// CGAL 6 has the traits of trees in space under another name.
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/stopwatch.h"
#include "kernel/convex/convex_sum.h"
#include "kernel/exact_types.h"

namespace blossom::morphology {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

#if __has_include(<CGAL/AABB_traits_3.h>)
template <typename Kernel, typename Primitive>
using TreeTraits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
template <typename Kernel, typename Primitive>
using TreeTraits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

/// Largest number of point pairs that one hull is made of.
constexpr std::size_t maximumPairsOfPoints = 40'000'000;

/// A sum of two pieces, or a union of such sums, with its position in the order of unions.
struct Piece {
  Solid solid;
  Vec3 place = Vec3::Zero();
};

/// A convex part with its hull, which has no faces where the part is flat or not on the grid.
struct Summand {
  const Part& part;
  Mesh hull;
};

std::vector<Summand> summandsOf(const Parts& parts, const Progress& progress) {
  std::vector<Summand> summands;
  summands.reserve(partCount(parts));
  for (const Part& part : parts->parts) {
    progress.check();
    summands.push_back({part, hullTriangles(part.grid)});
  }
  return summands;
}

void refuseManyPoints(std::size_t a, std::size_t b) {
  if (a > maximumPairsOfPoints / std::max<std::size_t>(1, b))
    throw Error(ErrorCode::LimitExceeded, "The two shapes have too many vertices to be added.",
                "Use a ball with fewer subdivisions, or a larger deviation.");
}

/// Points of which the sum is the hull, exact in doubles: of many all corners, of few all sums.
std::vector<Vec3> gridPointsOfSum(const Summand& a, const Summand& b, const Progress& progress) {
  constexpr std::size_t few = 100;
  const std::vector<Vec3>&p = a.part.grid, &q = b.part.grid;
  if (a.hull.faceCount() > 0 && b.hull.faceCount() > 0 && p.size() * q.size() > few)
    return pointsOfSum(a.hull, 1, b.hull, 1, cornersOfSum(a.hull, b.hull, progress));
  refuseManyPoints(p.size(), q.size());
  std::vector<Vec3> sums;
  sums.reserve(p.size() * q.size());
  for (const Vec3& x : p)
    for (const Vec3& y : q) sums.push_back(x + y);
  return sums;
}

SurfaceMesh hullOfSum(const Summand& a, const Summand& b, Vec3& place, const Progress& progress) {
  place = Vec3::Zero();
  SurfaceMesh surface;
  if (!a.part.grid.empty() && !b.part.grid.empty()) {
    const std::vector<Vec3> sums = gridPointsOfSum(a, b, progress);
    for (const Vec3& p : sums) place += p / static_cast<double>(sums.size());
    // A hull of points in a plane comes as a flat sheet: without volume, nothing is added.
    const bool solid = a.hull.faceCount() > 0 || b.hull.faceCount() > 0 || haveVolume(toPoints(sums));
    if (solid) surface = hullOf(sums);
  } else {
    refuseManyPoints(a.part.points.size(), b.part.points.size());
    std::vector<Point> sums;
    sums.reserve(a.part.points.size() * b.part.points.size());
    for (const Point& p : a.part.points)
      for (const Point& q : b.part.points) sums.push_back(p + (q - CGAL::ORIGIN));
    for (const Point& p : sums)
      place +=
          Vec3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())) / static_cast<double>(sums.size());
    if (haveVolume(sums)) surface = hullOf(sums);
  }
  if (surface.number_of_faces() > 0) PMP::triangulate_faces(surface);
  if (!CGAL::is_closed(surface))
    throw Error(ErrorCode::Internal, "The sum of two convex parts is not closed.", "Please report the two shapes.");
  return surface;
}

enum class Operation { Union, Difference };

/// How a part of one surface lies to the solid that the other bounds.
enum class Side { Outside, Inside, SameWay, OtherWay };

/// Both surfaces cut along each other; what CGAL makes of them afterwards may never end where the result has a vertex that
/// two parts share, so which pieces stay is found out here.
class Corefined {
 public:
  Corefined(const Solid& a, const Solid& b) : surfaces_{a->surface, b->surface} {
    for (std::size_t k = 0; k < 2; ++k) cuts_[k] = surfaces_[k].add_property_map<Edge, bool>("e:cut", false).first;
    PMP::corefine(surfaces_[0], surfaces_[1], CGAL::parameters::edge_is_constrained_map(cuts_[0]),
                  CGAL::parameters::edge_is_constrained_map(cuts_[1]));
  }

  [[nodiscard]] Triangles combined(Operation operation) const {
    Triangles out;
    const bool unite = operation == Operation::Union;
    collect(0, {Side::Outside, unite ? Side::SameWay : Side::OtherWay}, false, out);
    collect(1, {unite ? Side::Outside : Side::Inside}, !unite, out);
    return out;
  }

 private:
  using Edge = SurfaceMesh::Edge_index;
  using Face = SurfaceMesh::Face_index;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
  using Tree = CGAL::AABB_tree<TreeTraits<Exact, Primitive>>;

  static std::array<Point, 3> corners(const SurfaceMesh& surface, Face face) {
    const auto h = surface.halfedge(face);
    return {surface.point(surface.source(h)), surface.point(surface.target(h)),
            surface.point(surface.target(surface.next(h)))};
  }
  static Exact::Vector_3 normal(const SurfaceMesh& surface, Face face) {
    const auto [p, q, r] = corners(surface, face);
    return CGAL::normal(p, q, r);
  }
  static Side sideOf(const SurfaceMesh& surface, Face face, const SurfaceMesh& other, const Tree& tree) {
    const auto [p, q, r] = corners(surface, face);
    const Point middle = CGAL::centroid(p, q, r);
    const CGAL::Side_of_triangle_mesh<SurfaceMesh, Exact, CGAL::Default, Tree> side(tree);
    switch (side(middle)) {
      case CGAL::ON_UNBOUNDED_SIDE:
        return Side::Outside;
      case CGAL::ON_BOUNDED_SIDE:
        return Side::Inside;
      case CGAL::ON_BOUNDARY:
        break;
    }
    const auto covering = tree.any_intersected_primitive(middle);
    return covering && normal(surface, face) * normal(other, *covering) > 0 ? Side::SameWay : Side::OtherWay;
  }

  /// The pieces between the cuts that lie to the other surface in one of these ways.
  void collect(std::size_t which, const std::vector<Side>& wanted, bool reversed, Triangles& out) const {
    const SurfaceMesh &surface = surfaces_.at(which), &other = surfaces_.at(1 - which);
    Tree tree(faces(other).begin(), faces(other).end(), other);
    std::vector<std::size_t> piece(surface.number_of_faces() + surface.number_of_removed_faces());
    const auto pieceOf = CGAL::make_property_map(piece);
    const std::size_t count =
        PMP::connected_components(surface, pieceOf, CGAL::parameters::edge_is_constrained_map(cuts_.at(which)));
    std::vector<std::optional<bool>> stays(count);
    for (const Face face : surface.faces()) {
      auto& stay = stays[piece[face]];
      if (!stay) stay = std::find(wanted.begin(), wanted.end(), sideOf(surface, face, other, tree)) != wanted.end();
      if (*stay) add(surface, face, reversed, out);
    }
  }
  static void add(const SurfaceMesh& surface, Face face, bool reversed, Triangles& out) {
    const std::size_t from = out.points.size();
    for (const Point& p : corners(surface, face)) out.points.push_back(p);
    out.faces.push_back({from, from + (reversed ? 2 : 1), from + (reversed ? 1 : 2)});
  }

  std::array<SurfaceMesh, 2> surfaces_;
  std::array<SurfaceMesh::Property_map<Edge, bool>, 2> cuts_;
};

/// A surface when the triangles make one that is closed and has no vertex or edge that two of its parts share. Parts of two
/// surfaces that were cut along each other can touch in no other way.
std::optional<SurfaceMesh> surfaceOf(Triangles triangles) {
  PMP::merge_duplicate_points_in_polygon_soup(triangles.points, triangles.faces);
  if (!PMP::is_polygon_soup_a_polygon_mesh(triangles.faces)) return std::nullopt;
  SurfaceMesh surface;
  PMP::polygon_soup_to_polygon_mesh(triangles.points, triangles.faces, surface);
  if (surface.number_of_vertices() != triangles.points.size() || !CGAL::is_closed(surface)) return std::nullopt;
  return surface;
}

/// Back to a surface when it touches itself nowhere any more.
Solid simplest(const Nef& nef) {
  auto surface = surfaceOf(trianglesOf(nef));
  if (surface && !PMP::does_self_intersect(*surface)) return solidFrom(std::move(*surface));
  return solidFrom(nef);
}

Solid combined(const Solid& a, const Solid& b, Operation operation) {
  if (!a->nef && !b->nef)
    if (auto surface = surfaceOf(Corefined(a, b).combined(operation))) return solidFrom(std::move(*surface));
  // Surfaces that touch themselves.
  const Nef first = nefOf(*a), second = nefOf(*b);
  return simplest(operation == Operation::Union ? unionOf(first, second) : differenceOf(first, second));
}

/// Halves along the longest extent until single pieces are left: what is united lies side by side, which keeps
/// intermediate results small.
Solid unitedTree(std::vector<Piece>& pieces, std::size_t from, std::size_t to, std::size_t& done, const Progress& progress) {
  if (to - from == 1) return pieces[from].solid;
  Bounds bounds;
  for (std::size_t k = from; k < to; ++k) bounds.add(pieces[k].place);
  Eigen::Index axis = 0;
  (bounds.high - bounds.low).maxCoeff(&axis);
  const auto at = [&](std::size_t k) { return pieces.begin() + static_cast<std::ptrdiff_t>(k); };
  const std::size_t middle = (from + to) / 2;
  std::nth_element(at(from), at(middle), at(to),
                   [axis](const Piece& a, const Piece& b) { return a.place[axis] < b.place[axis]; });
  const Solid a = unitedTree(pieces, from, middle, done, progress);
  const Solid b = unitedTree(pieces, middle, to, done, progress);
  Solid both = combined(a, b, Operation::Union);
  progress.report(static_cast<double>(++done) / static_cast<double>(pieces.size()), "Uniting");
  return both;
}

}  // namespace

Parts piecesOf(const std::vector<std::vector<Vec3>>& pieces) {
  auto list = std::make_shared<PartList>();
  for (const auto& corners : pieces) list->parts.push_back({toPoints(corners), corners});
  return list;
}

std::size_t partCount(const Parts& parts) { return parts->parts.size(); }

Parts scaled(const Parts& parts, double factor, double grid) {
  auto list = std::make_shared<PartList>();
  for (const Part& part : parts->parts) {
    Part result;
    if (!part.grid.empty()) {
      for (const Vec3& p : part.grid) {
        const Vec3 q = factor * p / grid;
        result.grid.push_back(grid * Vec3(std::nearbyint(q.x()), std::nearbyint(q.y()), std::nearbyint(q.z())));
      }
      result.points = toPoints(result.grid);
    } else {
      for (const Point& p : part.points) result.points.push_back(CGAL::ORIGIN + Exact::FT(factor) * (p - CGAL::ORIGIN));
    }
    list->parts.push_back(std::move(result));
  }
  return list;
}

Solid sumOf(const Parts& a, const Parts& b, SumCounts& counts, const Progress& progress) {
  std::vector<Piece> pieces;
  Stopwatch watch;
  const std::size_t count = partCount(a) * partCount(b);
  const std::vector<Summand> summandsA = summandsOf(a, progress), summandsB = summandsOf(b, progress);
  for (const Summand& p : summandsA)
    for (const Summand& q : summandsB) {
      Piece piece;
      SurfaceMesh surface = hullOfSum(p, q, piece.place, progress);
      ++counts.pairs;
      progress.report(0.3 * static_cast<double>(pieces.size()) / static_cast<double>(count), "Adding convex parts");
      if (surface.number_of_faces() == 0) continue;
      counts.candidates += surface.number_of_faces();
      piece.solid = solidFrom(std::move(surface));
      pieces.push_back(std::move(piece));
    }
  counts.sumMs += watch.lapMs();
  if (pieces.empty()) return solidFrom(SurfaceMesh());
  if (pieces.size() == 1) {
    auto body = std::make_shared<SolidBody>(*pieces.front().solid);
    body->convex = true;
    return body;
  }
  std::size_t done = 0;
  Solid united = unitedTree(pieces, 0, pieces.size(), done, progress.part(0.3, 1));
  counts.uniteMs += watch.lapMs();
  return united;
}

Solid cutFrom(const Bounds& frame, const Solid& solid, const Progress& progress) {
  progress.report(0, "Cutting");
  if (isEmpty(solid)) return box(frame);
  return combined(box(frame), solid, Operation::Difference);
}

}  // namespace blossom::morphology
