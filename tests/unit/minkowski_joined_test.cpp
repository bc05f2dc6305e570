// Sides that parts share where they are hard to recognise, and loops that must not be taken for such parts.
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/outlines.h"
#include "support/regions.h"
#include "support/segment_counts.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// Its parts before and after a parameter, by de Casteljau's algorithm.
std::array<std::array<Vec2, 4>, 2> cutAt(double t, const std::array<Vec2, 4>& p) {
  const auto mix = [&](const Vec2& a, const Vec2& b) { return Vec2((1 - t) * a + t * b); };
  const Vec2 ab = mix(p[0], p[1]), bc = mix(p[1], p[2]), cd = mix(p[2], p[3]), abc = mix(ab, bc), bcd = mix(bc, cd);
  const Vec2 middle = mix(abc, bcd);
  return {{{p[0], ab, abc, middle}, {middle, bcd, cd, p[3]}}};
}

Path square(const Vec2& low, double size) {
  return polygonRegion({low, low + Vec2(size, 0), low + Vec2(size, size), low + Vec2(0, size)}).loops.front();
}

/// The left and the right part of the square of 20 about a curve from its lower to its upper edge, which the right one has
/// in two pieces where `cut` is in it.
Region partsAbout(const std::array<Vec2, 4>& curve, double cut) {
  std::vector<Segment> left, right;
  appendLines(left, {{0, 20}, {0, 0}, curve[0]});
  left.emplace_back(cubic(curve));
  appendLines(left, {curve[3], {0, 20}});
  appendLines(right, {curve[0], {20, 0}, {20, 20}, curve[3]});
  if (cut > 0) {
    const auto [lower, upper] = cutAt(cut, curve);
    right.push_back(reversed(Segment(cubic(upper))));
    right.push_back(reversed(Segment(cubic(lower))));
  } else {
    right.push_back(reversed(Segment(cubic(curve))));
  }
  return {{closedPath(left), closedPath(right)}};
}

double roomForDisc(const Region& region) { return area(minkowskiDifference(std::vector{region, circleRegion(1)}).region); }

}  // namespace

class MinkowskiJoinedTest : public QObject {
  Q_OBJECT

 private slots:
  /// By even-odd the second one would be a hole that leaves nothing of the first.
  void curvesDrawnTwiceAreRefused() {
    const Path disc = circleRegion(5, {50, 10}).loops.front();
    const std::vector<Region> pair{Region{{square({0, 0}, 20), disc, reversed(disc)}}, circleRegion(1)};
    try {
      minkowskiSum(pair);
      QFAIL("It was taken.");
    } catch (const Error& error) {
      QVERIFY2(error.message().find("drawn twice") != std::string::npos, error.message().c_str());
    }
  }

  /// Bends so sharp that Newton's method on the tangents goes astray.
  void partsOnBothSidesOfASharpBend() {
    const std::array<Vec2, 4> bend{Vec2(14.571, 0), {-14.715, 27.428}, {26.024, 16.016}, {12.405, 20}};
    for (const double cut : {0.0, 0.3, 0.5, 0.8}) COMPARE_NEAR(roomForDisc(partsAbout(bend, cut)), 324, 1e-8);
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> across(-10, 30), up(0.5, 19.5), end(2, 18);
    int tried = 0;
    for (int run = 0; run < 400 && tried < 40; ++run) {
      const std::array<Vec2, 4> curve{
          Vec2(end(random), 0), {across(random), up(random)}, {across(random), up(random)}, {end(random), 20}};
      const Region parts = partsAbout(curve, run % 2 == 0 ? 0 : 0.37);
      const double left = area(Region{{parts.loops[0]}}), right = area(Region{{parts.loops[1]}});
      if (std::abs(left + right - 400) > 1e-6 || crossesItself(cubic(curve)) || leavesSquare(cubic(curve))) continue;
      ++tried;
      COMPARE_NEAR(roomForDisc(parts), 324, 1e-6);
    }
    QVERIFY(tried >= 20);
  }

  /// A finger narrower than the distance of samples: the nearest one lies on its other side.
  void plugsOfNarrowFingers() {
    for (const double width : {2.0, 0.5, 0.05, 0.01})
      for (const double cut : {0.3, 0.47, 0.5}) {
        const std::array<Vec2, 4> finger{Vec2(10, 0), {10, 18}, {10 + width, 18}, {10 + width, 0}};
        const auto [up, down] = cutAt(cut, finger);
        std::vector<Segment> around, plug;
        appendLines(around, {{0, 0}, {10, 0}});
        around.emplace_back(cubic(finger));
        appendLines(around, {{10 + width, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}});
        plug = {reversed(Segment(cubic(down))), reversed(Segment(cubic(up))), Line2{finger[0], finger[3]}};
        COMPARE_NEAR(roomForDisc({{closedPath(around), closedPath(plug)}}), 324, 1e-8);
      }
  }

  /// An outline in lines about as short as what counts as one place between curves from files.
  void shortLinesStay() {
    for (const double length : {4e-4, 9e-4, 1e-3, 2e-3}) {
      std::vector<Segment> left, right;
      const Vec2 low(500, 0), high(500, 1000);
      const Arc2 arc{{-700, 500}, std::hypot(1200, 500), -std::atan2(500, 1200), 2 * std::atan2(500, 1200)};
      appendLines(left, {{0, 1000}, {0, 0}, low});
      left.emplace_back(arc);
      appendLines(left, {high, {0, 1000}});
      const int count = static_cast<int>(1 / length);
      std::vector<Vec2> points{low, {800, 0}};
      for (int k = 1; k <= count; ++k) points.emplace_back(800, -k * length);
      const double depth = count * length;
      for (int k = 1; k <= count; ++k) points.emplace_back(800 + k * length, -depth);
      for (int k = 1; k <= count; ++k) points.emplace_back(800 + depth, (k - count) * length);
      points.insert(points.end(), {Vec2(1000, 0), {1000, 1000}, high});
      appendLines(right, points);
      right.push_back(reversed(Segment(arc)));
      const Region parts{{closedPath(left), closedPath(right)}};
      const Region same = minkowskiSum(std::vector{parts, circleRegion(1)}, {.weights = {1, 0}}).region;
      COMPARE_NEAR(area(same), 1e6 + depth * depth, 1e-3);
    }
  }

  /// Holes in holes, as one loop draws them, are overlaps beside other loops, too.
  void holesInHolesAreToldAsDrawn() {
    std::vector<Segment> outline;
    appendLines(outline, {{0, 0}, {0, 10}, {6, 10}});
    outline.emplace_back(Arc2{{14, 10}, 8, pi, 2 * pi});
    appendLines(outline, {{6, 10}, {10, 10}});
    outline.emplace_back(Arc2{{14, 10}, 4, pi, 2 * pi});
    appendLines(outline, {{10, 10}, {6, 10}, {0, 10}, {0, 20}, {40, 20}, {40, 0}, {0, 0}});
    for (const bool isAlone : {true, false}) {
      Region region{{closedPath(outline)}};
      if (!isAlone) region.loops.push_back(reversed(square({60, 0}, 10)));
      VERIFY_ERROR(minkowskiSum(std::vector{region, circleRegion(1)}), ErrorCode::InvalidInput);
    }
  }

  /// A way from one disc to the other and back has no width.
  void bridgesBetweenDiscsGo() {
    const double half = std::asin(2 / 5.0);  // half the angle of the bridge, of radius 5 over a chord of 4
    const Arc2 bridge{{10, 10 - 5 * std::cos(half)}, 5, pi / 2 + half, -2 * half};
    std::vector<Segment> outline{bridge, Arc2{{15, 10}, 3, pi, 2 * pi}, reversed(Segment(bridge)),
                                 Arc2{{5, 10}, 3, 0, 2 * pi}};
    const Region sum = minkowskiSum(std::vector{Region{{closedPath(outline)}}, circleRegion(1)}).region;
    COMPARE_NEAR(area(sum), 32 * pi, 1e-9);
    QCOMPARE(sum.loops.size(), std::size_t{2});
    QCOMPARE(segmentCountOf<Line2>(sum), std::size_t{0});
  }

  /// Two parts meet on the arc of a third, each rounded to six decimals in a way of its own.
  void junctionsOnSharedArcs() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> share(0.3, 0.7), error(-5e-7, 5e-7), depth(0.5, 1.5);
    for (int run = 0; run < 40; ++run) {
      const double half = depth(random), radius = 10 / std::sin(half);
      const Arc2 whole{{10 - radius * std::cos(half), 10}, radius, -half, 2 * half};
      const double cut = share(random);
      const auto rounded = [&](Arc2 arc) {
        arc.center += Vec2(error(random), error(random));
        arc.radius += error(random);
        return arc;
      };
      const Arc2 lower = rounded({whole.center, radius, -half, 2 * half * cut}),
                 upper = rounded({whole.center, radius, half - 2 * half * (1 - cut), 2 * half * (1 - cut)});
      std::vector<Segment> left{whole}, under{reversed(Segment(lower))}, over{reversed(Segment(upper))};
      appendLines(left, {{10, 20}, {-10, 20}, {-10, 0}, {10, 0}});
      const Vec2 joint = endPoint(lower), other = startPoint(upper);
      appendLines(under, {startPoint(lower), {40, 0}, {40, joint.y()}, joint});
      appendLines(over, {other, {40, other.y()}, {40, 20}, endPoint(upper)});
      const Region parts{{closedPath(left), closedPath(under), closedPath(over)}};
      COMPARE_NEAR(roomForDisc(parts), 48 * 18, 1e-3);
    }
  }

 private:
  /// Of points along it, some that are far apart on the curve come as near as neighbours do.
  static bool crossesItself(const Spline2& curve) {
    constexpr int count = 200;
    std::vector<Vec2> points;
    for (int k = 0; k <= count; ++k) points.push_back(pointOf(curve, k / static_cast<double>(count)));
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); };
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (std::size_t j = i + 2; j + 1 < points.size(); ++j)
        if (turn(points[i], points[i + 1], points[j]) * turn(points[i], points[i + 1], points[j + 1]) <= 0 &&
            turn(points[j], points[j + 1], points[i]) * turn(points[j], points[j + 1], points[i + 1]) <= 0)
          return true;
    return false;
  }
  static bool leavesSquare(const Spline2& curve) {
    for (int k = 1; k < 200; ++k) {
      const Vec2 p = pointOf(curve, k / 200.0);
      if (p.minCoeff() <= 0 || p.maxCoeff() >= 20) return true;
    }
    return false;
  }
  static Vec2 pointOf(const Spline2& curve, double t) {
    const auto pole = [&](std::size_t k) { return Vec2(curve.poles[k].head<2>()); };
    return cutAt(t, {pole(0), pole(1), pole(2), pole(3)})[0][3];
  }
};

BLOSSOM_TEST(MinkowskiJoinedTest)
#include "minkowski_joined_test.moc"
