#include <limits>
#include <memory>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "subdivision/kernel/curve_through.h"
#include "subdivision/kernel/deform.h"
#include "subdivision/kernel/four_point.h"
#include "subdivision/kernel/limit_curve.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

ControlPolygon randomPolygon(std::mt19937_64& random, int count, bool closed) {
  std::uniform_real_distribution<double> coordinate(-5, 5);
  ControlPolygon polygon{{}, closed};
  for (int i = 0; i < count; ++i) polygon.points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return polygon;
}

ControlPolygon refinedOften(ControlPolygon polygon, CurveScheme scheme, int levels) {
  for (int level = 0; level < levels; ++level) polygon = refined(polygon, scheme);
  return polygon;
}

std::unique_ptr<LimitShape> limitOf(const ControlPolygon& polygon, CurveScheme scheme) {
  if (scheme == CurveScheme::FourPoint) return std::make_unique<FourPointCurve>(polygon);
  return std::make_unique<LimitCurve>(polygon, scheme);
}

double distanceToPolygon(const ControlPolygon& polygon, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t n = polygon.points.size();
  for (std::size_t i = 0; i + (polygon.closed ? 0 : 1) < n; ++i) {
    const Vec3 &a = polygon.points[i], &b = polygon.points[(i + 1) % n];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * (b - a) - p).norm());
  }
  return nearest;
}

}  // namespace

/// The limit curves of polygons.
class SubdivisionCurveTest : public QObject {
  Q_OBJECT

 private slots:
  void limitPointsLieWhereRefiningLeads() {
    auto random = seededRandom();
    for (const CurveScheme scheme : {CurveScheme::Cubic, CurveScheme::Quadratic, CurveScheme::FourPoint})
      for (const bool closed : {false, true})
        for (const int count : {3, 4, 5, 9}) {
          const ControlPolygon polygon = randomPolygon(random, count, closed);
          const ControlPolygon fine = onLimit(refinedOften(polygon, scheme, 10), scheme);
          const auto limit = limitOf(polygon, scheme);
          for (int k = 0; k <= 60; ++k) {
            const Row row = limit->row({0, k / 60.0, 0});
            double sum = 0;
            for (const double weight : row.weights) sum += weight;
            COMPARE_NEAR(sum, 1, 1e-12);
            const double off = distanceToPolygon(fine, combined(row, polygon.points));
            QVERIFY2(off < 1e-5, qPrintable(QString::number(off)));
          }
        }
  }

  void cubicPointsHaveTheClosedForm() {
    auto random = seededRandom();
    const ControlPolygon polygon = randomPolygon(random, 7, false);
    const LimitCurve curve(polygon);
    for (std::size_t i = 1; i < 6; ++i) {
      const Foot foot{0, static_cast<double>(i) / 6, 0};
      const Vec3 &a = polygon.points[i - 1], &b = polygon.points[i], &c = polygon.points[i + 1];
      const Frame frame = curve.frame(foot, polygon.points);
      QVERIFY((frame.at - (a + 4 * b + c) / 6).norm() < 1e-13);
      QVERIFY((frame.du / 6 - (c - a) / 2).norm() < 1e-13);  // by the whole parameter, which has 6 spans
    }
    QVERIFY((combined(curve.row({0, 0, 0}), polygon.points) - polygon.points.front()).norm() < 1e-13);
    QVERIFY((combined(curve.row({0, 1, 0}), polygon.points) - polygon.points.back()).norm() < 1e-13);
  }

  void quadraticCurvesTouchTheMiddlesOfEdges() {
    auto random = seededRandom();
    const ControlPolygon polygon = randomPolygon(random, 6, true);
    const LimitCurve curve(polygon, CurveScheme::Quadratic);
    const ControlPolygon middles = onLimit(polygon, CurveScheme::Quadratic);
    for (const Vec3& p : middles.points) {
      double nearest = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 6; ++k)
        nearest = std::min(nearest, (combined(curve.row({0, k / 6.0, 0}), polygon.points) - p).norm());
      QVERIFY(nearest < 1e-13);
    }
  }

  void fourPointCurvesPassThroughTheirPoints() {
    auto random = seededRandom();
    for (const bool closed : {false, true}) {
      const ControlPolygon polygon = randomPolygon(random, 8, closed);
      const FourPointCurve curve(polygon);
      for (int i = 0; i < 8; ++i) {
        const double u = static_cast<double>(i) / (closed ? 8 : 7);
        QVERIFY((combined(curve.row({0, u, 0}), polygon.points) - polygon.points[static_cast<std::size_t>(i)]).norm() <
                1e-9);
        const double h = 1e-5, low = std::max(u - h, 0.0), high = std::min(u + h, 1.0);
        const Vec3 slope =
            (combined(curve.row({0, high, 0}), polygon.points) - combined(curve.row({0, low, 0}), polygon.points)) /
            (high - low);
        QVERIFY((curve.frame({0, u, 0}, polygon.points).du - slope).norm() < 0.02 * (1 + slope.norm()));
      }
      // Cubic polynomials are kept (Dyn, Levin & Gregory 1987), away from ends.
    }
    ControlPolygon cubic;
    for (int i = 0; i < 12; ++i) cubic.points.emplace_back(i, i * i / 10.0, i * i * i / 100.0);
    const FourPointCurve curve(cubic);
    for (double t = 4; t <= 7; t += 0.13)
      QVERIFY((combined(curve.row({0, t / 11, 0}), cubic.points) - Vec3(t, t * t / 10, t * t * t / 100)).norm() < 1e-10);
  }

  void splinesOfPolygonsAreTheirLimitCurves() {
    auto random = seededRandom();
    for (const CurveScheme scheme : {CurveScheme::Cubic, CurveScheme::Quadratic})
      for (const bool closed : {false, true}) {
        const ControlPolygon polygon = randomPolygon(random, 6, closed);
        const Curve spline = splineOfPolygon(polygon, scheme);
        validate(spline);
        const LimitCurve curve(polygon, scheme);
        const auto [from, to] = spline.domain();
        for (int k = 0; k <= 40; ++k) {
          const double u = k / 40.0;
          const Vec3 wanted = combined(curve.row({0, u == 1 && closed ? 0.0 : u, 0}), polygon.points);
          QVERIFY((point(spline, from + u * (to - from)) - wanted).norm() < 1e-12);
        }
      }
  }

  void everySchemeIsPulledToATarget() {
    for (const CurveScheme scheme : {CurveScheme::Cubic, CurveScheme::Quadratic, CurveScheme::FourPoint}) {
      ControlPolygon polygon;
      for (int i = 0; i <= 12; ++i) polygon.points.emplace_back(i, 0, 0);
      std::vector<Vec3> target;
      for (int i = 0; i <= 20; ++i) target.emplace_back(4 + i / 5.0, std::pow(std::sin(std::numbers::pi * i / 20), 2), 0);
      const auto limit = limitOf(polygon, scheme);
      const DeformResult result = deform(*limit, polygon.points, target, {});
      qInfo("rms %.3g to %.3g with %zu free", result.before.rms, result.after.rms, result.freePoints.size());
      QVERIFY(result.after.rms < 0.1 * result.before.rms);
      QCOMPARE(result.outsideChange, 0.0);
      for (std::size_t i = 0; i < polygon.points.size(); ++i)
        if (!std::binary_search(result.freePoints.begin(), result.freePoints.end(), static_cast<int>(i)))
          QVERIFY(result.points[i] == polygon.points[i]);
    }
  }

  void strokesPassThroughTheirPointsSmoothly() {
    auto random = seededRandom();
    const std::vector<Vec3> points = randomPolygon(random, 7, false).points;
    const Curve curve = splineThrough(points);
    validate(curve);
    double along = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) along += (points[i] - points[i - 1]).norm();
      QVERIFY((point(curve, along) - points[i]).norm() < 1e-12);
      if (i == 0 || i + 1 == points.size()) continue;
      // Second derivatives from both sides agree.
      const double h = 1e-3;
      const auto second = [&](double t, double step) -> Vec3 {
        return (point(curve, t) - 2 * point(curve, t + step) + point(curve, t + 2 * step)) / (step * step);
      };
      const Vec3 left = 2 * second(along, -h) - second(along - h, -h), right = 2 * second(along, h) - second(along + h, h);
      QVERIFY((left - right).norm() < 1e-4 * (1 + left.norm()));
    }
  }

  void rubbishIsRefused() {
    for (const CurveScheme scheme : {CurveScheme::Cubic, CurveScheme::Quadratic, CurveScheme::FourPoint}) {
      VERIFY_ERROR(refined({{{0, 0, 0}}, false}, scheme), ErrorCode::InvalidInput);
      VERIFY_ERROR(refined({{{0, 0, 0}, {1, 0, 0}}, true}, scheme), ErrorCode::InvalidInput);
      VERIFY_ERROR(limitOf({{{0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 0}}, false}, scheme),
                   ErrorCode::InvalidInput);
    }
  }
};

BLOSSOM_TEST(SubdivisionCurveTest)
#include "subdivision_curve_test.moc"
