#include <algorithm>
#include <numbers>
#include <vector>

#include "geometry/bspline/bspline.h"
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

Vec2 placeOn(const Segment& segment, double parameter) {
  if (const auto* line = std::get_if<Line2>(&segment)) return line->from + parameter * (line->to - line->from);
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double angle = arc->start + parameter * arc->sweep;
    return arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle));
  }
  const Vec4 place = evaluate(toCurve(std::get<Spline2>(segment)), parameter);
  return {place.x() / place.w(), place.y() / place.w()};
}

/// Each foot lies where its parameter says, as far from the point as the clearance, the left one to the left.
/// @returns the largest error of a distance
double verifyFeet(const Region& part, const MedialAxis& axis, double tolerance = 1e-3) {
  double worst = 0;
  for (const MedialEdge& edge : axis.edges) {
    if (edge.feet.size() != edge.points.size()) return 1e9;
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      const Vec2 x = edge.points[i].head<2>();
      for (const BoundaryFoot& foot : {edge.feet[i].left, edge.feet[i].right}) {
        const Segment& segment = part.loops.at(foot.loop).segments.at(foot.segment);
        worst = std::max({worst, (placeOn(segment, foot.parameter) - foot.at).norm(),
                          std::abs((foot.at - x).norm() - edge.points[i].z())});
      }
      const Vec3 along = i == 0 ? Vec3(Vec3::Zero()) : Vec3(edge.points[i] - edge.points[i - 1]);
      if (along.norm() < tolerance) continue;  // beside a vertex the axis may run to and fro
      const Vec2 middle = (edge.points[i] + edge.points[i - 1]).head<2>() / 2;
      const Vec2 left = (edge.feet[i].left.at + edge.feet[i - 1].left.at) / 2;
      const Vec2 right = (edge.feet[i].right.at + edge.feet[i - 1].right.at) / 2;
      worst = std::max(
          {worst, -cross(along.head<2>().normalized(), left - middle), cross(along.head<2>().normalized(), right - middle)});
    }
  }
  return worst;
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
  void theFeetOfARectangleLieOnItsSides() {
    const Region part{{boxPath(0, 0, 60, 40)}};
    const MedialAxis axis = axisOf(part);
    const auto long_ = std::find_if(axis.edges.begin(), axis.edges.end(), [](const MedialEdge& edge) {
      return (edge.points.front() - edge.points.back()).head<2>().norm() > 19 && edge.points.front().z() == 20;
    });
    QVERIFY(long_ != axis.edges.end());
    for (std::size_t i = 0; i < long_->points.size(); ++i) {
      const MedialFeet& feet = long_->feet[i];
      const bool isForwards = long_->points.back().x() > long_->points.front().x();
      const BoundaryFoot& below = isForwards ? feet.right : feet.left;
      const BoundaryFoot& above = isForwards ? feet.left : feet.right;
      QCOMPARE(below.segment, std::size_t(0));
      QCOMPARE(above.segment, std::size_t(2));
      COMPARE_NEAR(below.parameter, long_->points[i].x() / 60, 1e-12);
      COMPARE_NEAR(above.parameter, 1 - long_->points[i].x() / 60, 1e-12);
    }
    QVERIFY(verifyFeet(part, axis) <= 1e-12);
  }
  /// The feet of the disc around (x, 0) have x a^2 / (a^2 - b^2) as their x.
  void theFeetOfAnEllipseAreItsNormals() {
    const double a = 20, b = 9;
    const Region part = ellipse(a, b);
    const MedialAxis axis = axisOf(part);
    for (std::size_t i = 0; i < axis.edges[0].points.size(); ++i) {
      const double wanted = axis.edges[0].points[i].x() * a * a / (a * a - b * b);
      // At the leaves the disc clings to the ellipse.
      const double within = std::abs(wanted) > a - 0.1 ? 0.05 : 1e-6;
      COMPARE_NEAR(axis.edges[0].feet[i].left.at.x(), wanted, within);
      COMPARE_NEAR(axis.edges[0].feet[i].right.at.x(), wanted, within);
    }
    QVERIFY(verifyFeet(part, axis) <= 1e-6);
  }
  void everyFootLiesWhereItsDiscTouches() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> share(0.05, 0.4), size(8, 30);
    std::uniform_int_distribution<int> waves(2, 9);
    std::vector<Region> parts{wave(), Region{{boxPath(0, 0, 60, 40), circlePath({25, 18}, 9, true)}}};
    for (int i = 0; i < 12; ++i) {
      const double radius = size(random);
      parts.push_back({{wavyPath({0, 0}, radius, share(random) * radius, waves(random)),
                        wavyPath({0.1 * radius, 0}, 0.3 * radius, share(random) * 0.3 * radius, waves(random), true)}});
    }
    for (const Region& part : parts) {
      const ClearanceDiagram diagram(part, {1e-3});
      const double worst = verifyFeet(diagram.region(), diagram.medialAxis());
      QVERIFY2(worst <= 1e-3 / 2, qPrintable(QString::number(worst)));
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
