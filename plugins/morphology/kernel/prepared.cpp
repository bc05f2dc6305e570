#include "kernel/prepared.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/shape/bounds.h"
#include "kernel/arrangement/numbers.h"
#include "kernel/convex/convex_surface.h"
#include "kernel/convex/hull.h"
#include "kernel/finished.h"
#include "kernel/flatness.h"
#include "kernel/manifold.h"
#include "kernel/rounding/kept.h"
#include "kernel/solid_check.h"
#include "kernel/welded.h"

namespace blossom::morphology {

namespace {

/// Nearly all doubles are kept as they are where they must be: results are read again as they were checked.
constexpr int gridBits = 57;

Vec3 snapped(const Vec3& p, double step) {
  const Vec3 q = p / step;
  return step * Vec3(std::nearbyint(q.x()), std::nearbyint(q.y()), std::nearbyint(q.z()));
}

/// No edge is reflex by more than `tolerance`.
bool locallyConvex(const Mesh& mesh, const MeshTopology& topology, double tolerance) {
  return std::all_of(topology.edges.begin(), topology.edges.end(), [&](const MeshEdge& edge) {
    if (!edge.manifold()) return false;
    const auto points = facePoints(mesh, static_cast<std::size_t>(edge.faces[0]));
    const Vec3 normal = vectorArea(points);
    const double length = normal.norm();
    if (!(length > 0)) return true;
    for (const Vec3& p : facePoints(mesh, static_cast<std::size_t>(edge.faces[1])))
      if ((p - points[0]).dot(normal) > tolerance * length) return false;
    return true;
  });
}

/// A solid whose hull adds nothing but rounding is its hull: faces of a tilted box are planes only nearly. Without faces: it
/// is not convex.
Mesh hullOfConvex(const Mesh& triangles) {
  const MeshTopology topology = meshTopology(triangles);
  const double size = bounds(triangles).diagonal(), tolerance = hullFlatness * size;
  if (topology.components.size() != 1 || topology.components.front().genus() != 0) return {};
  if (!locallyConvex(triangles, topology, tolerance)) return {};
  Mesh hull = hullTriangles(triangles.points);
  const double added = signedVolume(hull) - signedVolume(triangles);
  return std::abs(added) <= tolerance * area(triangles) ? hull : Mesh();
}

/// A point about which no coordinate of a box loses digits: along an axis on which it lies near the origin, the origin.
Vec3 exactCentre(const Bounds& box, double step) {
  Vec3 centre = snapped(box.center(), step);
  const double near = 2 * (box.high - box.low).maxCoeff();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::abs(centre[k]) <= near) centre[k] = 0;
  return centre;
}

Bounds boundsOfPoints(const std::vector<Vec3>& points) {
  Bounds bounds;
  for (const Vec3& p : points) bounds.add(p);
  return bounds;
}

Mesh snapped(Mesh mesh, double step) {
  for (Vec3& p : mesh.points) p = snapped(p, step);
  return mesh;
}

struct CheckedOnGrid {
  CheckedSolid solid;
  double step;
  bool wasOpen = false;
};

std::optional<CheckedSolid> checkedIfSound(const Mesh& mesh, double step, const Subject& subject, const Progress& progress) {
  try {
    return checkedSolid(mesh, step, subject, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput) throw;
    return std::nullopt;
  }
}

/// Whether rounding brings corners together that lie apart.
bool bringsCornersTogether(const Mesh& before, const Mesh& after, const Progress& progress) {
  const std::vector<int> first = mergeEqualPoints(after.points, progress);
  for (std::size_t k = 0; k < first.size(); ++k)
    if (before.points[k] != before.points[static_cast<std::size_t>(first[k])]) return true;
  return false;
}

/// How thin what is gone may have been that was thicker than rounding, or 0. Of what is open nobody knows what it enclosed.
double thicknessGone(const Mesh& given, const Mesh& rounded, const CheckedSolid& made, double step,
                     const Progress& progress) {
  const double size = bounds(given).diagonal(), thickness = 2 * step;
  if (thickness <= thicknessOfRounding * size) return 0;
  const Mesh before = snapped(given, std::ldexp(1, std::ilogb(thicknessOfRounding * size)));
  if (!made.isLess && !bringsCornersTogether(before, rounded, progress)) return 0;
  const Mesh joined = withoutInnerWalls(withSharedPoints(before, progress), progress);
  if (!meshTopology(joined, progress).closed()) return 0;
  const Mesh triangles = manifoldOf(triangulated(joined, progress).first, progress);
  return losesDetails(triangles, made.triangles, size, step, progress) ? thickness : 0;
}

std::string goneWarning(const Subject& subject, double thickness) {
  return fmt::format("{}: {}", subject.name, RoundingLoss{0, thickness}.sentences());
}

/// Rounded as is usual, or to the finest grid where that takes something away: unless bodies meet, which may touch but for
/// rounding, and be apart there.
CheckedOnGrid checkedOnUsualGrid(const Mesh& mesh, const CommonGrid& grid, const Subject& subject,
                                 const Progress& progress) {
  const double usual = grid.usualStep();
  const Mesh rounded = snapped(mesh, usual);
  CheckedOnGrid made{checkedSolid(rounded, usual, subject, progress), usual};
  const double thickness = thicknessGone(mesh, rounded, made.solid, usual, progress);
  if (!(thickness > 0)) return made;
  if (!made.solid.shellsMeet) {
    const Mesh exact = snapped(mesh, grid.step);
    if (auto checked = checkedIfSound(exact, grid.step, subject, progress))
      if (!(thicknessGone(mesh, exact, *checked, grid.step, progress) > 0)) return {*std::move(checked), grid.step};
  }
  made.solid.warnings.push_back(goneWarning(subject, thickness));
  return made;
}

/// Rounding may make faces cross that do not: then the finest grid is tried, which keeps nearly all doubles as they are, and
/// coarser ones at last. These close cracks, too; sheets that would fall into one and vanish are no cracks.
/// @param given the same where it lies: moving it has rounded it, too
CheckedOnGrid checkedOnGrid(const Mesh& mesh, const Mesh& given, const CommonGrid& grid, const Subject& subject,
                            const Progress& progress) {
  const double usual = grid.usualStep();
  try {
    return checkedOnUsualGrid(mesh, grid, subject, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput || firstCrossing(given, progress)) throw;
    if (auto checked = checkedIfSound(snapped(mesh, grid.step), grid.step, subject, progress))
      return {*std::move(checked), grid.step};
    const Mesh triangles = triangulated(withSharedPoints(mesh, progress), progress).first;
    const bool wasOpen = !isClosed(given, progress);
    const auto coarser = onCoarserGrid(triangles, usual, progress);
    if (!coarser) throw;
    CheckedOnGrid made{checkedSolid(coarser->triangles, coarser->step, subject, progress), coarser->step, wasOpen};
    if (wasOpen && !keepsPlaces(triangles, made.solid.triangles, made.step, coarser->loss.thickness > 0, progress)) throw;
    if (coarser->loss.thickness > 0) made.solid.warnings.push_back(goneWarning(subject, coarser->loss.thickness));
    return made;
  }
}

}  // namespace

CommonGrid gridFor(const Bounds& a, const Bounds& b) {
  const double largest = std::max((a.high - a.low).maxCoeff(), (b.high - b.low).maxCoeff());
  return {std::ldexp(1, std::ilogb(std::max(largest, 1e-9)) + 1 - gridBits)};
}

double CommonGrid::usualStep() const { return static_cast<double>(arrangement::usualSteps) * step; }

Prepared prepared(const Operand& operand, const CommonGrid& grid, const Progress& progress) {
  Prepared result;
  result.name = operand.name;
  const Bounds box = operand.bounds();
  const double usual = grid.usualStep();
  result.centre = exactCentre(box, usual);
  const auto local = [&](const Vec3& p) { return snapped(p - result.centre, usual); };
  if (operand.form != Operand::Form::Body) {
    result.pieces = operand.pieces;
    for (auto& piece : result.pieces)
      for (Vec3& p : piece) result.bounds.add(p = local(p));
    return result;
  }
  Mesh mesh = operand.mesh;
  for (Vec3& p : mesh.points) p -= result.centre;
  refuseUnusable(mesh, {operand.name, result.centre});
  if (Mesh hull = snapped(mesh, usual); isConvexSurface(hull)) {
    result.bounds = boundsOfPoints(hull.points);
    result.prisms = prismsOf(hull, usual, progress);
    result.hull = result.triangles = std::move(hull);
    return result;
  }
  auto [checked, step, wasOpen] = checkedOnGrid(mesh, operand.mesh, grid, {operand.name, result.centre}, progress);
  if (step > usual)
    checked.warnings.push_back(
        wasOpen
            ? fmt::format("{} was open: its corners have been rounded to {:.2g} mm, which closes it.", operand.name, step)
            : fmt::format("{} has been rounded to {:.2g} mm, so that none of its faces cross.", operand.name, step));
  // What is left of crossings then lies between bodies, and has a warning.
  result.wallsWithin = checked.wallsWithin;
  result.bodiesMeet = checked.bodyInBody || checked.wallsWithin > 0 ||
                      (!checked.warnings.empty() && firstCrossing(checked.triangles, progress));
  result.warnings = std::move(checked.warnings);
  result.bounds = boundsOfPoints(checked.triangles.points);
  const bool isFiner = step < usual;  // with details that sections would lose
  if (!result.bodiesMeet && !isFiner) result.prisms = prismsOf(checked.triangles, usual, progress);
  result.hull = hullOfConvex(checked.triangles);
  result.triangles = result.hull.faceCount() > 0 ? result.hull : std::move(checked.triangles);
  return result;
}

}  // namespace blossom::morphology
