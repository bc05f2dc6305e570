/// The arrangement of facets: sums and differences of any solids against cells that are counted, CGAL's Nef polyhedra and
/// the laws of morphology.
#include <array>
#include <set>

#include "core/parallel.h"
#include "geometry/mesh/mesh_crossing.h"
#include "morphology/kernel/arrangement/arranged_sum.h"
#include "support/morphology.h"
#include "support/solid_peer.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

/// Unit cells on a lattice: walls in common planes, holes, voids, parts that touch along edges and in corners.
Cells latticeOf(std::mt19937_64& random, const Cell& sides, double density) {
  std::bernoulli_distribution filled(density);
  Cells cells{{0, 0, 0}};
  for (int x = 0; x < sides[0]; ++x)
    for (int y = 0; y < sides[1]; ++y)
      for (int z = 0; z < sides[2]; ++z)
        if (filled(random)) cells.insert({x, y, z});
  return cells;
}

/// Each wall of a cell that no other cell has, as two triangles.
Mesh surfaceOf(const Cells& cells) {
  Operand corners;
  corners.form = Operand::Form::Points;
  for (const auto& [x, y, z] : cells) corners.pieces.push_back({Vec3(x, y, z)});
  return solidSum(corners, bodyOf(cuboid({0, 0, 0}, {1, 1, 1}))).solids.front();
}

/// The cells that A + B covers: two cells add up to a cube of two.
Cells sumOfCells(const Cells& a, const Cells& b) {
  Cells sum;
  for (const Cell& p : a)
    for (const Cell& q : b)
      for (int k = 0; k < 8; ++k) sum.insert({p[0] + q[0] + (k & 1), p[1] + q[1] + (k >> 1 & 1), p[2] + q[2] + (k >> 2)});
  return sum;
}

/// The cells of {x : x + B inside A}: those from whose every place all of B falls into A.
Cells differenceOfCells(const Cells& a, const Cells& b) {
  Cells difference;
  for (const Cell& p : a)
    for (const Cell& q : b) {
      const Cell at{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      const bool fits = std::all_of(b.begin(), b.end(), [&](const Cell& c) {
        for (int k = 0; k < 8; ++k)
          if (!a.contains({at[0] + c[0] + (k & 1), at[1] + c[1] + (k >> 1 & 1), at[2] + c[2] + (k >> 2)})) return false;
        return true;
      });
      if (fits) difference.insert(at);
    }
  return difference;
}

/// A sum that is no prism's or hull's.
Mesh arranged(const Mesh& a, const Mesh& b) {
  const Mesh first = triangulated(a).first, second = triangulated(b).first;
  const double step = std::ldexp(1, -36);
  auto made = arrangedSum({first, {}}, {second, {}}, step, Progress::none());
  return made ? std::move(made->triangles) : Mesh();
}

/// On a grid that both sides are given.
Mesh onGrid(Mesh mesh) {
  mesh = triangulated(mesh).first;
  for (Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) p[k] = std::round(p[k] * 1024) / 1024;
  return mesh;
}

Mesh solidOfKind(std::mt19937_64& random, int kind, double size) {
  switch (kind) {
    case 0:
      return onGrid(spikyRing(random, size, 0.4 * size, 5));
    case 1:
      return onGrid(scaledBy(turnedBy(lBlock(), randomTurn(random)), 0.3 * size));
    case 2:
      return onGrid(together(spikyCube(random, 0.6 * size), movedBy(spikyCube(random, 0.6 * size), {1.4 * size, 0, 0})));
    case 3:
      return onGrid(scaledBy(frameBlock(2, 1, 0, 1), 0.5 * size));
    case 4:
      return onGrid(together(cuboid({0, 0, 0}, {size, size, size}),
                             insideOut(scaledBy(movedBy(triangulated(cornerTetrahedron()).first, {1, 1, 1}), 0.2 * size))));
    default:
      return onGrid(spikyCube(random, size));
  }
}

}  // namespace

class MorphologyArrangementTest : public QObject {
  Q_OBJECT

 private slots:
  void cellsAreCounted() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 60; ++round) {
      const Cells a = latticeOf(random, {3, 3, 3}, 0.3 + 0.01 * round), b = latticeOf(random, {2, 2, 1}, 0.5);
      const Mesh first = surfaceOf(a), second = surfaceOf(b);
      COMPARE_NEAR(volumeOf(first), static_cast<double>(a.size()), 1e-12);
      const Mesh sum = solidSumOf(first, second);
      COMPARE_NEAR(volumeOf(sum), static_cast<double>(sumOfCells(a, b).size()), 1e-9);
      QVERIFY(!firstCrossing(sum));
    }
  }

  void cellsAreMelted() {
    std::mt19937_64 random = seededRandom();
    int rounds = 0;
    for (int round = 0; round < 200 && rounds < 40; ++round) {
      const Cells a = latticeOf(random, {5, 4, 4}, 0.85), b = latticeOf(random, {1, 1, 2}, 0.5);
      const Cells left = differenceOfCells(a, b);
      if (left.empty()) continue;
      ++rounds;
      const Mesh made = solidDifferenceOf(surfaceOf(a), surfaceOf(b));
      COMPARE_NEAR(volumeOf(made), static_cast<double>(left.size()), 1e-9);
      QVERIFY(!firstCrossing(made));
    }
    QVERIFY(rounds > 10);
  }

  void theSameAsCgal() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 12; ++round) {
      const Mesh a = solidOfKind(random, round % 6, 3), b = solidOfKind(random, 5 - round / 2, 1);
      const Mesh ours = arranged(a, b), theirs = sumByNef(a, b);
      COMPARE_NEAR(volumeOf(ours), volumeOf(theirs), tiny * volumeOf(theirs));
      COMPARE_NEAR(area(ours), area(theirs), tiny * area(theirs));
    }
  }

  /// Convex solids, too, which other ways make: all ways make the same.
  void theSameAsTheOtherWays() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      const Mesh a = onGrid(turnedBy(ballOf(2, round % 3), randomTurn(random))), b = onGrid(cuboid({0, 0, 0}, {1, 2, 0.5}));
      const Mesh ours = arranged(a, b), other = solidSumOf(a, b);
      COMPARE_NEAR(volumeOf(ours), volumeOf(other), tiny * volumeOf(other));
      COMPARE_NEAR(area(ours), areaOf(other), tiny * areaOf(other));
    }
  }

  /// {x : x + B inside A} is the complement of the complement of A plus -B, within a frame that both know.
  void differencesAreComplementsOfSums() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 24; ++round) {
      const Mesh a = solidOfKind(random, round % 6, 4), b = onGrid(scaledBy(solidOfKind(random, 5, 1), 0.3));
      const Bounds box = boundsOf(a);
      const Mesh frame = onGrid(cuboid(box.low - Vec3(2, 2, 2), box.high + Vec3(2, 2, 2)));
      // The frame with the solid as a void, and -B: what of that is left empty inside is the difference.
      const Mesh outside = triangulated(together(frame, insideOut(a))).first;
      const Mesh sum = arranged(outside, reflected(b));
      const Mesh grown = arranged(frame, reflected(b));
      const double left = volumeOf(grown) - volumeOf(sum);
      if (left < 1e-9) {
        VERIFY_ERROR(solidDifferenceOf(a, b), ErrorCode::Degenerate);
        continue;
      }
      COMPARE_NEAR(volumeOf(solidDifferenceOf(a, b)), left, 1e-9 * volumeOf(frame));
    }
  }

  /// Corner by corner: files are the same on any machine.
  void threadsChangeNothing() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 6; ++round) {
      const Mesh a = solidOfKind(random, round, 3), b = solidOfKind(random, 5 - round, 1);
      setThreadLimit(1);
      const Mesh alone = arranged(a, b);
      setThreadLimit(0);
      const Mesh together = arranged(a, b);
      QVERIFY(alone.points == together.points);
      QVERIFY(alone.faceVertices == together.faceVertices);
    }
  }

  void placesTellWhatBelongs() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 6; ++round) {
      const Mesh a = solidOfKind(random, round, 3), b = solidOfKind(random, 5 - round, 1);
      const Mesh ab = arranged(a, b), ba = arranged(b, a);
      COMPARE_NEAR(volumeOf(ab), volumeOf(ba), tiny * volumeOf(ab));
      QVERIFY(volumeOf(ab) >= std::pow(std::cbrt(volumeOf(a)) + std::cbrt(volumeOf(b)), 3) - tiny);
    }
  }
};

BLOSSOM_TEST(MorphologyArrangementTest)
#include "morphology_arrangement_test.moc"
