#include "morphology/kernel/convex/hull.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;
using std::numbers::pi;

namespace {

Mesh melt(const Mesh& solid, double radius, int subdivisions = 1) {
  return melted(bodyOf(solid), {.sizes = {radius}, .subdivisions = subdivisions}).solids.front();
}
Mesh inflate(const Mesh& solid, double radius, int subdivisions = 1, BallFit fit = BallFit::Inscribed) {
  return inflated(bodyOf(solid), {.sizes = {radius}, .subdivisions = subdivisions, .fit = fit}).solids.front();
}

std::vector<double> volumesOf(const MorphologyResult& result) {
  std::vector<double> volumes;
  for (const Mesh& solid : result.solids) volumes.push_back(volumeOf(solid));
  return volumes;
}

}  // namespace

/// Balls, inflating, melting and rounding of solids.
class MorphologyGrowthTest : public QObject {
  Q_OBJECT

 private slots:
  void ballsAreWhatTheySay() {
    for (int subdivisions = 0; subdivisions <= 4; ++subdivisions) {
      const BallResult inner = ball({3, subdivisions}), outer = ball({3, subdivisions, BallFit::Circumscribed});
      QCOMPARE(inner.mesh.faceCount(), std::size_t{20} << (2 * subdivisions));
      QCOMPARE(genusOf(inner.mesh), 0);
      const double exact = 4 * pi * 27 / 3;
      QVERIFY(volumeOf(inner.mesh) < exact && exact < volumeOf(outer.mesh));
      for (const Vec3& p : inner.mesh.points) COMPARE_NEAR(p.norm(), 3, 1e-14 * 3);
      // Every face within the deviation told.
      for (std::size_t f = 0; f < inner.mesh.faceCount(); ++f) {
        const auto points = facePoints(inner.mesh, f);
        QVERIFY(vectorArea(points).normalized().dot(points[0]) >= 3 - inner.deviation - tiny);
        const auto around = facePoints(outer.mesh, f);
        QVERIFY(vectorArea(around).normalized().dot(around[0]) >= 3 - tiny);
      }
    }
    VERIFY_ERROR(ball({0, 1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(ball({-1, 1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(ball({std::nan(""), 1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(ball({1, 7}), ErrorCode::InvalidParameter);
  }

  void aCuboidInflates() {
    const Vec3 sides(4, 3, 2);
    for (const BallFit fit : {BallFit::Inscribed, BallFit::Circumscribed}) {
      const double expected = volumeWithCuboid(ball({0.7, 2, fit}).mesh, sides);
      COMPARE_NEAR(volumeOf(inflate(cuboid({1, 1, 1}, Vec3(1, 1, 1) + sides), 0.7, 2, fit)), expected, tiny * expected);
    }
    // Steiner's formula of the true ball lies between the two.
    const double r = 0.7, steiner = 24 + 2 * r * (12 + 6 + 8) + pi * r * r * (4 + 3 + 2) + 4 * pi * r * r * r / 3;
    QVERIFY(volumeOf(inflate(cuboid({0, 0, 0}, sides), r, 2)) < steiner);
    QVERIFY(volumeOf(inflate(cuboid({0, 0, 0}, sides), r, 2, BallFit::Circumscribed)) > steiner);
  }

  void aCuboidMelts() {
    const Bounds reach = boundsOf(ballOf(0.5, 2));
    const Vec3 left = Vec3(4, 3, 2) - (reach.high - reach.low);
    const Mesh core = melt(cuboid({0, 0, 0}, {4, 3, 2}), 0.5, 2);
    COMPARE_NEAR(volumeOf(core), left.prod(), tiny);
    QCOMPARE(core.faceCount(), std::size_t{6});
  }

  void anLMelts() {
    // Both arms lose the ball's reach at each side; the reflex edge is rounded by it: less than the L of thinner arms.
    const double r = 0.2;
    const Vec3 reach = boundsOf(ballOf(r)).high;
    const Mesh core = melt(lBlock(), r);
    const double sharp =
        (2 - 2 * reach.z()) * ((4 - 2 * reach.x()) * (1 - 2 * reach.y()) + (1 - 2 * reach.x()) * (4 - 2 * reach.y()) -
                               (1 - 2 * reach.x()) * (1 - 2 * reach.y()));
    QVERIFY(volumeOf(core) >= sharp - tiny);
    QVERIFY(volumeOf(core) <= sharp + 2 * r * r);
    COMPARE_NEAR(volumeOf(solidDifferenceOf(lBlock(), ballOf(r))), volumeOf(core), tiny);
  }

  void aSequenceGrowsAndMelts() {
    const std::vector<double> radii{0, 0.1, 0.2, 0.3};
    const MorphologyResult grown = inflated(bodyOf(lBlock()), {.sizes = radii});
    const MorphologyResult gone = melted(bodyOf(lBlock()), {.sizes = radii});
    QCOMPARE(grown.solids.size(), radii.size());
    QCOMPARE(gone.solids.size(), radii.size());
    const auto larger = volumesOf(grown), smaller = volumesOf(gone);
    COMPARE_NEAR(larger[0], 14, tiny);
    COMPARE_NEAR(smaller[0], 14, tiny);
    for (std::size_t k = 1; k < radii.size(); ++k) {
      QVERIFY(larger[k] > larger[k - 1]);
      QVERIFY(smaller[k] < smaller[k - 1]);
      // Frames are what the single ones are.
      COMPARE_NEAR(larger[k], volumeOf(inflate(lBlock(), radii[k])), tiny * larger[k]);
      COMPARE_NEAR(smaller[k], volumeOf(melt(lBlock(), radii[k])), tiny * 14);
    }
  }

  void meltingEndsWhereNothingIsLeft() {
    const MorphologyResult gone = melted(bodyOf(lBlock()), {.sizes = {0, 0.25, 0.5, 0.75, 1}});
    QVERIFY(gone.solids.size() == 2 || gone.solids.size() == 3);
    QCOMPARE(gone.warnings.size(), std::size_t{1});
    VERIFY_ERROR(melt(lBlock(), 3), ErrorCode::Degenerate);
    VERIFY_ERROR(melted(bodyOf(cuboid({0, 0, 0}, {1, 1, 1})), {.sizes = {0, 5}}), ErrorCode::Degenerate);
  }

  /// What fits in is the room for the element, wherever its origin is.
  void anyShapeGrowsAndMelts() {
    const Mesh diamond = hullTriangles({{0.3, 0, 0}, {-0.1, 0, 0}, {0, 0.4, 0.1}, {0, -0.2, 0}, {0, 0, 0.5}});
    const Mesh solid = lBlock();
    for (const double size : {0.4, 0.8}) {
      GrowOptions options{.sizes = {0, size}, .element = bodyOf(diamond)};
      const Mesh melted_ = melted(bodyOf(solid), options).solids.back(),
                 grown = inflated(bodyOf(solid), options).solids.back();
      const Mesh element = scaledBy(diamond, size), less = solidDifferenceOf(solid, element),
                 more = solidSumOf(solid, element);
      COMPARE_NEAR(volumeOf(melted_), volumeOf(less), tiny);
      COMPARE_NEAR(volumeOf(grown), volumeOf(more), tiny);
      QVERIFY((boundsOf(melted_).low - boundsOf(less).low).norm() < tiny);
      QVERIFY((boundsOf(grown).high - boundsOf(more).high).norm() < tiny);
    }
    // A segment takes its length away.
    Operand segment;
    segment.form = Operand::Form::Lines;
    segment.pieces = {{Vec3(0, 0, 0), Vec3(0, 0, 2)}};
    COMPARE_NEAR(volumeOf(melted(bodyOf(solid), {.sizes = {0.5}, .element = segment}).solids.front()), 7, tiny);
  }

  /// Melting on and growing again is the opening of what is left.
  void whatMeltsIsRounded() {
    for (const Mesh& solid : {lBlock(), cuboid({0, 0, 0}, {4, 3, 2})}) {
      const Mesh rounded = melted(bodyOf(solid), {.sizes = {0.2}, .rounding = 0.5}).solids.front();
      const Mesh sharp = melt(solid, 0.2);
      COMPARE_NEAR(volumeOf(rounded), volumeOf(openingOf(sharp, ballOf(0.1))), tiny);
      QVERIFY(volumeOf(rounded) < volumeOf(sharp) - 1e-4);
      QVERIFY((boundsOf(rounded).low - boundsOf(sharp).low).norm() < tiny);
    }
  }

  void itMeltsUntilNothingIsLeft() {
    const Bounds reach = boundsOf(ballOf(1));
    const double exact = 2 / (reach.high - reach.low).z();  // half of the shortest side, but for the facets of the ball
    const MorphologyResult all = melted(bodyOf(cuboid({0, 0, 0}, {4, 3, 2})), {.sizes = {0, 0.5, 1}, .untilNothing = true});
    QCOMPARE(all.solids.size(), std::size_t{3});
    QVERIFY(all.stats.largestSize <= exact && all.stats.largestSize > 0.998 * exact);
    QVERIFY(volumeOf(all.solids[2]) < 0.01 * 24);
    const MorphologyResult rough = melted(bodyOf(lBlock()), {.sizes = {1}, .rounding = 0.3, .untilNothing = true});
    const double last = volumeOf(rough.solids.front());
    QVERIFY(last > 0 && last < 0.001 * volumeOf(lBlock()));  // rounded by a share of the size it would be 0.01
    VERIFY_ERROR(melted(bodyOf(lBlock()), {.sizes = {1.002 * rough.stats.largestSize}, .rounding = 0.3}),
                 ErrorCode::Degenerate);
    Operand point;
    point.form = Operand::Form::Points;
    point.pieces = {{Vec3(1, 0, 0)}};
    VERIFY_ERROR(melted(bodyOf(lBlock()), {.sizes = {1}, .element = point, .untilNothing = true}), ErrorCode::InvalidInput);
  }

  void allEdgesAreRounded() {
    const Vec3 sides(4, 3, 2);
    const Operand ball_ = bodyOf(ballOf(0.3, 2));
    const Bounds reach = boundsOf(ball_.mesh);
    const double box = volumeWithCuboid(ball_.mesh, sides - (reach.high - reach.low));
    for (const RoundedEdges edges : {RoundedEdges::Convex, RoundedEdges::Both})
      COMPARE_NEAR(volumeOf(solidRounded(bodyOf(cuboid({0, 0, 0}, sides)), ball_, edges).solids.front()), box, tiny * box);
    const auto ofL = [&](RoundedEdges edges) {
      return volumeOf(solidRounded(bodyOf(lBlock()), ball_, edges).solids.front());
    };
    QVERIFY(ofL(RoundedEdges::Convex) < ofL(RoundedEdges::Both));
    QVERIFY(ofL(RoundedEdges::Both) < ofL(RoundedEdges::Reflex));
    QVERIFY(ofL(RoundedEdges::Reflex) > 14);
  }
};

BLOSSOM_TEST(MorphologyGrowthTest)
#include "morphology_growth_test.moc"
