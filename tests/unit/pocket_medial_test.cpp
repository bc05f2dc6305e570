#include <algorithm>
#include <numbers>
#include <vector>

#include "geometry/planar/planar.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "support/medial_checks.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;

MedialAxis axisOf(const Region& region, double tolerance = 1e-3) {
  return ClearanceDiagram(region, {tolerance}).medialAxis();
}

/// The vertex next to a place.
const MedialVertex& vertexAt(const MedialAxis& axis, const Vec2& at) {
  return *std::min_element(axis.vertices.begin(), axis.vertices.end(), [&](const MedialVertex& a, const MedialVertex& b) {
    return (a.at - at).norm() < (b.at - at).norm();
  });
}

void verifyVertex(const MedialAxis& axis, const Vec2& at, double clearance, double within = 1e-9) {
  const MedialVertex& vertex = vertexAt(axis, at);
  COMPARE_NEAR((vertex.at - at).norm(), 0, within);
  COMPARE_NEAR(vertex.clearance, clearance, within);
  QVERIFY(vertex.certified);
}

Region ellipse(double a, double b) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(ellipticArc({0, 0}, {a, 0}, b / a, 0, fullTurn));
  return {{path}};
}

/// Discs around the axis' points cover exactly the part, and every disc touches its boundary twice.
void verifyAxis(const Region& part, const MedialAxis& axis, double tolerance, std::mt19937_64& random) {
  const AxisCheck check(part, axis);
  const AxisCheck::Report report = check.all();
  QVERIFY2(report.worstClearance <= tolerance, report.text().c_str());
  QVERIFY2(report.worstSecondFoot <= tolerance, report.text().c_str());
  QVERIFY2(report.outside == 0, report.text().c_str());
  const double uncovered = check.maximumUncovered(400, random);
  QVERIFY2(uncovered <= 3 * tolerance, qPrintable(QString("uncovered by %1").arg(uncovered)));
}

}  // namespace

class PocketMedialTest final : public QObject {
  Q_OBJECT
 private slots:
  void aRectangleHasFiveBranches() {
    const MedialAxis axis = axisOf({{boxPath(0, 0, 60, 40)}});
    QCOMPARE(axis.edges.size(), std::size_t(5));
    QCOMPARE(axis.vertices.size(), std::size_t(6));
    verifyVertex(axis, {20, 20}, 20);
    verifyVertex(axis, {40, 20}, 20);
    for (const Vec2& corner : {Vec2(0, 0), Vec2(60, 0), Vec2(60, 40), Vec2(0, 40)}) verifyVertex(axis, corner, 0);
    COMPARE_NEAR(lengthOf(axis), 20 + 4 * 20 * std::numbers::sqrt2, 1e-9);
  }
  void fourBranchesMeetInASquare() {
    const MedialAxis axis = axisOf({{boxPath(0, 0, 40, 40)}});
    QCOMPARE(axis.edges.size(), std::size_t(4));
    verifyVertex(axis, {20, 20}, 20);
  }
  void aTriangleMeetsInItsIncentre() {
    const Vec2 a(0, 0), b(30, 0), c(0, 40);
    const MedialAxis axis = axisOf({{polygonPath({a, b, c})}});
    QCOMPARE(axis.edges.size(), std::size_t(3));
    verifyVertex(axis, {10, 10}, 10);  // (30 + 40 - 50) / 2
  }
  void aDiscHasOnlyItsCentre() {
    const MedialAxis axis = axisOf({{circlePath({7, -3}, 12)}});
    QCOMPARE(axis.edges.size(), std::size_t(0));
    QCOMPARE(axis.vertices.size(), std::size_t(1));
    verifyVertex(axis, {7, -3}, 12);
  }
  void anAnnulusHasACircle() {
    const MedialAxis axis = axisOf({{circlePath({7, -3}, 20), circlePath({7, -3}, 8, true)}});
    QCOMPARE(axis.edges.size(), std::size_t(1));
    QCOMPARE(axis.edges[0].from, axis.edges[0].to);
    COMPARE_NEAR(lengthOf(axis), 2 * pi * 14, 1e-2);
    for (const Vec3& p : axis.edges[0].points) {
      COMPARE_NEAR((p.head<2>() - Vec2(7, -3)).norm(), 14, 1e-6);
      COMPARE_NEAR(p.z(), 6, 1e-6);
    }
  }
  void aStadiumHasTheLineBetweenItsCentres() {
    Path path;
    path.closed = true;
    path.segments.emplace_back(Line2{{-15, -6}, {15, -6}});
    path.segments.emplace_back(Arc2{{15, 0}, 6, -pi / 2, pi});
    path.segments.emplace_back(Line2{{15, 6}, {-15, 6}});
    path.segments.emplace_back(Arc2{{-15, 0}, 6, pi / 2, pi});
    const MedialAxis axis = axisOf({{path}});
    QCOMPARE(axis.edges.size(), std::size_t(1));
    verifyVertex(axis, {-15, 0}, 6, 1e-6);
    verifyVertex(axis, {15, 0}, 6, 1e-6);
    COMPARE_NEAR(lengthOf(axis), 30, 1e-6);
  }
  /// The axis of an ellipse ends in the centres of curvature of its sharp ends: at a - b^2/a, with clearance b^2/a.
  void theLeavesOfAnEllipseAreCentresOfCurvature() {
    for (const auto& [a, b] : {std::pair{20.0, 9.0}, std::pair{20.0, 15.0}, std::pair{20.0, 2.0}}) {
      const MedialAxis axis = axisOf(ellipse(a, b));
      QCOMPARE(axis.edges.size(), std::size_t(1));
      const double leaf = b * b / a;
      verifyVertex(axis, {a - leaf, 0}, leaf, 1e-5);
      verifyVertex(axis, {leaf - a, 0}, leaf, 1e-5);
      for (const Vec3& p : axis.edges[0].points) {
        COMPARE_NEAR(p.y(), 0, 1e-3);
        // The disc around (x, 0) on the major axis has b^2 (1 - x^2 / (a^2 - b^2)) as the square of its radius.
        COMPARE_NEAR(p.z(), b * std::sqrt(std::max(0.0, 1 - p.x() * p.x() / (a * a - b * b))), 1e-3);
      }
    }
  }
  /// As many closed chains as islands: edges - vertices + components = islands.
  void theAxisGoesRoundEveryIsland() {
    const MedialAxis axis = axisOf(wave());
    QCOMPARE(int(axis.edges.size()) - int(axis.vertices.size()) + 1, 2);
  }
  void everyDiscTouchesTwiceAndAllCoverThePart() {
    std::mt19937_64 random = seededRandom();
    for (const Region& part : {wave(), ellipse(20, 9), Region{{boxPath(0, 0, 60, 40), circlePath({25, 18}, 9, true)}}})
      verifyAxis(part, axisOf(part), 1e-3, random);
  }
  void soDoThoseOfRandomParts() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> share(0.05, 0.4), size(8, 30);
    std::uniform_int_distribution<int> waves(2, 9);
    for (int i = 0; i < 8; ++i) {
      const double radius = size(random);
      const Region part{{wavyPath({0, 0}, radius, share(random) * radius, waves(random)),
                         wavyPath({0.1 * radius, 0}, 0.3 * radius, share(random) * 0.3 * radius, waves(random), true)}};
      verifyAxis(part, axisOf(part), 1e-3, random);
    }
  }
  void turningAndReversingChangeNothing() {
    const MedialAxis axis = axisOf(wave());
    Eigen::Matrix<double, 2, 3> map;
    map << std::cos(0.7), -std::sin(0.7), 300, std::sin(0.7), std::cos(0.7), -20;
    Region turned;
    for (const Path& loop : wave().loops) turned.loops.push_back(reversed(transformed(loop, map)));
    const MedialAxis other = axisOf(turned);
    QCOMPARE(other.edges.size(), axis.edges.size());
    QCOMPARE(other.vertices.size(), axis.vertices.size());
    COMPARE_NEAR(lengthOf(other), lengthOf(axis), 0.05);
    for (const MedialVertex& vertex : axis.vertices) {
      const Vec2 wanted = map * Vec3(vertex.at.x(), vertex.at.y(), 1);
      COMPARE_NEAR((vertexAt(other, wanted).at - wanted).norm(), 0, 5e-3);
    }
  }
};

BLOSSOM_TEST(PocketMedialTest)
#include "pocket_medial_test.moc"
