#include "kernel/settled_cage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/error.h"
#include "kernel/limit_surface.h"
#include "kernel/subdivide.h"

namespace blossom::subdivision {
namespace {

constexpr double maximumFacesSettled = 50000;
constexpr double sharp = 10;

bool isSemiSharp(double sharpness) { return sharpness > 0 && sharpness < sharp; }

/// Sharpness of what is semi-sharp.
std::vector<double> semiSharp(const Mesh& cage) {
  std::vector<double> found;
  for (const Crease& crease : cage.creases)
    if (isSemiSharp(crease.sharpness)) found.push_back(crease.sharpness);
  for (const Corner& corner : cage.corners)
    if (isSemiSharp(corner.sharpness)) found.push_back(corner.sharpness);
  return found;
}

/// How often to refine, from seldom to often: refining helps where it brings some of the sharpness to an end.
std::set<int> levelsToTry(const Mesh& cage) {
  bool quadsOnly = true;
  for (std::size_t f = 0; f < cage.faceCount(); ++f) quadsOnly = quadsOnly && cage.face(f).size() == 4;
  const int first = quadsOnly ? 0 : 1;
  std::set<int> levels{first};
  for (const double sharpness : semiSharp(cage)) levels.insert(std::max(first, static_cast<int>(std::ceil(sharpness))));
  return levels;
}

/// What is semi-sharp becomes sharp; `touched` are the vertices that it ends at.
Mesh madeSharp(Mesh quads, std::vector<bool>& touched) {
  touched.assign(quads.points.size(), false);
  const auto touch = [&](int vertex) { touched[static_cast<std::size_t>(vertex)] = true; };
  for (Crease& crease : quads.creases)
    if (isSemiSharp(crease.sharpness)) {
      crease.sharpness = sharp;
      touch(crease.from);
      touch(crease.to);
    }
  for (Corner& corner : quads.corners)
    if (isSemiSharp(corner.sharpness)) {
      corner.sharpness = sharp;
      touch(corner.vertex);
    }
  return quads;
}

/// Largest distance between the limit surfaces of two cages that differ in sharpness alone, on the faces near `touched`.
double apartAt(const Mesh& soft, const Mesh& hard, const std::vector<bool>& touched, const Progress& progress) {
  constexpr int lattice = 8;
  std::vector<bool> near(soft.faceCount());
  for (std::size_t f = 0; f < near.size(); ++f) {
    const auto face = soft.face(f);
    near[f] = std::any_of(face.begin(), face.end(), [&](int v) { return touched[static_cast<std::size_t>(v)]; });
  }
  const LimitSurface before(soft, Scheme::CatmullClark, near, progress), after(hard, Scheme::CatmullClark, near, progress);
  double largest = 0;
  for (std::size_t f = 0; f < soft.faceCount(); ++f) {
    if (!near[f]) continue;
    progress.check();
    for (int i = 0; i <= lattice; ++i)
      for (int j = 0; j <= lattice; ++j) {
        const Foot foot{static_cast<int>(f), static_cast<double>(i) / lattice, static_cast<double>(j) / lattice};
        const Vec3 gap = combined(before.row(foot), soft.points) - combined(after.row(foot), hard.points);
        largest = std::max(largest, gap.norm());
      }
  }
  return largest;
}

}  // namespace

SettledCage settledCage(const Mesh& cage, double tolerance, const Progress& progress) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int levels : levelsToTry(cage)) {
    if (static_cast<double>(cage.faceVertices.size()) * std::pow(4.0, levels - 1) > maximumFacesSettled) break;
    SettledCage settled;
    settled.quads = levels > 0 ? subdivide(cage, {.levels = levels}, progress).mesh : cage;
    if (semiSharp(settled.quads).empty()) return settled;
    std::vector<bool> touched;
    Mesh hard = madeSharp(settled.quads, touched);
    settled.sharpened = apartAt(settled.quads, hard, touched, progress);
    settled.quads = std::move(hard);
    if (settled.sharpened <= tolerance) return settled;
    nearest = std::min(nearest, settled.sharpened);
  }
  if (std::isinf(nearest))
    throw Error(
        ErrorCode::LimitExceeded,
        fmt::format("The cage has {} faces; as B-spline faces {} are the most.", cage.faceCount(), maximumFacesSettled),
        "Take a coarser cage, or a limit mesh.");
  throw Error(ErrorCode::LimitExceeded,
              fmt::format("Edges that are sharp for some levels only would need more than {} B-spline faces; made sharp "
                          "for ever they would lie {:.2g} mm off.",
                          maximumFacesSettled, nearest),
              fmt::format("Raise the tolerance above {:.2g} mm, lower the sharpness of the edges, or take a limit mesh.",
                          2 * nearest));
}

}  // namespace blossom::subdivision
