#include "manipulators/pull_grips.h"

#include <algorithm>

#include "kernel/cage.h"
#include "kernel/foot_points.h"
#include "kernel/rims.h"

namespace blossom::subdivision {

std::shared_ptr<const GripSurface> gripSurface(const Shape& cage, Scheme scheme, const Progress& progress) {
  auto made = std::make_shared<GripSurface>();
  made->cage = cage;
  made->joined = joinedCage(*cage.get<Mesh>(), scheme, progress).mesh;
  made->scheme = scheme;
  const Mesh& mesh = made->mesh();
  checkCage(mesh, scheme, progress);
  made->surface = std::make_unique<LimitSurface>(mesh, scheme, progress);
  made->edges = made->surface->edges();
  std::vector<bool> known(mesh.points.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f % 256 == 0) progress.check();
    for (std::size_t k = 0; k < mesh.face(f).size(); ++k) {
      const auto v = static_cast<std::size_t>(mesh.face(f)[k]);
      if (known[v]) continue;
      known[v] = true;
      made->rows.push_back(made->surface->cornerRow(f, k));
      const Vec3 at = combined(made->rows.back(), mesh.points);
      made->corners.push_back({at, at, made->surface->cornerFoot(f, k), {}});
    }
  }
  return made;
}

bool samePlace(const Vec3& a, const Vec3& b) { return (a - b).norm() <= 1e-9 * (1 + b.norm()); }

double distanceTo(const Ray& ray, const Vec3& p) {
  const Vec3 from = p - ray.origin;
  return (from - std::max(0.0, from.dot(ray.direction)) * ray.direction).norm();
}

bool onVertices(const GripSurface& of, const std::vector<Pull>& pulls) {
  return std::all_of(pulls.begin(), pulls.end(), [&](const Pull& pull) {
    return std::any_of(of.corners.begin(), of.corners.end(),
                       [&](const Grip& grip) { return samePlace(grip.base, pull.at); });
  });
}

std::vector<Grip> gripsOf(const GripSurface& of, const std::vector<Pull>& pulls, std::span<const Vec3> now,
                          const Progress& progress) {
  // Before the first pull, and while the deformation is computed, the points are those of the cage.
  if (now.size() != of.mesh().points.size()) now = of.mesh().points;
  std::vector<Grip> grips = of.corners;
  for (std::size_t k = 0; k < grips.size(); ++k) grips[k].now = combined(of.rows[k], now);
  std::vector<std::size_t> between;
  std::vector<Vec3> places;
  for (std::size_t p = 0; p < pulls.size(); ++p) {
    const auto same = std::find_if(grips.begin(), grips.end(),
                                   [&](const Grip& grip) { return !grip.pull && samePlace(grip.base, pulls[p].at); });
    if (same != grips.end()) {
      same->pull = p;
    } else {
      between.push_back(p);
      places.push_back(pulls[p].at);
    }
  }
  if (between.empty()) return grips;
  const std::vector<Foot> feet = FootFinder(*of.surface, progress).feet(places, of.mesh().points, {}, progress);
  for (std::size_t i = 0; i < between.size(); ++i) {
    const Row row = of.surface->row(feet[i]);
    grips.push_back({combined(row, of.mesh().points), combined(row, now), feet[i], between[i]});
  }
  return grips;
}

}  // namespace blossom::subdivision
