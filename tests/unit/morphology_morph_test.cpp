#include <set>

#include "morphology/kernel/control.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

/// Morphs of two and more solids.
class MorphologyMorphTest : public QObject {
  Q_OBJECT

 private slots:
  void moreSolidsAreBlended() {
    const Vec3 a(1, 2, 3), b(4, 2, 1), c(2, 5, 2);
    const auto at = [](const Vec3& low, const Vec3& sides) { return bodyOf(cuboid(low, low + sides)); };
    const std::vector<std::vector<double>> weights{{1, 0, 0}, {0.25, 0.5, 0.25}, {0.7, 0, 0.3}, {0, 0, 1}};
    const MorphologyResult made = solidMorph({at({0, 0, 0}, a), at({10, 0, 0}, b), at({0, 1e4, 0}, c)}, weights);
    QCOMPARE(made.solids.size(), weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const Vec3 sides = weights[k][0] * a + weights[k][1] * b + weights[k][2] * c;
      const Vec3 low = weights[k][1] * Vec3(10, 0, 0) + weights[k][2] * Vec3(0, 1e4, 0);
      COMPARE_NEAR(volumeOf(made.solids[k]), sides.prod(), 1e-8);
      QVERIFY((boundsOf(made.solids[k]).low - low).norm() < 1e-9);
    }
  }

  /// In whatever order the sums are made.
  void anySolidsAreBlended() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 4; ++round) {
      const std::vector<Mesh> solids{movedBy(lBlock(), {1, 2, 3}), spikyCube(random, 2),
                                     turnedBy(frameBlock(2, 1, 0, 1), randomTurn(random))};
      const std::vector<double> w{0.2, 0.5, 0.3};
      std::vector<Operand> operands;
      for (const Mesh& solid : solids) operands.push_back(bodyOf(solid));
      const Mesh made = solidMorph(operands, {w}).solids.front();
      const Mesh other =
          solidSumOf(scaledBy(solids[2], w[2]), solidSumOf(scaledBy(solids[1], w[1]), scaledBy(solids[0], w[0])));
      COMPARE_NEAR(volumeOf(made), volumeOf(other), tiny * volumeOf(other));
      COMPARE_NEAR(areaOf(made), areaOf(other), tiny * areaOf(other));
      QVERIFY((boundsOf(made).low - boundsOf(other).low).norm() < 1e-9);
    }
  }

  void aMorphBeginsAndEndsWithItsSolids() {
    const Mesh a = lBlock(), b = movedBy(frameBlock(3, 1, 0, 1), {20, 0, 0});
    const MorphologyResult made = morphOf(a, b, {0, 0.5, 1});
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
      const MorphologyResult made = morphOf(cuboid({0, 0, 0}, a), cuboid({0, 0, 0}, b), {w});
      COMPARE_NEAR(volumeOf(made.solids.front()), ((1 - w) * a + w * b).prod(), tiny * 20);
    }
  }

  // Figure 6 of the paper: a quadrilateral becomes a triangle.
  void aBlockBecomesAWedge() {
    const Mesh block = prism({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0, 1), wedge = prism({{0, 0}, {2, 0}, {0, 2}}, 0, 1);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double s = 1 - t;  // areas: of the square s^2 4, of the triangle t^2 2, mixed 2 s t 2 2
      const double expected = 4 * s * s + 2 * t * t + s * t * (2 * 2 + 2 * 2);
      const Mesh made = morphOf(block, wedge, {t}).solids.front();
      COMPARE_NEAR(volumeOf(made), expected, tiny);
      QCOMPARE(made.faceCount(), std::size_t{t == 0 ? 6u : t == 1 ? 5u : 7u});
    }
  }

  /// Prisms, convex solids, any others, and a solid of bodies that overlap.
  void volumesBlend() {
    std::mt19937_64 random = seededRandom();
    const Mesh overlapping = together(cuboid({0, 0, 0}, {2, 2, 2}), cuboid({1, 1, 1}, {3, 3, 3}));
    const std::vector<std::pair<Mesh, double>> solids{{lBlock(), volumeOf(lBlock())},
                                                      {cuboid({5, 6, 7}, {6, 8, 8}), 2},
                                                      {ballOf(1.5, 1), volumeOf(ballOf(1.5, 1))},
                                                      {overlapping, 15},
                                                      {spikyCube(random, 2), 0}};
    for (const auto& [a, volumeOfA] : solids)
      for (const auto& [b, volumeOfB] : solids)
        for (const double t : {0.0, 0.3, 0.8, 1.0}) {
          const auto known = [](const Mesh& solid, double volume) { return volume > 0 ? volume : volumeOf(solid); };
          const double wanted = (1 - t) * known(a, volumeOfA) + t * known(b, volumeOfB);
          const Mesh made = solidMorph({bodyOf(a), bodyOf(b)}, {{1 - t, t}}, {.volumePreserving = true}).solids.front();
          COMPARE_NEAR(volumeOf(made), wanted, 1e-9 * wanted);
          const Vec3 middle = (1 - t) * boundsOf(a).center() + t * boundsOf(b).center();
          QVERIFY((boundsOf(made).center() - middle).norm() < 1e-9);
        }
  }

  void progressCountsTheFrames() {
    const std::vector<Operand> solids{bodyOf(lBlock()), bodyOf(cornerTetrahedron())};
    double before = 0;
    std::set<std::string> frames;
    const Progress progress({}, [&](double fraction, const std::string& stage) {
      QVERIFY(fraction >= before);
      before = fraction;
      frames.insert(stage.substr(0, stage.find(',')));
    });
    solidMorph(solids, {{0.75, 0.25}, {0.5, 0.5}, {0.25, 0.75}}, {}, progress);
    QCOMPARE(before, 1.0);
    for (const char* frame : {"frame 1 of 3", "frame 2 of 3", "frame 3 of 3"}) QVERIFY2(frames.contains(frame), frame);
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

BLOSSOM_TEST(MorphologyMorphTest)
#include "morphology_morph_test.moc"
