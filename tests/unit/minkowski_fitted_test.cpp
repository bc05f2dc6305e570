// Splines of sums lie within the tolerance of the true curves.
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/boundary_distance.h"
#include "support/outlines.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// How far points of fitted splines lie off the true offset of a curve.
double farthestOff(const Region& sum, const Segment& curve, double radius) {
  const std::vector<Vec2> points = flatten(curve, 1e-7);
  std::vector<std::pair<Vec2, Vec2>> chords;
  for (std::size_t k = 1; k < points.size(); ++k) chords.emplace_back(points[k - 1], points[k]);
  double farthest = 0;
  for (const Path& loop : sum.loops)
    for (const Segment& segment : loop.segments) {
      if (!std::holds_alternative<Spline2>(segment)) continue;
      for (const Vec2& p : flatten(segment, 1e-5)) farthest = std::max(farthest, std::abs(distanceFrom(chords, p) - radius));
    }
  return farthest;
}

}  // namespace

/// What is fitted to the polygons of a sum.
class MinkowskiFittedTest : public QObject {
  Q_OBJECT

 private slots:
  /// The hollow side of a polygon beside a curve that turns little has few points on the curve: one cubic through them may
  /// leave it by far. Nothing connected grows by more than its perimeter and the disc.
  void shallowHollowsStayWithinTheTolerance() {
    std::vector<Segment> outline{
        cubic({Vec2(0, 0), {10.0 / 3, -1.4625430235503953}, {20.0 / 3, 1.3897349477489307}, {10, 0}})};
    appendLines(outline, {{10, 0}, {10, 10}, {0, 10}, {0, 0}});
    const Region region{{closedPath(outline)}};
    for (const double radius : {0.02, 0.2})
      for (const double tolerance : {2e-4, 2e-3}) {
        const double grown = area(region) + radius * length(region.loops.front()) + pi * radius * radius;
        const Region sum = minkowskiSum(std::vector{region, circleRegion(radius)}, {.tolerance = tolerance}).region;
        QVERIFY(area(sum) <= grown + tolerance * 10);
        QVERIFY(area(sum) >= grown - radius * radius - 2 * tolerance * 10);
        QVERIFY2(farthestOff(sum, outline.front(), radius) <= tolerance, qPrintable(QString::number(radius)));
      }
  }

  /// A spline that is almost a line and turns at its ends only is no arc, and one with kinks has corners.
  void splinesThatTurnInPlacesStayWithinTheTolerance() {
    const auto shortHandles = [](double angle) {
      const Vec2 handle = 0.01 * Vec2(std::cos(angle), std::sin(angle));
      return cubic({Vec2(0, 0), handle, {10 - handle.x(), handle.y()}, {10, 0}});
    };
    const auto kinked = [](double depth) {
      return Spline2{3,
                     {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
                     {{0, 0, 1}, {1, depth, 1}, {3, depth, 1}, {5, depth, 1}, {7, 2 * depth, 1}, {9, 0, 1}, {10, 0, 1}}};
    };
    const auto corners = [](double depth) { return Spline2{1, {0, 0, 1, 2, 2}, {{0, 0, 1}, {5, depth, 1}, {10, 0, 1}}}; };
    std::vector<Segment> curves;
    for (const double angle : {-0.19, -0.05, 0.05, 0.19}) curves.push_back(shortHandles(angle));
    for (const double depth : {-1.5, -0.3, 0.3, 1.5}) curves.insert(curves.end(), {kinked(depth), corners(depth)});
    for (std::size_t k = 0; k < curves.size(); ++k)
      for (const double tolerance : {1e-2, 1e-3}) {
        std::vector<Segment> outline{curves[k]};
        appendLines(outline, {{10, 0}, {10, 10}, {0, 10}, {0, 0}});
        const std::vector<Region> shapes{Region{{closedPath(outline)}}, circleRegion(1)};
        const Region sum = minkowskiSum(shapes, {.tolerance = tolerance}).region;
        QVERIFY(std::any_of(sum.loops.front().segments.begin(), sum.loops.front().segments.end(),
                            [](const Segment& segment) { return std::holds_alternative<Spline2>(segment); }));
        QVERIFY2(farthestOff(sum, curves[k], 1) <= 1.05 * tolerance, qPrintable(QString::number(k)));
      }
  }
};

BLOSSOM_TEST(MinkowskiFittedTest)
#include "minkowski_fitted_test.moc"
