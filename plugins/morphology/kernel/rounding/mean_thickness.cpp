#include "kernel/rounding/mean_thickness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "kernel/arrangement/numbers.h"

namespace blossom::morphology {

namespace {

/// Calls visit(a, b, c) with the corners of the triangles that a face is divided into from its first corner. Some of them
/// turn the other way where it is not convex: sums of their normals are right, those of their areas are not.
template <class Visit>
void forEachTriangle(const Mesh& mesh, std::size_t face, const Visit& visit) {
  const auto corners = mesh.face(face);
  const auto at = [&](std::size_t k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(corners[k])]; };
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) visit(at(0), at(k), at(k + 1));
}

struct Measured {
  double sixVolumes = 0, twoAreas = 0;
  bool isSure = true;
  [[nodiscard]] double thickness() const { return twoAreas > 0 ? 2 * (sixVolumes / 6) / (twoAreas / 2) : 0; }
};

Measured measuredInDoubles(const Mesh& mesh, std::span<const std::size_t> shell) {
  const Vec3& from = mesh.points[static_cast<std::size_t>(mesh.face(shell.front())[0])];
  Measured sum;
  long double sixVolumes = 0;  // so that many triangles lose no more digits than one
  double products = 0, farthest = 0, count = 0;
  for (const std::size_t f : shell) {
    Vec3 ofFace = Vec3::Zero();
    forEachTriangle(mesh, f, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Vec3 normal = (b - a).cross(c - a);
      sixVolumes += normal.dot(a - from);
      ofFace += normal;
      products += (b - a).norm() * (c - a).norm();  // of which a cross product loses digits
      farthest = std::max(farthest, (a - from).norm());
      ++count;
    });
    sum.twoAreas += ofFace.norm();
  }
  constexpr double share = 1000, ofEach = 8 * std::numeric_limits<double>::epsilon();
  const double lost = ofEach + count * static_cast<double>(std::numeric_limits<long double>::epsilon());
  sum.sixVolumes = static_cast<double>(sixVolumes);
  sum.isSure = std::abs(sum.sixVolumes) > share * lost * farthest * products;
  return sum;
}

Measured measuredOnGrid(const Mesh& mesh, std::span<const std::size_t> shell, double unit) {
  using namespace arrangement;
  const auto onGrid = [unit](const Vec3& p) {
    return Grid3{std::llround(p[0] / unit), std::llround(p[1] / unit), std::llround(p[2] / unit)};
  };
  const Grid3 from = onGrid(mesh.points[static_cast<std::size_t>(mesh.face(shell.front())[0])]);
  Whole sixVolumes = 0;
  Measured sum;
  for (const std::size_t f : shell) {
    Vec3 ofFace = Vec3::Zero();
    forEachTriangle(mesh, f, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Grid3 first = onGrid(a);
      const Normal3 normal = cross(onGrid(b) - first, onGrid(c) - first);
      sixVolumes += dot(normal, first - from);
      ofFace += Vec3(static_cast<double>(normal[0]), static_cast<double>(normal[1]), static_cast<double>(normal[2]));
    });
    sum.twoAreas += ofFace.norm();
  }
  sum.sixVolumes = sixVolumes.convert_to<double>();
  return sum;
}

}  // namespace

double meanThickness(const Mesh& mesh, std::span<const std::size_t> shell, double unit) {
  if (shell.empty()) return 0;
  const Measured quick = measuredInDoubles(mesh, shell);
  return quick.isSure ? quick.thickness() : unit * measuredOnGrid(mesh, shell, unit).thickness();
}

double meanThickness(const Mesh& mesh) {
  std::vector<std::size_t> all(mesh.faceCount());
  std::iota(all.begin(), all.end(), std::size_t{0});
  double farthest = 0;
  for (const Vec3& p : mesh.points) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  return farthest > 0 ? meanThickness(mesh, all, std::ldexp(1, std::ilogb(farthest) - 58)) : 0;
}

}  // namespace blossom::morphology
