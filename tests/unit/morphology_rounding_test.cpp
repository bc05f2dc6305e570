#include "geometry/mesh/mesh_crossing.h"
#include "morphology/kernel/finished.h"
#include "support/morphology.h"
#include "support/solid_peer.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

/// The unit cube with the middle of its top pushed down.
Mesh dentedCube(double depth) {
  const Mesh cube = cuboid({0, 0, 0}, {1, 1, 1});
  Mesh mesh;
  mesh.points = cube.points;
  mesh.points.emplace_back(0.5, 0.5, 1 - depth);
  for (std::size_t f = 0; f < cube.faceCount(); ++f) {
    const auto face = cube.face(f);
    if (f != 1) {
      mesh.addFace(face);
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) mesh.addFace(std::array{face[k], face[(k + 1) % 4], 8});
  }
  return mesh;
}

/// A block with a slot of this width from above.
Mesh slotted(double width) {
  return prism({{-2, 0}, {2, 0}, {2, 3}, {width / 2, 3}, {width / 2, 1}, {-width / 2, 1}, {-width / 2, 3}, {-2, 3}}, 0, 1);
}

}  // namespace

/// What rounding to a grid and to doubles does, and does not, to results.
class MorphologyRoundingTest : public QObject {
  Q_OBJECT

 private slots:
  // A square moved about over a dent of the form of a pyramid leaves a smaller one, lower by as much.
  void aShallowDentStays() {
    for (const double depth : {1e-3, 5e-11}) {
      const Mesh cube = dentedCube(depth);
      const double side = 0.25;  // powers of two: the volume of the undented sum is a double
      const Mesh sum = solidSumOf(cube, cuboid({0, 0, 0}, {side, side, side}));
      const double whole = std::pow(1 + side, 3), left = depth * std::pow(1 - side, 3) / 3;
      const double grid = std::ldexp(1, -44);  // half a step: so far may the middle of the dent have been moved
      COMPARE_NEAR(whole - volumeOf(sum), left, grid * std::pow(1 - side, 3) / 3 + 1e-15);
      QVERIFY(sum.faceCount() > 6);
    }
  }

  void resultsCrossNowhere() {
    std::mt19937_64 random = seededRandom();
    for (int k = 0; k < 2; ++k) {
      const Mesh a = turnedBy(lBlock(), randomTurn(random));
      const Mesh b = k % 2 == 0 ? spikyCube(random, 1) : turnedBy(cuboid({0, 0, 0}, {1, 0.5, 0.25}), randomTurn(random));
      QVERIFY(!firstCrossing(solidSumOf(a, b)));
      QVERIFY(!firstCrossing(solidDifferenceOf(scaledBy(a, 3), b)));
    }
  }

  // Where the corners cannot hold a detail, it is closed, and said; what cannot be closed is refused.
  void whatRoundingMakesCrossIsSnapped() {
    const Mesh triangles = triangulated(slotted(1e-9)).first;
    QCOMPARE(finished(triangles, Vec3::Zero(), Slivers::Go, Progress::none()).warning, std::string());
    const Vec3 far(1e8, 1e8, 0);  // doubles lie 1.5e-8 apart here
    const Finished snapped = finished(triangles, far, Slivers::Go, Progress::none());
    QVERIFY(!firstCrossing(snapped.mesh));
    COMPARE_NEAR(volumeOf(movedBy(snapped.mesh, -far)), 12, 1e-6);
    QVERIFY(snapped.warning.starts_with("Corners have been moved by up to "));
    VERIFY_ERROR(finished(scaledBy(triangles, 1e-9), far, Slivers::Go, Progress::none()), ErrorCode::Degenerate);
  }

  void theSameSolidGivesTheSameMesh() {
    std::mt19937_64 random = seededRandom();
    const Mesh solid = triangulated(slotted(1)).first;
    const Mesh first = finished(solid, Vec3::Zero(), Slivers::Go, Progress::none()).mesh;
    for (int k = 0; k < 5; ++k) {
      // Other numbers, other orders, other first corners.
      std::vector<int> number(solid.points.size());
      std::iota(number.begin(), number.end(), 0);
      std::shuffle(number.begin(), number.end(), random);
      std::vector<std::size_t> order(solid.faceCount());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::shuffle(order.begin(), order.end(), random);
      Mesh shuffled;
      shuffled.points.resize(solid.points.size());
      for (std::size_t v = 0; v < number.size(); ++v) shuffled.points[static_cast<std::size_t>(number[v])] = solid.points[v];
      for (const std::size_t f : order) {
        std::vector<int> face;
        for (const int v : solid.face(f)) face.push_back(number[static_cast<std::size_t>(v)]);
        std::rotate(face.begin(), face.begin() + k % 3, face.end());
        shuffled.addFace(face);
      }
      QVERIFY(finished(shuffled, Vec3::Zero(), Slivers::Go, Progress::none()).mesh == first);
    }
  }

  void whatCgalMakesGivesTheSameMesh() {
    const Mesh l = lBlock(), frame = frameBlock(3, 1, 0, 2);
    for (const Mesh& b : {cornerTetrahedron(), cuboid({0, 0, 0}, {0.5, 0.25, 1}), lBlock()})
      for (const Mesh& a : {l, frame}) {
        const Mesh one = solidSum(bodyOf(a), bodyOf(b)).solids.front();
        const Mesh theirs = sumByNef(triangulated(a).first, triangulated(b).first);
        const Mesh other = finished(theirs, Vec3::Zero(), Slivers::Go, Progress::none()).mesh;
        COMPARE_NEAR(volumeOf(one), volumeOf(other), 1e-12 * volumeOf(one));
        QVERIFY(one == other);
      }
  }
};

BLOSSOM_TEST(MorphologyRoundingTest)
#include "morphology_rounding_test.moc"
