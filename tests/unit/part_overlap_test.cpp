/// Whether two parts hold the same space: plates that are thin for their size, and parts that only touch.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "geometry/crossing/part_overlap.h"
#include "support/crossing_shapes.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

TopoDS_Shape block(const Vec3& low, const Vec3& size) {
  return BRepPrimAPI_MakeBox(gp_Pnt(low.x(), low.y(), low.z()), size.x(), size.y(), size.z()).Shape();
}

TopoDS_Shape cylinder(double radius, double from, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, from), gp::DZ()), radius, height).Shape();
}

}  // namespace

class PartOverlapTest : public QObject {
  Q_OBJECT

  std::mt19937_64 random_;

  /// The place lies in both boxes.
  static void verifyWithin(const std::optional<Vec3>& place, const Vec3& low, const Vec3& high) {
    QVERIFY(place);
    constexpr double rounding = 1e-9;
    QVERIFY((place->array() >= low.array() - rounding).all() && (place->array() <= high.array() + rounding).all());
  }

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  void platesInOnePlaneOverlap() {
    for (const double thick : {0.1, 0.5, 2.2, 20.0}) {
      const Vec3 size(1000, 500, thick);
      const double shift = uniform(random_, 10, 900), aside = uniform(random_, -400, 400);
      verifyWithin(overlapOf(block({0, 0, 0}, size), block({shift, 0, 0}, size)), {shift, 0, 0}, size);
      verifyWithin(overlapOf(block({0, 0, 0}, size), block({shift, aside, 0}, size)), {shift, std::max(aside, 0.0), 0},
                   {1000, 500 + std::min(aside, 0.0), thick});
      QVERIFY(overlapOf(block({0, 0, 0}, size), block({0, 0, 0}, size)));
    }
  }

  void platesWithinBlocksOverlap() {
    for (const double thick : {0.1, 0.5, 2.2}) {
      const Vec3 low(uniform(random_, 10, 40), uniform(random_, 10, 40), uniform(random_, 10, 40));
      const Vec3 size(900, 400, thick);
      verifyWithin(overlapOf(block({0, 0, 0}, {1000, 500, 100}), block(low, size)), low, low + size);
      verifyWithin(overlapOf(block(low, size), block({0, 0, 0}, {1000, 500, 100})), low, low + size);
    }
    // A thin disc in a round block.
    QVERIFY(overlapOf(cylinder(500, 0, 100), cylinder(400, 50, 0.3)));
  }

  void partsThatTouchDoNotOverlap() {
    for (const double thick : {0.1, 2.2, 20.0}) {
      const Vec3 size(1000, 500, thick);
      QVERIFY(!overlapOf(block({0, 0, 0}, size), block({0, 0, thick}, size)));
      QVERIFY(!overlapOf(block({0, 0, 0}, size), block({uniform(random_, 10, 900), 0, thick}, size)));
      QVERIFY(!overlapOf(block({0, 0, 0}, size), block({1000, uniform(random_, -100, 100), 0}, size)));
      QVERIFY(!overlapOf(block({0, 0, 0}, size), block({0, 500, 0}, size)));
      // Side by side, not quite flush.
      QVERIFY(!overlapOf(block({0, 0, 0}, size), block({1000 - 1e-4, 0, 0}, size)));
    }
    const double radius = uniform(random_, 5, 20);
    const TopoDS_Shape holed = BRepAlgoAPI_Cut(block({-30, -30, 0}, {60, 60, 10}), cylinder(radius, 0, 10)).Shape();
    QVERIFY(!overlapOf(holed, cylinder(radius, 0, 10)));
    QVERIFY(!overlapOf(holed, cylinder(radius, 3, 20)));
    QVERIFY(!overlapOf(holed, cylinder(radius - 0.05, -5, 20)));
    QVERIFY(overlapOf(holed, cylinder(radius + 0.05, 3, 20)));
    // Rods side by side, and a rod on a plate.
    const TopoDS_Shape rod = cylinder(radius, 0, 40);
    QVERIFY(!overlapOf(rod, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2 * radius, 0, 0), gp::DZ()), radius, 40).Shape()));
    QVERIFY(!overlapOf(rod, block({radius, -30, 0}, {3, 60, 40})));
  }
};

BLOSSOM_TEST(PartOverlapTest)
#include "part_overlap_test.moc"
