#include <limits>
#include <numbers>
#include <string>

#include "geometry/planar/planar.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/support.h"
#include "support/true_distance.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

/// What a region is refused with; empty when it is taken.
std::string refusalOf(const Region& region) {
  try {
    (void)ClearanceDiagram(region);
  } catch (const Error& error) {
    return std::string(errorCodeName(error.code())) + ": " + error.message() + " " + error.hint();
  }
  return {};
}

#define VERIFY_SAID(region, ...)                                                                                          \
  do {                                                                                                                    \
    const std::string said_ = refusalOf(region);                                                                          \
    for (const char* part_ : {__VA_ARGS__}) QVERIFY2(said_.find(part_) != std::string::npos, ("said: " + said_).c_str()); \
  } while (false)

/// Random polygon that is seen whole from its middle.
Path spikes(std::mt19937_64& random, int corners) {
  std::uniform_real_distribution<double> share(0.3, 1);
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = fullTurn * (k + 0.7 * share(random)) / corners;
    points.push_back(25 * share(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygonPath(points);
}

/// Boost's sweep line and CGAL's Delaunay graph give the same offsets and axes.
void verifyPeers(const Region& part) {
  const ClearanceDiagram sweep(part);
  const ClearanceDiagram peer(part, {.exactPredicates = true});
  QCOMPARE(QString::fromStdString(sweep.stats().method), QStringLiteral("sweep line"));
  QCOMPARE(QString::fromStdString(peer.stats().method), QStringLiteral("Delaunay graph"));
  COMPARE_NEAR(peer.largestClearance(), sweep.largestClearance(), 1e-6);
  for (const double share : {0.05, 0.3, 0.7, 0.95})
    for (const Side side : {Side::Inside, Side::Outside}) {
      const double d = share * sweep.largestClearance();
      const Region a = sweep.offset(d, side), b = peer.offset(d, side);
      QCOMPARE(b.loops.size(), a.loops.size());
      COMPARE_NEAR(area(b), area(a), 1e-3 * perimeter(a));
      COMPARE_NEAR(perimeter(b), perimeter(a), 2e-3 * perimeter(a));
    }
  const MedialAxis a = sweep.medialAxis(), b = peer.medialAxis();
  QCOMPARE(b.edges.size(), a.edges.size());
  QCOMPARE(b.vertices.size(), a.vertices.size());
  COMPARE_NEAR(lengthOf(b), lengthOf(a), 1e-3 * lengthOf(a));
}

}  // namespace

/// What a diagram takes and refuses, its clearances, and its two ways of being built.
class PocketDiagramTest final : public QObject {
  Q_OBJECT
 private slots:
  void nothingIsRefused() {
    VERIFY_SAID(Region{}, "The region is empty", "Give a region");
    Path speck;
    speck.closed = true;
    speck.segments.emplace_back(Line2{{1, 1}, {1, 1}});
    QVERIFY(!refusalOf({{speck}}).empty());
  }
  void openOutlinesAreRefusedWithTheirEnds() {
    Path open = boxPath(0, 0, 10, 5);
    open.segments.pop_back();
    open.closed = false;
    VERIFY_SAID(Region{{open}}, "(0, 0)", "(0, 5)", "Close");
  }
  void crossingOutlinesAreRefusedWithThePlace() {
    VERIFY_SAID(Region{{polygonPath({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}}, "(5, 5)", "Redraw");
    VERIFY_SAID((Region{{boxPath(0, 0, 10, 10), circlePath({10, 5}, 2, true)}}), "crosses itself near (10, ", "Redraw");
    VERIFY_SAID((Region{{boxPath(0, 0, 10, 10), boxPath(10, 0, 20, 10)}}), "runs along itself near (10, ");
  }
  void curvesThatCrossAreRefused() {
    // A figure of eight drawn by one spline.
    Spline2 eight;
    eight.degree = 3;
    for (int i = 0; i < 19; ++i) {
      const double turn = fullTurn * i / 16;
      eight.poles.emplace_back((20 + 8 * std::cos(turn)) * std::cos(turn), 10 * std::sin(2 * turn), 1);
    }
    for (int i = 0; i < 23; ++i) eight.knots.push_back(i);
    Path path;
    path.closed = true;
    path.segments.emplace_back(eight);
    VERIFY_SAID(Region{{path}}, "crosses itself near (0.391, 0)");  // 8/3 sin^2(22.5 deg)
  }
  /// The corners of two squares meet: allowed where they touch, refused where a line goes through.
  void outlinesMayTouchButNotPassThroughAPoint() {
    const Region touching{{boxPath(0, 0, 10, 10), boxPath(10, 10, 20, 20)}};
    QCOMPARE(refusalOf(touching), std::string());
    COMPARE_NEAR(area(ClearanceDiagram(touching).offset(1, Side::Inside)), 128, 1e-9);
    VERIFY_SAID(Region{{polygonPath({{0, 0}, {10, 10}, {20, 20}, {20, 10}, {10, 10}, {0, 20}})}},
                "crosses itself near (10, 10)");
  }
  void numbersThatAreNoneAreRefused() {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      VERIFY_SAID(Region{{polygonPath({{0, 0}, {10, 0}, {bad, 10}})}}, "Segment 2 of outline 1", "finite");
      VERIFY_SAID(Region{{circlePath({0, 0}, bad)}}, "finite");
    }
  }
  void endlesslyFineToleranceIsRefused() {
    VERIFY_ERROR(ClearanceDiagram(wave(), {.tolerance = 1e-13}), ErrorCode::LimitExceeded);
  }
  void cancelStopsIt() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(ClearanceDiagram(wave(), {}, Progress(token)), ErrorCode::Cancelled);
  }
  void clearancesAreTrueDistances() {
    std::mt19937_64 random = seededRandom();
    const Region part = wave();
    const ClearanceDiagram diagram(part);
    const TrueDistance truth(part.loops);
    std::uniform_real_distribution<double> place(-45, 45);
    for (int i = 0; i < 2000; ++i) {
      const Vec2 x(place(random), place(random));
      const double wanted = windingAround(part.loops, x) == 1 ? truth(x) : -truth(x);
      COMPARE_NEAR(diagram.clearance(x), wanted, 1e-7);
    }
  }
  /// Near the centre of curvature many points of a curve are almost equally far. Of the parabola y = x^2 / 20 mm the nearest
  /// one is a root of a cubic.
  void clearancesHoldAtTheCentreOfCurvature() {
    const double p = 10;  // radius of curvature at the vertex, and y = x^2 / (2 p)
    Spline2 parabola;
    parabola.degree = 2;
    parabola.poles = {{-30, 45, 1}, {0, -45, 1}, {30, 45, 1}};
    parabola.knots = {0, 0, 0, 1, 1, 1};
    Path path;
    path.closed = true;
    path.segments = {parabola, Line2{{30, 45}, {-30, 45}}};
    const ClearanceDiagram diagram(Region{{path}});
    const auto distance = [&](const Vec2& x) {
      double best = std::numeric_limits<double>::infinity();
      // t^3 + 2 p (p - y) t - 2 p^2 x = 0, bisected in every stretch between its turning points.
      const double linear = 2 * p * (p - x.y()), turn = linear < 0 ? std::sqrt(-linear / 3) : 0;
      const auto value = [&](double t) { return t * t * t + linear * t - 2 * p * p * x.x(); };
      for (const auto& [from, to] : {std::pair(-30.0, -turn), std::pair(-turn, turn), std::pair(turn, 30.0)}) {
        double low = from, high = to;
        if ((value(low) > 0) == (value(high) > 0)) continue;
        for (int i = 0; i < 200; ++i) ((value(low) > 0) == (value((low + high) / 2) > 0) ? low : high) = (low + high) / 2;
        best = std::min(best, (Vec2(low, low * low / (2 * p)) - x).norm());
      }
      return best;
    };
    for (const double up : {-1e-1, -1e-3, -1e-6, 0.0, 1e-6, 1e-3, 1e-1, 1.0})
      for (const double aside : {-1.0, -1e-3, 0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.5}) {
        const Vec2 x(aside, p + up);
        COMPARE_NEAR(diagram.clearance(x), distance(x), 1e-12);
      }
  }
  void bothWaysOfBuildingAgree() {
    std::mt19937_64 random = seededRandom();
    verifyPeers(wave());
    verifyPeers({{boxPath(0, 0, 60, 40), circlePath({25, 18}, 9, true)}});
    for (int i = 0; i < 5; ++i) verifyPeers({{spikes(random, 7 + 4 * i)}});
  }
  /// Sizes from a watch to a ship, and a part far from the origin.
  void sizeAndPlaceDoNotMatter() {
    for (const double size : {0.05, 1.0, 1e3, 1e6}) {
      const Region part{{boxPath(0, 0, 3 * size, 2 * size), circlePath({size, size}, 0.4 * size, true)}};
      const ClearanceDiagram diagram(part, {.tolerance = 1e-4 * size});
      const double d = 0.2 * size;
      COMPARE_NEAR(area(diagram.offset(d, Side::Inside)) / (size * size), 2.6 * 1.6 - std::numbers::pi * 0.36, 1e-6);
    }
    const Region far{{boxPath(1e6, -2e6, 1e6 + 30, -2e6 + 20)}};
    COMPARE_NEAR(area(ClearanceDiagram(far).offset(2, Side::Inside)), 26 * 16, 1e-5);
  }
};

BLOSSOM_TEST(PocketDiagramTest)
#include "pocket_diagram_test.moc"
