#include "minkowski/kernel/convex_core.h"
#include "minkowski/kernel/flattening.h"
#include "minkowski/kernel/snapped_operands.h"
#include "minkowski/kernel/winding/winding_faces.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

/// An outline with many corners about a circle, some with a hole or a second part.
Region manyCorners(Random& random, double reach) {
  const auto ring = [&](const Vec2& at, double inner, double outer, int corners) {
    std::vector<Vec2> points;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * (k + uniform(random, 0, 0.8)) / corners;
      points.push_back(at + uniform(random, inner, outer) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
  };
  Region region = polygonRegion(ring({0, 0}, 0.7 * reach, reach, uniformInt(random, 200, 400)));
  if (uniformInt(random, 0, 2) == 0) {
    std::vector<Vec2> hole = ring({0.1 * reach, 0}, 0.2 * reach, 0.4 * reach, 40);
    std::reverse(hole.begin(), hole.end());
    region.loops.push_back(polygonPath(hole));
  }
  if (uniformInt(random, 0, 2) == 0) region.loops.push_back(polygonPath(ring({3 * reach, 0}, 0.2 * reach, reach, 30)));
  return region;
}

}  // namespace

/// What lies inside of a sum need not be looked at.
class MinkowskiCoreTest : public QObject {
  Q_OBJECT

 private slots:
  void theCoreChangesNothing() {
    Random random = seededRandom();
    int cores = 0;
    for (int round = 0; round < 25; ++round) {
      const Polygons a = flattened(manyCorners(random, 10), {}, "shape 1"),
                     b = flattened(manyCorners(random, uniform(random, 0.5, 10)), {}, "shape 2");
      const SnappedOperands operands = snappedTogether(a, b);
      const std::optional<ConvexCore> core = coreOfSum(operands.a, operands.b);
      if (!core) continue;
      ++cores;
      const auto all = convolution(operands.a, operands.b),
                 fewer = convolution(operands.a, operands.b, Progress::none(), Effort(), nullptr, &*core);
      QVERIFY(fewer.size() < all.size());
      const Polygons wanted = windingFaces(all), found = windingFaces(fewer);
      QCOMPARE(found.size(), wanted.size());
      QCOMPARE(edgeCount(found), edgeCount(wanted));
      COMPARE_NEAR(minkowski::area(found), minkowski::area(wanted), 1e-12 * minkowski::area(wanted));
    }
    QVERIFY2(cores > 15, qPrintable(QString::number(cores)));
  }

  void fewCornersHaveNone() {
    const Polygons square = flattened(rectangleRegion({0, 0}, {1, 1}), {}, "shape");
    const SnappedOperands operands = snappedTogether(square, square);
    QVERIFY(!coreOfSum(operands.a, operands.b));
  }
};

BLOSSOM_TEST(MinkowskiCoreTest)
#include "minkowski_core_test.moc"
