#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "kernel/exact_types.h"
#include "kernel/stopwatch.h"

namespace blossom::morphology {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// Largest number of point pairs that one hull is made of.
constexpr std::size_t mostPairsOfPoints = 40'000'000;

/// A sum of two pieces, or a union of such, with the place it stands for in the order of unions.
struct Piece {
  Solid solid;
  Vec3 place = Vec3::Zero();
};

SurfaceMesh hullOfSum(const Part& a, const Part& b, Vec3& place) {
  if (a.points.size() > mostPairsOfPoints / std::max<std::size_t>(1, b.points.size()))
    throw Error(ErrorCode::LimitExceeded, "The two shapes have too many vertices to be added.",
                "Use a ball with fewer subdivisions, or a larger deviation.");
  place = Vec3::Zero();
  SurfaceMesh surface;
  if (!a.grid.empty() && !b.grid.empty()) {
    std::vector<Vec3> sums;
    sums.reserve(a.grid.size() * b.grid.size());
    for (const Vec3& p : a.grid)
      for (const Vec3& q : b.grid) sums.push_back(p + q);
    for (const Vec3& p : sums) place += p / static_cast<double>(sums.size());
    // A hull of points in a plane comes as a flat sheet: without volume, nothing is added.
    if (haveVolume(toPoints(sums))) surface = hullOf(sums);
  } else {
    std::vector<Point> sums;
    sums.reserve(a.points.size() * b.points.size());
    for (const Point& p : a.points)
      for (const Point& q : b.points) sums.push_back(p + (q - CGAL::ORIGIN));
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

/// Back to a surface when it touches itself nowhere any more.
Solid simplest(Nef nef) {
  Triangles triangles = trianglesOf(nef);
  if (!PMP::is_polygon_soup_a_polygon_mesh(triangles.faces)) return solidFrom(std::move(nef));
  SurfaceMesh surface;
  PMP::polygon_soup_to_polygon_mesh(triangles.points, triangles.faces, surface);
  if (surface.number_of_vertices() != triangles.points.size() || PMP::does_self_intersect(surface))
    return solidFrom(std::move(nef));
  return solidFrom(std::move(surface));
}

enum class Operation { Union, Difference };

Solid combined(const Solid& a, const Solid& b, Operation operation) {
  if (!a->nef && !b->nef) {
    SurfaceMesh first = a->surface, second = b->surface, result;
    try {
      const bool done = operation == Operation::Union ? PMP::corefine_and_compute_union(first, second, result)
                                                      : PMP::corefine_and_compute_difference(first, second, result);
      result.collect_garbage();
      // Corefinement hands out surfaces that are open or touch themselves, and goes astray on them: it may never end.
      if (done && CGAL::is_valid_polygon_mesh(result) && CGAL::is_closed(result) && !PMP::does_self_intersect(result))
        return solidFrom(std::move(result));
    } catch (const std::exception&) {  // CGAL refuses what it has made; Nef polyhedra take any input
    }
  }
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
  for (const Part& p : a->parts)
    for (const Part& q : b->parts) {
      Piece piece;
      SurfaceMesh surface = hullOfSum(p, q, piece.place);
      ++counts.pairs;
      progress.report(0.3 * static_cast<double>(pieces.size()) / static_cast<double>(count), "Adding convex parts");
      if (surface.number_of_faces() == 0) continue;
      counts.candidates += surface.number_of_faces();
      piece.solid = solidFrom(std::move(surface));
      pieces.push_back(std::move(piece));
    }
  counts.sumMs += watch.lap();
  if (pieces.empty()) return solidFrom(SurfaceMesh());
  if (pieces.size() == 1) {
    auto body = std::make_shared<SolidBody>(*pieces.front().solid);
    body->convex = true;
    return body;
  }
  std::size_t done = 0;
  Solid united = unitedTree(pieces, 0, pieces.size(), done, progress.part(0.3, 1));
  counts.uniteMs += watch.lap();
  return united;
}

Solid cutFrom(const Bounds& frame, const Solid& solid, const Progress& progress) {
  progress.report(0, "Cutting");
  if (isEmpty(solid)) return box(frame);
  return combined(box(frame), solid, Operation::Difference);
}

}  // namespace blossom::morphology
