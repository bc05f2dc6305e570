#include "geometry/crossing/sheet_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/crossing/divided_triangles.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/numeric/union_find.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/brep.h"
#include "geometry/tessellate/brep_mesher.h"
#include "geometry/tessellate/grid_fit.h"

namespace blossom {
namespace {

constexpr std::size_t cellsOfABlock = 8;       // in either direction
constexpr std::size_t trianglesOfABlock = 32;  // where there is no grid
constexpr double anglesOfSheets = 0.6;         // radians; the chord is what counts
constexpr double samePlace = 1e-9;             // of the size

double turnBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// The cone about the mean of directions; those of length zero, as at poles, have none.
DirectionCone coneOf(const std::vector<Vec3>& sides) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& side : sides)
    if (side.squaredNorm() > 0) sum += side.normalized();
  if (!(sum.norm() > 0)) return {Vec3::Zero(), std::numbers::pi};
  DirectionCone cone{sum.normalized(), 0};
  for (const Vec3& side : sides)
    if (side.squaredNorm() > 0) cone.halfAngle = std::max(cone.halfAngle, turnBetween(cone.axis, side));
  return cone;
}

void setSize(SheetMesh& mesh) {
  Box3 box;
  for (const Vec3& p : mesh.points) box.extend(p);
  mesh.size = box.isEmpty() ? 0 : box.diagonal().norm();
}

bool isWithoutArea(const SheetTriangle& t) {
  return t.corners[0] == t.corners[1] || t.corners[1] == t.corners[2] || t.corners[2] == t.corners[0];
}

/// Box and mean normal of a block whose triangles stand in the mesh.
void setBoxAndNormal(const SheetMesh& mesh, SheetBlock& block) {
  for (std::uint32_t k = block.first; k < block.first + block.count; ++k) {
    const auto t = mesh.at(mesh.triangles[k]);
    for (const Vec3& p : t) block.box.extend(p);
    block.normal += (t[1] - t[0]).cross(t[2] - t[0]);
  }
  const double length = block.normal.norm();
  block.normal = length > 0 ? Vec3(block.normal / length) : Vec3(Vec3::Zero());
}

/// The blocks of a grid, row by row.
class GridBlocks {
 public:
  explicit GridBlocks(const SurfaceGrid& grid) : grid_(grid) {
    mesh_.points = grid.points;
    const std::size_t cellsU = grid.u.size() - 1, cellsV = grid.v.size() - 1;
    mesh_.blocksU = (cellsU + cellsOfABlock - 1) / cellsOfABlock;
    mesh_.blocksV = (cellsV + cellsOfABlock - 1) / cellsOfABlock;
    for (std::size_t a = 0; a < mesh_.blocksU; ++a)
      for (std::size_t b = 0; b < mesh_.blocksV; ++b)
        addBlock(a * cellsOfABlock, std::min(cellsU, (a + 1) * cellsOfABlock), b * cellsOfABlock,
                 std::min(cellsV, (b + 1) * cellsOfABlock));
  }

  SheetMesh finished() && {
    setSize(mesh_);
    UnionFind joints(mesh_.points.size());
    joinKinks(joints);
    mesh_.closedU = joinRows(joints, 0, grid_.u.size() - 1, Direction::U);
    mesh_.closedV = joinRows(joints, 0, grid_.v.size() - 1, Direction::V);
    for (const std::size_t end : {std::size_t{0}, grid_.u.size() - 1}) joinPole(joints, end, Direction::U);
    for (const std::size_t end : {std::size_t{0}, grid_.v.size() - 1}) joinPole(joints, end, Direction::V);
    for (SheetTriangle& t : mesh_.triangles)
      for (int& corner : t.corners) corner = static_cast<int>(joints.find(static_cast<std::size_t>(corner)));
    dropCollapsed();
    for (SheetBlock& block : mesh_.blocks) setBoxAndNormal(mesh_, block);
    return std::move(mesh_);
  }

 private:
  void addBlock(std::size_t u0, std::size_t u1, std::size_t v0, std::size_t v1) {
    SheetBlock block;
    block.first = static_cast<std::uint32_t>(mesh_.triangles.size());
    std::vector<Vec3> alongU, alongV;
    for (std::size_t i = u0; i <= u1; ++i)
      for (std::size_t j = v0; j <= v1; ++j) {
        if (i < u1) alongU.push_back(grid_.point(i + 1, j) - grid_.point(i, j));
        if (j < v1) alongV.push_back(grid_.point(i, j + 1) - grid_.point(i, j));
        if (i < u1 && j < v1) addCell(i, j);
      }
    block.alongU = coneOf(alongU);
    block.alongV = coneOf(alongV);
    block.count = static_cast<std::uint32_t>(mesh_.triangles.size()) - block.first;
    mesh_.blocks.push_back(block);
  }

  void addCell(std::size_t i, std::size_t j) {
    if (mainDiagonal(grid_.point(i, j), grid_.point(i + 1, j), grid_.point(i, j + 1), grid_.point(i + 1, j + 1))) {
      addTriangle({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
      addTriangle({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
    } else {
      addTriangle({{{i, j}, {i + 1, j}, {i, j + 1}}});
      addTriangle({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  }

  void addTriangle(const std::array<std::pair<std::size_t, std::size_t>, 3>& samples) {
    SheetTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [i, j] = samples[k];
      t.corners[k] = static_cast<int>(i * grid_.v.size() + j);
      t.at[k] = Vec2(grid_.u[i].t, grid_.v[j].t);
    }
    mesh_.triangles.push_back(t);
  }

  enum class Direction { U, V };

  [[nodiscard]] std::size_t index(std::size_t row, std::size_t k, Direction d) const {
    return d == Direction::U ? row * grid_.v.size() + k : k * grid_.v.size() + row;
  }
  [[nodiscard]] std::size_t lengthOfRow(Direction d) const { return d == Direction::U ? grid_.v.size() : grid_.u.size(); }

  [[nodiscard]] bool arePointsNear(std::size_t a, std::size_t b) const {
    return (grid_.points[a] - grid_.points[b]).norm() <= samePlace * mesh_.size;
  }

  /// Two rows that are the same points, as at a seam.
  bool joinRows(UnionFind& joints, std::size_t a, std::size_t b, Direction d) const {
    for (std::size_t k = 0; k < lengthOfRow(d); ++k)
      if (!arePointsNear(index(a, k, d), index(b, k, d))) return false;
    for (std::size_t k = 0; k < lengthOfRow(d); ++k) joints.unite(index(a, k, d), index(b, k, d));
    return true;
  }

  /// The two samples of a kink.
  void joinKinks(UnionFind& joints) const {
    for (std::size_t i = 0; i + 1 < grid_.u.size(); ++i)
      if (!grid_.connectedU(i)) joinRows(joints, i, i + 1, Direction::U);
    for (std::size_t j = 0; j + 1 < grid_.v.size(); ++j)
      if (!grid_.connectedV(j)) joinRows(joints, j, j + 1, Direction::V);
  }

  /// A row that is one point.
  void joinPole(UnionFind& joints, std::size_t row, Direction d) const {
    for (std::size_t k = 1; k < lengthOfRow(d); ++k)
      if (!arePointsNear(index(row, 0, d), index(row, k, d))) return;
    for (std::size_t k = 1; k < lengthOfRow(d); ++k) joints.unite(index(row, 0, d), index(row, k, d));
  }

  /// Those at poles and between the two samples of a kink.
  void dropCollapsed() {
    std::vector<SheetTriangle> kept;
    kept.reserve(mesh_.triangles.size());
    for (SheetBlock& block : mesh_.blocks) {
      const auto from = static_cast<std::uint32_t>(kept.size());
      for (std::uint32_t k = block.first; k < block.first + block.count; ++k)
        if (!isWithoutArea(mesh_.triangles[k])) kept.push_back(mesh_.triangles[k]);
      block.first = from;
      block.count = static_cast<std::uint32_t>(kept.size()) - from;
    }
    mesh_.triangles = std::move(kept);
  }

  const SurfaceGrid& grid_;
  SheetMesh mesh_;
};

/// Halves sides that are farther than the chord from the smooth faces.
void refine(SheetMesh& mesh, const SmoothSheets& sheets, double chord, const Progress& progress) {
  constexpr int rounds = 3;
  const auto isOff = [&](const Vec3& p, const Vec3& q, const Vec3& middle) {
    return (q - p).cross(middle - p).squaredNorm() > chord * chord * (q - p).squaredNorm();
  };
  DivisionMemory memory;
  for (int round = 0; round < rounds; ++round) {
    progress.check();
    if (!divideOnce(mesh.points, mesh.triangles, sheets, isOff, memory)) return;
  }
}

/// Puts the triangles in the order of a tree of boxes and makes a block of each of its leaves.
void blocksOfLeaves(SheetMesh& mesh, const Progress& progress) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const SheetTriangle& t : mesh.triangles) {
    Box3& box = boxes.emplace_back();
    for (const Vec3& p : mesh.at(t)) box.extend(p);
  }
  const BoxTree<3> tree(boxes, trianglesOfABlock, progress);
  std::vector<SheetTriangle> ordered;
  ordered.reserve(mesh.triangles.size());
  for (const std::uint32_t k : tree.order()) ordered.push_back(mesh.triangles[k]);
  mesh.triangles = std::move(ordered);
  for (const auto& node : tree.nodes()) {
    if (!node.isLeaf()) continue;
    SheetBlock block;
    block.first = node.first;
    block.count = node.count;
    setBoxAndNormal(mesh, block);
    mesh.blocks.push_back(block);
  }
}

}  // namespace

DirectionCone joinedCone(const DirectionCone& a, const DirectionCone& b) {
  const Vec3 sum = a.axis + b.axis;
  if (!(sum.norm() > 1e-9)) return {Vec3::Zero(), std::numbers::pi};
  const Vec3 axis = sum.normalized();
  return {axis, std::max(turnBetween(axis, a.axis) + a.halfAngle, turnBetween(axis, b.axis) + b.halfAngle)};
}

Box3 sampledBox(const Surface& surface, const Progress& progress) {
  const auto along = [](int degree, const std::vector<double>& knots) {
    const std::vector<double> breaks = domainBreaks(degree, knots);
    return samples(degree, knots, breaks, std::vector<int>(breaks.size() - 1, 4), 1, Kinks::Once);
  };
  const SurfaceGrid grid = evaluateGrid(surface, along(surface.degreeU, surface.knotsU),
                                        along(surface.degreeV, surface.knotsV), progress, GridNormals::No);
  Box3 box;
  for (const Vec3& p : grid.points) box.extend(p);
  return box;
}

double sampledSize(const Surface& surface, const Progress& progress) {
  return sampledBox(surface, progress).diagonal().norm();
}

SheetMesh sheetMesh(const Surface& surface, double chord, const Progress& progress) {
  const TessellationOptions options{.chord = chord, .angle = anglesOfSheets};
  SheetMesh mesh = GridBlocks(fitGrid(surface, options, GridBorder::Own, progress)).finished();
  mesh.chord = chord;
  return mesh;
}

SheetMesh sheetMesh(const TopoDS_Shape& shape, double chord, const Progress& progress) {
  constexpr double coarser = 2.5;  // OCCT's own mesh: halving its sides is far cheaper than a fine one
  PointOrigins origins;
  const Tessellation made = meshShape(shape, {.chord = coarser * chord, .angle = anglesOfSheets}, progress, &origins);
  SheetMesh mesh;
  mesh.points = made.points;
  mesh.chord = chord;
  setSize(mesh);
  mesh.triangles.reserve(made.triangles.size());
  for (std::size_t k = 0; k < made.triangles.size(); ++k) {
    SheetTriangle& t = mesh.triangles.emplace_back();
    t.face = made.faceOfTriangle[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto point = static_cast<std::size_t>(made.triangles[k][i]);
      t.corners[i] = origins.joint[point];
      t.at[i] = origins.parameters[point];
    }
  }
  std::erase_if(mesh.triangles, isWithoutArea);
  refine(mesh, SmoothSheets(shape), chord, progress);
  blocksOfLeaves(mesh, progress);
  return mesh;
}

SheetMesh sheetMeshWithin(double share, const TopoDS_Shape& shape, const Progress& progress) {
  constexpr double enough = 1.25;  // at most the whole depth for two sheets, see chordFor
  constexpr int rounds = 6;
  // The box of a rational face is that of its poles, and one of a small weight lies anywhere. What the triangles span is
  // known when they are made; those of a far too large chord are few.
  double chord = share * bounds(Shape(Brep(shape))).diagonal();
  SheetMesh mesh = sheetMesh(shape, chord, progress);
  for (int round = 0; round < rounds && mesh.size > 0 && chord > enough * share * mesh.size; ++round) {
    chord = share * mesh.size;
    mesh = sheetMesh(shape, chord, progress);
  }
  return mesh;
}

}  // namespace blossom
