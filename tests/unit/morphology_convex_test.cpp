/// Corners of sums of convex polyhedra, against the hull of all pairs of corners.
#include "core/stopwatch.h"
#include "morphology/kernel/convex/convex_sum.h"
#include "morphology/kernel/convex/hull.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

std::vector<Vec3> allSums(const Mesh& a, const Mesh& b) {
  std::vector<Vec3> sums;
  for (const Vec3& p : a.points)
    for (const Vec3& q : b.points) sums.push_back(p + q);
  return sums;
}

std::vector<Vec3> sumsAt(const Mesh& a, const Mesh& b, const std::vector<std::array<int, 2>>& pairs) {
  std::vector<Vec3> sums;
  for (const auto& [i, j] : pairs)
    sums.push_back(a.points[static_cast<std::size_t>(i)] + b.points[static_cast<std::size_t>(j)]);
  return sums;
}

/// Corners anywhere, on a sphere, of a box that is turned, of a box along the axes, of a pyramid, of a needle.
Mesh convexOfKind(std::mt19937_64& random, int kind) {
  std::normal_distribution<double> any(0, 1);
  const auto place = [&] { return Vec3(any(random), any(random), any(random)); };
  std::vector<Vec3> points;
  const int count = std::uniform_int_distribution<int>(5, 60)(random);
  for (int k = 0; k < count; ++k) {
    Vec3 p = place();
    if (kind % 3 == 1) p.normalize();
    if (kind % 6 == 5) p.x() *= 1e-3;
    points.push_back(p);
  }
  if (kind % 6 == 2) points = cuboid({-1, -2, -0.5}, {1, 0.5, 3}).points;
  if (kind % 6 == 3) points = turnedBy(cuboid({-1, -2, -0.5}, {1, 0.5, 3}), randomTurn(random)).points;
  if (kind % 6 == 4) points = prism({{0, 0}, {2, 0}, {3, 1}, {1, 3}}, 0, 1 + std::abs(any(random))).points;
  return hullTriangles(points);
}

}  // namespace

class MorphologyConvexTest : public QObject {
  Q_OBJECT

 private slots:
  void theirHullIsThatOfAllSums() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 200; ++round) {
      const Mesh a = convexOfKind(random, round), b = convexOfKind(random, round / 6);
      const auto pairs = cornersOfSum(a, b);
      const std::vector<Vec3> corners = sumsAt(a, b, pairs);
      const Mesh whole = hullTriangles(allSums(a, b)), found = hullTriangles(corners);
      COMPARE_NEAR(volumeOf(found), volumeOf(whole), 1e-10 * volumeOf(whole));
      COMPARE_NEAR(area(found), area(whole), 1e-10 * area(whole));
      QVERIFY(pairs.size() <= a.points.size() * b.points.size());
    }
  }

  /// In general position each corner is a pair, and each pair a corner.
  void noPairIsTooMany() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 60; ++round) {
      const Mesh a = convexOfKind(random, 1), b = convexOfKind(random, 6 * round);
      QCOMPARE(cornersOfSum(a, b).size(), hullTriangles(allSums(a, b)).points.size());
    }
  }

  /// All faces are parallel to faces of the other one.
  void ballsOfTheSameDirectionsAreABall() {
    for (const int fine : {1, 2, 3}) {
      const Mesh a = ballOf(5, fine), b = ballOf(2, fine);
      QCOMPARE(cornersOfSum(a, b).size(), a.points.size());
      const Mesh sum = solidSumOf(a, b);
      COMPARE_NEAR(volumeOf(sum), std::pow(7.0 / 5, 3) * volumeOf(a), 1e-11 * volumeOf(sum));
      QCOMPARE(sum.points.size(), a.points.size());
    }
  }

  void fineBallsAreAdded() {
    const Mesh a = ballOf(5, 4), b = ballOf(2, 4);
    Stopwatch watch;
    const Mesh sum = solidSumOf(a, b);
    qInfo("figure balls_ms %.3g", watch.lapMs());
    COMPARE_NEAR(volumeOf(sum), std::pow(7.0 / 5, 3) * volumeOf(a), 1e-11 * volumeOf(sum));
    const Mesh finest = solidSumOf(
        ballOf(5, 6), turnedBy(ballOf(2, 3), Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix()));
    QVERIFY(volumeOf(finest) > 0.99 * 4.0 / 3 * std::numbers::pi * 343);
    QVERIFY(volumeOf(finest) < 4.0 / 3 * std::numbers::pi * 343);
    qInfo("figure fine_balls_ms %.3g", watch.lapMs());
  }
};

BLOSSOM_TEST(MorphologyConvexTest)
#include "morphology_convex_test.moc"
