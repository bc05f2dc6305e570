#include <fmt/format.h>

#include "geometry/planar/boundary_tree.h"
#include "geometry/planar/polygons/sound_region.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "geometry/planar/winding/touching_loops.h"
#include "minkowski/kernel/region_repeat.h"
#include "support/regions.h"
#include "support/segment_counts.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

Region turned(const Region& region, double angle) {
  Eigen::Matrix<double, 2, 3> turn;
  turn << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0;
  Region image = region;
  for (Path& loop : image.loops) loop = transformed(loop, turn);
  return image;
}

Region twoDiscs() { return {{circleInArcs(10, 2, {-10, 0}), circleInArcs(10, 2, {10, 0})}}; }

}  // namespace

/// Loops that touch one another in points, and what is nearly the same twice.
class MinkowskiTouchingTest : public QObject {
  Q_OBJECT

 private slots:
  void loopsAreSortedByContainment() {
    using planar::GridLoop;
    const auto square = [](std::int64_t x, std::int64_t y, std::int64_t side) {
      return GridLoop{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
    };
    const auto diamond = GridLoop{{5, 0}, {10, 5}, {5, 10}, {0, 5}};  // all of its corners on the first square
    const auto around = planar::touchingLoopsAround({square(0, 0, 10), diamond, square(10, 10, 5), square(4, 4, 2)});
    QVERIFY(around.has_value());
    QVERIFY(!(*around)[0] && (*around)[1] == 0u && !(*around)[2] && (*around)[3] == 1u);
    QVERIFY(!planar::touchingLoopsAround({square(0, 0, 10), square(0, 0, 10)}).has_value());
  }

  void arcsStayArcs() {
    const Region disc = circleRegion(1);
    for (const double angle : {0.0, 0.3, 1.0}) {
      const Region discs = turned(twoDiscs(), angle);
      // The union of two discs of 11, 20 apart.
      const double half = std::acos(10 / 11.0), lens = 121 * (2 * half - std::sin(2 * half));
      const Region sum = minkowskiSum(std::vector{discs, disc}).region;
      QVERIFY2(std::abs(area(sum) - (242 * pi - lens)) < 1e-9, fmt::format("{}", area(sum) - (242 * pi - lens)).c_str());
      QCOMPARE(segmentCountOf<Line2>(sum), std::size_t{0});
      QVERIFY(segmentCount(sum) <= 6);
      const Region hull = regionHull(discs, std::nullopt);
      QVERIFY(std::abs(area(hull) - (100 * pi + 400)) < 1e-9);
      QCOMPARE(segmentCountOf<Line2>(hull), std::size_t{2});
    }
  }

  /// The thin horns beside the place where a hole touches its outline belong to the region, whatever is added to it.
  void holesMayTouchTheirOutline_data() {
    QTest::addColumn<double>("outer");
    QTest::addColumn<double>("hole");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("disc");
    QTest::addColumn<double>("tolerance");
    for (const auto& [outer, hole] : {std::pair{10.0, 4.0}, {10.0, 5.0}, {1000.0, 900.0}, {1000.0, 500.0}, {10.0, 9.9}})
      for (const double start : {0.0, 1.0, 2.7})
        for (const double disc : {1e-3, 5e-3, 0.1})
          for (const double tolerance : {0.0, 1e-3, 1e-4})
            QTest::addRow("%g-%g %g %g %g", outer, hole, start, disc, tolerance)
                << outer << hole << start << disc * outer << tolerance;
  }
  void holesMayTouchTheirOutline() {
    QFETCH(double, outer);
    QFETCH(double, hole);
    QFETCH(double, start);
    QFETCH(double, disc);
    QFETCH(double, tolerance);
    const Region region{
        {circleInArcs(outer, 2, Vec2::Zero(), start), reversed(circleInArcs(hole, 2, {outer - hole, 0}, -start))}};
    const std::optional<double> within = tolerance > 0 ? std::optional(tolerance) : std::nullopt;
    const Region sum = minkowskiSum(std::vector{region, circleRegion(disc)}, {.tolerance = within}).region;
    const double left = hole > disc ? hole - disc : 0, grown = outer + disc;
    const double off = area(sum) - (grown * grown - left * left) * pi;
    QVERIFY2(std::abs(off) < 1e-9 * outer * outer,
             fmt::format("{} too much, {} lines, {} segments", off, segmentCountOf<Line2>(sum), segmentCount(sum)).c_str());
    QCOMPARE(sum.loops.size(), std::size_t{2});
    QCOMPARE(segmentCountOf<Line2>(sum), std::size_t{0});
  }

  /// Two half circles that end in a cusp: its tip is part of the region.
  void theTipOfAHornIsKept() {
    Path outline;
    outline.segments = {Arc2{{0, 0}, 10, 0, pi}, Line2{{-10, 0}, {-8, 0}}, Arc2{{1, 0}, 9, pi, -pi}};
    outline.closed = true;
    const Region horn{{outline}};
    for (const double disc : {0.01, 0.05, 0.5}) {
      const BoundaryTree around(minkowskiSum(std::vector{horn, circleRegion(disc)}).region);
      for (int k = -8; k <= 8; ++k) {
        const Vec2 beside = Vec2(10, 0) + 0.999 * disc * Vec2(std::cos(0.2 * k), std::sin(0.2 * k));
        QVERIFY2(around.windingNumber(beside) == 1, fmt::format("{} {}", disc, k).c_str());
      }
    }
  }

  /// Wherever the drawing of the arcs begins, at the contact or elsewhere.
  void roomOfTouchingLoopsHasArcs() {
    const Region disc = circleRegion(1);
    const auto room = [&](const Region& shape) { return minkowskiDifference(std::vector{shape, disc}).region; };
    for (const double start : {0.0, 0.3}) {
      const Region discs{{circleInArcs(5, 2, {-5, 0}, start), circleInArcs(5, 2, {5, 0}, pi + start)}};
      QVERIFY2(std::abs(area(room(discs)) - 32 * pi) < 1e-4, fmt::format("{}", area(room(discs)) - 32 * pi).c_str());
      QVERIFY2(segmentCount(room(discs)) <= 8, fmt::format("{} segments", segmentCount(room(discs))).c_str());
    }
    const Region holed{{polygonPath({{0, 0}, {20, 0}, {20, 10}, {0, 10}}), reversed(circleInArcs(3, 2, {10, 3}, -pi / 2))}};
    const Region sides = room(holed);
    // What a disc of 1 leaves between the hole, grown to 4, and the other sides: the rectangle less the circle above y = 1.
    const double below = 16 * std::acos(2 / 4.0) - 2 * std::sqrt(12.0);
    QVERIFY2(std::abs(area(sides) - (18 * 8 - (16 * pi - below))) < 1e-9, fmt::format("{}", area(sides)).c_str());
    QCOMPARE(segmentCountOf<Line2>(sides), std::size_t{5});
  }

  /// In the midst of arcs of both, where a chord of the outline cuts into the hole.
  void aRoundHoleMayTouchItsOutlineAnywhere() {
    for (int k = 0; k < 24; ++k) {
      const double angle = 0.1 + k * pi / 12;
      const Vec2 middle = 5 * Vec2(std::cos(angle), std::sin(angle));
      const Region region{{circleInArcs(10, 2), reversed(circleInArcs(5, 2, middle, 0.4 + 0.9 * k))}};
      const Region sum = minkowskiSum(std::vector{region, circleRegion(2)}).region;
      QVERIFY2(std::abs(area(sum) - (144 - 9) * pi) < 5e-3, fmt::format("{} {}", k, area(sum) - 135 * pi).c_str());
      const Region room = minkowskiDifference(std::vector{region, circleRegion(1)}).region;
      // A disc of 9 less one of 6, whose centres are 5 apart.
      const auto lens = [](double r, double s, double d) {
        const double x = (d * d + r * r - s * s) / (2 * d), y = d - x;
        return r * r * std::acos(x / r) - x * std::sqrt(r * r - x * x) + s * s * std::acos(y / s) -
               y * std::sqrt(s * s - y * y);
      };
      QVERIFY2(std::abs(area(room) - (81 * pi - lens(9, 6, 5))) < 5e-3, fmt::format("{}", area(room)).c_str());
    }
  }

  void onlyRoomOfPolygonsMayBeLarger() {
    const auto warnings = [](double radius) {
      return minkowskiDifference(std::vector{circleRegion(5), circleRegion(radius)}).warnings.size();
    };
    QCOMPARE(warnings(4.9999999), std::size_t{0});
  }

  void roomOfDiscsIsADisc() {
    for (const double size : {1.0, 1e3, 1e5, 1e6}) {
      const Region a{{circleInArcs(size + 1, 3, {size, 2})}}, b{{circleInArcs(size, 2, {-1, 5}, 0.3)}};
      const Region room = roomInside(std::vector{a, b}, {}, Progress::none());
      QVERIFY(std::abs(area(room) - pi) < 1e-8);
      QVERIFY((std::get<Arc2>(room.loops.front().segments.front()).center - Vec2(size + 1, -3)).norm() < 1e-9);
    }
    QVERIFY(roomInside(std::vector{circleRegion(5), circleRegion(5)}, {}, Progress::none()).loops.empty());
  }
};

BLOSSOM_TEST(MinkowskiTouchingTest)
#include "minkowski_touching_test.moc"
