#include "kernel/self_crossing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/triangle_crossing.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/shape/bounds.h"
#include "kernel/manifold.h"
#include "kernel/near_walls.h"

namespace blossom::morphology {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

Point toKernel(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

struct Triangle {
  Triangle3 at;
  int component = 0;
  [[nodiscard]] Box3 box() const { return Box3(at[0]).extend(at[1]).extend(at[2]); }
};

std::vector<Triangle> trianglesOf(const Mesh& mesh, const std::vector<int>& componentOfFace) {
  std::vector<Triangle> triangles(mesh.faceCount());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) triangles[f].at[k] = mesh.points[static_cast<std::size_t>(mesh.face(f)[k])];
    triangles[f].component = componentOfFace[f];
  }
  return triangles;
}

/// First crossing within a shell, and first between two of them.
struct Crossings {
  std::optional<Vec3> within, between;
};

/// Those of a triangle with triangles after it.
Crossings crossingsWithLater(std::size_t t, const std::vector<Triangle>& triangles, const BoxTree<3>& tree) {
  Crossings found;
  std::size_t lowestWithin = triangles.size(), lowestBetween = triangles.size();
  const Box3 box = triangles[t].box();
  const auto visit = [&](std::size_t other) {
    const bool same = triangles[t].component == triangles[other].component;
    std::size_t& lowest = same ? lowestWithin : lowestBetween;
    if (other >= lowest || !box.intersects(triangles[other].box())) return;
    const auto place = crossingElsewhere(triangles[t].at, triangles[other].at);
    if (!place) return;
    lowest = other;
    (same ? found.within : found.between) = place;
  };
  tree.meeting(box, visit, t + 1);
  return found;
}

Crossings crossingsOf(const std::vector<Triangle>& triangles, const Progress& progress) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles) boxes.push_back(t.box());
  const BoxTree<3> tree(boxes, 4, progress);
  std::vector<Crossings> ofEach(triangles.size());
  parallelFor(triangles.size(), 128, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) ofEach[t] = crossingsWithLater(t, triangles, tree);
  });
  Crossings found;
  for (const Crossings& each : ofEach) {
    if (!found.within) found.within = each.within;
    if (!found.between) found.between = each.between;
  }
  return found;
}

/// Nothing where faces do not make a manifold.
std::optional<Surface> surfaceOf(const Mesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const Vec3& p : mesh.points) vertices.push_back(surface.add_vertex(toKernel(p)));
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const auto at = [&](std::size_t k) { return vertices[static_cast<std::size_t>(face[k])]; };
    if (surface.add_face(at(0), at(1), at(2)) == Surface::null_face()) return std::nullopt;
  }
  if (!surface.is_valid(false)) return std::nullopt;
  return surface;
}

Mesh meshOf(Surface& surface) {
  surface.collect_garbage();
  Mesh mesh;
  for (const auto v : surface.vertices()) {
    const Point& p = surface.point(v);
    mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : surface.faces()) {
    std::vector<int> face;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) face.push_back(static_cast<int>(v));
    mesh.addFace(face);
  }
  return mesh;
}

constexpr double narrowCrack = 1e-6;  ///< of the size: gaps that files with few digits leave

std::optional<Vec3> firstDegenerate(const Mesh& mesh) {
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(mesh.face(f)[k])]; };
    if (CGAL::collinear(toKernel(at(0)), toKernel(at(1)), toKernel(at(2)))) return at(0);
  }
  return std::nullopt;
}

}  // namespace

Mesh withoutDegenerate(const Mesh& triangles, const Subject& subject) {
  if (!firstDegenerate(triangles)) return triangles;
  std::optional<Surface> surface = surfaceOf(triangles);
  Mesh mended;
  if (surface) {
    CGAL::Polygon_mesh_processing::remove_degenerate_faces(*surface);
    mended = meshOf(*surface);
  }
  const auto left = firstDegenerate(mended);
  if (!surface || left || !meshTopology(mended).closed())
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} has faces without area near {}.", subject.name,
                            subject.place(left.value_or(*firstDegenerate(triangles)))),
                "Repair the mesh, or export it again with a larger deviation.");
  return mended;
}

void refuseCrossing(CheckedSolid& solid, double near, const Subject& subject, const Progress& progress) {
  const MeshTopology topology = meshTopology(solid.triangles, progress);
  Crossings found = crossingsOf(trianglesOf(solid.triangles, topology.componentOfFace), progress);
  if (const auto twisted = firstTwistedEdge(solid.triangles, progress); twisted && !found.within) {
    const int component = topology.componentOfFace[twisted->faces.front()];
    const bool same = std::all_of(twisted->faces.begin(), twisted->faces.end(),
                                  [&](std::size_t f) { return topology.componentOfFace[f] == component; });
    (same ? found.within : found.between) = twisted->place;
  }
  if (found.within)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} crosses or touches itself near {}.", subject.name, subject.place(*found.within)),
                "Repair the mesh in the program that made it.");
  if (topology.components.size() > 1) {
    const auto wallWithin = [&](double distance) {
      return firstNearWall(solid.triangles, topology.componentOfFace, distance, progress);
    };
    const double crack = narrowCrack * bounds(solid.triangles).diagonal();
    if (const auto wall = wallWithin(near)) {
      solid.wallsWithin = near;
      if (!found.between) found.between = wall;
    } else if (const auto beside = crack > near ? wallWithin(crack) : std::nullopt) {
      solid.warnings.push_back(fmt::format(
          "{} has bodies that nearly touch near {}: what is between their faces, less than {:.1g} mm, counts as a gap. "
          "Unite them first if they are one.",
          subject.name, subject.place(*beside), crack));
    }
  }
  solid.shellsMeet = found.between.has_value();
  if (found.between)
    solid.warnings.push_back(fmt::format("{} has bodies that touch or overlap near {}; they count as one.", subject.name,
                                         subject.place(*found.between)));
}

}  // namespace blossom::morphology
