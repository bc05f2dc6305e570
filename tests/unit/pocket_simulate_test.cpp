#include <numbers>

#include "core/angle.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/check/simulate.h"
#include "pocket/kernel/stroke/inside_test.h"
#include "pocket/kernel/stroke/stroke_tree.h"
#include "pocket/kernel/stroke/walls.h"
#include "support/planar_parts.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;

Path closedPolygon(const std::vector<Vec2>& corners) {
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < corners.size(); ++i)
    path.segments.emplace_back(Line2{corners[i], corners[(i + 1) % corners.size()]});
  return path;
}

Region rectangle(double width, double height) {
  return {{closedPolygon({{0, 0}, {width, 0}, {width, height}, {0, height}})}};
}

Region disc(double radius) {
  Path path;
  path.closed = true;
  path.segments.emplace_back(Arc2{{0, 0}, radius, 0, fullTurn});
  return {{path}};
}

/// Down at the first point, along the others at z, up again.
Toolpath along(const std::vector<Vec2>& points, double z, double diameter) {
  Toolpath path;
  path.cutter.diameter = diameter;
  path.start = {points.front().x(), points.front().y(), 5};
  const auto add = [&](MoveKind kind, const Vec2& p, double height) {
    ToolMove move;
    move.kind = kind;
    move.to = {p.x(), p.y(), height};
    move.feed = kind == MoveKind::Rapid ? 0 : 100;
    path.moves.push_back(move);
  };
  add(MoveKind::Plunge, points.front(), z);
  for (std::size_t i = 1; i < points.size(); ++i) add(MoveKind::Feed, points[i], z);
  add(MoveKind::Rapid, points.back(), 5);
  return path;
}

Stroke randomStroke(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return Vec2(4 * unit(random) - 2, 4 * unit(random) - 2); };
  if (unit(random) < 0.5) return Stroke::line(point(), point());
  const double sweep = (unit(random) < 0.5 ? -1 : 1) * (unit(random) < 0.1 ? 1 : unit(random)) * fullTurn;
  return Stroke::arc(point(), 0.05 + 2 * unit(random), 7 * unit(random) - 3.5, sweep);
}

}  // namespace

class PocketSimulateTest final : public QObject {
  Q_OBJECT
 private slots:
  /// Closed forms against brute force over samples.
  void distancesOfStrokes() {
    auto random = seededRandom();
    for (int k = 0; k < 1000; ++k) {
      const Stroke a = randomStroke(random), b = randomStroke(random);
      const double exact = distance(a, b);
      double sampled = 1e300;
      constexpr int count = 200;
      for (int i = 0; i <= count; ++i) sampled = std::min(sampled, distance(b, a.at(static_cast<double>(i) / count)));
      QVERIFY(exact <= sampled + 1e-12);
      // the distance changes at most as fast as one walks
      QVERIFY2(exact >= sampled - a.length() / count / 2 - 1e-12, qPrintable(QString("%1 %2").arg(exact).arg(sampled)));
      COMPARE_NEAR(exact, distance(b, a), 1e-12);
      double nearest = 1e300;
      for (int i = 0; i <= 2000; ++i) nearest = std::min(nearest, (a.at(i / 2000.0) - b.from).norm());
      COMPARE_NEAR(distance(a, b.from), nearest, a.length() / 2000);
    }
  }

  void treesFindWhatBruteForceFinds() {
    auto random = seededRandom();
    std::vector<Stroke> strokes;
    for (int k = 0; k < 300; ++k) strokes.push_back(randomStroke(random));
    const StrokeTree tree(strokes);
    for (int k = 0; k < 300; ++k) {
      const Stroke wanted = randomStroke(random);
      double best = 1e300, bestPoint = 1e300;
      for (const Stroke& s : strokes) {
        best = std::min(best, distance(s, wanted));
        bestPoint = std::min(bestPoint, distance(s, wanted.from));
      }
      QCOMPARE(tree.nearest(wanted).distance, best);
      QCOMPARE(tree.nearest(wanted.from).distance, bestPoint);
      QCOMPARE(tree.nearest(wanted.from, bestPoint / 2).stroke, strokes.size());
    }
  }

  void insideIsWhereTheWindingNumberSaysSo() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> unit(-1.2, 1.2);
    Path path;
    path.closed = true;
    path.segments = {Line2{{-1, -1}, {1, -1}}, Arc2{{1, 0}, 1, -pi / 2, pi}, Line2{{1, 1}, {-1, 1}},
                     Arc2{{-1, 0}, 1, pi / 2, -pi}};
    const InsideTest inside(strokesOf(path, 1e-4));
    for (int k = 0; k < 5000; ++k) {
      const Vec2 p(2 * unit(random), unit(random));
      QCOMPARE(inside(p), windingNumber(path, p) != 0);
    }
  }

  /// Letters in a line and in a block: rows that many loops cross.
  void insideHoldsAmongManyLoops() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> unit(0, 1);
    for (const int columns : {40, 7}) {
      std::vector<Path> loops;
      std::vector<Stroke> strokes;
      for (int k = 0; k < 40; ++k) {
        const Vec2 at(5 * (k % columns), 5 * (k / columns));
        for (const Path& loop : {circlePath(at, 1 + unit(random)), boxPath(at.x() - 0.4, at.y() - 0.5, at.x() + 0.3, at.y()),
                                 wavyPath(at + Vec2(0.2, 0.1), 0.7, 0.2, 3)}) {
          loops.push_back(loop);
          for (const Stroke& s : strokesOf(loop, 1e-3)) strokes.push_back(s);
        }
      }
      const InsideTest inside(strokes);
      const StrokeTree tree(strokes);
      for (int k = 0; k < 4000; ++k) {
        const Vec2 p((5 * columns + 4) * unit(random) - 3, (200 / columns + 6) * unit(random) - 3);
        if (tree.nearest(p).distance < 2e-3) continue;  // the loops are splines, the strokes lines beside them
        const auto around =
            std::count_if(loops.begin(), loops.end(), [&](const Path& loop) { return windingNumber(loop, p) != 0; });
        QCOMPARE(inside(p), around % 2 != 0);
      }
    }
  }

  /// Rays at the very height of a joint, where rounding could leave a gap.
  void insideHoldsAtTheHeightsOfJoints() {
    Path ellipse;
    ellipse.closed = true;
    ellipse.segments.emplace_back(ellipticArc({0, 0}, {16, 0}, 0.625, 0, fullTurn));
    for (const Path& path :
         {ellipse, wavyPath({1.1, 0.7}, 9, 2, 5), circlePath({0.1, 0.3}, 7), circlePath({0.1, 0.3}, 7, true)}) {
      const std::vector<Stroke> strokes = strokesOf(path, 1e-3);
      const InsideTest inside(strokes);
      for (const Stroke& s : strokes)
        for (const double y : {s.from.y(), s.to.y(), std::nextafter(s.from.y(), 1e9), std::nextafter(s.from.y(), -1e9)})
          for (const double x : {-30.0, 30.0}) QVERIFY(!inside({x, y}));
    }
  }

  void gougeIsHowDeepTheToolCutsIntoTheWall() {
    const Region part = rectangle(40, 30);
    const Vec2 a(5, 5), b(35, 5), c(35, 25), d(5, 25);
    COMPARE_NEAR(simulate(along({a, b, c, d, a}, -2, 10), part).gouge, 0, 1e-12);
    COMPARE_NEAR(simulate(along({a, b, c, d, a}, -2, 10.5), part).gouge, 0.25, 1e-12);
    // the straight way from corner to corner of an L runs over the inner corner
    const Region l{{closedPolygon({{0, 0}, {40, 0}, {40, 10}, {10, 10}, {10, 40}, {0, 40}})}};
    const auto crossing = simulate(along({{35, 5}, {5, 35}}, -1, 6), l);
    COMPARE_NEAR(crossing.gouge, 3 + 10, 1e-3);  // the middle (20, 20) lies 10 mm beyond both walls
    // within the stock above the part nothing is gouged
    Toolpath above = along({{20, 15}, {20, 16}}, -1, 6);
    for (const Vec2& p : {Vec2(-50, 16), Vec2(90, 16)})
      above.moves.push_back({.kind = MoveKind::Feed, .to = {p.x(), p.y(), 1}, .feed = 100});
    COMPARE_NEAR(simulate(above, part).gouge, 0, 1e-12);
    // deeper than the floor
    COMPARE_NEAR(simulate(along({a, b}, -2.25, 10), part, {.depth = 2}).gouge, 0.25, 1e-12);
    // outside of everything
    COMPARE_NEAR(simulate(along({{60, 5}, {60, 6}}, -2, 10), part).gouge, 5 + 20, 1e-12);
  }

  void curvedWaysAreMeasuredToo() {
    // a circle of the tool's centre in a disc, and one that is half a hundredth too wide
    for (const double radius : {7.0, 7.005}) {
      Toolpath path = along({{radius, 0}}, -1, 6);
      path.moves.insert(path.moves.begin() + 1,
                        ToolMove{.kind = MoveKind::Feed, .to = {radius, 0, -1}, .turn = 1, .center = {0, 0}, .feed = 100});
      COMPARE_NEAR(simulate(path, disc(10)).gouge, radius - 7, 1e-9);
    }
  }

  void waysAlongAWallAreMeasuredAllTheirLength() {
    // On the wall for almost a metre, but for a notch early on, whose middle is 2 mm from the part.
    const Region notched{{closedPolygon({{0, 0}, {10, 0}, {10, 3}, {14, 3}, {14, 0}, {1000, 0}, {1000, 50}, {0, 50}})}};
    const SimulationResult found = simulate(along({{5, 0}, {995, 0}}, -1, 2), notched, {.depth = 1});
    COMPARE_NEAR(found.gouge, 3, 1e-4);
    COMPARE_NEAR(found.gougeAt.x(), 12, 0.01);
  }

  void waysThatLeaveThePartAgainstSamples() {
    auto random = seededRandom();
    const auto unit = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
    for (int k = 0; k < 200; ++k) {
      const double width = 0.5 + 2 * unit(), height = 0.5 + unit();
      Region part = k % 2 == 0 ? rectangle(width, height) : disc(width);
      if (k % 4 < 2) part.loops.push_back(circlePath({width / 2, 0.25}, 0.05 + 0.15 * unit(), true));
      const Walls walls(part, 1e-6);
      Stroke way = randomStroke(random);
      if (k % 8 == 1)
        way = Stroke::arc({0, 0}, width * (0.5 + unit()), 7 * unit(), 1 + 5 * unit());  // beside the disc's wall
      const double radius = 0.05 + 0.3 * unit();
      constexpr int samples = 20'000;
      double deepest = 0;
      for (int i = 0; i <= samples; ++i) deepest = std::max(deepest, walls.depth(way.at(double(i) / samples), radius));
      const double told = walls.gouge(way, radius, Progress::none()).first;
      const double between = way.length() / samples / 2;
      QVERIFY2(told >= deepest - 2e-5 && told <= deepest + between + 2e-5,
               qPrintable(QString("way %1: told %2, sampled %3").arg(k).arg(told, 0, 'g', 9).arg(deepest, 0, 'g', 9)));
    }
  }

  void residueOfOneCircle() {
    // The tool opens the whole disc of 10; one circle at 7 sweeps the ring from 4 to 10: a disc of 4 stays.
    Toolpath path = along({{7, 0}}, -1, 6);
    path.moves.insert(path.moves.begin() + 1,
                      ToolMove{.kind = MoveKind::Feed, .to = {7, 0, -1}, .turn = 1, .center = {0, 0}, .feed = 100});
    for (const double tolerance : {0.05, 0.01}) {
      const SimulationResult result = simulate(path, disc(10), {.tolerance = tolerance});
      const double inner = 4 - tolerance;
      COMPARE_NEAR(*result.residue, pi * inner * inner, 2 * pi * 4 * tolerance);
      COMPARE_NEAR(result.reachable, pi * 100, 0.05);
      QVERIFY(!result.residueAt.empty());
      for (const Vec2& p : result.residueAt) QVERIFY(p.norm() < 4);
    }
  }

  void marksOfResidueLieAllOverIt() {
    // A tool of 2 mm goes once along the lower wall of a field of 200 x 200: nearly all of it stays.
    const SimulationResult result = simulate(along({{1, 1}, {199, 1}}, -1, 2), rectangle(200, 200));
    QVERIFY(result.residueAt.size() > 8 && result.residueAt.size() <= 64);
    for (int k = 0; k < 16; ++k) {
      const Vec2 quarter(50 * (k % 4) + 25, 50 * (k / 4) + 25);
      QVERIFY2(std::any_of(result.residueAt.begin(), result.residueAt.end(),
                           [&](const Vec2& p) { return (p - quarter).norm() < 60; }),
               qPrintable(QString("none near (%1, %2)").arg(quarter.x()).arg(quarter.y())));
    }
  }

  void cornersOutOfReachAreNoResidue() {
    // a rectangle as wide as twice the tool: one time around clears what the tool opens
    const Toolpath path = along({{3, 3}, {37, 3}, {37, 9}, {3, 9}, {3, 3}}, -1, 6);
    const SimulationResult result = simulate(path, rectangle(40, 12));
    COMPARE_NEAR(*result.residue, 0, 1e-12);
    COMPARE_NEAR(result.reachable, 40 * 12 - (4 - pi) * 9, 0.02);
    // half of it not done
    const SimulationResult half = simulate(along({{20, 3}, {37, 3}, {37, 9}, {20, 9}, {20, 3}}, -1, 6), rectangle(40, 12));
    // left of the tool at x = 20: to its rim at 17, where its own corners of (4 - pi) 9 / 2 stay
    const double rest = 17 * 12 - (4 - pi) * 9 / 2 + (4 - pi) * 9 / 2;
    COMPARE_NEAR(*half.residue, rest, 0.8);
  }

  void whatIsToBeLeftIsNoResidue() {
    const Toolpath path = along({{4, 4}, {36, 4}, {36, 8}, {4, 8}, {4, 4}}, -1, 6);
    COMPARE_NEAR(*simulate(path, rectangle(40, 12), {.leave = 1}).residue, 0, 1e-12);
    QVERIFY(*simulate(path, rectangle(40, 12)).residue > 80);
  }

  void onlyTheFloorCounts() {
    Toolpath path = along({{3, 3}, {37, 3}, {37, 9}, {3, 9}, {3, 3}}, -1, 6);
    const Toolpath deeper = along({{3, 3}, {37, 3}}, -2, 6);
    path.moves.insert(path.moves.end(), deeper.moves.begin(), deeper.moves.end());
    QVERIFY(*simulate(path, rectangle(40, 12)).residue > 100);
    COMPARE_NEAR(*simulate(path, rectangle(40, 12), {.depth = 1}).residue, 0, 1e-12);
    COMPARE_NEAR(simulate(path, rectangle(40, 12), {.depth = 1}).gouge, 1, 1e-12);
  }

  void rapidsThroughMaterialAreCounted() {
    Toolpath path = along({{3, 3}, {37, 3}}, -1, 6);
    QCOMPARE(simulate(path, rectangle(40, 12)).rapidsInStock, std::size_t(0));
    path.moves.push_back({.kind = MoveKind::Rapid, .to = {3, 3, -0.5}});  // falling along what was cut
    QCOMPARE(simulate(path, rectangle(40, 12)).rapidsInStock, std::size_t(0));
    path.moves.back().to = {3, 9, -0.5};  // across, falling, from z = 5
    QCOMPARE(simulate(path, rectangle(40, 12)).rapidsInStock, std::size_t(1));
    QCOMPARE(simulate(path, rectangle(40, 12)).rapidMove, path.moves.size() - 1);
  }

  /// A tenth of a millimetre in material is seen in every direction, and rounding is not.
  void rapidsRunWhereCutsHaveClearedTheWay() {
    // a slot of 8 by cutters of 6 at y = 5 and 7, 2 deep, from x = 5 to 35
    const auto slot = [](const Vec3& rapid, double corner) {
      Toolpath path = along({{5, 5}, {35, 5}, {35, 7}, {5, 7}}, -2, 6);
      path.cutter.cornerRadius = corner;
      path.moves.push_back({.kind = MoveKind::Rapid, .to = {rapid.x(), rapid.y(), 5}});
      path.moves.push_back({.kind = MoveKind::Rapid, .to = rapid});
      return simulate(path, rectangle(40, 12)).rapidsInStock;
    };
    for (const double corner : {0.0, 1.0, 3.0}) {
      // between the two ways a ball has left a ridge
      QCOMPARE(slot({20, 6, -1.999}, corner), std::size_t(corner == 3 ? 1 : 0));
      for (const Vec3& free : {Vec3(20, 5, -2.01), Vec3(20, 7.01, -1), Vec3(35.01, 6, -1), Vec3(20, 6, -1)})
        QVERIFY2(slot(free, corner) == 0,
                 qPrintable(QString("%1: %2 %3 %4").arg(corner).arg(free.x()).arg(free.y()).arg(free.z())));
      for (const Vec3& hit :
           {Vec3(20, 6, -2.1), Vec3(20, 7.1, -2), Vec3(20, 4.9, -2), Vec3(4.88, 6, -2), Vec3(20, 11, -0.1)})
        QVERIFY2(slot(hit, corner) == 1,
                 qPrintable(QString("%1: %2 %3 %4").arg(corner).arg(hit.x()).arg(hit.y()).arg(hit.z())));
    }
    // Beside the stock there is nothing.
    Toolpath beside = along({{3, 3}, {37, 3}}, -1, 6);
    beside.moves.push_back({.kind = MoveKind::Rapid, .to = {-20, 3, 5}});
    beside.moves.push_back({.kind = MoveKind::Rapid, .to = {-20, 3, -1}});
    QCOMPARE(simulate(beside, rectangle(40, 12)).rapidsInStock, std::size_t(1));
    beside.stock.add(Vec3(-5, -5, -3));
    beside.stock.add(Vec3(45, 17, 0));
    QCOMPARE(simulate(beside, rectangle(40, 12)).rapidsInStock, std::size_t(0));
    beside.moves.rbegin()[1].to = {-7.9, 3, 5};
    beside.moves.back().to = {-7.9, 3, -1};
    QCOMPARE(simulate(beside, rectangle(40, 12)).rapidsInStock, std::size_t(1));
  }

  /// Ridges between passes of round tools: r - sqrt(r^2 - (step / 2)^2) high.
  void roundToolsLeaveRidges() {
    const auto combed = [](double corner, double step) {
      std::vector<Vec2> ways{{3, 3}, {37, 3}, {37, 9}, {3, 9}};
      for (double y = 3; y <= 9 + 1e-9; y += step) {
        const bool back = ways.size() % 4 != 0;
        ways.emplace_back(back ? 37 : 3, y);
        ways.emplace_back(back ? 3 : 37, y);
      }
      Toolpath path = along(ways, -4, 6);
      path.cutter.cornerRadius = corner;
      return simulate(path, rectangle(40, 12));
    };
    QCOMPARE(combed(0, 2).ridge, 0.0);
    COMPARE_NEAR(*combed(0, 2).residue, 0, 1e-9);
    COMPARE_NEAR(combed(3, 2).ridge, 3 - std::sqrt(8.0), 0.01);
    COMPARE_NEAR(combed(1, 6).ridge, 1 - std::sqrt(1.0 - 1), 0.01);  // its flat of 4 leaves 1 mm beside each way
    // At a hundredth above the floor a ball clears sqrt(0.01 * 5.99) beside its way; seven ways leave six strips between.
    const double clears = std::sqrt(0.01 * 5.99);
    const double strips = (34 - 2 * clears) * 6 * (1 - 2 * clears);
    const SimulationResult ball = combed(3, 1);
    COMPARE_NEAR(*ball.residue, strips, 0.06 * strips);
    COMPARE_NEAR(ball.ridge, 3 - std::sqrt(9 - 0.25), 0.004);
  }

  /// A control that may cut corners by a tenth cuts into what stands inside of them.
  void blendingBelongsToTheGouge() {
    // around the outside of a block in the middle, at exactly the tool's radius
    const Region ring{
        {closedPolygon({{0, 0}, {60, 0}, {60, 60}, {0, 60}}), closedPolygon({{20, 40}, {40, 40}, {40, 20}, {20, 20}})}};
    Toolpath path = along({{17, 17}, {43, 17}, {43, 43}, {17, 43}, {17, 17}}, -1, 6);
    COMPARE_NEAR(simulate(path, ring).gouge, 0, 1e-9);
    // At a sharp corner of the way there is room: it lies sqrt(2) radii from the block's corner.
    path.blending = 0.1;
    COMPARE_NEAR(simulate(path, ring).gouge, 0, 1e-9);
    Toolpath inwards = along({{40, 3}, {57, 3}, {57, 20}}, -1, 6);  // a corner of the pocket: the blend stays inside
    inwards.blending = 0.1;
    COMPARE_NEAR(simulate(inwards, ring).gouge, 0, 1e-9);
    // Around the block's corner in chords of 0.2: their middles cut in by their height, their ends by what the control
    // takes.
    std::vector<Vec2> chords{{30, 17}};
    for (int k = 0; k <= 5; ++k)
      chords.emplace_back(Vec2(40, 20) + 3 * Vec2(std::cos(0.2 * k - pi / 2), std::sin(0.2 * k - pi / 2)));
    Toolpath around = along(chords, -1, 6);
    COMPARE_NEAR(simulate(around, ring).gouge, 3 * (1 - std::cos(0.1)), 1e-4);
    around.blending = 0.02;
    COMPARE_NEAR(simulate(around, ring).gouge, 0.02, 1e-4);
    around.blending = 1;  // no farther than a curve from middle to middle
    COMPARE_NEAR(simulate(around, ring).gouge, 3 * std::sin(0.1) * std::sin(0.1), 1e-4);
  }

  void bullNosesAndVBitsAreNarrowAtTheTip() {
    COMPARE_NEAR(radiusAt({.diameter = 6, .cornerRadius = 3}, 3), 3, 1e-12);
    COMPARE_NEAR(radiusAt({.diameter = 6, .cornerRadius = 3}, 1.5), 3 * std::sqrt(0.75), 1e-12);
    COMPARE_NEAR(radiusAt({.diameter = 6, .cornerRadius = 1}, 0.5), 2 + std::sqrt(0.75), 1e-12);
    COMPARE_NEAR(radiusAt({.diameter = 6, .vAngle = pi / 2}, 2), 2, 1e-12);
    COMPARE_NEAR(radiusAt({.diameter = 6, .vAngle = pi / 2}, 20), 3, 1e-12);
    // a V bit of 90 degrees 1 mm deep is 1 mm wide on either side: 1.5 mm from the wall it does not touch it
    Toolpath path = along({{1.5, 1.5}, {38.5, 1.5}}, -1, 6);
    path.cutter.vAngle = pi / 2;
    const SimulationResult result = simulate(path, rectangle(40, 12));
    COMPARE_NEAR(result.gouge, 0, 1e-12);
    QVERIFY(!result.residue);
  }

  void rubbishIsRefused() {
    const Region part = rectangle(40, 12);
    VERIFY_ERROR(simulate(Toolpath(), part), ErrorCode::InvalidInput);
    VERIFY_ERROR(simulate(along({{3, 3}, {37, 3}}, -1, 0), part), ErrorCode::InvalidInput);
    VERIFY_ERROR(simulate(along({{3, 3}, {37, 3}}, -1, 6), Region()), ErrorCode::InvalidInput);
    VERIFY_ERROR(simulate(along({{3, 3}, {37, 3}}, 1, 6), part), ErrorCode::InvalidInput);
    VERIFY_ERROR(simulate(along({{3, 3}, {std::nan(""), 3}}, -1, 6), part), ErrorCode::InvalidInput);
    VERIFY_ERROR(simulate(along({{3, 3}, {37, 3}}, -1, 6), part, {.tolerance = 0}), ErrorCode::InvalidParameter);
    CancelToken cancelled;
    cancelled.cancel();
    VERIFY_ERROR(simulate(along({{3, 3}, {37, 3}}, -1, 6), part, {}, Progress(cancelled)), ErrorCode::Cancelled);
  }

  /// Two rooms and between them a slot just as wide as the tool: a program that leaves it out is told so.
  void aSlotAsWideAsTheToolIsMissedWhenItIsNotCut() {
    const Region part{{closedPolygon({{0, 0},
                                      {30, 0},
                                      {30, 17},
                                      {70, 17},
                                      {70, 0},
                                      {100, 0},
                                      {100, 40},
                                      {70, 40},
                                      {70, 23},
                                      {30, 23},
                                      {30, 40},
                                      {0, 40}})}};
    SimulationOptions options;
    options.depth = 2;
    options.tolerance = 0.01;
    const auto rooms = [](bool slot) {
      Toolpath path;
      for (const double left : {0.0, 70.0}) {
        std::vector<Vec2> way;
        for (double inset = 3; inset < 15; inset += 2)
          for (const Vec2& corner : {Vec2(inset, inset), Vec2(30 - inset, inset), Vec2(30 - inset, 40 - inset),
                                     Vec2(inset, 40 - inset), Vec2(inset, inset)})
            way.emplace_back(left + corner.x(), corner.y());
        const Toolpath room = along(way, -2, 6);
        if (path.moves.empty())
          path = room;
        else
          path.moves.insert(path.moves.end(), room.moves.begin(), room.moves.end());
      }
      const std::vector<Vec2> through{{20, 20}, {80, 20}};
      const Toolpath last = along(through, -2, 6);
      if (slot) path.moves.insert(path.moves.end(), last.moves.begin(), last.moves.end());
      return path;
    };
    const SimulationResult all = simulate(rooms(true), part, options), missed = simulate(rooms(false), part, options);
    COMPARE_NEAR(all.residue.value(), 0, 0.05);
    COMPARE_NEAR(missed.residue.value(), 240, 3);  // 40 x 6, less the tolerance at its walls
    QVERIFY(!missed.residueAt.empty());
  }
};

BLOSSOM_TEST(PocketSimulateTest)
#include "pocket_simulate_test.moc"
