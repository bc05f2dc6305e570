#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/medial/disc_proof.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "support/modeling.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;

/// Two chambers of 10 x 10, joined by a slot of 10 x 2.
Region chambersWithSlot(double shift = 0) {
  return {{polygonPath({{0, 0},
                        {10, 0},
                        {10, 4 + shift},
                        {20, 4 + shift},
                        {20, 0},
                        {30, 0},
                        {30, 10},
                        {20, 10},
                        {20, 6},
                        {10, 6},
                        {10, 10},
                        {0, 10}})}};
}

Region turnedAndMoved(const Region& region, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix<double, 2, 3> by;
  by << c, -s, 3, s, c, -2;
  Region out;
  for (const Path& loop : region.loops) out.loops.push_back(transformed(loop, by));
  return out;
}

/// Arcs that bulge around a centre, each moved by up to `gap`.
Region flower(int petals, double radius, double gap, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Path path;
  path.closed = true;
  for (int i = 0; i < petals; ++i) {
    const double half = fullTurn / 2 / petals, angle = fullTurn * i / petals;
    const Vec2 middle = radius * std::cos(half) * Vec2(std::cos(angle), std::sin(angle));
    const Vec2 off = gap * Vec2(unit(random), unit(random));
    path.segments.emplace_back(Arc2{middle + off, radius * std::sin(half), angle - fullTurn / 4, fullTurn / 2});
  }
  return {{path}};
}

}  // namespace

/// Offsets at the edge of what is possible: distances equal to a clearance, tiny gaps and jogs, places far away.
class PocketOffsetEdgesTest final : public QObject {
  Q_OBJECT
 private slots:
  /// At half the slot's width the slot is a line without area: two loops stay, each with a cusp towards the slot.
  void aDistanceEqualToAFlatClearance() {
    const double cusp = 2 - pi / 2;
    for (const double angle : {0.0, 0.1, 0.7, 1.234, 2.5}) {
      const Region part = turnedAndMoved(chambersWithSlot(), angle);
      const Region inset = ClearanceDiagram(part).offset(1, Side::Inside);
      QCOMPARE(inset.loops.size(), std::size_t(2));
      COMPARE_NEAR(areaOf(inset), 2 * (64 + cusp), 1e-6);
      // what overlaps is refused when it is extruded
      const Evaluated solid = made("extrude", {{"height", 2}}, {inset});
      COMPARE_NEAR(volume(solid), 4 * (64 + cusp), 1e-5);
    }
    // a little narrower and wider
    for (const double off : {1e-9, -1e-9, 1e-8, -1e-8, 1e-7, -1e-7}) {
      const Region inset = ClearanceDiagram(chambersWithSlot(off)).offset(1, Side::Inside);
      QCOMPARE(inset.loops.size(), std::size_t(2));
      COMPARE_NEAR(areaOf(inset), 2 * (64 + cusp), 1e-5);
    }
    QCOMPARE(ClearanceDiagram(chambersWithSlot(-0.01)).offset(1, Side::Inside).loops.size(), std::size_t(1));
    QCOMPARE(ClearanceDiagram(chambersWithSlot(0.01)).offset(1, Side::Inside).loops.size(), std::size_t(2));
  }

  /// The same outside: a slot of 2 mm between two walls is filled by 1 mm on each.
  void aFlatClearanceOutside() {
    const Region comb{{polygonPath({{0, 0}, {30, 0}, {30, 20}, {16, 20}, {16, 5}, {14, 5}, {14, 20}, {0, 20}})}};
    const Region grown = ClearanceDiagram(comb).offset(1, Side::Outside);
    QCOMPARE(grown.loops.size(), std::size_t(1));
    // the slot is filled up to the cusp between the corners at its mouth
    COMPARE_NEAR(areaOf(grown), 30 * 20 + 2 * 30 + 2 * 20 + pi - (2 - pi / 2), 1e-6);
  }

  void theLargestDistanceIsNamedOnce() {
    const Error none = refusal("offset", {{"distance", {10}}}, {Region{{boxPath(0, 0, 40, 20)}}});
    VERIFY_REFUSED(none, ErrorCode::InvalidParameter, "which is the radius of the largest disc that fits");
    QVERIFY(none.message().find("the distance must be below") == std::string::npos);
    VERIFY_REFUSED(refusal("offset", {{"distance", {10.5}}}, {Region{{boxPath(0, 0, 40, 20)}}}), ErrorCode::InvalidParameter,
                   "10.5 mm; the distance must be below 10 mm");
  }

  /// A little less than what is told leaves something; as much does not.
  void theDistanceToldIsTheLeastThatLeavesNothing() {
    for (const Region& part : {Region{{boxPath(0, 0, 40, 20)}}, Region{{circlePath({3, 4}, 7.3)}}, chambersWithSlot(),
                               Region{{polygonPath({{0, 0}, {30, 0}, {10, 17}})}}, Region{{wavyPath({0, 0}, 12, 2, 5)}}}) {
      const std::string told = refusal("offset", {{"distance", {100}}}, {part}).message();
      const std::string before = "must be below ";
      const std::size_t at = told.find(before);
      QVERIFY2(at != std::string::npos, told.c_str());
      const double most = std::stod(told.substr(at + before.size()));
      QVERIFY(!ClearanceDiagram(part).offset(most * 0.999, Side::Inside).loops.empty());
      for (const double share : {1.0, 1.001})
        VERIFY_REFUSED(refusal("offset", {{"distance", {most * share}}}, {part}), ErrorCode::InvalidParameter,
                       "left inside");
    }
  }

  void gapsBetweenArcs() {
    auto random = seededRandom();
    for (const double gap : {0.0, 1e-10, 1e-9, 5e-9, 1e-8})
      for (const int petals : {3, 4, 8}) {
        const ClearanceDiagram diagram(flower(petals, 3, gap, random));
        QCOMPARE(diagram.offset(0.2, Side::Outside).loops.size(), std::size_t(1));
        COMPARE_NEAR(areaOf(diagram.offset(0.2, Side::Outside)), grownFlower(petals, 3, 0.2), 1e-5);
        COMPARE_NEAR(areaOf(diagram.offset(0.2, Side::Inside)), shrunkFlower(petals, 3, 0.2), 1e-5);
      }
  }

  void jogsBelowTheTolerance() {
    for (const double jog : {1e-9, 1e-8, 1e-7, 3e-7, 1e-6})
      for (const double back : {0.0, -1.0, 1.0})
        for (const double up : {-1.0, 1.0}) {
          const double x = 12.909252, size = 38.078381;
          const Region part{
              {polygonPath({{0, 0}, {x, 0}, {x + back * jog, up * jog}, {size, up * jog}, {size, 20}, {0, 20}})}};
          COMPARE_NEAR(areaOf(ClearanceDiagram(part).offset(2, Side::Inside)), (size - 4) * 16, 1e-4);
          COMPARE_NEAR(areaOf(ClearanceDiagram(part).offset(2, Side::Outside)), size * 20 + 2 * 2 * (size + 20) + 4 * pi,
                       1e-3);
        }
    // what crosses by more is refused as before
    const Region crossing{{polygonPath({{0, 0}, {15, 0}, {14, 0.01}, {14, -0.01}, {30, 0}, {30, 20}, {0, 20}})}};
    VERIFY_ERROR(ClearanceDiagram(crossing), ErrorCode::InvalidInput);
  }

  void farFromTheOrigin() {
    const Region far{{boxPath(1e6, 2e6, 1e6 + 30, 2e6 + 20), circlePath({1e6 + 15, 2e6 + 10}, 3, true)}};
    const Evaluated inset = made("offset", {{"distance", {2}}}, {far});
    COMPARE_NEAR(surfaceArea(inset), 26 * 16 - 25 * pi, 1e-5);
    const Value tool = {{"tool-diameter", 4}, {"depth", 2}};
    const Evaluated there = made("pocket", tool, {far});
    QVERIFY(!there.warnings.empty());
    QVERIFY2(there.warnings.back().find("--zero corner") != std::string::npos, there.warnings.back().c_str());
    Value cornered = tool;
    cornered["zero"] = "corner";
    const Evaluated here = made("pocket", cornered, {far});
    for (const ToolMove& move : here.shape.get<Toolpath>()->moves) QVERIFY(move.to.cwiseAbs().maxCoeff() < 50);
    QVERIFY(here.warnings.empty());
  }

  /// Chords shorter than the grid tells apart turn at random: refused at once with the least that will do.
  void tolerancesFinerThanTheGridAreRefused() {
    const Region part{{wavyPath({0, 0}, 25, 6, 5)}};
    try {
      const ClearanceDiagram diagram(part, {.tolerance = 1e-6});
      QFAIL("finer than the grid");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::InvalidParameter);
      QVERIFY2(error.message().find("finer than free-form curves") != std::string::npos, error.what());
      double minimum = 0;
      QCOMPARE(std::sscanf(error.hint().c_str(), "Give at least %lf mm", &minimum), 1);
      QVERIFY(minimum > 1e-6 && minimum <= 3e-6);
    }
    // what arcs give is exact with any chords, and straight lines have none
    COMPARE_NEAR(areaOf(ClearanceDiagram({{circlePath({3, 4}, 10)}}, {.tolerance = 1e-7}).offset(2, Side::Inside)), 64 * pi,
                 1e-9);
    COMPARE_NEAR(areaOf(ClearanceDiagram({{boxPath(0, 0, 40, 20)}}, {.tolerance = 1e-9}).offset(2, Side::Inside)), 36 * 16,
                 1e-9);
  }

  /// Every offset tells how far its own points are off, and how many joints the chords had to tell.
  void offsetsTellHowFarTheyAreOff() {
    const Evaluated inset = made("offset", {{"distance", {2, 4}}}, {Region{{wavyPath({0, 0}, 25, 6, 5)}}});
    for (const Value& each : inset.stats["offsets"]) {
      QVERIFY(each["farthest_off_mm"].get<double>() <= 1e-3);
      QVERIFY(each.contains("chord_joints"));
    }
    const Evaluated box = made("offset", {{"distance", {2}}}, {Region{{boxPath(0, 0, 40, 20)}}});
    QCOMPARE(box.stats["offsets"][0]["chord_joints"].get<int>(), 0);
    QVERIFY(box.stats["offsets"][0]["farthest_off_mm"].get<double>() < 1e-9);
    std::printf("figure offset_farthest_off_mm %.3g\n", inset.stats["offsets"][0]["farthest_off_mm"].get<double>());
  }

  /// A disc that no chord meets may still hold a curve: hulls tell.
  void discsAreProvedOnTheCurvesAsDrawn() {
    const Region part{{wavyPath({0, 0}, 25, 6, 5), circlePath({1, 2}, 3, true)}};
    const DiscProof proof(part, 1e-4, Progress::none());
    auto random = seededRandom();
    std::uniform_real_distribution<double> unit(-25, 25);
    const std::vector<Vec2> outline = flatten(part.loops[0], 1e-5);
    for (int i = 0; i < 300; ++i) {
      const Vec2 p(unit(random), unit(random));
      double nearest = std::abs((p - Vec2(1, 2)).norm() - 3);
      for (std::size_t k = 1; k < outline.size(); ++k) {
        const Vec2 along = outline[k] - outline[k - 1], offset = p - outline[k - 1];
        const double share = std::clamp(offset.dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (offset - share * along).norm());
      }
      // The chords lie within 1e-5 of the curve.
      QVERIFY(!proof.isClear(p, nearest + 2e-5));
      if (nearest > 1e-3) QVERIFY(proof.isClear(p, nearest - 1e-3));  // else there is no such disc
    }
    const Evaluated axis = made("medial-axis", {}, {part});
    QCOMPARE(figure(axis.shape, "uncertified"), 0.0);
    std::printf("figure discs_proved %g\n", figure(axis.shape, "certified"));
  }

 private:
  /// Half a petal is a quarter disc on a triangle; the corner between petals takes a sector out of it.
  static double shrunkFlower(int petals, double radius, double distance) {
    const double half = fullTurn / 2 / petals, apart = radius * std::cos(half), petal = radius * std::sin(half);
    const double disc = pi * (petal - distance) * (petal - distance) / 4;
    return 2 * petals * (disc + apart * petal / 2 - distance * distance / 2 * (pi / 2 - half));
  }
  /// The larger discs meet on the lines from the middle to the corners.
  static double grownFlower(int petals, double radius, double distance) {
    const double half = fullTurn / 2 / petals, apart = radius * std::cos(half), grown = radius * std::sin(half) + distance;
    constexpr int steps = 4000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double angle = half * (i + 0.5) / steps, across = apart * std::sin(angle);
      const double reach = apart * std::cos(angle) + std::sqrt(grown * grown - across * across);
      sum += reach * reach / 2 * half / steps;
    }
    return 2 * petals * sum;
  }
};

BLOSSOM_TEST(PocketOffsetEdgesTest)
#include "pocket_offset_edges_test.moc"
