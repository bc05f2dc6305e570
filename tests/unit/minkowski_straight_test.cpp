// Sides that hardly bend: arcs of circles a million times as large as the shape and more.
#include "geometry/planar/sums/curved_union.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;

namespace {

/// From one point to another one, leaving the chord by `bow` at most, to the right.
Segment bowed(const Vec2& from, const Vec2& to, double bow) { return arcBetween(from, to, 8 * bow / (to - from).norm()); }

Vec2 toTheLeft(const Vec2& v) { return {-v.y(), v.x()}; }

Path closedPath(std::vector<Segment> segments) { return {std::move(segments), true, {}, {}}; }

}  // namespace

class MinkowskiStraightTest : public QObject {
  Q_OBJECT

 private slots:
  /// Ends of such arcs differ from their neighbours by more than what counts as a side: sums had lines there that crossed.
  void sumsCanBeSummedAgain() {
    for (const double length : {500.0, 1000.0, 2000.0, 3000.0, 5000.0})
      for (const double bow : {1.1e-5, 1.5e-5, 2e-5, 3e-5, 5e-5, 1e-4})
        for (std::size_t bent = 0; bent < 3; ++bent) {
          const std::array<Vec2, 3> corners{Vec2(0, 0), Vec2(length, 0), Vec2(0.3 * length, 0.7 * length)};
          std::vector<Segment> sides;
          for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 &from = corners[k], &to = corners[(k + 1) % 3];
            sides.push_back(k == bent ? bowed(from, to, bow) : Segment(Line2{from, to}));
          }
          const Region triangle{{closedPath(sides)}};
          for (const Region& other : {rectangleRegion({-100, -100}, {100, 100}), circleRegion(100), triangle}) {
            const Region sum = minkowskiSum(std::vector{triangle, other}).region;
            QVERIFY2(largestGap(sum) < 1e-4, qPrintable(QString("length %1, bow %2").arg(length).arg(bow)));
            const double again = area(minkowskiSum(std::vector{sum, circleRegion(10)}).region);
            QVERIFY(again > area(sum));
          }
        }
  }

  /// A path that passes one corner twice, 1e-12 apart, beside such an arc: a corner of the sum was missing.
  void cornersPassedTwiceKeepTheirSides() {
    Path loop = polygonPath({{38, -11},
                             {28.8, -10.6},
                             {27.99724636045795, -20.355175364926254},
                             {0, 0},
                             {-0.41107255016686395, -9.622072489982543},
                             {-0.62252546802483266, -19.339809976443007},
                             {-1, -28},
                             {9, -29},
                             {18, -30},
                             {28, -29},
                             {27.997246360457925, -20.355175364925174},
                             {37.6, -20.5}});
    loop.segments[4] =
        Arc2{{37296.134077269773, -826.0366830006094}, 37305.479663567021, 3.1197063301827819, 0.00026055254837008366};
    const Region added = polygonRegion({{1, 0}, {0.6, 1}, {0, 1}});
    const Region sum = minkowskiSum(std::vector{Region{{loop}}, added}).region;
    double nearest = 1e9;
    for (const Path& path : sum.loops)
      for (const Segment& side : path.segments) nearest = std::min(nearest, (startPoint(side) - Vec2(29, -29)).norm());
    QVERIFY2(nearest < 1e-9, qPrintable(QString("the corner is off by %1").arg(nearest)));
    COMPARE_NEAR(area(sum), 705.8212, 1e-3);
  }

  /// Unions end each such side where the next one begins.
  void unionsAreClosed() {
    const double half = 171.3, bow = 1e-3;
    const Vec2 a(half, -half), b(half, half), c(-half, half), d(-half, -half);
    const Region block{{closedPath({bowed(a, b, bow), Line2{b, c}, bowed(c, d, bow), Line2{d, a}})}};
    for (const double thin : {1.1e-5, 1.5e-5, 3e-5, 1e-4}) {
      const Vec2 p(-717.96984505541752, -335.1574118467521), q(738.59308710793778, 286.86484762180226);
      const Region strip{{closedPath({bowed(p, q, thin), Line2{q, -p}, bowed(-p, -q, thin), Line2{-q, p}})}};
      Effort effort;
      const std::vector<SoundRegion> parts{soundRegion(block, {}, "the block"), soundRegion(strip, {}, "the strip")};
      const Region both = united(parts, Progress::none(), effort).region;
      QVERIFY2(largestGap(both) < 1e-4, qPrintable(QString("bow %1: a gap of %2").arg(thin).arg(largestGap(both))));
      const double again = area(soundRegion(both, {}, "a").region);
      COMPARE_NEAR(again, area(both), 1e-5 * length(both.loops.front()));
    }
  }

  /// Corners rounded by edges so short that each alone is no gap: together they are one.
  void shortEdgesBesideSuchSidesStay() {
    for (const double length : {100.0, 1000.0, 5000.0})
      for (const double edge : {1e-6, 1e-5, 4.9e-5})
        for (const int edges : {4, 100, 1000}) {
          const Region bent{
              {closedPath({bowed({0, 0}, {length, 0}, 1.2e-5), Line2{{length, 0}, {0.3 * length, 0.7 * length}},
                           Line2{{0.3 * length, 0.7 * length}, {0, 0}}})}};
          std::vector<Vec2> corners{{-50, -50}};
          const double radius = edge * edges / (std::numbers::pi / 2);
          for (int k = 0; k <= edges; ++k) {
            const double angle = std::numbers::pi / 2 * (k / static_cast<double>(edges) - 1);
            corners.emplace_back(50 - radius + radius * std::cos(angle), -50 + radius + radius * std::sin(angle));
          }
          corners.emplace_back(50, 50), corners.emplace_back(-50, 50);
          const Region sum = minkowskiSum(std::vector{bent, polygonRegion(corners)}).region;
          QVERIFY2(largestGap(sum) < 1e-4,
                   qPrintable(QString("%1 edges of %2: a gap of %3").arg(edges).arg(edge).arg(largestGap(sum))));
          COMPARE_NEAR(area(soundRegion(sum, {}, "a").region), area(sum), 1e-6 * area(sum));
        }
  }

  /// Two shapes that share part of a side on such a circle: their union has one side there.
  void partsOfOneSideBecomeOne() {
    int read = 0, all = 0;
    for (const double radius : {1e8, 1e9, 6e9, 1e10, 3e10})
      for (int k = 0; k < 20; ++k) {
        const double length = radius < 1e9 ? 1e3 : 1e4, turn = 0.31 * k, half = length / 2 / radius;
        const Vec2 out(std::cos(turn), std::sin(turn)), along = toTheLeft(out), centre = length * along / 2 - radius * out;
        const auto side = [&](double from, double to) { return Segment(Arc2{centre, radius, turn + from, to - from}); };
        const auto on = [&](double angle, double depth) -> Vec2 {
          return startPoint(side(angle, angle + 1e-9)) - depth * out;
        };
        const auto part = [&](double from, double to, double depth) {  // from a side inwards, or outwards below 0
          const Vec2 a = startPoint(side(from, to)), b = endPoint(side(from, to)), c = on(to, depth), d = on(from, depth);
          Path path = closedPath({side(from, to), Line2{b, c}, Line2{c, d}, Line2{d, a}});
          return Region{{depth > 0 ? path : reversed(path)}};
        };
        Effort effort;
        const std::vector<SoundRegion> parts{soundRegion(part(-half, half, 0.7 * length), {}, "a"),
                                             soundRegion(part(-0.4 * half, 0.7 * half, -0.3 * length), {}, "b")};
        const Region both = united(parts, Progress::none(), effort).region;
        ++all;
        try {
          const double expected = 0.7 * length * length + 0.55 * length * 0.3 * length;
          read += std::abs(area(soundRegion(both, {}, "a").region) - expected) < 1e-3 * expected;
        } catch (const Error&) {
        }
      }
    QCOMPARE(read, all);
  }

  /// Of two such sides in a row the one on the smaller circle knows where they meet.
  void theSmallerCircleKnowsWhereSidesMeet() {
    for (const double tolerance : {1e-4, 1e-5, 1e-6})
      for (const double bulge : {1e-13, 3e-13, 1e-12, 1e-11})
        for (const bool isSecond : {false, true})
          for (int k = 0; k < 10; ++k) {
            const Eigen::Rotation2Dd turn(0.3 * k);
            const auto at = [&](double x, double y) -> Vec2 { return turn * Vec2(x, y); };
            const double x = 0.31 + 0.037 * k, larger = tolerance * 1e-3;
            const auto side = [&](double from, double to, double of) {
              return bowed(at(from, 0), at(to, 0), of * (to - from) / 2);
            };
            const Region square{
                {closedPath({side(0, x, isSecond ? bulge : larger), side(x, 1, isSecond ? larger : bulge),
                             Line2{at(1, 0), at(1, 1)}, Line2{at(1, 1), at(0, 1)}, Line2{at(0, 1), at(0, 0)}})}};
            double found = 1;
            try {
              found = area(soundRegion(square, {.tolerance = tolerance}, "a").region);
            } catch (const Error& error) {
              QVERIFY(error.code() == ErrorCode::InvalidInput);  // the ends of its arcs are too far apart
            }
            COMPARE_NEAR(found, 1, 4 * tolerance);
          }
  }
};

BLOSSOM_TEST(MinkowskiStraightTest)
#include "minkowski_straight_test.moc"
