// Thin and tiny shapes, and room that is hardly wider than the tolerance.
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::planar;
using namespace blossom::test;

namespace {

using std::numbers::pi;

double perimeterOfEllipse(double a, double b) { return 4 * a * std::comp_ellint_2(std::sqrt(1 - b * b / (a * a))); }

double sumArea(const Region& a, const Region& b) { return area(minkowskiSum(std::vector{a, b}).region); }

}  // namespace

class MinkowskiThinTest : public QObject {
  Q_OBJECT
 private slots:
  /// However small a part is, its sum with the other set is as large as that.
  void specksCountAsPoints() {
    const Region l = polygonRegion({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});
    for (double size = 1e-3; size > 1e-18; size /= 10) {
      const Region speck = polygonRegion({{50, 0}, {50 + size, 0}, {50 + size / 3, size / 3}, {50, size}});
      const double rounding = 20 * size + 1e-7;
      if (size >= 1e-5) COMPARE_NEAR(sumArea(l, speck), 7, rounding);
      Polygons star;
      for (int k = 0; k < 10; ++k)
        star.resize(1), star[0].outer.push_back((k % 2 == 0 ? size : size / 3) *
                                                Vec2(std::cos(2 * pi * k / 10), std::sin(2 * pi * k / 10)));
      const Polygons large{{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, {}}};
      COMPARE_NEAR(planar::area(sum(large, star)), 7, rounding);
      Polygons both = star;
      both.push_back({{{50, 0}, {60, 0}, {60, 10}, {50, 10}}, {}});
      COMPARE_NEAR(planar::area(sum(large, both)), 7 + 14 * 14 - 3 * 3, 10 * rounding);
    }
  }

  /// So is what rounding to the common grid makes a line, straight or bent.
  void partsThinnerThanTheGridAreLines() {
    const Polygons square{{{{-32, -32}, {32, -32}, {32, 32}, {-32, 32}}, {}}},
        l{{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, {}}};
    const double thin = 1e-14;
    for (const double length : {5e-9, 1.0, 20.0}) {
      const Polygons strip{{{{0, -thin}, {length, -thin}, {length, thin}, {0, thin}}, {}}};
      COMPARE_NEAR(planar::area(sum(square, strip)), 64 * (64 + length), 1e-7);
      Effort unlimited;
      COMPARE_NEAR(planar::area(difference(square, strip, Progress::none(), unlimited)), 64 * (64 - length), 1e-7);
      const Polygons upright{{{{-thin, 0}, {thin, 0}, {thin, -length}, {-thin, -length}}, {}}};
      COMPARE_NEAR(planar::area(sum(l, upright)), 7 + 4 * length, 1e-7);
    }
    const Polygons hook{{{{0, 0}, {20, 0}, {20, 10}, {20 - thin, 10}, {20 - thin, thin}, {0, thin}}, {}}};
    COMPARE_NEAR(planar::area(sum(square, hook)), 64 * 64 + 64 * 30, 1e-7);
  }

  /// A slot exactly as wide as what enters it, after rounding one unit wider, lies below a hole.
  void aHoleAboveASlotIsNotLost() {
    const double u = std::ldexp(1.0, -40);
    const Polygons plate{
        {{{-32, -32}, {32, -32}, {32, 32}, {-32, 32}},
         {{{-8 - 2 * u, -28}, {-8 - 2 * u, -10}, {8 - u, -10}, {8 - u, -28}}, {{0, -7}, {-19, 12}, {0, 31}, {19, 12}}}}},
        square{{{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}, {}}};
    // The diamond |x| + |y - 12| <= 19 leaves |x| + |y - 12| <= 3.
    COMPARE_NEAR(planar::area(sum(plate, square)), 80 * 80 - 2 * 3 * 3, 1e-6);
  }

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
  /// A disc in a disc hardly larger has its true room, of which nothing is said.
  void roomHardlyWiderThanTheToleranceIsTheTrueOne() {
    for (const double inner : {4.0, 4.8, 4.99, 4.999}) {
      const double exact = pi * (5 - inner) * (5 - inner);
      const auto result = minkowskiDifference(std::vector{circleRegion(5), circleRegion(inner)});
      const double room = area(result.region);
      QVERIFY(std::abs(room - exact) <= 1e-9 * exact && result.warnings.empty());
    }
  }
  void wordsOfNoRoomTellHowCloselyItWasLookedFor() {
    const auto none = minkowskiDifference(std::vector{circleRegion(5), circleRegion(5)});
    QVERIFY(none.region.loops.empty() && none.warnings.size() == 1);
    QVERIFY2(none.warnings.front().find("within ") != std::string::npos, none.warnings.front().c_str());
  }
};

BLOSSOM_TEST(MinkowskiThinTest)
#include "minkowski_thin_test.moc"
