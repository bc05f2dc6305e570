#include <limits>

#include "subdivision/kernel/deform.h"
#include "subdivision/kernel/foot_points.h"
#include "subdivision/kernel/least_squares.h"
#include "subdivision/kernel/limit_curve.h"
#include "subdivision/kernel/limit_surface.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

/// A bump over the middle of a plane grid.
std::vector<Vec3> bump(double height) {
  std::vector<Vec3> samples;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j) {
      const double x = i / 3.0, y = j / 3.0;
      samples.emplace_back(5 + x, 5 + y, height * std::exp(-(x * x + y * y)));
    }
  return samples;
}

std::size_t moved(const std::vector<Vec3>& before, const DeformResult& result) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == result.points[i]) continue;
    ++count;
    if (!std::binary_search(result.freePoints.begin(), result.freePoints.end(), static_cast<int>(i)))
      return std::numeric_limits<std::size_t>::max();
  }
  return count;
}

}  // namespace

class SubdivisionDeformTest : public QObject {
  Q_OBJECT

 private slots:
  void aSurfaceFollowsABumpAndTheRestStays() {
    const Mesh cage = gridCage(10, 10);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const DeformResult result = deform(surface, cage.points, bump(1), {});
    qInfo("%zu free, rms %.3g to %.3g", result.freePoints.size(), result.before.rms, result.after.rms);
    QVERIFY(result.freePoints.size() < cage.points.size());
    QVERIFY(moved(cage.points, result) <= result.freePoints.size());
    QVERIFY(result.after.rms < 0.1 * result.before.rms);
    QVERIFY(result.after.largest < result.before.largest);
    QCOMPARE(result.outsideChange, 0.0);
    QVERIFY(!result.beyondRange);
  }

  void theObjectiveNeverGrows() {
    auto random = seededRandom();
    for (int k = 0; k < 6; ++k) {
      const Mesh cage = jittered(k % 2 ? gridCage(10, 10) : torusCage(8, 6), random, 0.2);
      const LimitSurface surface(cage, Scheme::CatmullClark);
      std::vector<Vec3> samples = bump(0.6 + 0.2 * k);
      if (k % 2 == 0)
        for (Vec3& p : samples) p += Vec3(-2, -5, 0.8);
      const DeformResult result = deform(surface, cage.points, samples, {.lambda = k < 3 ? 1e-4 : 1e-2});
      for (std::size_t i = 0; i + 1 < result.objective.size(); ++i)
        QVERIFY(result.objective[i + 1] <= result.objective[i] * (1 + 1e-9));
      QVERIFY(result.after.rms < result.before.rms);
      QVERIFY(moved(cage.points, result) <= result.freePoints.size());
      QCOMPARE(result.outsideChange, 0.0);
    }
  }

  void loopFollowsToo() {
    Mesh cage = gridCage(10, 10), triangles;
    triangles.points = cage.points;
    for (std::size_t f = 0; f < cage.faceCount(); ++f) {
      const auto q = cage.face(f);
      addPolygon(triangles, {q[0], q[1], q[2]});
      addPolygon(triangles, {q[0], q[2], q[3]});
    }
    const LimitSurface surface(triangles, Scheme::Loop);
    const DeformResult result = deform(surface, triangles.points, bump(1), {});
    QVERIFY(result.after.rms < 0.1 * result.before.rms);
    QCOMPARE(result.outsideChange, 0.0);
  }

  void onePointIsReachedByTheShortestMovement() {
    const Mesh cage = gridCage(10, 10);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const std::vector<Vec3> target{{5, 5, 1}};
    const DeformResult result = deform(surface, cage.points, target, {.lambda = 0, .iterations = 1});
    QVERIFY(result.after.rms < 1e-12);
    // The minimum-norm solution of w d = r is w r / |w|^2, and for the vertex of a bicubic B-spline |w|^2 = 1/4.
    double length = 0;
    for (std::size_t i = 0; i < cage.points.size(); ++i) length += (result.points[i] - cage.points[i]).squaredNorm();
    COMPARE_NEAR(length, 4, 1e-10);
  }

  void thePapersRuleOnACurve() {
    ControlPolygon polygon;
    for (int i = 0; i <= 12; ++i) polygon.points.emplace_back(i, 0.3 * std::sin(i), 0);
    std::vector<Vec3> target;
    for (int i = 0; i <= 20; ++i) target.emplace_back(4 + i / 5.0, -0.6 + 1.5 * std::sin(std::numbers::pi * i / 20), 0);
    const LimitCurve curve(polygon);
    const DeformResult result = deform(curve, polygon.points, target, {.free = {.paper = true}});
    for (const int i : result.freePoints) {
      const Vec3& p = polygon.points[static_cast<std::size_t>(i)];
      QVERIFY(p.x() >= 4 && p.x() <= 8 && p.y() > -0.6);
    }
    QVERIFY(result.freePoints.size() >= 3);
    QVERIFY(moved(polygon.points, result) <= result.freePoints.size());
    QVERIFY(result.after.rms < result.before.rms);
    QCOMPARE(result.outsideChange, 0.0);
    // No control point on the side of the target: the case about which the paper is silent.
    for (Vec3& p : target) p = {p.x(), 5 + (p.y() + 0.6), 0};
    VERIFY_ERROR(deform(curve, polygon.points, target, {.free = {.paper = true}}), ErrorCode::InvalidInput);
  }

  void thePapersRuleOnASurface() {
    const Mesh cage = gridCage(10, 10);
    std::vector<Vec3> samples = bump(1);
    for (Vec3& p : samples) p.z() -= 0.2;
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const DeformResult result = deform(surface, cage.points, samples, {.free = {.paper = true}});
    QVERIFY(!result.freePoints.empty());
    QVERIFY(moved(cage.points, result) <= result.freePoints.size());
    QVERIFY(result.after.rms < result.before.rms);
    QCOMPARE(result.outsideChange, 0.0);
  }

  void ringsGrowAndShrink() {
    const Mesh cage = gridCage(10, 10);
    const auto edges = LimitSurface(cage, Scheme::CatmullClark).edges();
    const auto grownBy = [&](int rings) { return grown({60}, edges, cage.points.size(), rings); };  // 60 is (5, 5)
    QCOMPARE(grownBy(1).size(), std::size_t(5));
    QCOMPARE(grownBy(2).size(), std::size_t(13));
    QCOMPARE(grown(grownBy(2), edges, cage.points.size(), -2), std::vector<int>{60});
    VERIFY_ERROR(deform(LimitSurface(cage, Scheme::CatmullClark), cage.points, bump(1), {.free = {.rings = -20}}),
                 ErrorCode::InvalidInput);
  }

  /// Feet against a search by brute force.
  void feetAreTheClosestPoints() {
    auto random = seededRandom();
    const Mesh cage = jittered(prism(5), random, 0.2);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const FootFinder finder(surface, {});
    std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
    std::vector<Vec3> samples, places;
    for (int i = 0; i < 60; ++i) samples.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    const int patches = 5 + 2 * 5;
    for (int p = 0; p < patches; ++p)
      for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) places.push_back(combined(surface.row({p, i / 20.0, j / 20.0}), cage.points));
    const std::vector<Foot> feet = finder.feet(samples, cage.points, {}, {});
    for (std::size_t s = 0; s < samples.size(); ++s) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& p : places) nearest = std::min(nearest, (p - samples[s]).norm());
      QVERIFY((combined(surface.row(feet[s]), cage.points) - samples[s]).norm() <= nearest + 1e-9);
    }
  }

  void rubbishIsRefused() {
    const Mesh cage = gridCage(4, 4);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    VERIFY_ERROR(deform(surface, cage.points, {}, {}), ErrorCode::InvalidInput);
    const std::vector<Vec3> nan{{0, std::numeric_limits<double>::quiet_NaN(), 0}}, one{{1, 1, 1}};
    VERIFY_ERROR(deform(surface, cage.points, nan, {}), ErrorCode::InvalidInput);
    VERIFY_ERROR(deform(surface, cage.points, one, {.lambda = -1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(deform(surface, cage.points, one, {.free = {.paper = true}}), ErrorCode::InvalidInput);
  }

  void cancelInTheMiddle() {
    const Mesh cage = gridCage(10, 10);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const CancelToken token;
    const Progress progress(token, [&](double fraction, const std::string&) {
      if (fraction > 0.2) token.cancel();
    });
    VERIFY_ERROR(deform(surface, cage.points, bump(3), {.lambda = 1e-2}, progress), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(SubdivisionDeformTest)
#include "subdivision_deform_test.moc"
