#include <QTemporaryDir>

#include "geometry/planar/planar.h"
#include "minkowski/kernel/morph/control_centre.h"
#include "minkowski/kernel/morph/control_placement.h"
#include "support/command_line.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

double around(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

/// A triangle that is nowhere symmetric.
Region skewTriangle(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-50, 50), small(1, 9);
  const Vec2 corner(place(random), place(random));
  return polygonRegion({corner, corner + Vec2(10 + small(random), small(random)), corner + Vec2(-small(random), 12)});
}

}  // namespace

/// Control shapes scaled, turned and moved in a morph.
class MinkowskiPlacementTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingIsDoneByNothing() {
    const Region disc = circleRegion(5);
    QVERIFY(placed(disc, {}) == disc);
    const Region box = rectangleRegion({0.1, 0.3}, {4.7, 2.9});
    const Region moved = placed(box, {.turn = 360, .offset = {0.7, -0.2}});
    const Vec2 from = startPoint(box.loops[0].segments[2]), to = startPoint(moved.loops[0].segments[2]);
    QVERIFY(to == Vec2(from + Vec2(0.7, -0.2)));
  }

  void quartersOfATurnAreExact() {
    const Region box = rectangleRegion({0, 0}, {4, 2});
    for (const double turn : {90.0, -90.0, 270.0, 450.0}) {
      Vec2 low(1e9, 1e9), high(-1e9, -1e9);
      const Region turned = placed(box, {.turn = turn});
      for (const Segment& side : turned.loops.at(0).segments) {
        low = low.cwiseMin(startPoint(side));
        high = high.cwiseMax(startPoint(side));
      }
      QVERIFY(low == Vec2(1, -1) && high == Vec2(3, 3));
    }
    for (const double turn : {180.0, -180.0, 540.0})
      QVERIFY(startPoint(placed(box, {.turn = turn}).loops.at(0).segments.at(0)) ==
              Vec2(Vec2(4, 2) - startPoint(box.loops[0].segments[0])));
  }

  void theCentreStaysAndAreasGrowWithTheSquare() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> scale(0.1, 5), turn(-400, 400), place(-30, 30);
    for (int round = 0; round < 200; ++round) {
      const Region shape = skewTriangle(random);
      const Placement placement{scale(random), turn(random), {place(random), place(random)}};
      const Region result = placed(shape, placement);
      COMPARE_NEAR(area(result), placement.scale * placement.scale * area(shape), 1e-9 * (1 + area(result)));
      COMPARE_NEAR(around(result), placement.scale * around(shape), 1e-9 * (1 + around(result)));
      const Vec2 wanted = centreOf(shape) + placement.offset;
      COMPARE_NEAR((centreOf(result) - wanted).norm(), 0, 1e-9 * (1 + wanted.norm()));
      // A side is turned by just that angle.
      const auto along = [](const Region& r) -> Vec2 {
        return endPoint(r.loops[0].segments[0]) - startPoint(r.loops[0].segments[0]);
      };
      const Vec2 before = along(shape), after = along(result);
      const double turned = std::atan2(cross(before, after), before.dot(after)) * 180 / std::numbers::pi;
      COMPARE_NEAR(std::remainder(turned - placement.turn, 360), 0, 1e-7);
    }
  }

  /// A curve that is a whole outline has both of its ends in one point of the boundary.
  void theCentreOfOneClosedCurveIsInItsMiddle() {
    const Vec2 middle(7, -3);
    const Region oval{{Path{{ellipticArc(middle, {4, 3}, 0.4, 0.6, 2 * std::numbers::pi)}, true, {}, {}}}};
    COMPARE_NEAR((centreOf(oval) - middle).norm(), 0, 1e-2);
  }

  void arcsStayArcs() {
    const Region disc = placed(circleRegion(5), {.scale = 0.3, .turn = 17, .offset = {1, 2}});
    for (const Segment& segment : disc.loops.at(0).segments) {
      const auto* arc = std::get_if<Arc2>(&segment);
      QVERIFY(arc);
      COMPARE_NEAR(arc->radius, 1.5, 1e-12);
    }
  }

  void rubbishIsRefused() {
    VERIFY_ERROR(placed(circleRegion(5), {.scale = 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(placed(circleRegion(5), {.scale = -1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(placed(circleRegion(5), {.turn = NAN}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(placed(circleRegion(5), {.offset = {0, INFINITY}}), ErrorCode::InvalidParameter);
  }

  /// The second is 40 x 60 and lies on its side.
  void theMorphTakesScalesAndTurns() {
    const QStringList both{"morph", "rectangle:10:10", "rectangle:20:30", "--t", "0.5"};
    COMPARE_NEAR(blossom(both + QStringList{"--scales", "1,2", "--turns", "0,90"}).result("area"), 35 * 25, 1e-9);
    COMPARE_NEAR(blossom(both + QStringList{"--scales", "2"}).result("area"), 20 * 25, 1e-9);  // the others stay
    for (const QStringList& wrong :
         {QStringList{"--scales", "1,0"}, QStringList{"--scales", "1,1,1"}, QStringList{"--turns", "1,2,3"}}) {
      const Answer refused = blossom(both + wrong);
      QCOMPARE(refused.json["error"]["code"], Value("InvalidParameter"));
    }
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(MinkowskiPlacementTest)
#include "minkowski_placement_test.moc"
