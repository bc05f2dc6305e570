#include "geometry/planar/planar.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <set>

#include "geometry/bspline/bspline.h"
#include "geometry/planar/outline_crossing.h"
#include "support/planar_points.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using blossom::test::seededRandom;

using test::Random;
using test::uniform;

namespace {

using std::numbers::pi;
using Affine = Eigen::Matrix<double, 2, 3>;

Path roundLoop(const Vec2& center, double radius, double sweep = 2 * pi) {
  return {{Arc2{center, radius, 0.3, sweep}}, true, {}, {}};
}

Path polylinePath(const std::vector<Vec2>& points) {
  Path path = polygonPath(points);
  path.segments.pop_back();
  path.closed = false;
  return path;
}

Path squarePath(const Vec2& low, double side) {
  return polygonPath({low, low + Vec2(side, 0), low + Vec2(side, side), low + Vec2(0, side)});
}

Spline2 randomSpline(Random& random) {
  const int degree = std::uniform_int_distribution(1, 6)(random);
  const int count = degree + 1 + std::uniform_int_distribution(0, 6)(random);
  Spline2 spline{degree, {}, {}};
  std::vector<double> inner;
  for (int i = 0; i < count - degree - 1; ++i) inner.push_back(uniform(random, 0.05, 0.95));
  std::sort(inner.begin(), inner.end());
  spline.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
  spline.knots.insert(spline.knots.end(), inner.begin(), inner.end());
  spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  for (int i = 0; i < count; ++i) {
    const double w = uniform(random, 0.3, 3);
    spline.poles.emplace_back(w * uniform(random, -10, 10), w * uniform(random, -10, 10), w);
  }
  return spline;
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

double distance(const Vec2& p, const std::vector<Vec2>& polyline) {
  double minimum = 1e300;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
    minimum = std::min(minimum, distance(p, polyline[i], polyline[i + 1]));
  return minimum;
}

/// Perimeter of an ellipse by the arithmetic-geometric mean (Gauss, Kummer): 2 pi (a^2 - sum 2^(n-1) c_n^2) / agm, an
/// independent way.
double ellipsePerimeter(double a, double b) {
  double x = a, y = b, factor = 0.5;
  double sum = factor * (a * a - b * b);
  for (int n = 0; n < 60 && std::abs(x - y) > 1e-17 * x; ++n) {
    const double c = (x - y) / 2;
    const double mean = (x + y) / 2;
    y = std::sqrt(x * y);
    x = mean;
    factor *= 2;
    sum += factor * c * c;
  }
  return 2 * pi * (a * a - sum) / x;
}

double distanceFromEllipse(const Vec2& p, double a, double b) { return std::abs(std::hypot(p.x() / a, p.y() / b) - 1); }

std::size_t loopsOf(const Region& region, bool outer) {
  return static_cast<std::size_t>(
      std::count_if(region.loops.begin(), region.loops.end(), [&](const Path& p) { return (signedArea(p) > 0) == outer; }));
}

}  // namespace

class PlanarTest : public QObject {
  Q_OBJECT
 private slots:
  void discIsExact() {
    const Path disc = roundLoop({3, -4}, 2.5);
    COMPARE_NEAR(signedArea(disc), pi * 6.25, 1e-13);
    COMPARE_NEAR(length(disc), 2 * pi * 2.5, 1e-13);
    COMPARE_NEAR(signedArea(roundLoop({3, -4}, 2.5, -2 * pi)), -pi * 6.25, 1e-13);
  }
  void farAwayNothingIsLost() { COMPARE_NEAR(signedArea(roundLoop({1e6, 1e6}, 1)), pi, 1e-9); }
  /// Between an arc and its chord, which is about 10: r^2 (s - sin s) / 2.
  void shallowArcsKeepTheirArea() {
    for (double sweep = 0.2; sweep > 1e-9; sweep /= 3) {
      const Arc2 arc{{3, -1}, 10 / sweep, 0.7, sweep};
      Path loop;
      loop.closed = true;
      loop.segments = {arc, Line2{endPoint(arc), startPoint(arc)}};
      const double expected = 100 * sweep / 12 * (1 - sweep * sweep / 20);
      COMPARE_NEAR(signedArea(loop), expected, expected * (std::pow(sweep, 4) / 500 + 1e-12));
      COMPARE_NEAR(signedArea(reversed(loop)), -expected, expected * (std::pow(sweep, 4) / 500 + 1e-12));
    }
  }

  void slotOfLinesAndArcs() {
    const double r = 2, l = 10;
    const Path slot{
        {Line2{{0, -r}, {l, -r}}, Arc2{{l, 0}, r, -pi / 2, pi}, Line2{{l, r}, {0, r}}, Arc2{{0, 0}, r, pi / 2, pi}},
        true,
        {},
        {}};
    COMPARE_NEAR(signedArea(slot), 2 * r * l + pi * r * r, 1e-12);
    COMPARE_NEAR(length(slot), 2 * l + 2 * pi * r, 1e-12);
    COMPARE_NEAR(signedArea(reversed(slot)), -(2 * r * l + pi * r * r), 1e-12);
  }
  void ellipticArcLiesOnItsEllipse() {
    Random random = seededRandom();
    for (int i = 0; i < 50; ++i) {
      const double a = uniform(random, 0.5, 9), ratio = uniform(random, 0.1, 2) * (i % 2 == 0 ? 1 : -1),
                   start = uniform(random, -7, 7);
      const double sweep = uniform(random, -2 * pi, 2 * pi);
      const Spline2 arc = ellipticArc({0, 0}, {a, 0}, ratio, start, sweep);
      for (int k = 0; k <= 20; ++k)
        COMPARE_NEAR(distanceFromEllipse(pointOf(arc, arc.knots.back() * k / 20), a, a * ratio), 0, 1e-13);
      const double end = start + sweep;
      COMPARE_NEAR((endPoint(arc) - Vec2(a * std::cos(end), a * ratio * std::sin(end))).norm(), 0, 1e-12);
      COMPARE_NEAR((startPoint(arc) - Vec2(a * std::cos(start), a * ratio * std::sin(start))).norm(), 0, 1e-12);
    }
  }
  void ellipseHasItsAreaAndPerimeter() {
    for (const double ratio : {1.0, 0.5, 0.1, 0.01}) {
      const Path ellipse{{ellipticArc({5, 6}, Vec2(3, 4), ratio, 0, 2 * pi)}, true, {}, {}};
      COMPARE_NEAR(signedArea(ellipse) / (pi * 25 * ratio), 1, 1e-12);
      COMPARE_NEAR(length(ellipse) / ellipsePerimeter(5, 5 * ratio), 1, 1e-12);
    }
  }
  void splineLengthAndAreaAgreeWithFinePolygons() {
    Random random = seededRandom();
    for (int i = 0; i < 20; ++i) {
      const Spline2 spline = randomSpline(random);
      constexpr int steps = 4000;  // in every span of knots, however short
      double polygonLength = 0, twiceArea = 0;
      Vec2 last = pointOf(spline, 0);
      for (std::size_t span = 0; span + 1 < spline.knots.size(); ++span) {
        const double from = spline.knots[span], to = spline.knots[span + 1];
        for (int k = 1; from < to && k <= steps; ++k) {
          const Vec2 p = pointOf(spline, k == steps ? to : from + (to - from) * k / steps);
          polygonLength += (p - last).norm();
          twiceArea += last.x() * p.y() - last.y() * p.x();
          last = p;
        }
      }
      const Path closed{{spline, Line2{endPoint(spline), startPoint(spline)}}, true, {}, {}};
      const Vec2 a = endPoint(spline), b = startPoint(spline);
      twiceArea += a.x() * b.y() - a.y() * b.x();
      COMPARE_NEAR(length(Segment(spline)) / polygonLength, 1, 1e-6);
      COMPARE_NEAR(signedArea(closed), twiceArea / 2, 1e-4);
      COMPARE_NEAR(length(reversed(Segment(spline))), length(Segment(spline)), 1e-10 * polygonLength);
    }
  }
  void flattenKeepsTheChord() {
    Random random = seededRandom();
    for (int i = 0; i < 40; ++i) {
      const Spline2 spline = randomSpline(random);
      const double chord = std::pow(10, uniform(random, -4, 0));
      const std::vector<Vec2> polyline = flatten(Segment(spline), chord);
      COMPARE_NEAR((polyline.front() - startPoint(spline)).norm() + (polyline.back() - endPoint(spline)).norm(), 0, 1e-12);
      for (int k = 0; k <= 100; ++k) QVERIFY(distance(pointOf(spline, k / 100.0), polyline) <= chord * (1 + 1e-9));

      const Arc2 arc{{1, 2}, uniform(random, 0.01, 50), uniform(random, -4, 4), uniform(random, -2 * pi, 2 * pi)};
      const std::vector<Vec2> arcLine = flatten(Segment(arc), chord);
      for (int k = 0; k <= 100; ++k) {
        const double angle = arc.start + arc.sweep * k / 100;
        QVERIFY(distance(arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle)), arcLine) <= chord * (1 + 1e-9));
      }
    }
    VERIFY_ERROR(flatten(Segment(Line2{{0, 0}, {1, 0}}), 0), ErrorCode::InvalidParameter);
  }
  void affineMapsScaleAreasByTheirDeterminant() {
    Random random = seededRandom();
    const Path shape{{Line2{{0, -2}, {10, -2}}, Arc2{{10, 0}, 2, -pi / 2, pi}, Line2{{10, 2}, {0, 2}},
                      ellipticArc({0, 0}, {0, 2}, 1.7, 0, pi)},
                     true,
                     {},
                     {}};
    for (int i = 0; i < 30; ++i) {
      Affine affine;
      for (int k = 0; k < 6; ++k) affine(k / 3, k % 3) = uniform(random, -3, 3);
      const Path image = transformed(shape, affine);
      const double determinant = affine(0, 0) * affine(1, 1) - affine(0, 1) * affine(1, 0);
      if (std::abs(determinant) < 0.01) continue;
      COMPARE_NEAR(signedArea(image), determinant * signedArea(shape), 1e-9);
      for (std::size_t k = 0; k < image.segments.size(); ++k)
        COMPARE_NEAR((endPoint(image.segments[k]) - startPoint(image.segments[(k + 1) % image.segments.size()])).norm(), 0,
                     1e-11);
    }
  }
  void arcsStayArcsUnderSimilarities() {
    const Arc2 arc{{1, 2}, 3, 0.4, 2};
    Affine mirror;
    mirror << 0, 2, 5, 2, 0, -1;  // scaled by two and reflected in the diagonal
    const Segment image = transformed(Segment(arc), mirror);
    QVERIFY(std::holds_alternative<Arc2>(image));
    const Arc2 mirrored = std::get<Arc2>(image);
    COMPARE_NEAR(mirrored.radius, 6, 1e-12);
    COMPARE_NEAR(mirrored.sweep, -2, 1e-12);
    COMPARE_NEAR((startPoint(image) - (mirror.leftCols<2>() * startPoint(Segment(arc)) + mirror.col(2))).norm(), 0, 1e-12);
    COMPARE_NEAR((endPoint(image) - (mirror.leftCols<2>() * endPoint(Segment(arc)) + mirror.col(2))).norm(), 0, 1e-12);
    Affine squeeze;
    squeeze << 1, 0, 0, 0, 0.5, 0;
    QVERIFY(std::holds_alternative<Spline2>(transformed(Segment(arc), squeeze)));
    Affine flat;
    flat << 1, 2, 0, 2, 4, 0;
    VERIFY_ERROR(transformed(Segment(arc), flat), ErrorCode::Degenerate);
  }
  void shuffledSegmentsJoinIntoTheirLoops() {
    Random random = seededRandom();
    std::vector<Path> pieces;
    double expected = 0;
    for (int loop = 0; loop < 200; ++loop) {
      std::vector<Vec2> points;
      const int corners = 3 + loop % 9;
      for (int k = 0; k < corners; ++k) {
        const double angle = 2 * pi * k / corners;
        points.push_back(Vec2(loop * 3, 0) + Vec2(std::cos(angle), std::sin(angle)));
      }
      expected += corners / 2.0 * std::sin(2 * pi / corners);
      for (int k = 0; k < corners; ++k) {
        const Vec2 noise(uniform(random, -4e-5, 4e-5), 0);
        Segment segment =
            Line2{points[static_cast<std::size_t>(k)] + noise, points[static_cast<std::size_t>((k + 1) % corners)]};
        if (random() % 2 == 0) segment = reversed(segment);
        pieces.push_back({{segment}, false, {}, {}});
      }
    }
    std::shuffle(pieces.begin(), pieces.end(), random);
    const Curves whole = joined({pieces, FillRule::EvenOdd});
    QCOMPARE(whole.paths.size(), std::size_t{200});
    double total = 0;
    for (const Path& path : whole.paths) {
      QVERIFY(path.closed);
      total += std::abs(signedArea(path));
      for (std::size_t k = 0; k < path.segments.size(); ++k)  // lines give way: no gap is left
        QVERIFY(endPoint(path.segments[k]) == startPoint(path.segments[(k + 1) % path.segments.size()]));
    }
    COMPARE_NEAR(total, expected, 0.1);
    QVERIFY(joined(whole).paths == whole.paths);
  }
  void gapsWiderThanTheJoiningDistanceStay() {
    const Path open = polylinePath({{0, 0}, {1, 0}, {1, 1}, {2e-4, 2e-4}});
    QVERIFY(!joined({{open}, FillRule::EvenOdd}).paths[0].closed);
    Tolerance wide;
    wide.joining = 1e-3;
    QVERIFY(joined({{open}, FillRule::EvenOdd}, wide).paths[0].closed);
  }
  void windingNumbersOfCurvedLoops() {
    Random random = seededRandom();
    const Path ellipse{{ellipticArc({0, 0}, {5, 0}, 0.3, 0.7, 2 * pi)}, true, {}, {}};
    const Path disc = roundLoop({0, 0}, 3, -2 * pi);
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p(uniform(random, -6, 6), uniform(random, -6, 6));
      QCOMPARE(windingNumber(ellipse, p), std::hypot(p.x() / 5, p.y() / 1.5) < 1 ? 1 : 0);
      QCOMPARE(windingNumber(disc, p), p.norm() < 3 ? -1 : 0);
    }
    // A hair from the curve, where a polygon would err.
    for (int i = 0; i < 500; ++i) {
      const double angle = uniform(random, 0, 2 * pi);
      QCOMPARE(windingNumber(disc, Vec2(std::cos(angle), std::sin(angle)) * (3 - 1e-12)), -1);
      QCOMPARE(windingNumber(disc, Vec2(std::cos(angle), std::sin(angle)) * (3 + 1e-12)), 0);
    }
  }
  void interiorPointsAreInside() {
    const std::vector<Path> shapes{squarePath({0, 0}, 1), roundLoop({9, 9}, 1e-3),
                                   polygonPath({{0, 0}, {100, 0}, {100, 1e-3}, {50, 5e-4}}),
                                   polygonPath({{0, 0}, {10, 0}, {10, 10}, {9.99, 10}, {9.99, 0.01}, {0, 0.01}})};
    for (const Path& path : shapes) QVERIFY(windingNumber(path, interiorPoint(path)) != 0);
    VERIFY_ERROR(interiorPoint(polygonPath({{0, 0}, {1, 0}})), ErrorCode::Degenerate);
  }
  /// Two squares that meet in a corner at half the height, some sides bowed: rounding makes several corners of it.
  void pathsThatPassACornerTwiceHaveAnInterior() {
    auto random = seededRandom();
    const std::vector<Vec2> corners{{2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}, {0, 0}, {1, 1}, {1, 0}, {2, 0}};
    const std::set<std::size_t> bowed{0, 2, 5, 7};
    for (int round = 0; round < 500; ++round) {
      const double size = uniform(random, 1, 3);
      Path path;
      path.closed = true;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 from = size * corners[k], to = size * corners[(k + 1) % corners.size()];
        if (bowed.contains(k))
          path.segments.emplace_back(arcBetween(from, to, uniform(random, 0.05, 0.4) * (uniformInt(random, 0, 1) ? 1 : -1)));
        else
          path.segments.emplace_back(Line2{from, to});
      }
      QCOMPARE(windingNumber(path, interiorPoint(path)), 1);
      QCOMPARE(components({{path}}).size(), std::size_t{1});
    }
  }
  /// Places on the curves themselves: whatever is told of them, it is told at once.
  void windingNumbersOfShallowArcs() {
    for (double sweep = 1e-3; sweep > 1e-12; sweep /= 3) {
      const Arc2 arc{{3, -1}, 10 / sweep, 0.7, sweep};
      Path loop;
      loop.closed = true;
      loop.segments = {arc, Line2{endPoint(arc), startPoint(arc)}};
      for (const double share : {0.3, 0.5, 0.77}) {
        const double angle = arc.start + share * sweep;
        (void)windingNumber(loop, arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle)));
      }
    }
  }
  /// Lines drawn there and back enclose nothing, however they are rounded.
  void linesThereAndBackBoundNothing() {
    auto random = seededRandom();
    for (int round = 0; round < 300; ++round) {
      std::vector<Vec2> corners(static_cast<std::size_t>(uniformInt(random, 2, 30)));
      for (Vec2& corner : corners) corner = Vec2(uniform(random, -20, 20), uniform(random, -20, 20));
      for (std::size_t k = corners.size() - 1; k > 1; --k) corners.push_back(corners[k - 1]);
      const Region region = toRegion(Curves{{polygonPath(corners), squarePath({50, 50}, 1)}, FillRule::NonZero});
      QCOMPARE(region.loops.size(), std::size_t{1});
    }
  }
  /// Most of a disc, and in it a hole that goes on as an island in the part that the disc leaves out.
  void holesThatTouchIslandsLieInTheirOutline() {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double by = quarter * pi / 2;
      const auto at = [&](double radius, double degrees) {
        return Vec2(radius * std::cos(degrees * pi / 180 + by), radius * std::sin(degrees * pi / 180 + by));
      };
      const Arc2 round{{0, 0}, 20, 4 * pi / 3 + by, 4 * pi / 3};
      Path outline;
      outline.closed = true;
      outline.segments = {Line2{{0, 0}, startPoint(round)}, round, Line2{endPoint(round), {0, 0}}};
      const Path hole = polygonPath({{0, 0}, at(18, 7), at(18, -7), {0, 0}, at(5, 130), at(5, 230)});
      const auto parts = components({{outline, hole}});
      QCOMPARE(parts.size(), std::size_t{1});
      QCOMPARE(parts[0].holes, (std::vector<std::size_t>{1}));
    }
  }
  void nestedLoopsAlternateByEvenOdd() {
    Curves curves{{}, FillRule::EvenOdd};
    for (int i = 5; i >= 1; --i) curves.paths.push_back(roundLoop({1, 1}, i, i % 2 == 0 ? 2 * pi : -2 * pi));
    const Region region = toRegion(curves);
    QCOMPARE(loopsOf(region, true), std::size_t{3});
    QCOMPARE(loopsOf(region, false), std::size_t{2});
    COMPARE_NEAR(area(region), pi * (25 - 16 + 9 - 4 + 1), 1e-12);
    const auto parts = components(region);
    QCOMPARE(parts.size(), std::size_t{3});
    QCOMPARE(parts[0].holes.size(), std::size_t{1});
    QCOMPARE(parts[2].holes.size(), std::size_t{0});
  }
  void nonZeroFillsNestedLoopsOfOneDirection() {
    Curves curves{{roundLoop({0, 0}, 3), roundLoop({0, 0}, 2), roundLoop({0, 0}, 1, -2 * pi)}, FillRule::NonZero};
    COMPARE_NEAR(area(toRegion(curves)), pi * 9, 1e-12);  // 1 + 1 - 1 is still not zero
    curves.paths[1] = roundLoop({0, 0}, 2, -2 * pi);
    COMPARE_NEAR(area(toRegion(curves)), pi * (9 - 4 + 1), 1e-12);
    const Curves clockwise{{reversed(squarePath({0, 0}, 2))}, FillRule::NonZero};
    COMPARE_NEAR(area(toRegion(clockwise)), 4, 1e-12);
  }
  void twoFacesWithHolesAreTwoComponents() {
    const Curves curves{{roundLoop({0.5, 0.5}, 0.2), squarePath({0, 0}, 1), squarePath({2, 0}, 1),
                         roundLoop({2.3, 0.3}, 0.1), roundLoop({2.7, 0.7}, 0.1)},
                        FillRule::EvenOdd};
    const Region region = toRegion(curves);
    COMPARE_NEAR(area(region), 2 - pi * (0.04 + 0.01 + 0.01), 1e-12);
    const auto parts = components(region);
    QCOMPARE(parts.size(), std::size_t{2});
    QCOMPARE(parts[0].outer, std::size_t{1});
    QCOMPARE(parts[0].holes, (std::vector<std::size_t>{0}));
    QCOMPARE(parts[1].holes, (std::vector<std::size_t>{3, 4}));
    QVERIFY(toRegion(toCurves(region)) == region);
  }
  /// An outline of thousands of scallops, some turned inwards, around thousands of holes with an island each: even-odd by
  /// the way they were made, whatever their order.
  void loopsByTheThousandLieInAnOutlineOfThousandsOfArcs() {
    auto random = seededRandom();
    constexpr int scallops = 6000, rows = 40;
    const double radius = 100, half = radius * std::sin(pi / scallops);
    Path outline;
    outline.closed = true;
    double scalloped = scallops * radius * radius * std::sin(2 * pi / scallops) / 2;  // the polygon of their ends
    for (int k = 0; k < scallops; ++k) {
      const double from = 2 * pi * k / scallops, to = 2 * pi * (k + 1) / scallops, middle = (from + to) / 2;
      const Vec2 centre = radius * std::cos(pi / scallops) * Vec2(std::cos(middle), std::sin(middle));
      const bool outwards = k % 3 != 0;
      outline.segments.push_back(Arc2{centre, half, outwards ? middle - pi / 2 : middle + 3 * pi / 2, outwards ? pi : -pi});
      scalloped += (outwards ? 1 : -1) * pi * half * half / 2;
    }
    Curves curves{{outline}, FillRule::EvenOdd};
    const double hole = 0.7, island = 0.3, pitch = 2 * 0.6 * radius / rows;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < rows; ++j) {
        const Vec2 at = pitch * Vec2(i - (rows - 1) / 2.0, j - (rows - 1) / 2.0);
        curves.paths.push_back(roundLoop(at, hole));
        curves.paths.push_back(squarePath(at - Vec2(island / 2, island / 2), island));
      }
    std::shuffle(curves.paths.begin(), curves.paths.end(), random);
    const Region region = toRegion(curves);
    constexpr int holes = rows * rows;
    QCOMPARE(loopsOf(region, true), std::size_t{1 + holes});
    QCOMPARE(loopsOf(region, false), std::size_t{holes});
    COMPARE_NEAR(area(region), scalloped + holes * (island * island - pi * hole * hole), 1e-9 * scalloped);
    std::size_t most = 0;
    for (const RegionComponent& part : components(region)) most = std::max(most, part.holes.size());
    QCOMPARE(most, std::size_t{holes});
  }
  void openOutlinesAreNamedWithTheirPlace() {
    const Curves curves{{polylinePath({{12.5, 0}, {20, 0}, {20, 7}, {13, 1}})}, FillRule::EvenOdd};
    try {
      toRegion(curves);
      QFAIL("an open outline made a region");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::InvalidInput);
      QVERIFY2(error.message().find("(12.5, 0)") != std::string::npos, error.what());
      QVERIFY2(error.message().find("(13, 1)") != std::string::npos, error.what());
    }
    VERIFY_ERROR(toRegion({}), ErrorCode::InvalidInput);
    // The halves of an 8 cancel out; beside a square it must not vanish without a word.
    const Path apart = polygonPath({{20, 0}, {30, 0}, {30, 10}, {20, 10}}),
               eight = polygonPath({{0, 0}, {10, 10}, {10, 0}, {0, 10}});
    VERIFY_ERROR(toRegion({{apart, eight}, FillRule::EvenOdd}), ErrorCode::InvalidInput);
    const Path thereAndBack = polygonPath({{0, 0}, {5, 1}, {9, 0}, {5, 1}});
    COMPARE_NEAR(area(toRegion({{apart, thereAndBack}, FillRule::EvenOdd})), 100, 1e-12);
    VERIFY_ERROR(toRegion({{polygonPath({{0, 0}, {5, 0}})}, FillRule::EvenOdd}), ErrorCode::InvalidInput);
  }

  /// Where two outlines cross, however shallow, even-odd leaves empty what both enclose; their union does not.
  void crossingsAgainstTheFillRuleAreFound() {
    for (const double degrees : {60.0, 4.0, 2.5, 0.5, 0.1}) {
      const double rise = 495 * std::tan(degrees * pi / 180);
      for (const double turn : {0.0, 0.3, 1.1}) {
        const auto turned = [&](const std::vector<Vec2>& points) {
          std::vector<Vec2> result;
          for (const Vec2& p : points) result.push_back(Eigen::Rotation2Dd(turn) * p);
          return polygonPath(result);
        };
        const Path plate = turned({{0, 0}, {1000, 0}, {1000, 500}, {0, 500}}),
                   lens =
                       turned({{5, 500 + rise / 7}, {500, 500 - 6 * rise / 7}, {995, 500 + rise / 7}, {995, 900}, {5, 900}}),
                   beside = turned({{0, 500}, {1000, 500}, {800, 900}, {200, 900}});
        const auto misfilled = [&](const Path& other, FillRule rule) {
          const Curves drawing{{plate, other}, rule};
          return misfilledCrossing(drawing, toRegion(drawing)).has_value();
        };
        QVERIFY2(misfilled(lens, FillRule::EvenOdd), qPrintable(QString::number(degrees)));
        // A loop whose inside lies within the other is taken for one within it, and left out: then the union lacks a part.
        const bool bothTaken = toRegion({{plate, lens}, FillRule::NonZero}).loops.size() == 2;
        QCOMPARE(misfilled(lens, FillRule::NonZero), !bothTaken);
        QVERIFY(bothTaken || degrees > 45);
        QVERIFY(misfilled(reversed(lens), FillRule::NonZero));
        QVERIFY(!misfilled(beside, FillRule::EvenOdd));
      }
    }
  }

  /// Two shapes on both sides of one long curve touch all along it, which is soon told from crossing.
  void shapesOnBothSidesOfACurveOnlyTouch() {
    const Spline2 curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{100, 100, 1}, {300, 50, 1}, {600, 350, 1}, {900, 100, 1}}};
    const auto shape = [&](double y) {
      return Path{
          {curve, Line2{{900, 100}, {900, y}}, Line2{{900, y}, {100, y}}, Line2{{100, y}, {100, 100}}}, true, {}, {}};
    };
    const Curves apart{{shape(400), shape(-50)}, FillRule::EvenOdd};
    QVERIFY(!misfilledCrossing(apart, toRegion(apart)));
  }
};

BLOSSOM_TEST(PlanarTest)
#include "planar_test.moc"
