#include <numbers>

#include "geometry/planar/planar.h"
#include "pocket/kernel/check/simulate.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "pocket/kernel/path/pocket_path.h"
#include "support/planar_parts.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;

PocketOptions tool(double diameter, double depth, double stepover = 0) {
  PocketOptions o;
  o.cutter.diameter = diameter;
  o.depth = depth;
  o.stepover = stepover;
  return o;
}

Region plateWithIsland() { return {{boxPath(0, 0, 60, 40), circlePath({30, 20}, 8, true)}}; }

/// mm that a path cuts at its floor.
double lengthAtFloor(const Toolpath& path, double floor) {
  double sum = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (path.moves[i].to.z() == floor && startOf(path, i).z() == floor) sum += lengthOf(startOf(path, i), path.moves[i]);
  return sum;
}

std::string described(const SimulationResult& s) {
  std::string text = "gouge " + std::to_string(s.gouge) + " residue " + std::to_string(s.residue.value_or(-1)) +
                     " rapids in stock " + std::to_string(s.rapidsInStock);
  if (!s.residueAt.empty()) text += " at " + std::to_string(s.residueAt[0].x()) + ", " + std::to_string(s.residueAt[0].y());
  return text;
}

/// The promises of every path: it cuts no wall, leaves nothing, runs no rapid through material, and joins up.
void verifyPath(const Region& part, const PocketOptions& o, PocketResult* out = nullptr) {
  const PocketResult made = pocketPath(part, o);
  const SimulationResult s =
      simulate(made.path, part, {.depth = o.depth - o.leaveFloor, .leave = o.leaveWall, .tolerance = 0.02});
  QVERIFY2(s.gouge <= o.tolerance + 1e-6, described(s).c_str());
  QVERIFY2(*s.residue == 0, described(s).c_str());
  QVERIFY2(s.rapidsInStock == 0, described(s).c_str());
  for (std::size_t i = 0; i < made.path.moves.size(); ++i) {
    const ToolMove& m = made.path.moves[i];
    const Vec3 from = startOf(made.path, i);
    QVERIFY(m.to.allFinite());
    QVERIFY(m.kind == MoveKind::Rapid || m.feed > 0);
    if (m.turn != 0) COMPARE_NEAR((from.head<2>() - m.center).norm(), (m.to.head<2>() - m.center).norm(), 1e-6);
    if (m.kind == MoveKind::Rapid && m.to.head<2>() != from.head<2>()) QCOMPARE(m.to.z(), o.safeHeight);
  }
  QCOMPARE(made.path.moves.back().to.z(), o.safeHeight);
  if (out) *out = made;
}

}  // namespace

class PocketPathTest final : public QObject {
  Q_OBJECT
 private slots:
  /// A disc of 10 with a tool of radius 3 and steps of 2: circles at 7, 5, 3 and 1.
  void aRoundPocketIsCutInCircles() {
    const Region disc{{circlePath({5, -2}, 10)}};
    PocketOptions o = tool(6, 2, 2);
    o.stepdown = 2;
    o.entry = Entry::Plunge;
    PocketResult made;
    verifyPath(disc, o, &made);
    QCOMPARE(made.depths, std::size_t(1));
    QCOMPARE(made.loops, std::size_t(4));
    QCOMPARE(made.spokes, std::size_t(0));
    // four circles and three steps between them
    COMPARE_NEAR(lengthAtFloor(made.path, -2), 2 * pi * (7 + 5 + 3 + 1) + 3 * 2, 0.05);
  }

  void aRectangleIsCutInRectangles() {
    // passes at 3, 5 and 7 mm from the walls of 60 x 20; at 9 the rest is 42 x 2
    const Region box{{boxPath(0, 0, 60, 20)}};
    PocketOptions o = tool(6, 1, 2);
    PocketResult made;
    verifyPath(box, o, &made);
    QCOMPARE(made.loops, std::size_t(4));
    double sum = 0;
    for (const double d : {3.0, 5.0, 7.0, 9.0}) sum += 2 * (60 - 2 * d) + 2 * (20 - 2 * d);
    COMPARE_NEAR(lengthAtFloor(made.path, -1), sum + 3 * 2, 0.1);
  }

  void depthsAreEven() {
    PocketOptions o = tool(6, 10);
    o.stepdown = 3;
    PocketResult made;
    verifyPath(plateWithIsland(), o, &made);
    QCOMPARE(made.depths, std::size_t(4));
    QCOMPARE(made.path.passes, std::size_t(4));
    std::set<double> floors;
    for (std::size_t i = 0; i < made.path.moves.size(); ++i)
      if (made.path.moves[i].kind == MoveKind::Feed && made.path.moves[i].to.z() < 0)
        floors.insert(made.path.moves[i].to.z());
    QVERIFY(floors.size() == 4);
    double wanted = -10;
    for (const double z : floors) {
      COMPARE_NEAR(z, wanted, 1e-12);
      wanted += 2.5;
    }
  }

  void everyStepoverLeavesNothing_data() {
    QTest::addColumn<double>("share");
    for (const double share : {0.1, 0.3, 0.45, 0.5, 0.6, 0.75, 0.85, 0.95, 1.0})
      QTest::newRow(qPrintable(QString::number(100 * share))) << share;
  }
  void everyStepoverLeavesNothing() {
    QFETCH(double, share);
    const double d = 5;
    verifyPath(plateWithIsland(), tool(d, 2, share * d));
    verifyPath({{boxPath(0, 0, 31, 47)}}, tool(d, 2, share * d));
    verifyPath({{circlePath({0, 0}, 17.3)}}, tool(d, 2, share * d));
    verifyPath({{polygonPath({{0, 0}, {50, 0}, {20, 12}, {12, 50}, {-6, 20}})}}, tool(d, 2, share * d));
    verifyPath({{wavyPath({0, 0}, 25, 6, 5), wavyPath({2, 1}, 8, 1.5, 3, true)}}, tool(d, 2, share * d));
  }

  /// Wide steps do leave something without spokes: the test above would not see it otherwise.
  void spokesAreNeededAndMade() {
    PocketResult made;
    verifyPath({{polygonPath({{0, 0}, {60, 0}, {30, 52}})}}, tool(6, 1, 5.7), &made);
    QVERIFY(made.spokes > 0);
    verifyPath({{polygonPath({{0, 0}, {60, 0}, {30, 52}})}}, tool(6, 1, 3), &made);
    QCOMPARE(made.spokes, std::size_t(0));
  }

  void randomPolygonsWithIslands() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 25; ++k) {
      const int corners = 3 + static_cast<int>(10 * unit(random));
      std::vector<Vec2> outer;
      for (int i = 0; i < corners; ++i) {
        const double angle = fullTurn * (i + 0.7 * unit(random)) / corners, r = 20 + 20 * unit(random);
        outer.emplace_back(r * std::cos(angle), r * std::sin(angle));
      }
      Region part{{polygonPath(outer)}};
      const ClearanceDiagram whole(part);
      if (whole.largestClearance() > 9) part.loops.push_back(circlePath(whole.largestCenter(), 1 + 3 * unit(random), true));
      const ClearanceDiagram diagram(part);
      const double diameter = std::min(2 + 4 * unit(random), 1.8 * diagram.largestClearance());
      PocketOptions o = tool(diameter, 1 + 4 * unit(random), (0.2 + 0.8 * unit(random)) * diameter);
      o.stepdown = 1 + unit(random);
      o.climb = unit(random) < 0.5;
      o.entry = static_cast<Entry>(k % 3);
      o.finish = k % 4 == 0 ? 0.05 * diameter : 0;
      if (diagram.largestClearance() <= diameter / 2 + o.finish + 0.01) continue;
      verifyPath(part, o);
      if (QTest::currentTestFailed()) return;
    }
  }

  void disjointPocketsAreCutOneAfterTheOther() {
    const Region two{{boxPath(0, 0, 20, 20), boxPath(30, 0, 50, 20), circlePath({80, 10}, 2)}};
    PocketResult made;
    verifyPath(two, tool(6, 6), &made);
    QCOMPARE(made.tooNarrow.size(), std::size_t(1));
    COMPARE_NEAR((made.tooNarrow[0] - Vec2(80, 10)).norm(), 2, 1e-9);
    // each to its full depth before the next is begun
    std::vector<bool> right;
    for (const ToolMove& m : made.path.moves)
      if (m.to.z() < 0) right.push_back(m.to.x() > 25);
    QCOMPARE(std::adjacent_find(right.begin(), right.end(), std::not_equal_to<>()) != right.end(), true);
    QVERIFY(std::is_sorted(right.begin(), right.end()) || std::is_sorted(right.rbegin(), right.rend()));
  }

  void climbKeepsTheWallOnTheRight() {
    const Region part = plateWithIsland();
    for (const bool climb : {true, false}) {
      PocketOptions o = tool(6, 1);
      o.climb = climb;
      const PocketResult made = pocketPath(part, o);
      int right = 0, wrong = 0;
      const ClearanceDiagram diagram(part);
      for (std::size_t i = 0; i < made.path.moves.size(); ++i) {
        const ToolMove& m = made.path.moves[i];
        if (m.kind != MoveKind::Feed || m.to.z() != -1) continue;
        const Vec2 a = startOf(made.path, i).head<2>(), b = m.to.head<2>();
        if (m.turn != 0 || (b - a).norm() < 1) continue;
        const Vec2 middle = (a + b) / 2, along = (b - a).normalized(), side(along.y(), -along.x());
        if (std::abs(diagram.clearance(middle) - 3) > 1e-6) continue;
        (diagram.clearance(middle + 0.01 * side) < 3 ? right : wrong)++;
      }
      QVERIFY(climb ? right >= 4 && wrong == 0 : wrong >= 4 && right == 0);
    }
  }

  void rampsAndHelicesFallNoSteeperThanAsked() {
    for (const Entry entry : {Entry::Ramp, Entry::Helix}) {
      PocketOptions o = tool(6, 4);
      o.entry = entry;
      o.rampAngle = 0.06;
      o.approach = 0.5;
      PocketResult made;
      verifyPath(plateWithIsland(), o, &made);
      int falling = 0;
      for (std::size_t i = 0; i < made.path.moves.size(); ++i) {
        const Vec3 from = startOf(made.path, i);
        const ToolMove& m = made.path.moves[i];
        const double along = std::sqrt(std::max(0.0, std::pow(lengthOf(from, m), 2) - std::pow(m.to.z() - from.z(), 2)));
        if (m.kind != MoveKind::Plunge || along < 1e-3) continue;
        QVERIFY((from.z() - m.to.z()) / along <= std::tan(0.06) * (1 + 1e-6));
        ++falling;
      }
      QVERIFY(falling > 2);
      QCOMPARE(made.plunged, std::size_t(0));
    }
  }

  /// A pass falls just onto the middle line of a ring, of a corridor with bends, and of a wall.
  void passesMayCollapseOntoTheMiddleLine() {
    const Region ring{{circlePath({0, 0}, 10), circlePath({0, 0}, 8, true)}};
    const Region hook{{polygonPath({{0, 0}, {20, 0}, {20, 2}, {2, 2}, {2, 12}, {0, 12}})}};
    const Region wavy{{wavyPath({0, 0}, 12, 1, 5), circlePath({0, 0}, 7.1, true)}};
    for (const double diameter : {0.2, 0.4, 1.0})
      for (const double step : {0.45, 0.9, (1 - diameter / 2) / 2 / diameter, (1 - diameter / 2) / diameter})
        if (step <= 1)
          for (const Region* part : {&ring, &hook, &wavy})
            verifyPath(*part, tool(diameter, 0.5 * diameter, step * diameter));
  }

  /// The widest place lies between islands; the first pass is the outermost one, on their far side.
  void aHelixGoesOnAlongThePassBesideIt() {
    Region part{{circlePath({0, 0}, 70)}};
    for (const double turn : {0.3, 0.3 + 2 * pi / 3, 0.3 + 4 * pi / 3})
      part.loops.push_back(circlePath({30 * std::cos(turn), 30 * std::sin(turn)}, 14, true));
    PocketOptions o = tool(16, 4, 15);
    o.entry = Entry::Helix;
    PocketResult made;
    verifyPath(part, o, &made);
    QCOMPARE(made.plunged, std::size_t(0));
  }

  void aFinishingPassRunsOnceAtFullDepth() {
    PocketOptions o = tool(6, 6);
    o.finish = 0.3;
    o.stepdown = 2;
    PocketResult made;
    verifyPath(plateWithIsland(), o, &made);
    const ClearanceDiagram diagram(plateWithIsland());
    double atWall = 0;
    for (std::size_t i = 0; i < made.path.moves.size(); ++i) {
      const Vec3 from = startOf(made.path, i);
      const ToolMove& m = made.path.moves[i];
      const auto points = polylineOf(from, m, 1e-3);
      bool wall = m.kind == MoveKind::Feed;
      for (const Vec3& p : points) wall = wall && std::abs(diagram.clearance(p.head<2>()) - 3) < 5e-3;
      if (!wall || m.to.z() > -1) continue;
      QCOMPARE(m.to.z(), -6.0);
      atWall += lengthOf(from, m);
    }
    COMPARE_NEAR(atWall, 2 * (54 + 34) + 2 * pi * 11, 1e-3);
  }

  /// Where only the finishing pass has room, it goes down in steps and by ways of its own.
  void finishingPassesFindTheirWayIntoNarrowPlaces() {
    PocketOptions o = tool(6, 6);
    o.stepdown = 2;
    o.finish = 0.3;
    // a pocket of its own beside a wall, an arm of a wide pocket, and an island in a ring
    const Region apart{{boxPath(0, 0, 30, 30), boxPath(31, 0, 37.2, 40)}};
    const Region arm{{polygonPath({{0, 0}, {30, 0}, {30, 11}, {70, 11}, {70, 17.2}, {30, 17.2}, {30, 30}, {0, 30}})}};
    const Region ring{{boxPath(0, 0, 30, 30), circlePath({60, 15}, 12.2), circlePath({60, 15}, 6, true)}};
    for (const Entry entry : {Entry::Ramp, Entry::Helix, Entry::Plunge})
      for (const Region* part : {&apart, &arm, &ring}) {
        o.entry = entry;
        PocketResult made;
        verifyPath(*part, o, &made);
        QVERIFY(made.tooNarrow.empty());
        // no way through full material at full depth: what is cut deepest was cut at 2 and at 4 mm before
        for (const Vec2& p : {Vec2(60, 14.1), Vec2(34.1, 20), Vec2(51, 15)}) {
          std::set<double> floors;
          for (std::size_t i = 0; i < made.path.moves.size(); ++i)
            if (made.path.moves[i].kind != MoveKind::Rapid)
              for (const Vec3& q : polylineOf(startOf(made.path, i), made.path.moves[i], 1e-3))
                if (q.z() == startOf(made.path, i).z() && q.z() == made.path.moves[i].to.z() &&
                    (q.head<2>() - p).norm() < 15)
                  floors.insert(q.z());
          if (ClearanceDiagram(*part).clearance(p) > 3) QCOMPARE(floors.size(), std::size_t(3));
        }
      }
  }

  void stockIsLeftOnWallsAndFloor() {
    PocketOptions o = tool(6, 5);
    o.leaveWall = 0.4;
    o.leaveFloor = 0.5;
    PocketResult made;
    verifyPath(plateWithIsland(), o, &made);
    const ClearanceDiagram diagram(plateWithIsland());
    double minimum = 1e300, lowest = 0;
    for (const ToolMove& m : made.path.moves) {
      minimum = std::min(minimum, diagram.clearance(m.to.head<2>()));
      lowest = std::min(lowest, m.to.z());
    }
    COMPARE_NEAR(minimum, 3.4, 1e-6);
    COMPARE_NEAR(lowest, -4.5, 1e-12);
  }

  void aToolThatDoesNotFitIsRefusedWithTheLargestThatDoes() {
    const Region slot{{boxPath(0, 0, 40, 5)}};
    try {
      (void)pocketPath(slot, tool(6, 1));
      QFAIL("6 mm in a slot of 5");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::InvalidInput);
      QVERIFY2(error.hint().find("a diameter of 5 mm") != std::string::npos, error.hint().c_str());
    }
    verifyPath(slot, tool(4.99, 1));
    VERIFY_ERROR(pocketPath(slot, tool(5.01, 1)), ErrorCode::InvalidInput);
  }

  /// A slot as wide as the tool has no inner offset, yet the tool goes through it.
  void aSlotJustAsWideAsTheToolIsCutAlongItsMiddle() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double rounding : {0.0, 1e-13, -1e-13, 1e-9, -1e-9}) {
      const double turn = pi * unit(random), c = std::cos(turn), s = std::sin(turn);
      const Vec2 corner(100 * unit(random), 100 * unit(random));
      const auto place = [&](double x, double y) { return Vec2(corner + Vec2(c * x - s * y, s * x + c * y)); };
      const Region slot{{polygonPath({place(0, 0), place(40, 0), place(40, 6), place(0, 6)})}};
      for (const Entry entry : {Entry::Ramp, Entry::Helix, Entry::Plunge}) {
        PocketOptions o = tool(6 + rounding, 2);
        o.entry = entry;
        PocketResult made;
        verifyPath(slot, o, &made);
        if (QTest::currentTestFailed()) return;
        double minimum = 1e300, maximum = -1e300;
        for (const ToolMove& m : made.path.moves) {
          const Vec2 p = m.to.head<2>() - corner;
          COMPARE_NEAR(p.dot(Vec2(-s, c)), 3, o.tolerance / 20);
          minimum = std::min(minimum, p.dot(Vec2(c, s)));
          maximum = std::max(maximum, p.dot(Vec2(c, s)));
        }
        COMPARE_NEAR(minimum, 3, o.tolerance);
        COMPARE_NEAR(maximum, 37, o.tolerance);
      }
    }
    // with stock to leave it is the room that is left which counts
    PocketOptions o = tool(5, 2);
    o.leaveWall = 0.5;
    verifyPath({{boxPath(0, 0, 40, 6)}}, o);
  }

  /// In bends the diagram's chords leave the walls, by less than the path may be off.
  void bentSlotsJustAsWideAsTheToolAreCutAllAlong() {
    Path half;  // of a ring, its ends square
    half.closed = true;
    half.segments = {Line2{{15, 0}, {20, 0}}, Arc2{{0, 0}, 20, 0, pi}, Line2{{-20, 0}, {-15, 0}}, Arc2{{0, 0}, 15, pi, -pi}};
    for (const Region& bent : {Region{{circlePath({0, 0}, 20), circlePath({0, 0}, 15, true)}}, Region{{half}}}) {
      PocketResult made;
      const PocketOptions o = tool(5, 2.5);
      verifyPath(bent, o, &made);
      if (QTest::currentTestFailed()) return;
      double left = 1e300, right = -1e300;
      for (std::size_t i = 0; i < made.path.moves.size(); ++i)
        for (const Vec3& p : polylineOf(startOf(made.path, i), made.path.moves[i], 1e-4)) {
          if (p.z() != -2.5) continue;
          COMPARE_NEAR(p.head<2>().norm(), 17.5, o.tolerance / 2 + 1e-3);
          left = std::min(left, p.x());
          right = std::max(right, p.x());
        }
      // to the walls at the ends of the half ring, where the tool's middle stays 2.5 above them
      const double end = bent.loops.size() == 2 ? 17.5 : std::sqrt(17.5 * 17.5 - 2.5 * 2.5);
      COMPARE_NEAR(left, -end, 0.02);
      COMPARE_NEAR(right, end, 0.02);
    }
  }

  /// What a refusal says of the largest tool: it cuts, and a thousandth more is refused.
  void theLargestToolThatFitsIsTold() {
    const std::vector<Vec2> corner{{0, 0}, {40, 0}, {40, 7.3}, {7.3, 7.3}, {7.3, 30}, {0, 30}};
    const std::vector<Vec2> lean{{0, 0}, {50, 3}, {47, 31}, {-4, 20}};
    const std::pair<const char*, Region> parts[] = {
        {"slot", {{boxPath(0, 0, 40, 6)}}},
        {"slot in inches", {{boxPath(0, 0, 2 * 25.4, 25.4 / 8)}}},
        {"slot of a third", {{boxPath(0, 0, 9, 1.0 / 3)}}},
        {"square", {{boxPath(0, 0, 6, 6)}}},
        {"disc", {{circlePath({1, 2}, 3)}}},
        {"corner", {{polygonPath(corner)}}},
        {"triangle", {{polygonPath({{0, 0}, {30, 0}, {10, 17}})}}},
        {"leaning", {{polygonPath(lean)}}},
        {"ring", {{circlePath({0, 0}, 20), circlePath({0, 0}, 15, true)}}},
        {"beside its middle", {{circlePath({0, 0}, 20), circlePath({1, 0}, 15, true)}}},
        {"free-form", {{wavyPath({0, 0}, 12, 2, 5)}}},
        {"far away", {{boxPath(1e5, 2e5, 1e5 + 40, 2e5 + 6)}}},
        {"tiny", {{boxPath(0, 0, 0.3, 0.08)}}},
        {"large", {{boxPath(0, 0, 3000, 700), boxPath(100, 100, 2900, 150, true)}}},
        {"two", {{boxPath(0, 0, 20, 5), boxPath(30, 0, 37, 20)}}}};
    for (const auto& [name, part] : parts)
      for (const double leave : {0.0, 0.01}) {
        const auto cutBy = [&, &region = part](double diameter) {
          PocketOptions o = tool(diameter, diameter / 4);
          o.leaveWall = leave;
          return pocketPath(region, o);
        };
        double told = 0;
        try {
          (void)cutBy(1e4);
          QFAIL(name);
        } catch (const Error& error) {
          const std::string before = "a diameter of ";
          const std::size_t at = error.hint().find(before);
          QVERIFY2(at != std::string::npos, error.what());
          told = std::stod(error.hint().substr(at + before.size()));
        }
        try {
          const PocketResult made = cutBy(told);
          QVERIFY2(!made.path.moves.empty(), name);
          const SimulationResult s = simulate(made.path, part, {.depth = told / 4, .leave = leave});
          QVERIFY2(s.gouge <= 0.005 + 1e-6, name);
        } catch (const Error& error) {
          QFAIL(fmt::format("{}: {} {}", name, error.message(), error.hint()).c_str());
        }
        try {
          (void)cutBy(told * 1.001);
          QFAIL(fmt::format("{}: {} is not the largest", name, told).c_str());
        } catch (const Error& error) {
          QCOMPARE(error.code(), ErrorCode::InvalidInput);
          QVERIFY2(error.message().find("does not fit") != std::string::npos, error.what());
        }
      }
  }

  void rubbishIsRefused() {
    const Region part = plateWithIsland();
    VERIFY_ERROR(pocketPath(part, tool(0, 1)), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pocketPath(part, tool(6, 0)), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pocketPath(part, tool(6, -1)), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pocketPath(part, tool(6, std::nan(""))), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pocketPath(part, tool(6, 1, 6.1)), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pocketPath(Region(), tool(6, 1)), ErrorCode::InvalidInput);
    VERIFY_ERROR(pocketPath({{polygonPath({{0, 0}, {40, 40}, {40, 0}, {0, 40}})}}, tool(6, 1)), ErrorCode::InvalidInput);
    VERIFY_ERROR(pocketPath({{boxPath(0, 0, std::nan(""), 40)}}, tool(6, 1)), ErrorCode::InvalidInput);
    PocketOptions o = tool(6, 1);
    o.cutter.cornerRadius = 3.1;
    VERIFY_ERROR(pocketPath(part, o), ErrorCode::InvalidParameter);
    o = tool(6, 1);
    o.leaveFloor = 1;
    VERIFY_ERROR(pocketPath(part, o), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pocketPath(part, tool(6, 1, 1e-6)), ErrorCode::LimitExceeded);
    CancelToken cancelled;
    cancelled.cancel();
    VERIFY_ERROR(pocketPath(part, tool(6, 1), Progress(cancelled)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(PocketPathTest)
#include "pocket_path_test.moc"
