#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

bool closed(const Mesh& mesh) { return meshTopology(mesh).closed(); }

Mesh cubeOfSideOne(const Vec3& at = Vec3::Zero()) { return cuboid(at, at + Vec3(1, 1, 1)); }

/// A solid prism below, a segment or a flat polygon as the element.
Operand thin(Operand::Form form, std::vector<std::vector<Vec3>> pieces) {
  Operand operand;
  operand.form = form;
  operand.pieces = std::move(pieces);
  return operand;
}

}  // namespace

/// Sums of solids with closed forms.
class MorphologySumTest : public QObject {
  Q_OBJECT

 private slots:
  void cuboidsAddTheirSides() {
    const Mesh sum = solidSumOf(cuboid({1, 2, 3}, {3, 5, 7}), cuboid({-1, 0, 0.5}, {0, 5, 2.5}));
    COMPARE_NEAR(volumeOf(sum), 3 * 8 * 6, tiny);
    QCOMPARE(sum.faceCount(), std::size_t{6});
    QCOMPARE(sum.points.size(), std::size_t{8});
    QVERIFY(boundsOf(sum).low.isApprox(Vec3(0, 2, 3.5)) && boundsOf(sum).high.isApprox(Vec3(3, 10, 9.5)));
    qInfo("figure box_box_error %.3g", std::abs(volumeOf(sum) - 144));
  }

  // A sum does not hold its operands: the origin lies in neither.
  void cubesFarFromTheOriginMove() {
    const Mesh sum = solidSumOf(cubeOfSideOne(), cubeOfSideOne({5, 5, 5}));
    COMPARE_NEAR(volumeOf(sum), 8, tiny);
    QVERIFY(boundsOf(sum).low.isApprox(Vec3(5, 5, 5)) && boundsOf(sum).high.isApprox(Vec3(7, 7, 7)));
    QCOMPARE(componentsOf(sum), std::size_t{1});
    qInfo("figure moved_cubes_volume %.17g", volumeOf(sum));
  }

  void aCuboidAndAPrism() {
    const double w = 3, d = 2, h = 5, a = 1.5, b = 2.5, height = 0.75;
    const Mesh wedge = prism({{0, 0}, {a, 0}, {0, b}}, 1, 1 + height);
    const Mesh sum = solidSumOf(cuboid({0, 0, 0}, {w, d, h}), wedge);
    const double expected = (w * d + a * b / 2 + w * b + d * a) * (h + height);
    COMPARE_NEAR(volumeOf(sum), expected, tiny);
    QCOMPARE(sum.faceCount(), std::size_t{7});
    qInfo("figure box_prism_error %.3g", std::abs(volumeOf(sum) - expected));
  }

  void aCuboidAndAnyConvexSolid() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> side(0.1, 5), any(-3, 3);
    const auto place = [&] { return Vec3(any(random), any(random), any(random)); };
    for (int pair = 0; pair < 100; ++pair) {
      const Vec3 sides(side(random), side(random), side(random)), at = place();
      Mesh convex = tetrahedron(place(), place(), place(), place());
      if (pair % 3 == 1) convex = movedBy(turnedBy(cuboid({0, 0, 0}, sides.reverse()), randomTurn(random)), place());
      if (pair % 3 == 2) convex = turnedBy(prism({{0, 0}, {2, 0}, {3, 1}, {1, 3}}, 0, side(random)), randomTurn(random));
      if (volumeOf(convex) < 1e-3) continue;
      const double expected = volumeWithCuboid(convex, sides);
      COMPARE_NEAR(volumeOf(solidSumOf(cuboid(at, at + sides), convex)), expected, tiny * expected);
      COMPARE_NEAR(volumeOf(solidSumOf(convex, cuboid(at, at + sides))), expected, tiny * expected);
    }
  }

  // Slices: an L plus a right triangle of legs u covers 7 + 8u (u up to 1). Below z = 2 there is all of the triangle, then
  // it shrinks to nothing: 2 (7 + 8) + 7 + 4.
  void anLAndATetrahedronByHand() {
    const Mesh sum = solidSumOf(lBlock(), cornerTetrahedron());
    COMPARE_NEAR(volumeOf(sum), 41, tiny);
    QVERIFY(closed(sum));
    qInfo("figure l_tetrahedron_error %.3g", std::abs(volumeOf(sum) - 41));
  }

  void theSameTurnedAndMoved() {
    std::mt19937_64 random = seededRandom();
    for (int k = 0; k < 5; ++k) {
      const Eigen::Matrix3d turn = randomTurn(random);
      const Mesh sum = solidSumOf(movedBy(turnedBy(lBlock(), turn), {100, -20, 3}), turnedBy(cornerTetrahedron(), turn));
      COMPARE_NEAR(volumeOf(sum), 41, tiny * 41);
      QVERIFY(closed(sum));
      QCOMPARE(genusOf(sum), 0);
      // Faces of one plane are one, although rounding has bent them.
      const Mesh straight = solidSumOf(lBlock(), cornerTetrahedron());
      QVERIFY2(sum.faceCount() <= straight.faceCount() + 4, qPrintable(QString::number(sum.faceCount())));
    }
  }

  void holesShrinkAndFillUp() {
    const Mesh frame = frameBlock(5, 2, 0, 2);
    const Mesh narrowed = solidSumOf(frame, cubeOfSideOne());
    COMPARE_NEAR(volumeOf(narrowed), (11 * 11 - 3 * 3) * 3, tiny * 400);
    QCOMPARE(genusOf(narrowed), 1);
    const Mesh filled = solidSumOf(frame, cuboid({0, 0, 0}, {5, 5, 5}));
    COMPARE_NEAR(volumeOf(filled), 15 * 15 * 7, tiny * 2000);
    QCOMPARE(genusOf(filled), 0);
    QCOMPARE(filled.faceCount(), std::size_t{6});
  }

  void voidsShrinkAndFillUp() {
    const Mesh hollow = together(cuboid({0, 0, 0}, {10, 10, 10}), insideOut(cuboid({3, 3, 3}, {7, 7, 7})));
    COMPARE_NEAR(volumeOf(hollow), 1000 - 64, tiny);
    const Mesh smaller = solidSumOf(hollow, cubeOfSideOne());
    COMPARE_NEAR(volumeOf(smaller), 11 * 11 * 11 - 3 * 3 * 3, tiny * 1e3);
    QCOMPARE(componentsOf(smaller), std::size_t{2});
    COMPARE_NEAR(volumeOf(solidSumOf(hollow, cuboid({0, 0, 0}, {4, 4, 4}))), 14 * 14 * 14, tiny * 1e3);
  }

  void partsStayApartOrUnite() {
    const Mesh two = together(cubeOfSideOne(), cubeOfSideOne({5, 0, 0}));
    const Mesh apart = solidSumOf(two, cubeOfSideOne());
    COMPARE_NEAR(volumeOf(apart), 16, tiny);
    QCOMPARE(componentsOf(apart), std::size_t{2});
    const Mesh one = solidSumOf(two, cuboid({0, 0, 0}, {4.5, 1, 1}));
    COMPARE_NEAR(volumeOf(one), 10.5 * 2 * 2, tiny);
    QCOMPARE(componentsOf(one), std::size_t{1});
    // They grow until they touch in a face: one solid.
    COMPARE_NEAR(volumeOf(solidSumOf(two, cuboid({0, 0, 0}, {4, 1, 1}))), 10 * 2 * 2, tiny);
    COMPARE_NEAR(volumeOf(solidSumOf(two, two)), 3 * 8, tiny);
  }

  void aSegmentSweepsASolid() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> any(-4, 4);
    for (int k = 0; k < 20; ++k) {
      const Mesh solid = turnedBy(prism({{0, 0}, {2, 0}, {3, 1}, {1, 3}}, 0, 1), randomTurn(random));
      const Vec3 along(any(random), any(random), any(random));
      const Mesh swept = solidSum(bodyOf(solid), thin(Operand::Form::Lines, {{Vec3::Zero(), along}})).solids.front();
      const double expected = volumeOf(solid) + along.norm() * shadowOf(solid, along);
      COMPARE_NEAR(volumeOf(swept), expected, tiny * expected);
    }
    // An L has no shadow formula, but straight up it grows as a prism does.
    const Mesh tall = solidSum(bodyOf(lBlock()), thin(Operand::Form::Lines, {{{0, 0, -1}, {0, 0, 3}}})).solids.front();
    COMPARE_NEAR(volumeOf(tall), 7 * 6, tiny);
    COMPARE_NEAR(boundsOf(tall).low.z(), -1, 0);
    QCOMPARE(tall.faceCount(), std::size_t{8});
  }

  void flatElementsAndPoints() {
    const Operand square =
        thin(Operand::Form::Sheet, {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {{0, 0, 0}, {2, 2, 0}, {0, 2, 0}}});
    COMPARE_NEAR(volumeOf(solidSum(bodyOf(cubeOfSideOne()), square).solids.front()), 3 * 3 * 1, tiny);
    const Operand up = thin(Operand::Form::Lines, {{{0, 0, 0}, {0, 0, 1.5}}});
    COMPARE_NEAR(volumeOf(solidSum(square, up).solids.front()), 2 * 2 * 1.5, tiny);
    const Operand places = thin(Operand::Form::Points, {{{0, 0, 0}}, {{0.5, 0, 0}}, {{9, 0, 0}}});
    const Mesh copies = solidSum(bodyOf(cubeOfSideOne()), places).solids.front();
    COMPARE_NEAR(volumeOf(copies), 2.5, tiny);
    QCOMPARE(componentsOf(copies), std::size_t{2});
    VERIFY_ERROR(solidSum(square, square), ErrorCode::Degenerate);
    VERIFY_ERROR(solidSum(up, up), ErrorCode::Degenerate);
  }

  void orderAndPlaceDoNotMatter() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> any(-50, 50);
    for (int k = 0; k < 3; ++k) {
      const Mesh a = spikyCube(random, 2), b = spikyCube(random, 1);
      const Mesh ab = solidSumOf(a, b), ba = solidSumOf(b, a);
      const double volume = volumeOf(ab);
      COMPARE_NEAR(volumeOf(ba), volume, tiny * volume);
      COMPARE_NEAR(areaOf(ba), areaOf(ab), tiny * areaOf(ab));
      const Vec3 by(any(random), any(random), any(random));
      const Mesh moved = solidSumOf(movedBy(a, by), b);
      COMPARE_NEAR(volumeOf(moved), volume, tiny * volume);
      QVERIFY((boundsOf(moved).low - by - boundsOf(ab).low).norm() < 1e-9);
      // Brunn and Minkowski from below, the sum of the hulls from above: both lie in a cuboid.
      QVERIFY(std::cbrt(volume) >= std::cbrt(volumeOf(a)) + std::cbrt(volumeOf(b)) - tiny);
      const Bounds boxA = boundsOf(a), boxB = boundsOf(b);
      QVERIFY(volume <= (boxA.high - boxA.low + boxB.high - boxB.low).prod());
    }
  }

  /// An L and a tetrahedron, both about as they are drawn: 8 faces at a corner each, 4 more at those of the L, and the
  /// edges.
  /// Around convex solids in general position the facets are the boundary; elsewhere they cover it.
  void facetsCoverTheBoundary() {
    std::mt19937_64 random = seededRandom();
    const auto areaOf_ = [](const SumParts& parts) {
      double sum = 0;
      for (const auto& family : parts.facets)
        for (const std::vector<Vec3>& facet : family) sum += vectorArea(facet).norm();
      return sum;
    };
    for (int round = 0; round < 10; ++round) {
      const Mesh a = turnedBy(ballOf(2, 1), randomTurn(random)),
                 b = turnedBy(cuboid({1, 0, 0}, {2, 3, 1}), randomTurn(random));
      const SumParts parts = partsOfSum(bodyOf(a), bodyOf(b));
      const Mesh sum = solidSumOf(a, b);
      COMPARE_NEAR(areaOf_(parts), areaOf(sum), 1e-9 * areaOf(sum));
      QVERIFY(parts.reflex.empty());
      // From outside: each family has the rest of the sum behind its facets.
      for (const auto& family : parts.facets)
        for (const std::vector<Vec3>& facet : family)
          for (const Vec3& p : sum.points) QVERIFY((p - facet[0]).dot(vectorArea(facet)) < 1e-9);
    }
    const SumParts parts = partsOfSum(bodyOf(lBlock()), bodyOf(cornerTetrahedron()));
    QCOMPARE(parts.reflex.size(), std::size_t(2));
    QVERIFY(areaOf_(parts) > areaOf(solidSumOf(lBlock(), cornerTetrahedron())));
  }

  void theCountersTellWhatWasDone() {
    const MorphologyResult made = solidSum(bodyOf(lBlock()), bodyOf(cornerTetrahedron()));
    QVERIFY(made.stats.way == Way::Arranged);
    QVERIFY(made.stats.candidates >= 12);
    QVERIFY(made.warnings.empty());
    QVERIFY(solidSum(bodyOf(lBlock()), bodyOf(lBlock())).stats.way == Way::Prisms);
    QVERIFY(solidSum(bodyOf(ballOf(1)), bodyOf(cornerTetrahedron())).stats.way == Way::Hulls);
    QVERIFY(solidDifference(bodyOf(ballOf(1)), bodyOf(ballOf(0.5))).stats.way == Way::Planes);
  }
};

BLOSSOM_TEST(MorphologySumTest)
#include "morphology_sum_test.moc"
