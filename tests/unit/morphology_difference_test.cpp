#include <array>
#include <map>
#include <set>

#include "support/morphology.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

/// A frame box with the solid as a void in it, shells as they are.
Mesh boxAround(const Mesh& solid, double room) {
  const Bounds box = boundsOf(solid);
  return together(cuboid(box.low - Vec3::Constant(room), box.high + Vec3::Constant(room)), insideOut(solid));
}

/// vol(A - B) by duality: what of the void (frame - A) + (-B) leaves, seen only from sums.
double differenceByDuality(const Mesh& a, const Mesh& b) {
  const double room = 1.5 * (boundsOf(b).high - boundsOf(b).low).norm() + boundsOf(b).low.norm();
  const Bounds frame = boundsOf(boxAround(a, room));
  const Mesh mirrored = reflected(b);
  return volumeOf(solidSumOf(cuboid(frame.low, frame.high), mirrored)) - volumeOf(solidSumOf(boxAround(a, room), mirrored));
}

/// Every point tried that lies in `inner` lies in `outer`.
void verifyWithin(std::mt19937_64& random, const Mesh& inner, const Mesh& outer) {
  const Mesh a = triangulated(inner).first, b = triangulated(outer).first;
  int found = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = randomPoint(random, boundsOf(a));
    if (!contains(a, p)) continue;
    ++found;
    QVERIFY(contains(b, p));
  }
  QVERIFY(found > 20);
}

/// The boundary of cubes of size 1 in a lattice.
Mesh cellsMesh(const std::set<std::array<int, 3>>& cells) {
  Mesh mesh;
  std::map<std::array<int, 3>, int> corners;
  const auto cornerAt = [&](const std::array<int, 3>& at) {
    const auto [it, isNew] = corners.emplace(at, static_cast<int>(mesh.points.size()));
    if (isNew) mesh.points.emplace_back(at[0], at[1], at[2]);
    return it->second;
  };
  for (const auto& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        std::array<int, 3> beside = cell;
        beside[axis] += side == 1 ? 1 : -1;
        if (cells.contains(beside)) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::vector<int> face;
        for (const auto& [du, dv] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
          std::array<int, 3> at = cell;
          at[axis] += side;
          at[u] += du;
          at[v] += dv;
          face.push_back(cornerAt(at));
        }
        if (side == 0) std::reverse(face.begin(), face.end());
        mesh.addFace(face);
      }
  return mesh;
}

}  // namespace

/// Differences, openings and closings of solids.
class MorphologyDifferenceTest : public QObject {
  Q_OBJECT

 private slots:
  // {x : x + [0,1]^3 inside [-5,5]^3}: the element is not reflected.
  void theElementIsNotReflected() {
    const Mesh room = solidDifferenceOf(cuboid({-5, -5, -5}, {5, 5, 5}), cuboid({0, 0, 0}, {1, 1, 1}));
    COMPARE_NEAR(volumeOf(room), 729, tiny * 729);
    QVERIFY((boundsOf(room).low - Vec3(-5, -5, -5)).norm() < tiny);
    QVERIFY((boundsOf(room).high - Vec3(4, 4, 4)).norm() < tiny);
    QCOMPARE(room.faceCount(), std::size_t{6});
    qInfo("figure difference_volume %.17g", volumeOf(room));
    qInfo("figure difference_low %.17g", boundsOf(room).low.x());
    qInfo("figure difference_high %.17g", boundsOf(room).high.x());
  }

  // What a ball has rounded is melted by it again: of the faces that it has made nothing is left but points, and they are
  // left out. Sums leave out none.
  void roundedSolidsMeltedAgain() {
    const Mesh ball = ballOf(0.4, 1);
    for (const Mesh& solid : {lBlock(), frameBlock(2, 0.3, 0, 1), frameBlock(3, 1, 0, 2)}) {
      const Mesh rounded = solidSumOf(solid, ball);
      const double left = volumeOf(solidDifferenceOf(rounded, ball));
      COMPARE_NEAR(left, differenceByDuality(rounded, ball), 1e-8);
      QVERIFY(left > volumeOf(solid) - 1e-9);
    }
  }

  // The same through the way of solids that are not convex.
  void nonConvexSolidsLikewise() {
    const Mesh room = solidDifferenceOf(lBlock(), cuboid({0, 0, 0}, {0.5, 0.25, 1}));
    // Along x: 3.5 by 0.75; along y: 0.5 by 3.75; common 0.5 by 0.75; one high.
    COMPARE_NEAR(volumeOf(room), 3.5 * 0.75 + 0.5 * 3.75 - 0.5 * 0.75, tiny);
    QVERIFY(boundsOf(room).low.norm() < tiny);
    QVERIFY((boundsOf(room).high - Vec3(3.5, 3.75, 1)).norm() < tiny);
  }

  void aDifferenceUndoesATranslation() {
    const Mesh l = lBlock();
    // A very small cube at b: nearly the translation by b.
    const double size = 1e-4;
    const Vec3 by(7, -3, 11);
    const Mesh back = solidDifferenceOf(movedBy(l, by), cuboid(by, by + Vec3::Constant(size)));
    QVERIFY((boundsOf(back).low - boundsOf(l).low).norm() < 2 * size);
    QVERIFY((boundsOf(back).high - boundsOf(l).high).norm() < 2 * size);
  }

  void dualityOfSumAndDifference() {
    std::mt19937_64 random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 4; ++k) {
      const Mesh solids[] = {lBlock(), frameBlock(3, 1, 0, 2), turnedBy(lBlock(), randomTurn(random)), spikyCube(random, 3)};
      const Mesh& a = solids[k];
      const Mesh b = movedBy(scaledBy(cornerTetrahedron(), 0.4), {0.3, -0.2, 0.1});
      const double direct = volumeOf(solidDifferenceOf(a, b)), dual = differenceByDuality(a, b);
      COMPARE_NEAR(direct, dual, 1e-8 * volumeOf(a));
      worst = std::max(worst, std::abs(direct - dual) / volumeOf(a));
    }
    qInfo("figure duality_error %.3g", worst);
  }

  void aSumMinusItsElementHoldsTheSolid() {
    std::mt19937_64 random = seededRandom();
    const Mesh a = turnedBy(lBlock(), randomTurn(random)), b = cornerTetrahedron();
    const Mesh closed = closingOf(a, b);
    QVERIFY(volumeOf(closed) >= volumeOf(a) - tiny);
    verifyWithin(random, a, closed);
    const Mesh back = solidDifferenceOf(solidSumOf(a, b), b);
    COMPARE_NEAR(volumeOf(back), volumeOf(closed), tiny * volumeOf(back));
  }

  void openingAndClosing() {
    // A ball-like element leaves the wide part and takes the fin; a cube fills a slot narrower than itself.
    const Mesh fin = prism({{0, 0}, {6, 0}, {6, 0.4}, {3, 0.4}, {3, 3}, {0, 3}}, 0, 3);
    const Mesh opened = openingOf(fin, cuboid({0, 0, 0}, {1, 1, 1}));
    COMPARE_NEAR(volumeOf(opened), 27, tiny * 27);
    const Mesh again = openingOf(opened, cuboid({0, 0, 0}, {1, 1, 1}));
    COMPARE_NEAR(volumeOf(again), volumeOf(opened), tiny * 27);
    const Mesh slotted = prism({{0, 0}, {5, 0}, {5, 3}, {2.5, 3}, {2.5, 1}, {2, 1}, {2, 3}, {0, 3}}, 0, 3);
    const Mesh filled = closingOf(slotted, cuboid({0, 0, 0}, {1, 1, 1}));
    COMPARE_NEAR(volumeOf(filled), 45, tiny * 45);
    const Mesh wide = closingOf(slotted, cuboid({0, 0, 0}, {0.5, 0.5, 0.5}));
    QVERIFY(volumeOf(wide) <= 45 + tiny);
    // An element that goes through every slot changes nothing.
    COMPARE_NEAR(volumeOf(closingOf(slotted, cuboid({0, 0, 0}, {0.25, 0.25, 0.25}))), volumeOf(slotted), tiny * 45);
  }

  void flatElements() {
    Operand segment;
    segment.form = Operand::Form::Lines;
    segment.pieces = {{{0, 0, 0}, {0, 0, 1.5}}};
    // The L is 2 high: half of it is left, at the bottom.
    const Mesh left = solidDifference(bodyOf(lBlock()), segment).solids.front();
    COMPARE_NEAR(volumeOf(left), 3.5, tiny);
    COMPARE_NEAR(boundsOf(left).high.z(), 0.5, tiny);
    Operand plate;
    plate.form = Operand::Form::Sheet;
    plate.pieces = {{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}}, {{0, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}}};
    COMPARE_NEAR(volumeOf(solidDifference(bodyOf(lBlock()), plate).solids.front()), 2 * (2 * 3.5 * 0.5 - 0.25), tiny);
  }

  /// An arm as wide as what moves in it: it has no volume left, which is said; of one that is narrower nothing is.
  void exactFitsAreSaid() {
    const auto block = [](double width) {
      return prism({{0, 0}, {20, 0}, {20, width}, {10, width}, {10, 10}, {0, 10}}, 0, 10);
    };
    const Mesh cube = cuboid({-2, -2, -2}, {2, 2, 2});
    const auto isSaid = [](const MorphologyResult& made) {
      return std::any_of(made.warnings.begin(), made.warnings.end(),
                         [](const std::string& warning) { return warning.find("exactly as wide") != std::string::npos; });
    };
    for (const bool arePrisms : {true, false}) {
      // A tetrahedron far away, and the solid is no prism.
      const auto solid = [&](double width) {
        return bodyOf(arePrisms ? block(width)
                                : together(block(width), movedBy(scaledBy(cornerTetrahedron(), 20), {100, 0, 0})));
      };
      for (const double width : {3.0, 3.99, 4.0, 4.01}) {
        const bool isTight = width == 4;
        QCOMPARE(isSaid(solidDifference(solid(width), bodyOf(cube))), isTight);
        QCOMPARE(isSaid(solidOpening(solid(width), bodyOf(cube))), isTight);
      }
    }
    // An arm that ends within the box of what is left, and is joined to it.
    const auto hooked = [](double width) {
      return prism({{0, 0}, {18, 0}, {18, width}, {8, width}, {8, 22}, {22, 22}, {22, 0}, {30, 0}, {30, 30}, {0, 30}}, 0,
                   10);
    };
    for (const bool arePrisms : {true, false}) {
      const auto solid = [&](double width) {
        return bodyOf(arePrisms ? hooked(width)
                                : together(hooked(width), movedBy(scaledBy(cornerTetrahedron(), 20), {100, 0, 0})));
      };
      for (const double width : {3.0, 3.99, 4.0, 4.01})
        QCOMPARE(isSaid(solidDifference(solid(width), bodyOf(cube))), width == 4);
    }
    for (const double size : {4.0, 5.0}) {
      try {
        solidDifferenceOf(cuboid({0, 0, 0}, {4, 9, 9}), cuboid({0, 0, 0}, {size, size, size}));
        QFAIL("not refused");
      } catch (const Error& error) {
        QCOMPARE(std::string(error.message()).find("fits exactly") != std::string::npos, size == 4);
      }
    }
  }

  /// Of cells in whole numbers: what fits exactly lies between places that do not, and is told where it is left out.
  void exactFitsBetweenOthersAreSaid() {
    auto random = seededRandom();
    const Mesh corner = cellsMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    int told = 0, silent = 0;
    for (int k = 0; k < 12; ++k) {
      std::set<std::array<int, 3>> cells;
      for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
          for (int z = 0; z < 4; ++z)
            if (uniform(random, 0, 1) < (k % 2 == 0 ? 0.9 : 0.98)) cells.insert({x, y, z});
      // The cells that the corner can reach, and those that it can reach with room on all sides of it.
      std::set<std::array<int, 3>> reached;
      const std::array<std::array<int, 3>, 3> parts{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
      for (const auto& at : cells)
        if (std::all_of(parts.begin(), parts.end(), [&](const auto& p) {
              return cells.contains({at[0] + p[0], at[1] + p[1], at[2]});
            }))
          for (const auto& p : parts) reached.insert({at[0] + p[0], at[1] + p[1], at[2]});
      MorphologyResult opened;
      try {
        opened = solidOpening(bodyOf(cellsMesh(cells)), bodyOf(corner));
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::Degenerate);  // nothing is left
        continue;
      }
      const bool isLess = volumeOf(opened.solids.front()) < static_cast<double>(reached.size()) - tiny;
      const bool isTold = std::any_of(opened.warnings.begin(), opened.warnings.end(), [](const std::string& warning) {
        return warning.find("exactly as wide") != std::string::npos;
      });
      if (isLess) QVERIFY(isTold);
      ++(isTold ? told : silent);
    }
    QVERIFY(told > 0);
  }

  void nothingLeftIsSaid() {
    VERIFY_ERROR(solidDifferenceOf(cuboid({0, 0, 0}, {1, 1, 1}), cuboid({0, 0, 0}, {2, 0.1, 0.1})), ErrorCode::Degenerate);
    VERIFY_ERROR(solidDifferenceOf(lBlock(), cuboid({0, 0, 0}, {2, 2, 0.1})), ErrorCode::Degenerate);
    // As large as the solid: one place, which has no volume.
    VERIFY_ERROR(solidDifferenceOf(lBlock(), lBlock()), ErrorCode::Degenerate);
    VERIFY_ERROR(openingOf(lBlock(), cuboid({0, 0, 0}, {2, 2, 2})), ErrorCode::Degenerate);
  }
};

BLOSSOM_TEST(MorphologyDifferenceTest)
#include "morphology_difference_test.moc"
