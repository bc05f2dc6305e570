#include <numbers>

#include "geometry/planar/planar.h"
#include "pocket/kernel/medial/boundary.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "pocket/kernel/offset/offset.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/support.h"
#include "support/true_distance.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;
constexpr double tolerance = 1e-3;

Region offsetOf(const Region& region, double distance, Side side) { return offset(region, {distance, side}).region; }

Path ellipsePath(double a, double b) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(ellipticArc({0, 0}, {a, 0}, b / a, 0, fullTurn));
  return path;
}

/// Two half circles joined by straight lines, along x.
Path stadiumPath(double half, double radius) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(Line2{{-half, -radius}, {half, -radius}});
  path.segments.emplace_back(Arc2{{half, 0}, radius, -pi / 2, pi});
  path.segments.emplace_back(Line2{{half, radius}, {-half, radius}});
  path.segments.emplace_back(Arc2{{-half, 0}, radius, pi / 2, pi});
  return path;
}

/// Two squares of side 10 joined by a bar of width 2 and length 10.
Region dumbbell() {
  return {{polygonPath(
      {{0, 0}, {10, 0}, {10, 4}, {20, 4}, {20, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 6}, {10, 6}, {10, 10}, {0, 10}})}};
}

Region waveWithIslands() {
  return {{wavyPath({0, 0}, 30, 5, 5), wavyPath({-8, 2}, 6, 1.5, 3, true), circlePath({12, -3}, 5, true)}};
}

Vec2 pointOn(const Segment& segment, double t) {
  if (const auto* line = std::get_if<Line2>(&segment)) return line->from + t * (line->to - line->from);
  const Arc2& arc = std::get<Arc2>(segment);
  const double angle = arc.start + t * arc.sweep;
  return arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Every sampled point of the offset lies at the distance from the true curves and on its side, and random points are in the
/// offset exactly when they should be.
void verifyOffset(const Region& part, const Region& made, double distance, Side side, std::mt19937_64& random) {
  const TrueDistance truth(part.loops, 1e-6);
  if (!made.loops.empty()) (void)Boundary(made, tolerance / 4, Progress::none());  // throws where its loops cross
  for (const Path& loop : made.loops)
    for (const Segment& segment : loop.segments)
      for (const double t : {0.0, 0.4, 0.8}) {
        const Vec2 p = pointOn(segment, t);
        COMPARE_NEAR(truth(p), distance, tolerance);
        if (distance > 2 * tolerance) QCOMPARE(windingAround(part.loops, p), side == Side::Inside ? 1 : 0);
      }
  const double reach = side == Side::Outside ? 40 + distance : 40;
  std::uniform_real_distribution<double> place(-reach, reach);
  for (int i = 0; i < 200; ++i) {
    const Vec2 p(place(random), place(random));
    const double away = truth(p);
    if (std::abs(away - distance) < 2 * tolerance) continue;
    const bool within = windingAround(part.loops, p) == 1;
    const bool wanted = side == Side::Inside ? within && away > distance : within || away < distance;
    QCOMPARE(windingAround(made.loops, p), wanted ? 1 : 0);
  }
}

/// The same area and boundary however a part is written.
void verifySame(const Region& a, const Region& b, double scale = 1) {
  QCOMPARE(a.loops.size(), b.loops.size());
  COMPARE_NEAR(perimeter(b), scale * perimeter(a), 1e-3 * scale * perimeter(a));
  COMPARE_NEAR(area(b), scale * scale * area(a), scale * tolerance * perimeter(a));
}

Spline2 withKnot(const Spline2& s, double knot) {
  std::size_t k = static_cast<std::size_t>(s.degree);
  while (s.knots[k + 1] <= knot) ++k;
  Spline2 out = s;
  out.knots.insert(out.knots.begin() + static_cast<std::ptrdiff_t>(k) + 1, knot);
  out.poles.clear();
  const auto degree = static_cast<std::size_t>(s.degree);
  for (std::size_t i = 0; i <= s.poles.size(); ++i) {  // Boehm 1980
    if (i + degree <= k) {
      out.poles.push_back(s.poles[i]);
    } else if (i > k) {
      out.poles.push_back(s.poles[i - 1]);
    } else {
      const double share = (knot - s.knots[i]) / (s.knots[i + degree] - s.knots[i]);
      out.poles.push_back((1 - share) * s.poles[i - 1] + share * s.poles[i]);
    }
  }
  return out;
}

Region mapped(const Region& region, const Eigen::Matrix<double, 2, 3>& map) {
  Region out;
  for (const Path& loop : region.loops) out.loops.push_back(transformed(loop, map));
  return out;
}

}  // namespace

/// Offsets against closed forms and an independent search on the true curves.
class PocketOffsetTest final : public QObject {
  Q_OBJECT
 private slots:
  void aRectangleShrinks() {
    const Region part{{boxPath(3, -2, 63, 38)}};
    for (const double d : {0.01, 1.0, 7.5, 19.9}) {
      const Region made = offsetOf(part, d, Side::Inside);
      QCOMPARE(made.loops.size(), std::size_t(1));
      QCOMPARE(made.loops[0].segments.size(), std::size_t(4));
      COMPARE_NEAR(area(made), (60 - 2 * d) * (40 - 2 * d), 1e-9 * 2400);
    }
  }
  void aRectangleGrowsRoundCorners() {
    const Region part{{boxPath(3, -2, 63, 38)}};
    for (const double d : {0.01, 4.0, 100.0}) {
      const Region made = offsetOf(part, d, Side::Outside);
      QCOMPARE(made.loops.size(), std::size_t(1));
      QCOMPARE(made.loops[0].segments.size(), std::size_t(8));
      COMPARE_NEAR(area(made), 2400 + 200 * d + pi * d * d, 1e-9 * area(made));
      COMPARE_NEAR(perimeter(made), 200 + 2 * pi * d, 1e-9 * perimeter(made));
    }
  }
  void aReflexCornerIsFollowedByAnArc() {
    const Region part{{polygonPath({{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}})}};
    const double d = 3;
    const Region made = offsetOf(part, d, Side::Inside);
    // Five mitred corners, and a quarter of a circle where the L bends.
    COMPARE_NEAR(area(made), 500 - 120 * d + 5 * d * d - pi * d * d / 4, 1e-6);
    std::size_t arcs = 0;
    for (const Segment& segment : made.loops[0].segments)
      if (const auto* arc = std::get_if<Arc2>(&segment)) {
        ++arcs;
        COMPARE_NEAR((arc->center - Vec2(10, 10)).norm(), 0, 1e-9);
        COMPARE_NEAR(arc->radius, d, 1e-9);
      }
    QCOMPARE(arcs, std::size_t(1));
  }
  void anAnnulusStaysOne() {
    const Region part{{circlePath({4, 5}, 20), circlePath({4, 5}, 8, true)}};
    for (const double d : {0.5, 3.0, 5.99}) {
      const Region inside = offsetOf(part, d, Side::Inside);
      QCOMPARE(inside.loops.size(), std::size_t(2));
      COMPARE_NEAR(area(inside), pi * ((20 - d) * (20 - d) - (8 + d) * (8 + d)), 1e-8);
    }
    COMPARE_NEAR(area(offsetOf(part, 3, Side::Outside)), pi * (23.0 * 23 - 5 * 5), 1e-8);
    QCOMPARE(offsetOf(part, 8.1, Side::Outside).loops.size(), std::size_t(1));  // the hole is filled
    QVERIFY(offsetOf(part, 6.01, Side::Inside).loops.empty());
  }
  void aHoleThatTouchesTheOutlineKeepsItsOffset() {
    // A circle that touches all four sides of its square.
    const Region part{{boxPath(0, 0, 10, 10), circlePath({5, 5}, 5, true)}};
    const Region made = offsetOf(part, 0.5, Side::Outside);
    QCOMPARE(made.loops.size(), std::size_t(2));
    COMPARE_NEAR(area(made), 100 + 40 * 0.5 + pi * 0.25 - pi * 4.5 * 4.5, 1e-3);
  }
  void aStadiumStaysOne() {
    const Region part{{stadiumPath(15, 6)}};
    for (const double d : {0.25, 3.0, 5.9}) {
      const Region made = offsetOf(part, d, Side::Inside);
      QCOMPARE(made.loops.size(), std::size_t(1));
      COMPARE_NEAR(area(made), 60 * (6 - d) + pi * (6 - d) * (6 - d), 1e-7);
    }
    COMPARE_NEAR(area(offsetOf(part, 2, Side::Outside)), 60 * 8 + pi * 64, 1e-7);
    COMPARE_NEAR(ClearanceDiagram(part).largestClearance(), 6, 1e-9);
  }
  /// Steiner's formula holds for every convex shape: A + L d + pi d^2.
  void anEllipseGrowsBySteinersFormula() {
    const Region part{{ellipsePath(20, 9)}};
    for (const double d : {0.1, 2.0, 15.0}) {
      const Region made = offsetOf(part, d, Side::Outside);
      COMPARE_NEAR(area(made), pi * 180 + perimeter(part) * d + pi * d * d, tolerance * perimeter(made) / 2);
      COMPARE_NEAR(perimeter(made), perimeter(part) + 2 * pi * d, 1e-3 * perimeter(made));
    }
    // Inside the same holds up to the smallest radius of curvature, b^2 / a.
    const double d = 0.95 * 81 / 20;
    COMPARE_NEAR(area(offsetOf(part, d, Side::Inside)), pi * 180 - perimeter(part) * d + pi * d * d, 0.05);
  }
  void aNarrowBarLetsThePartFallInTwo() {
    QCOMPARE(offsetOf(dumbbell(), 0.9, Side::Inside).loops.size(), std::size_t(1));
    const Region two = offsetOf(dumbbell(), 1.1, Side::Inside);
    QCOMPARE(two.loops.size(), std::size_t(2));
    // Each square is a square with rounded dents where the bar came in.
    QCOMPARE(offsetOf(dumbbell(), 4.9, Side::Inside).loops.size(), std::size_t(2));
    QVERIFY(offsetOf(dumbbell(), 5.2, Side::Inside).loops.empty());
  }
  /// Half-open intervals of clearance: the bar's middle line has clearance 1 all along.
  void theDistanceOfAFlatEdgeGivesClosedLoops() {
    for (const double d : {1.0, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)})
      for (const Path& loop : offsetOf(dumbbell(), d, Side::Inside).loops) {
        QVERIFY(loop.closed);
        COMPARE_NEAR((endPoint(loop) - startPoint(loop)).norm(), 0, 1e-9);
      }
  }
  /// dA/dd = -L, integrated by Simpson's rule between distances where nothing vanishes in between.
  void areasAreTheIntegralsOfLengths() {
    const ClearanceDiagram diagram(waveWithIslands(), {.tolerance = 1e-4});
    for (const auto& [side, sign] : {std::pair{Side::Inside, -1.0}, std::pair{Side::Outside, 1.0}}) {
      const double from = 0.2, to = 1.0;
      constexpr int steps = 8;
      double integral = 0;
      for (int i = 0; i <= 2 * steps; ++i) {
        const double d = from + (to - from) * i / (2.0 * steps);
        integral += (i == 0 || i == 2 * steps ? 1 : i % 2 == 1 ? 4 : 2) * perimeter(diagram.offset(d, side));
      }
      integral *= (to - from) / (6 * steps);
      COMPARE_NEAR(area(diagram.offset(to, side)) - area(diagram.offset(from, side)), sign * integral, 0.02);
    }
  }
  void freeFormOffsetsLieAtTheDistance() {
    std::mt19937_64 random = seededRandom();
    const Region part = waveWithIslands();
    const ClearanceDiagram diagram(part);
    for (const double share : {0.001, 0.05, 0.3, 0.6, 0.9, 0.999}) {
      const double d = share * diagram.largestClearance();
      verifyOffset(part, diagram.offset(d, Side::Inside), d, Side::Inside, random);
      verifyOffset(part, diagram.offset(d, Side::Outside), d, Side::Outside, random);
    }
  }
  /// Samples of a fitted run once led 0.009 mm back before a cusp.
  void loopsDoNotCrossThemselvesAtCusps() {
    std::mt19937_64 random = seededRandom();
    const Region pair{{wavyPath({0, 0}, 10, 2, 3), wavyPath({23.5, 1}, 10, 2, 5)}};
    for (const double d : {0.8, 1.5, 2.2, 3.0, 4.4, 6.1})
      verifyOffset(pair, offsetOf(pair, d, Side::Outside), d, Side::Outside, random);
  }
  void randomPartsLieAtTheDistance() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> wave(0.05, 0.4), size(8, 30), share(0.02, 0.95);
    std::uniform_int_distribution<int> waves(2, 9);
    for (int i = 0; i < 6; ++i) {
      const double radius = size(random);
      const Region part{{wavyPath({0, 0}, radius, wave(random) * radius, waves(random)),
                         wavyPath({0.1 * radius, 0}, 0.3 * radius, wave(random) * 0.3 * radius, waves(random), true)}};
      const ClearanceDiagram diagram(part);
      const double d = share(random) * diagram.largestClearance();
      verifyOffset(part, diagram.offset(d, Side::Inside), d, Side::Inside, random);
      verifyOffset(part, diagram.offset(d, Side::Outside), d, Side::Outside, random);
    }
  }
  void turningMovingAndScalingChangeNothing() {
    const Region part = waveWithIslands();
    const Region made = offsetOf(part, 1.5, Side::Inside);
    Eigen::Matrix<double, 2, 3> map;
    for (const double angle : {0.3, pi / 2, 2.5}) {
      map << std::cos(angle), -std::sin(angle), 1000, std::sin(angle), std::cos(angle), -250;
      verifySame(made, offsetOf(mapped(part, map), 1.5, Side::Inside));
    }
    map << 25, 0, 0, 0, 25, 0;
    verifySame(made, offset(mapped(part, map), {37.5, Side::Inside, 25 * tolerance}).region, 25);
  }
  void theDirectionOfTheLoopsDoesNotMatter() {
    Region turned = waveWithIslands();
    for (Path& loop : turned.loops) loop = reversed(loop);
    for (const Side side : {Side::Inside, Side::Outside})
      verifySame(offsetOf(waveWithIslands(), 1.5, side), offsetOf(turned, 1.5, side));
  }
  void insertedKnotsChangeNothing() {
    Region refined = waveWithIslands();
    auto& spline = std::get<Spline2>(refined.loops[0].segments[0]);
    for (const double knot : {5.3, 5.3, 11.0, 20.75}) spline = withKnot(spline, knot);
    for (const Side side : {Side::Inside, Side::Outside})
      verifySame(offsetOf(waveWithIslands(), 1.5, side), offsetOf(refined, 1.5, side));
  }
  void aSmallerToleranceComesNearer() {
    const Region part{{ellipsePath(20, 9)}};
    const TrueDistance truth(part.loops, 1e-11);
    for (const double asked : {1e-1, 1e-3, 1e-5}) {
      double worst = 0;
      const Region made = offset(part, {2.5, Side::Inside, asked}).region;
      for (const Segment& segment : made.loops[0].segments)
        for (const double t : {0.0, 0.25, 0.5, 0.75}) worst = std::max(worst, std::abs(truth(pointOn(segment, t)) - 2.5));
      QVERIFY2(worst <= asked, qPrintable(QString::number(worst)));
    }
  }
  void nothingIsLeftBeyondTheLargestDisc() {
    const Region part = waveWithIslands();
    const ClearanceDiagram diagram(part);
    const double largest = diagram.largestClearance();
    const TrueDistance truth(part.loops);
    COMPARE_NEAR(truth(diagram.largestCenter()), largest, 1e-6);
    QVERIFY(diagram.offset(largest * 1.001, Side::Inside).loops.empty());
    QVERIFY(!diagram.offset(largest * 0.999, Side::Inside).loops.empty());
  }
  void distancesThatAreNoneAreRefused() {
    const ClearanceDiagram diagram({{boxPath(0, 0, 10, 10)}});
    for (const double d : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
      VERIFY_ERROR(diagram.offset(d, Side::Inside), ErrorCode::InvalidParameter);
    QCOMPARE(diagram.offset(0, Side::Inside), diagram.region());
    for (const double t : {0.0, -1.0, std::nan("")})
      VERIFY_ERROR(ClearanceDiagram({{boxPath(0, 0, 10, 10)}}, {.tolerance = t}), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(PocketOffsetTest)
#include "pocket_offset_test.moc"
