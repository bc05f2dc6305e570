#include "geometry/tessellate/self_crossing.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/mesh/common_area.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/brep.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom {
namespace {

/// Number of crossings of one tessellation that are examined, evenly chosen: a real crossing is a curve with many of them.
constexpr std::size_t crossingsTried = 16;
/// Share of the size, far below what the finest tessellation could find.
constexpr double depthThatIsNone = 1e-8;

Triangle3 triangleOf(const Mesh& mesh, std::size_t f) {
  const auto corner = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(mesh.face(f)[i])]; };
  return {corner(0), corner(1), corner(2)};
}

Vec3 normalOf(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

/// The solid angle of a triangle (van Oosterom and Strackee 1983, equation 8).
double solidAngle(const Triangle3& t, const Vec3& eye) {
  const Vec3 a = t[0] - eye, b = t[1] - eye, c = t[2] - eye;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Whether all that a triangle has in common with the other's plane is one corner, up to a depth that is none. So the tip of
/// a cone stands on a disc: that is no crossing, and every finer tessellation would show it again.
bool standsOnACorner(const Triangle3& standing, const Triangle3& ground, double slack) {
  const Vec3 normal = normalOf(ground);
  int above = 0, below = 0;
  for (const Vec3& corner : standing) {
    const double height = (corner - ground[0]).dot(normal);
    if (height > slack) ++above;
    if (height < -slack) ++below;
  }
  return above + below == 2 && above * below == 0;
}

/// How often the surface goes round a point.
int windingNumber(const Mesh& mesh, const Vec3& point) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) sum += solidAngle(triangleOf(mesh, f), point);
  return static_cast<int>(std::lround(sum / (4 * std::numbers::pi)));
}

double distanceTo(const Mesh& mesh, const Vec3& point) {
  double minimum = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    minimum = std::min(minimum, (closestOnTriangle(point, triangleOf(mesh, f)) - point).squaredNorm());
  return std::sqrt(minimum);
}

/// Whether a point near the crossing, clear of the surface and of the error of its triangles, is enclosed twice or inside
/// out. Around a real crossing the winding number is such in one of the four wedges between the two sheets.
bool isReal(const MeshCrossing& crossing, const Mesh& mesh, double chord, double size, const Progress& progress) {
  const Vec3 n = normalOf(triangleOf(mesh, crossing.first)), m = normalOf(triangleOf(mesh, crossing.second));
  const std::array<Vec3, 6> ways{n + m, -n - m, n - m, m - n, n.cross(m).cross(n), n};
  for (double step = 4 * chord; step < size / 4; step *= 4)
    for (const Vec3& way : ways) {
      progress.check();
      if (!(way.norm() > 1e-3)) continue;
      const Vec3 beside = crossing.place + step * way.normalized();
      const int winding = windingNumber(mesh, beside);
      if (winding != 0 && winding != 1 && distanceTo(mesh, beside) > 2 * chord) return true;
    }
  return false;
}

/// Whether two triangles lie on one another, looking away from each other's space: between them is no space at all.
bool liesOn(const Triangle3& a, const Triangle3& b, double size) {
  constexpr double planar = 1e-9, visible = 1e-8;
  const Vec3 normal = normalOf(a);
  if (normal.dot(normalOf(b)) > -1 + planar) return false;
  for (const Vec3& corner : b)
    if (std::abs((corner - a[0]).dot(normal)) > planar * size) return false;
  return areaOf(commonPolygon(a, b)) > visible * size * size;
}

/// Where a wall lies on another wall: winding numbers do not tell, for there is nothing between them.
std::optional<Vec3> doubledWall(const Mesh& mesh, double size, const Progress& progress) {
  const auto counts = [&](const Triangle3& a, const Triangle3& b) { return liesOn(a, b, size); };
  const auto found = crossings(mesh, counts, progress);
  return found.empty() ? std::nullopt : std::optional(found.front().place);
}

}  // namespace

std::optional<Vec3> selfCrossing(const TopoDS_Shape& solid, const Progress& progress) {
  const Shape shape{Brep(solid)};
  const double size = bounds(shape).diagonal();
  for (const double share : {1e-3, 1e-4, 2e-5}) {
    const double chord = share * size;
    const Mesh mesh = meshOf(shape, {.chord = chord, .angle = 0.5}, progress);
    const auto counts = [slack = depthThatIsNone * size](const Triangle3& a, const Triangle3& b) {
      return !standsOnACorner(a, b, slack) && !standsOnACorner(b, a, slack);
    };
    const auto found = crossings(mesh, counts, progress);
    if (found.empty()) return {};
    if (auto place = doubledWall(mesh, size, progress)) return place;
    const std::size_t stride = (found.size() + crossingsTried - 1) / crossingsTried;
    for (std::size_t k = 0; k < found.size(); k += stride)
      if (isReal(found[k], mesh, chord, size, progress)) return found[k].place;
  }
  return {};
}

}  // namespace blossom
