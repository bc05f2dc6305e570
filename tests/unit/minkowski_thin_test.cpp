// Thin shapes, and room that is hardly wider than the tolerance.
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "minkowski/kernel/flattening.h"
#include "minkowski/kernel/region_sum.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::minkowski;
using namespace blossom::test;

namespace {

using std::numbers::pi;

double perimeterOfEllipse(double a, double b) { return 4 * a * std::comp_ellint_2(std::sqrt(1 - b * b / (a * a))); }

double sumArea(const Region& a, const Region& b) { return area(minkowskiSum(std::vector{a, b}).region); }

}  // namespace

class MinkowskiThinTest : public QObject {
  Q_OBJECT
 private slots:
  /// Steiner: area + perimeter r + pi r^2.
  void thinShapesAreDrawnAsFinelyAsTheirThicknessAsks() {
    for (const double b : {1e-3, 1e-2, 0.1, 1.0, 9.0})
      for (const double r : {1e-3, 1e-2, 1.0}) {
        const double exact = pi * 10 * b + perimeterOfEllipse(10, b) * r + pi * r * r;
        COMPARE_NEAR(sumArea(ellipseRegion(10, b), circleRegion(r)) / exact, 1, 1e-3);
      }
  }
  void thicknessIsThatOfStripsAndDiscs() {
    COMPARE_NEAR(thicknessOf(circleRegion(3)), 3, 1e-12);
    COMPARE_NEAR(thicknessOf(rectangleRegion({0, 0}, {1e4, 2})), 2, 1e-3);
    COMPARE_NEAR(defaultTolerance(circleRegion(3)), 6e-4, 1e-12);
    COMPARE_NEAR(defaultTolerance(circleRegion(1e4)), 0.01, 0);
  }
  void aToleranceTooCoarseForTheThicknessIsRefused() {
    const std::vector<Region> shapes{ellipseRegion(10, 0.01), circleRegion(1)};
    VERIFY_ERROR(minkowskiSum(shapes, {.tolerance = 0.05}), ErrorCode::InvalidParameter);
    QVERIFY(area(minkowskiSum(shapes, {.tolerance = 1e-3}).region) > 0);
  }
  /// A disc in a disc hardly larger: what is lost of the room is told.
  void roomHardlyWiderThanTheToleranceIsTold() {
    for (const double inner : {4.0, 4.8, 4.99, 4.999}) {
      const double exact = pi * (5 - inner) * (5 - inner);
      const auto result = minkowskiDifference(std::vector{circleRegion(5), circleRegion(inner)});
      const double room = area(result.region);
      QVERIFY(room <= exact * (1 + 1e-9));
      QVERIFY(room > 0.95 * exact || !result.warnings.empty());
      QCOMPARE(result.warnings.empty(), inner < 4.9);  // with a tolerance of 0.001 mm
    }
  }
  void wordsOfNoRoomTellHowCloselyItWasLookedFor() {
    try {
      (void)minkowskiDifference(std::vector{circleRegion(5), circleRegion(5)});
      QFAIL("there is no room");
    } catch (const Error& error) {
      QVERIFY2(error.message().find("within ") != std::string::npos, error.message().c_str());
    }
  }
};

BLOSSOM_TEST(MinkowskiThinTest)
#include "minkowski_thin_test.moc"
