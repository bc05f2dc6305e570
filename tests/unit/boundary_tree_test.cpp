#include "geometry/planar/boundary_tree.h"

#include <cmath>

#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"
#include "support/curved_regions.h"
#include "support/lattice_regions.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"
#include "support/true_distance.h"

using namespace blossom;
using namespace blossom::test;

namespace {

int windingOfAll(const Region& region, const Vec2& p) {
  int sum = 0;
  for (const Path& loop : region.loops) sum += windingNumber(loop, p);
  return sum;
}

}  // namespace

class BoundaryTreeTest : public QObject {
  Q_OBJECT

 private slots:
  void aDiscInAFrame() {
    const BoundaryTree tree({{rectanglePath({-4, -3}, {4, 3}), reversed(circleRegion(1).loops.front())}});
    COMPARE_NEAR(tree.distanceTo({0.25, 0}), 0.75, 1e-15);
    COMPARE_NEAR(tree.distanceTo({7, 7}), 5, 1e-15);
    COMPARE_NEAR(tree.distanceTo({-3, 0.5}), 1, 1e-15);
    QCOMPARE(tree.windingNumber({0.25, 0}), 0);
    QCOMPARE(tree.windingNumber({-3, 0.5}), 1);
    QCOMPARE(tree.windingNumber({-5, 0}), 0);
    QVERIFY(std::isinf(BoundaryTree(Region{}).distanceTo({0, 0})));
  }

  /// The levels of corners are those of many others on a lattice.
  void likeAllSegmentsOneByOne() {
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
      const Region region = i % 2 ? latticeRegion(random) : anyRounded(random, 5);
      const BoundaryTree tree(region);
      const TrueDistance distance(region.loops);
      for (int k = 0; k < 40; ++k) {
        const bool onLattice = k % 2 == 0;
        const Vec2 p = onLattice ? Vec2(uniformInt(random, -4, 12), uniformInt(random, -4, 12))
                                 : Vec2(uniform(random, -12, 12), uniform(random, -12, 12));
        COMPARE_NEAR(tree.distanceTo(p), distance(p), 1e-7);
        if (distance(p) > 1e-6) QCOMPARE(tree.windingNumber(p), windingOfAll(region, p));
      }
    }
  }

  /// Around all points of a segment and touched by them on every side.
  void boxesAreTight() {
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
      const Arc2 arc{{uniform(random, -5, 5), uniform(random, -5, 5)},
                     uniform(random, 0.1, 5),
                     uniform(random, -7, 7),
                     uniform(random, -6.2, 6.2)};
      const Box2 box = boxAround(arc);
      Box2 points;
      for (const Vec2& p : flatten(Segment(arc), 1e-6)) points.extend(p);
      QVERIFY((box.min() - points.min()).cwiseAbs().maxCoeff() < 2e-6);
      QVERIFY((box.max() - points.max()).cwiseAbs().maxCoeff() < 2e-6);
      QVERIFY((box.min().array() <= points.min().array() + 1e-14).all());
      QVERIFY((box.max().array() >= points.max().array() - 1e-14).all());
    }
  }
};

BLOSSOM_TEST(BoundaryTreeTest)
#include "boundary_tree_test.moc"
