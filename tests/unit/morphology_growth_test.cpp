#include "morphology/kernel/control.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;
using std::numbers::pi;

namespace {

Mesh melt(const Mesh& solid, double radius, int subdivisions = 1) {
  return melted(bodyOf(solid), {.radii = {radius}, .subdivisions = subdivisions}).solids.front();
}
Mesh inflate(const Mesh& solid, double radius, int subdivisions = 1, BallFit fit = BallFit::Inscribed) {
  return inflated(bodyOf(solid), {.radii = {radius}, .subdivisions = subdivisions, .fit = fit}).solids.front();
}

std::vector<double> volumesOf(const MorphologyResult& result) {
  std::vector<double> volumes;
  for (const Mesh& solid : result.solids) volumes.push_back(volumeOf(solid));
  return volumes;
}

}  // namespace

/// Balls, inflating, melting and morphs of solids.
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
    const MorphologyResult grown = inflated(bodyOf(lBlock()), {.radii = radii});
    const MorphologyResult gone = melted(bodyOf(lBlock()), {.radii = radii});
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
    const MorphologyResult gone = melted(bodyOf(lBlock()), {.radii = {0, 0.25, 0.5, 0.75, 1}});
    QVERIFY(gone.solids.size() == 2 || gone.solids.size() == 3);
    QCOMPARE(gone.warnings.size(), std::size_t{1});
    VERIFY_ERROR(melt(lBlock(), 3), ErrorCode::Degenerate);
    VERIFY_ERROR(melted(bodyOf(cuboid({0, 0, 0}, {1, 1, 1})), {.radii = {0, 5}}), ErrorCode::Degenerate);
  }

  void aMorphBeginsAndEndsWithItsSolids() {
    const Mesh a = lBlock(), b = movedBy(frameBlock(3, 1, 0, 1), {20, 0, 0});
    const MorphologyResult made = solidMorph(bodyOf(a), bodyOf(b), {0, 0.5, 1});
    QCOMPARE(made.solids.size(), std::size_t{3});
    COMPARE_NEAR(volumeOf(made.solids[0]), volumeOf(a), tiny * 14);
    COMPARE_NEAR(volumeOf(made.solids[2]), volumeOf(b), tiny * 40);
    QCOMPARE(genusOf(made.solids[0]), 0);
    QCOMPARE(genusOf(made.solids[2]), 1);
    // Bounding boxes blend, centres too (Theorem 1).
    const Bounds first = boundsOf(a), last = boundsOf(b), middle = boundsOf(made.solids[1]);
    QVERIFY((middle.low - (first.low + last.low) / 2).norm() < tiny);
    QVERIFY((middle.high - (first.high + last.high) / 2).norm() < tiny);
    qInfo("figure morph_ends_error %.3g",
          std::abs(volumeOf(made.solids[0]) - volumeOf(a)) + std::abs(volumeOf(made.solids[2]) - volumeOf(b)));
  }

  void aMorphOfCuboidsBlendsTheirSides() {
    const Vec3 a(1, 2, 3), b(4, 2, 1);
    for (const double w : {0.1, 0.25, 0.5, 0.9}) {
      const MorphologyResult made = solidMorph(bodyOf(cuboid({0, 0, 0}, a)), bodyOf(cuboid({0, 0, 0}, b)), {w});
      COMPARE_NEAR(volumeOf(made.solids.front()), ((1 - w) * a + w * b).prod(), tiny * 20);
    }
  }

  // Figure 6 of the paper: a quadrilateral becomes a triangle.
  void aBlockBecomesAWedge() {
    const Mesh block = prism({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0, 1), wedge = prism({{0, 0}, {2, 0}, {0, 2}}, 0, 1);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double s = 1 - t;  // areas: of the square s^2 4, of the triangle t^2 2, mixed 2 s t 2 2
      const double expected = 4 * s * s + 2 * t * t + s * t * (2 * 2 + 2 * 2);
      const Mesh made = solidMorph(bodyOf(block), bodyOf(wedge), {t}).solids.front();
      COMPARE_NEAR(volumeOf(made), expected, tiny);
      QCOMPARE(made.faceCount(), std::size_t{t == 0 ? 6u : t == 1 ? 5u : 7u});
    }
  }

  void controlFunctions() {
    for (const Control control : {Control::Linear, Control::Ease, Control::EaseIn, Control::EaseOut}) {
      COMPARE_NEAR(controlValue(control, {}, 0), 0, 0);
      COMPARE_NEAR(controlValue(control, {}, 1), 1, 0);
      double before = 0;
      for (double t = 0.05; t < 1; t += 0.05) {
        const double value = controlValue(control, {}, t);
        QVERIFY(value > before && value < 1);
        before = value;
      }
    }
    COMPARE_NEAR(controlValue(Control::Ease, {}, 0.5), 0.5, 1e-15);
    COMPARE_NEAR(controlValue(Control::EaseIn, {}, 0.5), 0.25, 1e-15);
    COMPARE_NEAR(controlValue(Control::EaseOut, {}, 0.5), 0.75, 1e-15);
    const std::vector<ControlPoint> curve{{0.2, 0.1}, {0.4, 0.9}, {0.4, 0.3}, {1, 1}};
    COMPARE_NEAR(controlValue(Control::Curve, curve, 0), 0.1, 1e-15);
    COMPARE_NEAR(controlValue(Control::Curve, curve, 0.3), 0.5, 1e-15);
    COMPARE_NEAR(controlValue(Control::Curve, curve, 0.7), 0.65, 1e-15);
    VERIFY_ERROR(controlValue(Control::Curve, {}, 0.5), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(MorphologyGrowthTest)
#include "morphology_growth_test.moc"
