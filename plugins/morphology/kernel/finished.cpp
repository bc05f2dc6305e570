#include "kernel/finished.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"
#include "kernel/collapsed.h"
#include "kernel/coplanar.h"
#include "kernel/flatness.h"
#include "kernel/in_order.h"
#include "kernel/manifold.h"
#include "kernel/place.h"
#include "kernel/rounding/attempts.h"
#include "kernel/rounding/kept.h"
#include "kernel/rounding/slivers.h"
#include "kernel/self_crossing.h"
#include "kernel/separated.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology {

namespace {

/// Corners on a grid, in the user's coordinates.
Mesh snappedTo(Mesh mesh, const Vec3& centre, double step, const Progress& progress) {
  for (Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) p[k] = step * std::nearbyint((p[k] + centre[k]) / step) - centre[k];
  return manifoldOf(collapsed(mesh, progress), progress);
}

/// Triangles, those without area flipped or collapsed, and none that lie on each other back to back; nothing when that is
/// impossible.
std::optional<Mesh> mended(const Mesh& mesh, const Progress& progress) {
  if (mesh.faceCount() == 0 || !meshTopology(mesh).closed()) return std::nullopt;
  try {
    const Mesh triangles = manifoldOf(collapsed(triangulated(mesh, progress).first, progress), progress);
    return inOrder(manifoldOf(withoutDegenerate(triangles, {"The result"}), progress));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput) throw;
    return std::nullopt;
  }
}

/// A closed surface in two forms, which are one where no triangles are coplanar.
struct Surface {
  Mesh triangles, joined;
  MeshTopology topology;  ///< of the triangles
  double size = 0;        ///< of what it was at first
  bool isLess = false;    ///< shells are no longer there

  [[nodiscard]] std::size_t shells() const { return topology.components.size(); }
};

Surface surfaceOf(Mesh triangles, double size, const Progress& progress) {
  Surface made;
  made.triangles = std::move(triangles);
  made.size = size;
  sideBySide(
      progress, [&] { made.topology = meshTopology(made.triangles); },
      [&] { made.joined = joinedCoplanar(made.triangles, {.tolerance = joinedFacesFlatness * size}, progress); });
  if (made.joined.faceCount() == made.triangles.faceCount())
    made.joined = made.triangles;
  else if (made.topology.closed())
    made.joined = manifoldOf(made.joined, progress);
  return made;
}

/// A small part of a thickness, as long as the grid of it holds the whole surface.
double unitFor(double thickness, const Mesh& mesh) {
  double farthest = 0;
  for (const Vec3& p : mesh.points) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  return std::max(thickness / 64, std::ldexp(farthest, -58));
}

/// Without shells that are thinner, which rounding may turn inside out. Nothing may be left.
Surface withoutThinShells(Surface surface, double thickness, const Progress& progress) {
  if (!(thickness > 0)) return surface;
  const auto thicker =
      withoutSlivers(surface.triangles, surface.topology, thickness, unitFor(thickness, surface.triangles), progress);
  if (!thicker) return surface;
  Surface made = surfaceOf(inOrder(*thicker), surface.size, progress);
  made.isLess = true;
  return made;
}

/// Whether it is what the surface was, but for corners that have moved by no more.
bool isSame(const Surface& before, const Mesh& after, double moved, const Progress& progress) {
  return keepsVolume(before.triangles, after, before.size, moved + joinedFacesFlatness * before.size, progress);
}

/// @param thickness of shells that are gone if `surface` is less than it was
RoundingLoss lossOf(double moved, const Surface& surface, double thickness) {
  return {moved, surface.isLess && thickness > thicknessOfRounding * surface.size ? thickness : 0};
}
RoundingLoss lossOf(double moved, const Surface& surface, double thickness, const Mesh& made, const Progress& progress) {
  // Cracks that close are no loss.
  const bool isLess =
      surface.isLess || (surface.topology.closed() && losesDetails(surface.triangles, made, surface.size, moved, progress));
  return {moved, isLess && thickness > thicknessOfRounding * surface.size ? thickness : 0};
}

/// Rounds a surface to coarser and coarser grids until one crosses nowhere.
class Rounding {
 public:
  Rounding(const Vec3& centre, Attempts& attempts, const Progress& progress)
      : centre_(centre), attempts_(attempts), progress_(progress) {}

  struct Rounded {
    Mesh mesh;
    double step = 0;
    RoundingLoss loss;
  };
  /// @param bits of the first grid after the finest one, and of the last one
  [[nodiscard]] std::optional<Rounded> from(const Surface& surface, int finest, int firstBits, int lastBits) {
    for (int bits = firstBits; bits <= lastBits; bits += 2) {
      const double step = std::ldexp(1, finest + bits), thickness = 2 * step;
      // What is open may close on the grid: nobody knows what lies within it before.
      const Surface thick = surface.topology.closed() ? withoutThinShells(surface, thickness, progress_) : surface;
      auto made = onGrid(thick.joined, thick, step);
      if (!made && thick.joined.faceCount() < thick.triangles.faceCount()) made = onGrid(thick.triangles, thick, step);
      if (!made) continue;
      const RoundingLoss loss = lossOf(step, thick, thickness, *made, progress_);
      return Rounded{*std::move(made), step, loss};
    }
    return std::nullopt;
  }

 private:
  std::optional<Mesh> onGrid(const Mesh& form, const Surface& surface, double step) {
    const Mesh snapped = inOrder(snappedTo(form, centre_, step, progress_));
    if (auto made = attempts_.withFewerPolygons(snapped); made && isSame(surface, *made, step, progress_)) return made;
    if (const auto whole = mended(snapped, progress_))
      if (auto made = attempts_.asIs(*whole); made && isSame(surface, *made, step, progress_)) return made;
    return std::nullopt;
  }

  const Vec3& centre_;
  Attempts& attempts_;
  const Progress& progress_;
};

/// With what is nearly one made one; nothing when that does not help.
/// @param finest the step of the finest grid
std::optional<Finished> withNearOnesUnited(const Surface& surface, double finest, Attempts& attempts,
                                           const Progress& progress) {
  const double usual = std::max(1e-11 * surface.size, 4 * finest);
  for (const double least : {usual, 10 * usual, 100 * usual}) {
    const double moved = 2 * least, thickness = 2 * moved, flat = 8 * least;
    const Surface thick = withoutThinShells(surface, thickness, progress);
    const auto apart = separated(thick.triangles, least, progress);
    if (!apart || apart->faceCount() == 0) continue;
    const Mesh whole = inOrder(manifoldOf(*apart, progress));
    if (!meshTopology(whole).closed()) continue;
    auto made = attempts.withFewerPolygons(manifoldOf(joinedCoplanar(whole, {.tolerance = flat}, progress), progress));
    const auto isKept = [&] { return made && isSame(thick, *made, moved + flat, progress); };
    bool isGood = isKept();
    if (!isGood) {
      made = attempts.asIs(whole);
      isGood = isKept();
    }
    if (isGood) return Finished{inOrder(*made), lossOf(moved, thick, thickness, *made, progress)};
  }
  return std::nullopt;
}

constexpr int fewBits = 4, mostBits = 24;  ///< by which grids are coarser than the finest one

}  // namespace

void RoundingLoss::add(const RoundingLoss& other) {
  moved = std::max(moved, other.moved);
  thickness = std::max(thickness, other.thickness);
}

std::string RoundingLoss::sentences() const {
  std::string all;
  if (moved > 0)
    all = fmt::format("Corners have been moved by up to {:.2g} mm, so that rounding makes no faces cross.", moved);
  if (!(thickness > 0)) return all;
  return all + fmt::format("{}Bodies, voids, walls or gaps thinner than {:.2g} mm have been left out.",
                           all.empty() ? "" : " ", thickness);
}

CannotBeRounded::CannotBeRounded(const std::string& message)
    : Error(ErrorCode::Degenerate, message,
            "Make one shape a little larger or smaller where one just fits the other, or leave out details too small for "
            "their size.") {}

namespace {

/// How far rounding moves a point at most where it lies.
double movedByDoubles(const Mesh& mesh, const Vec3& centre) {
  double farthest = 0;
  for (const Vec3& p : mesh.points) farthest = std::max(farthest, (((p + centre) - centre) - p).norm());
  return farthest;
}

/// As exact as is possible. @param thickness of shells that rounding to doubles may turn
Finished roundedSomehow(Surface whole, const Vec3& centre, double thickness, const Progress& progress) {
  const Surface surface = withoutThinShells(std::move(whole), thickness, progress);
  Attempts attempts(centre, progress);
  const double moved = movedByDoubles(surface.triangles, centre) + joinedFacesFlatness * surface.size;
  if (const auto made = attempts.withFewerPolygons(surface.joined)) {
    Mesh ordered = inOrder(*made);  // which triangles readers make depends on where polygons begin
    if (!foldsBack(ordered, surface.size, moved, progress)) return {std::move(ordered), lossOf(0, surface, thickness)};
  }
  std::optional<MeshCrossing> crossing = attempts.crossing();
  if (auto made = attempts.asIs(surface.triangles)) return {inOrder(*made), lossOf(0, surface, thickness)};
  const int finest = std::ilogb(std::max(surface.size, centre.cwiseAbs().maxCoeff())) - 51;  // two units in the last place
  Rounding rounding(centre, attempts, progress);
  if (auto made = rounding.from(surface, finest, 0, fewBits)) return {inOrder(made->mesh), made->loss};
  if (auto made = withNearOnesUnited(surface, std::ldexp(1, finest), attempts, progress)) return *std::move(made);
  if (auto made = rounding.from(surface, finest, fewBits + 2, mostBits)) return {inOrder(made->mesh), made->loss};
  if (attempts.crossing()) crossing = attempts.crossing();
  throw CannotBeRounded(
      crossing ? fmt::format("With corners rounded to numbers of 16 digits the result crosses itself near {}.",
                             Subject{}.place(crossing->place))
               : fmt::format("With corners rounded to numbers of 16 digits nothing closed is left of the result near {}.",
                             Subject{}.place(centre)));
}

/// What rounding has cut off, or turned, at places that were thinner than the rest of a shell goes, too, unless nothing else
/// is there.
Finished withoutThinRemains(Finished made, double thickness, double toldFrom, const Progress& progress) {
  // A polygon may hang together in corners only: its triangles know.
  const Mesh triangles = triangulated(made.mesh, progress).first;
  const MeshTopology ofTriangles = meshTopology(triangles, progress);
  if (ofTriangles.components.size() < 2) return made;
  const MeshTopology ofPolygons = meshTopology(made.mesh, progress);
  const double unit = unitFor(thickness, triangles);
  const bool isAlike = ofPolygons.components.size() == ofTriangles.components.size();
  const auto thicker = isAlike ? withoutSlivers(made.mesh, ofPolygons, thickness, unit, progress)
                               : withoutSlivers(triangles, ofTriangles, thickness, unit, progress);
  if (!thicker || thicker->faceCount() == 0) return made;
  if (thickness > toldFrom) made.loss.add({0, thickness});
  made.mesh = inOrder(*thicker);
  return made;
}

}  // namespace

Finished finished(const Mesh& soup, const Vec3& centre, Slivers slivers, const Progress& progress) {
  progress.report(0, "Joining faces");
  const Mesh triangles = inOrder(manifoldOf(soup, progress));
  Surface surface = surfaceOf(triangles, bounds(triangles).diagonal(), progress);
  if (!surface.topology.closed())
    throw Error(ErrorCode::Internal, "The result is not closed.", "Please report the two shapes.");
  const double ofRounding = thicknessOfRounding * surface.size, unwanted = slivers == Slivers::Go ? ofRounding : 0;
  if (unwanted > 0 && surface.shells() > 1)
    if (Surface thick = withoutThinShells(surface, unwanted, progress); thick.shells() > 0) surface = std::move(thick);
  surface.isLess = false;
  const double thickness = std::max(4 * movedByDoubles(surface.triangles, centre), std::ldexp(surface.size, -51));
  Finished made = roundedSomehow(std::move(surface), centre, thickness, progress);
  const double least = std::max({unwanted, thickness, 2 * made.loss.moved});
  return withoutThinRemains(std::move(made), least, ofRounding, progress);
}

std::optional<OnGrid> onCoarserGrid(const Mesh& triangles, double step, const Progress& progress) {
  const Surface surface{triangles, triangles, meshTopology(triangles, progress), bounds(triangles).diagonal()};
  const Vec3 centre = Vec3::Zero();
  Attempts attempts(centre, progress);
  Rounding rounding(centre, attempts, progress);
  const auto of = [&](const Rounding::Rounded& made) {
    return OnGrid{triangulated(made.mesh, progress).first, made.step, made.loss};
  };
  if (auto made = rounding.from(surface, std::ilogb(step), 0, fewBits)) return of(*made);
  // What is nearly one, in a result of our own, falls into shells without area on any grid. Whole walls are not made one.
  if (surface.topology.closed())
    if (const auto made = withNearOnesUnited(surface, step, attempts, progress)) {
      const OnGrid united{triangulated(made->mesh, progress).first, made->loss.moved, made->loss};
      if (keepsPlaces(triangles, united.triangles, united.step, united.loss.thickness > 0, progress)) return united;
    }
  if (auto made = rounding.from(surface, std::ilogb(step), fewBits + 2, mostBits)) return of(*made);
  return std::nullopt;
}

}  // namespace blossom::morphology
