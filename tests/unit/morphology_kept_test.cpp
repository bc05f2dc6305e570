// What rounding keeps of thin details, and of faces far from the origin.
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "morphology/kernel/finished.h"
#include "support/exchange.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

/// Two cubes of 0.3, joined by a wire of 0.5.
Mesh joinedByWire(double width) {
  Mesh mesh;
  const auto addSquare = [&](double x, double half) {
    for (const Vec2& p : {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)})
      mesh.points.emplace_back(x, p.x(), p.y());
  };
  addSquare(0, 0.15), addSquare(0.3, 0.15), addSquare(0.3, width / 2);
  addSquare(0.8, width / 2), addSquare(0.8, 0.15), addSquare(1.1, 0.15);
  for (int ring = 0; ring < 5; ++ring)
    for (int k = 0; k < 4; ++k) {
      const int a = 4 * ring + k, b = 4 * ring + (k + 1) % 4;
      mesh.addFace(std::array{b, a, a + 4, b + 4});
    }
  mesh.addFace(std::array{0, 1, 2, 3});
  mesh.addFace(std::array{23, 22, 21, 20});
  const Mesh triangles = triangulated(mesh).first;
  return volumeOf(triangles) < 0 ? insideOut(triangles) : triangles;
}

/// A block with a wall on it.
Mesh withFin(double thickness, double height) {
  const double half = thickness / 2;
  return prism(
      {{-0.5, 0}, {0.5, 0}, {0.5, 0.5}, {half, 0.5}, {half, 0.5 + height}, {-half, 0.5 + height}, {-half, 0.5}, {-0.5, 0.5}},
      0, 1);
}

Mesh withGap(double width) {
  return together(cuboid({0, 0, 0}, {0.5, 0.5, 0.5}), cuboid({0.1, 0.1, 0.5 + width}, {0.5, 0.5, 1}));
}

std::vector<Mesh> detailsOf(double thickness) {
  return {joinedByWire(thickness),  withFin(thickness, 1),       withFin(thickness, 1e-4),
          hollowCube(1, thickness), hollowCube(1e-4, thickness), withGap(thickness)};
}

}  // namespace

class MorphologyKeptTest : public QObject {
  Q_OBJECT

 private slots:
  /// Far away, corners of one face come to lie on its other sides: its triangles cover it once all the same.
  void resultsFarAwayDoNotFold() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 60; ++run) {
      const Mesh solid = turnedBy(lBlock(), randomTurn(random));
      const Mesh element = scaledBy(turnedBy(cuboid({0, 0, 0}, {1, 2, 3}), randomTurn(random)), uniform(random, 0.05, 0.3));
      const Mesh near = closingOf(solid, element);
      const double far = std::pow(10, uniform(random, 3, 6.5));
      const Vec3 centre(std::round(far), -std::round(far * uniform(random, 0, 1)), std::round(far * uniform(random, 0, 1)));
      const Mesh made = closingOf(movedBy(solid, centre), element);
      const double within = 1e-6 + 1e-11 * far;
      COMPARE_NEAR(volumeOf(made), volumeOf(near), 100 * within);
      COMPARE_NEAR(areaOf(made), areaOf(near), 100 * within);
      COMPARE_NEAR(areaOf(movedBy(made, -centre)), areaOf(near), 100 * within);  // where its triangles may be others
    }
  }

  /// Beside a corner that has to be rounded: what is lost is told, or refused.
  void detailsBesideAStepOfRoundingAreNotLost() {
    const Mesh given = *readShape(formats(), sourceFolder() / "tests/fixtures/nearly_closed_corner.off").shape.get<Mesh>();
    Mesh point;
    point.points = {{0, 0, 0}};
    for (const double thickness : {1e-11, 5e-11})
      for (const Mesh& detail : detailsOf(thickness))
        VERIFY_ERROR(solidSum(bodyOf(together(given, movedBy(detail, {0.3, 0.3, 2.6}))), bodyOf(point)),
                     ErrorCode::InvalidInput);
    const Mesh thick = movedBy(joinedByWire(1e-3), {0.3, 0.3, 2.6});
    const MorphologyResult made = solidSum(bodyOf(together(given, thick)), bodyOf(point));
    COMPARE_NEAR(volumeOf(made.solids.front()), volumeOf(given) + volumeOf(thick), 1e-8);
  }

  /// A slot that narrows to its bottom, much wider than rounding, is read as it is.
  void narrowSlotsAreRead() {
    Mesh point;
    point.points = {{0, 0, 0}};
    for (const double half : {1e-9, 4e-9, 1e-8, 1e-7, 1e-6}) {
      const Mesh block =
          prism({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {half, 0.5}, {0, -0.2}, {-half, 0.5}, {-0.5, 0.5}}, 0, 0.3);
      QVERIFY(!firstCrossing(block));
      COMPARE_NEAR(volumeOf(solidSumOf(block, point)), 0.3 * (1 - 0.7 * half), 1e-12);
    }
  }

  /// The same of results that lie far away.
  void detailsLostFarAwayAreTold() {
    int told = 0;
    for (const double far : {1e5, 1e7}) {
      const double unit = std::ldexp(1, std::ilogb(far) - 52);
      for (const double units : {0.5, 1.0, 2.0, 4.0, 32.0})
        for (const Mesh& detail : detailsOf(units * unit)) {
          const Mesh before = triangulated(detail).first;
          Finished made;
          try {
            made = finished(before, Vec3(far, far / 3, -far / 7), Slivers::Go, Progress::none());
          } catch (const CannotBeRounded&) {
            continue;
          }
          const bool isTold = made.loss.sentences().find("thinner than") != std::string::npos;
          const Mesh after = movedBy(made.mesh, -Vec3(far, far / 3, -far / 7));
          const bool isThere =
              componentsOf(after) == componentsOf(before) && std::abs(areaOf(after) - areaOf(before)) < 1e-4;
          told += isTold;
          QVERIFY2(isThere || isTold, qPrintable(QString("%1 units at %2").arg(units).arg(far)));
        }
    }
    QVERIFY(told > 0);
  }
};

BLOSSOM_TEST(MorphologyKeptTest)
#include "morphology_kept_test.moc"
