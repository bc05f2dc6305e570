/// Previews on a grid: about the same solid, however many faces there are.
#include "geometry/mesh/mesh_topology.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

Mesh previewOf(const Operand& a, const Operand& b, double weightA, double weightB, int cells) {
  return previewOfSum({a, b}, {weightA, weightB}, cells).solids.front();
}

}  // namespace

class MorphologyPreviewTest : public QObject {
  Q_OBJECT

 private slots:
  void boundsAndVolumeAreAboutRight() {
    std::mt19937_64 random = seededRandom();
    const std::vector<std::pair<Mesh, Mesh>> pairs{
        {lBlock(), cornerTetrahedron()},
        {turnedBy(frameBlock(3, 1, 0, 1), randomTurn(random)), ballOf(0.4, 1)},
        {spikyCube(random, 2), turnedBy(cuboid({5, 5, 5}, {6, 7, 5.5}), randomTurn(random))},
        {ballOf(0.2, 1), ballOf(2, 2)},  // boundaries alone would leave a hollow
        {together(cuboid({0, 0, 0}, {1, 1, 1}), cuboid({0.5, 0.5, 0.5}, {2, 2, 2})), ballOf(0.5, 1)}};
    for (const auto& [first, second] : pairs)
      for (const bool swapped : {false, true}) {
        const Mesh &a = swapped ? second : first, &b = swapped ? first : second;
        constexpr int cells = 40;
        const Mesh exact = solidSumOf(a, b), preview = previewOf(bodyOf(a), bodyOf(b), 1, 1, cells);
        QVERIFY(meshTopology(preview).closed());
        const Bounds box = boundsOf(exact), about = boundsOf(preview);
        const double cell = (box.high - box.low).maxCoeff() / cells;
        const double off =
            std::max((box.low - about.low).cwiseAbs().maxCoeff(), (box.high - about.high).cwiseAbs().maxCoeff());
        QVERIFY2(off < 2 * cell, qPrintable(QStringLiteral("%1 cells").arg(off / cell)));
        // A layer of half a cell all over.
        const double apart = std::abs(volumeOf(preview) - volumeOf(exact));
        QVERIFY2(apart < 0.5 * cell * areaOf(exact), qPrintable(QStringLiteral("%1 of %2").arg(apart).arg(volumeOf(exact))));
      }
  }

  /// Walls of a slot that grow together where the grid cannot tell them apart.
  void everyEdgeHasTwoFaces() {
    const Mesh slotted = prism({{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 3}, {4, 3}, {4, 10}, {0, 10}}, 0, 10);
    for (const int cells : {20, 32, 40, 50}) {
      const MeshTopology topology = meshTopology(previewOf(bodyOf(slotted), bodyOf(cornerTetrahedron()), 1, 1, cells));
      QVERIFY(
          std::all_of(topology.edges.begin(), topology.edges.end(), [](const MeshEdge& edge) { return edge.manifold(); }));
    }
  }

  /// A plate thinner than a cell, a solid inside out, and volumes that are kept.
  void thinAndTurnedSolids() {
    const Mesh plate = cuboid({0, 0, 0}, {100, 60, 2}), ball_ = ballOf(2, 2), exact = solidSumOf(plate, ball_);
    for (const bool swapped : {false, true}) {
      const Mesh made =
          swapped ? previewOf(bodyOf(ball_), bodyOf(plate), 1, 1, 32) : previewOf(bodyOf(plate), bodyOf(ball_), 1, 1, 32);
      QVERIFY2(volumeOf(made) > 0.5 * volumeOf(exact), qPrintable(QString::number(volumeOf(made))));
    }
    const Mesh block = lBlock();
    COMPARE_NEAR(volumeOf(previewOf(bodyOf(insideOut(block)), bodyOf(ball_), 1, 1, 32)),
                 volumeOf(previewOf(bodyOf(block), bodyOf(ball_), 1, 1, 32)), 0.01);
    const MorphologyResult kept = previewOfSum({bodyOf(block), bodyOf(ball_)}, {0.4, 0.6}, 32, {.volumePreserving = true});
    COMPARE_NEAR(volumeOf(kept.solids.front()), 0.4 * volumeOf(block) + 0.6 * volumeOf(ball_), 1e-6);
  }

  void finerGridsAreNearer() {
    const Mesh a = ballOf(2, 2), b = lBlock(), exact = solidSumOf(a, b);
    double before = HUGE_VAL;
    for (const int cells : {16, 32, 64}) {
      const double apart = std::abs(volumeOf(previewOf(bodyOf(a), bodyOf(b), 1, 1, cells)) - volumeOf(exact));
      QVERIFY(apart < before);
      before = apart;
    }
    QVERIFY(before < 0.01 * volumeOf(exact));
  }

  void morphsAndThinShapes() {
    const Mesh a = movedBy(ballOf(2, 2), {10, 0, 0}), b = frameBlock(3, 1, 0, 1);
    const Mesh exact = morphOf(a, b, {0.3}).solids.front(), preview = previewOf(bodyOf(a), bodyOf(b), 0.7, 0.3, 48);
    COMPARE_NEAR(volumeOf(preview), volumeOf(exact), 0.05 * volumeOf(exact));
    QVERIFY((boundsOf(preview).center() - boundsOf(exact).center()).norm() < 0.1);
    Operand segment;
    segment.form = Operand::Form::Lines;
    segment.pieces = {{Vec3(0, 0, 0), Vec3(0, 0, 5)}};
    const Mesh cube = cuboid({0, 0, 0}, {2, 2, 2});
    COMPARE_NEAR(volumeOf(previewOf(bodyOf(cube), segment, 1, 1, 48)), 28, 1);
    COMPARE_NEAR(volumeOf(previewOf(segment, bodyOf(cube), 1, 1, 48)), 28, 1);
    VERIFY_ERROR(previewOfSum({segment, segment}, {1, 1}, 32), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(MorphologyPreviewTest)
#include "morphology_preview_test.moc"
