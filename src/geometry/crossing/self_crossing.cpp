#include "geometry/crossing/self_crossing.h"

#include <Eigen/Geometry>
#include <array>
#include <utility>
#include <vector>

#include "geometry/crossing/crossing_search.h"
#include "geometry/mesh/winding_field.h"

namespace blossom {
namespace {

/// Pairs around which winding numbers are asked for, evenly chosen.
constexpr std::size_t pairsTried = 48;

std::vector<Triangle3> trianglesOf(const SheetMesh& mesh) {
  std::vector<Triangle3> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const SheetTriangle& t : mesh.triangles) triangles.push_back(mesh.at(t));
  return triangles;
}

Vec3 unitNormalOf(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

/// Whether no solid has that winding number: it is enclosed twice or inside out. A void has 0, whether it is meant or not.
bool isWrong(int winding) { return winding != 0 && winding != 1; }

/// The space around triangles that meet.
class Around {
 public:
  Around(const SheetMesh& mesh, const Progress& progress)
      : mesh_(mesh),
        chord_(mesh.chord),
        progress_(progress),
        field_(trianglesOf(mesh), progress),
        tree_(trianglesOf(mesh)) {}

  /// Whether a point near a pair, clear of the surface and of the error of its triangles, is enclosed twice or inside out.
  /// Around a crossing one of the four wedges between the two sheets is.
  [[nodiscard]] bool isEnclosedWrongly(const TrianglePair& pair) const {
    const Vec3 n = unitNormalOf(at(pair.first)), m = unitNormalOf(at(pair.second));
    const Vec3 aside = chord_ * Vec3(0.4391, 0.5273, 0.3617);  // along no plane that a drawing is likely to have
    const std::array<Vec3, 6> ways{n + m, -n - m, n - m, m - n, n.cross(m).cross(n), n};
    for (double step = 4 * chord_; step < mesh_.size / 4; step *= 2)
      for (const Vec3& way : ways) {
        progress_.check();
        if (!(way.norm() > 1e-3)) continue;
        const Vec3 beside = pair.place + step * way.normalized();
        if (isWrongAt(beside - aside) && isWrongAt(beside + aside) && distanceTo(beside) > 2 * chord_) return true;
      }
    return false;
  }

  /// Whether triangles that lie on one another have space on either side, so that the wall between them has no thickness, or
  /// enclose something wrongly. A solid on one side only is what every face has: there the triangles alone are folded.
  [[nodiscard]] bool isWallWithoutThickness(const TrianglePair& pair) const {
    const Vec3 aside = 1e-7 * mesh_.size * unitNormalOf(at(pair.first));
    const int before = field_.at(pair.place + aside), behind = field_.at(pair.place - aside);
    return isWrong(before) || isWrong(behind) || (before == 0 && behind == 0);
  }

 private:
  /// Asked for on either side of a place: rays from one of symmetry may run along seams.
  [[nodiscard]] bool isWrongAt(const Vec3& p) const { return isWrong(field_.at(p)); }
  [[nodiscard]] Triangle3 at(std::uint32_t triangle) const { return mesh_.at(mesh_.triangles[triangle]); }
  [[nodiscard]] double distanceTo(const Vec3& p) const {
    return tree_.closest(TriangleTree({Triangle3{p, p, p}}), progress_).distance();
  }

  const SheetMesh& mesh_;
  double chord_;
  const Progress& progress_;
  WindingField field_;
  TriangleTree tree_;
};

}  // namespace

std::optional<Vec3> selfCrossing(const TopoDS_Shape& solid, const Progress& progress) {
  const CrossingOptions options;
  const SheetMesh mesh = sheetMeshWithin(chordFor(options), solid, progress);
  const MeetingTriangles found = meetingTriangles(mesh, pairsKept, progress);
  if (found.pairs.empty() && found.lying.empty()) return {};
  if (const auto deepest = searchCrossing(mesh, SmoothSheets(solid), found, options, progress).deepest)
    return deepest->point;
  const Around around(mesh, progress);
  for (const TrianglePair& pair : found.lying)
    if (around.isWallWithoutThickness(pair)) return pair.place;
  const std::size_t stride = (found.pairs.size() + pairsTried - 1) / pairsTried;
  for (std::size_t k = 0; k < found.pairs.size(); k += stride)
    if (around.isEnclosedWrongly(found.pairs[k])) return found.pairs[k].place;
  return {};
}

}  // namespace blossom
