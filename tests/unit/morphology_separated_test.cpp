// Results whose sheets lie on each other but for rounding.
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "morphology/kernel/manifold.h"
#include "morphology/kernel/separated.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

/// Corners nearer to the middle or farther away, by this share at most: hardly an edge is convex with its neighbours.
Mesh bumpy(Mesh ball, double share, std::mt19937_64& random) {
  std::uniform_real_distribution<double> factor(1 - share, 1 + share);
  for (Vec3& p : ball.points) p *= factor(random);
  return triangulated(ball).first;
}

/// No corner comes nearer than `least` to an edge that it is no corner of.
bool isSeparated(const Mesh& mesh, double least) {
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int from = face[k], to = face[(k + 1) % face.size()];
      const Vec3 &p = mesh.points[static_cast<std::size_t>(from)], &q = mesh.points[static_cast<std::size_t>(to)];
      for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
        if (v == from || v == to) continue;
        const Vec3 d = mesh.points[static_cast<std::size_t>(v)] - p;
        const double t = std::clamp(d.dot(q - p) / (q - p).squaredNorm(), 0.0, 1.0);
        if ((d - t * (q - p)).norm() < least) return false;
      }
    }
  }
  return true;
}

}  // namespace

class MorphologySeparatedTest : public QObject {
  Q_OBJECT

 private slots:
  /// Facets of the opening lie in those of the solid, which the way there and back has rounded; an opening opened again
  /// stays as it is.
  void openingsByElementsThatAreNotConvex() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 3; ++run) {
      const Mesh solid = bumpy(ballOf(3, 2), 0.1, random), element = bumpy(ballOf(0.7, 1), 0.2, random);
      const Mesh opened = openingOf(solid, element);
      QVERIFY(!firstCrossing(opened));
      QVERIFY(volumeOf(opened) < volumeOf(solid) * (1 + tiny));
      COMPARE_NEAR(volumeOf(openingOf(opened, element)), volumeOf(opened), 1e-7 * volumeOf(solid));
      const Mesh closed = closingOf(solid, element);
      QVERIFY(!firstCrossing(closed));
      QVERIFY(volumeOf(closed) > volumeOf(solid) * (1 - tiny));
      COMPARE_NEAR(volumeOf(closingOf(closed, element)), volumeOf(closed), 1e-7 * volumeOf(solid));
    }
  }

  /// Boxes turned anyhow with a gap or an overlap as thin as rounding between them become one.
  void wallsOnEachOtherGo() {
    std::mt19937_64 random = seededRandom();
    for (const double apart : {-1e-13, 0.0, 1e-13, 1e-12})
      for (const double shift : {0.0, 0.25, 1e-13}) {
        const Mesh lower = cuboid({0, 0, 0}, {1, 1, 1}), upper = cuboid({shift, 0, 1 + apart}, {1 + shift, 1, 2});
        const Mesh both = triangulated(turnedBy(together(lower, upper), randomTurn(random))).first;
        constexpr double least = 1e-11;
        const auto made = separated(both, least);
        const bool isWallToWall = shift < 0.1;
        if (!made && !isWallToWall) continue;  // then edges of both cross on and on
        QVERIFY(made);
        const Mesh one = manifoldOf(*made);
        QVERIFY(meshTopology(one).closed());
        QCOMPARE(componentsOf(one), std::size_t{1});
        QVERIFY(!firstCrossing(one));
        QVERIFY(isSeparated(one, 0.9 * least));
        COMPARE_NEAR(volumeOf(one), 2, 1e-9);
      }
  }

  /// What is far apart stays as it is.
  void nothingElseMoves() {
    std::mt19937_64 random = seededRandom();
    const Mesh solid = bumpy(ballOf(3, 2), 0.1, random);
    const auto made = separated(solid, 1e-9);
    QVERIFY(made);
    QCOMPARE(made->faceCount(), solid.faceCount());
    QCOMPARE(volumeOf(*made), volumeOf(solid));
  }

  /// From a corner on one side of a strip thin triangles go to near corners on the other side. What is made of it has its
  /// volume; before such triangles were let be, none of these strips came to an end.
  void narrowStripsKeepTheirVolume() {
    constexpr double least = 1e-11, width = 50 * least;
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> along(0.1, 0.99), step(1e-4, 1e-3);
    int made = 0;
    for (int run = 0; run < 50; ++run) {
      const double x = along(random);
      const std::vector<Vec2> outline{{0, 0}, {1, 0}, {1, width}, {x, width}, {x - step(random), width}, {0, width}};
      const auto strip = separated(triangulated(turnedBy(prism(outline, 0, 1), randomTurn(random))).first, least);
      if (!strip) continue;
      ++made;
      COMPARE_NEAR(volumeOf(*strip), width, 2 * least);
    }
    QVERIFY(made >= 3);
  }

  /// Details as small as the distance leave nothing.
  void whatIsThinnerGoes() {
    const auto made = separated(triangulated(cuboid({0, 0, 0}, {1, 1, 1e-12})).first, 1e-10);
    QVERIFY(made);
    QCOMPARE(made->faceCount(), std::size_t{0});
  }

  void itIsCancelled() {
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(separated(triangulated(ballOf(3, 2)).first, 1e-9, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(MorphologySeparatedTest)
#include "morphology_separated_test.moc"
