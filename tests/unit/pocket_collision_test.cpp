#include <algorithm>
#include <numbers>
#include <random>
#include <vector>

#include "pocket/kernel/setup/collision.h"
#include "pocket/kernel/setup/stage_distance.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using Triangle = std::array<Vec3, 3>;

Triangles boxTriangles(const Vec3& low, const Vec3& high) {
  const auto corner = [&](int i) {
    return Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  };
  Triangles triangles;
  for (const auto& side : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
                           std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    triangles.push_back({corner(side[0]), corner(side[1]), corner(side[2])});
    triangles.push_back({corner(side[0]), corner(side[2]), corner(side[3])});
  }
  return triangles;
}

/// The least value of a convex function on an interval.
template <class Function>
double leastOn(double low, double high, const Function& value) {
  for (int i = 0; i < 60; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    (value(left) < value(right) ? high : low) = value(left) < value(right) ? right : left;
  }
  return value((low + high) / 2);
}

/// One search within another: the least of a convex function along lines is convex itself.
double leastBySearch(const ToolStage& stage, const Triangle& t) {
  const auto at = [&](double u, double v) { return distanceTo(stage, Vec3(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]))); };
  return leastOn(0, 1, [&](double u) { return leastOn(0, 1 - u, [&](double v) { return at(u, v); }); });
}

/// How deep an upright cylinder and an upright box are in each other, negative apart: the least by which one has to move.
double depthInBox(double radius, double low, double high, const Vec3& tip, const Vec3& boxLow, const Vec3& boxHigh) {
  const Vec2 nearest = tip.head<2>().cwiseMax(boxLow.head<2>()).cwiseMin(boxHigh.head<2>());
  const double across = radius - (tip.head<2>() - nearest).norm();
  const double up = std::min(tip.z() + high - boxLow.z(), boxHigh.z() - tip.z() - low);
  return std::min(across, up);
}

Toolpath pathOf(const Vec3& start, const std::vector<ToolMove>& moves) {
  Toolpath path;
  path.cutter.diameter = 6;
  path.start = start;
  path.moves = moves;
  return path;
}

ToolMove to(const Vec3& place) { return {MoveKind::Feed, place, 0, {0, 0}, 100, 0}; }

}  // namespace

class PocketCollisionTest final : public QObject {
  Q_OBJECT
 private slots:
  void theStagesOfAToolStandOnEachOther() {
    const ToolAssembly tool{{6, 1, 0, 1, 0}, 20, 8, 40, 30, 50};
    const auto stages = stagesOf(tool, 0);
    QCOMPARE(stages.size(), std::size_t(4));
    COMPARE_NEAR(stages[0].low(), 0, 1e-12);
    COMPARE_NEAR(stages[0].reach(), 3, 1e-12);
    COMPARE_NEAR(stages[1].low(), 1, 1e-12);
    COMPARE_NEAR(stages[1].reach(), 3, 1e-12);
    COMPARE_NEAR(stages[1].high(), 20, 1e-12);
    COMPARE_NEAR(stages[2].low(), 20, 1e-12);
    COMPARE_NEAR(stages[3].low(), 40, 1e-12);
    COMPARE_NEAR(stages[3].high(), 90, 1e-12);
    for (const ToolStage& stage : stagesOf(tool, 0.25)) QVERIFY(stage.reach() < 15);
    COMPARE_NEAR(stagesOf(tool, 0.25)[0].low(), 0.25, 1e-12);
    COMPARE_NEAR(stagesOf(tool, 0.25)[3].reach(), 14.75, 1e-12);
  }
  /// Without the length of the flutes nobody knows where the shank begins; the holder is where it is.
  void whatIsNotKnownIsNotChecked() {
    const auto stages = stagesOf({{6, 0, 0, 1, 0}, 0, 8, 40, 30, 50}, 0);
    QCOMPARE(stages.size(), std::size_t(2));
    QVERIFY(stages[1].part == ToolPart::Holder);
  }
  /// However short the flutes are: a ball as long as wide still cuts.
  void roundCuttersKeepTheirFlutes() {
    for (const double flutes : {3.0, 6.0, 6.1, 20.0}) {
      const ToolAssembly ball{{6, 3, 0, 1, 0}, flutes};
      const auto told = [&](double y) {
        return collisionsOf(pathOf({-20, y, 0}, {to({20, y, 0})}), ball, Obstacles(boxTriangles({-1, 0, 0}, {1, 1, 40})),
                            {0.01});
      };
      QCOMPARE(told(3.9).size(), std::size_t(1));  // as wide as its diameter at the height of its middle
      QVERIFY(told(4.05).empty());
    }
  }
  void aToleranceLargerThanTheCutterIsRefused() {
    const Obstacles block(boxTriangles({0, 0, 0}, {10, 10, 10}));
    VERIFY_ERROR(collisionsOf(pathOf({-20, 5, 1}, {to({20, 5, 1})}), {{6, 0, 0, 1, 0}}, block, {3}),
                 ErrorCode::InvalidParameter);
  }
  /// Flat, bull, ball and V: closed forms.
  void thePointsOfACutterAreAsFarAsTheyShouldBe() {
    const ToolStage flat = stagesOf({{6, 0, 0, 1, 0}}, 0)[0];
    COMPARE_NEAR(distanceTo(flat, Vec3(7, 0, 5)), 4, 1e-12);
    COMPARE_NEAR(distanceTo(flat, Vec3(0, 1, -2)), 2, 1e-12);
    COMPARE_NEAR(distanceTo(flat, Vec3(6, 0, -4)), 5, 1e-12);
    COMPARE_NEAR(distanceTo(flat, Vec3(2, 1, 4)), 0, 1e-12);
    const ToolStage ball = stagesOf({{6, 3, 0, 1, 0}}, 0)[0];
    COMPARE_NEAR(distanceTo(ball, Vec3(3, 0, -1)), 2, 1e-12);
    COMPARE_NEAR(distanceTo(ball, Vec3(0, 0, -1)), 1, 1e-12);
    const ToolStage bull = stagesOf({{6, 1, 0, 1, 0}}, 0)[0];
    COMPARE_NEAR(distanceTo(bull, Vec3(5, 0, -3)), 4, 1e-12);  // 3, 4, 5 from the circle of the corner's centres
    const ToolStage vee = stagesOf({{6, 0, std::numbers::pi / 2, 1, 0}}, 0)[0];
    COMPARE_NEAR(distanceTo(vee, Vec3(2, 0, 0)), std::numbers::sqrt2, 1e-12);
    COMPARE_NEAR(distanceTo(vee, Vec3(5, 0, 10)), 2, 1e-12);
  }
  void trianglesAreAsFarAsTheirNearestPoints() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> place(-12, 12), size(0.1, 15);
    const std::vector<ToolAssembly> tools{
        {{6, 0, 0, 1, 0}, 10}, {{6, 1, 0, 1, 0}, 10}, {{6, 3, 0, 1, 0}, 10}, {{6, 0, std::numbers::pi / 3, 1, 0}, 10}};
    for (int i = 0; i < 400; ++i) {
      const auto stages = stagesOf(tools[static_cast<std::size_t>(i) % tools.size()], 0);
      const ToolStage& stage = stages[static_cast<std::size_t>(i / 7) % stages.size()];
      const Vec3 middle(place(random), place(random), place(random));
      Triangle triangle;
      for (Vec3& corner : triangle) corner = middle + size(random) / 12 * Vec3(place(random), place(random), place(random));
      if (i % 5 == 0) triangle[1].z() = triangle[2].z() = triangle[0].z();            // a floor
      if (i % 5 == 1) triangle[1] = triangle[0] + Vec3(0, 0, size(random));           // a wall
      if (i % 7 == 2) triangle[2] = triangle[0] + 0.5 * (triangle[1] - triangle[0]);  // a line
      COMPARE_NEAR(distanceTo(stage, triangle), leastBySearch(stage, triangle), 1e-5);
      Box3 box;
      for (const Vec3& corner : triangle) box.extend(corner);
      QVERIFY(distanceAtLeast(stage, box) <= distanceTo(stage, triangle) + 1e-9);
    }
  }
  /// Moves past, over and through boxes, against steps of a hundredth of a millimetre in closed form.
  void everyContactWithABoxIsTold() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> place(-20, 20), size(0.5, 12);
    const ToolAssembly tool{{6, 0, 0, 1, 0}, 12, 8, 20, 24, 15};
    struct Part {
      double radius, low, high;
    };
    const std::array<Part, 3> parts{{{3, 0, 12}, {4, 12, 20}, {12, 20, 35}}};
    const double allowed = 0.02;
    int hits = 0, misses = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 low(place(random), place(random), place(random));
      const Vec3 high = low + Vec3(size(random), size(random), size(random));
      Vec3 from(place(random), place(random), place(random));
      Vec3 end(place(random), place(random), place(random));
      if (i % 3 == 0) end.z() = from.z();
      if (i % 3 == 1) end.head<2>() = from.head<2>();
      if (i % 4 == 0) from.y() = end.y() = high.y() + 3;  // the flutes run along a side
      const auto found = collisionsOf(pathOf(from, {to(end)}), tool, Obstacles(boxTriangles(low, high)), {allowed});
      for (std::size_t k = 0; k < parts.size(); ++k) {
        double deepest = -1e9;
        const int steps = std::max(1, static_cast<int>((end - from).norm() / 0.01));
        double starts = 0;
        for (int s = 0; s <= steps; ++s) {
          const Vec3 tip = from + double(s) / steps * (end - from);
          const double depth = depthInBox(parts[k].radius, parts[k].low, parts[k].high, tip, low, high);
          deepest = std::max(deepest, depth);
          if (s == 0) starts = depth;
        }
        const bool told = std::any_of(found.begin(), found.end(),
                                      [&](const Collision& each) { return each.part == static_cast<ToolPart>(k); });
        const bool isSwallowed = starts > 0;  // the box may lie inside the tool, where no surface is crossed
        if (deepest > 1.25 * allowed + 0.01 && !isSwallowed) QVERIFY(told);
        if (deepest < 0.75 * allowed - 0.01) QVERIFY(!told);
        (told ? hits : misses) += 1;
      }
    }
    QVERIFY2(hits > 60 && misses > 60, qPrintable(QString("%1 hits, %2 misses").arg(hits).arg(misses)));
  }
  void theFirstContactOfAMoveIsTold() {
    const auto found = collisionsOf(pathOf({-20, 5, 1}, {to({20, 5, 1})}), {{6, 0, 0, 1, 0}},
                                    Obstacles(boxTriangles({0, 0, 0}, {10, 10, 10})), {0.01});
    QCOMPARE(found.size(), std::size_t(1));
    COMPARE_NEAR(found[0].tip.x(), -3 + 0.01, 2e-3);
  }
  /// A disc turning about a pin: its edge passes at a distance that a chord from end to end would not see.
  void arcsAreFollowed() {
    ToolMove arc{MoveKind::Feed, {0, -10, 0}, 1, {0, 0}, 100, 0};
    const auto along = [&](double outer) {
      return collisionsOf(pathOf({0, 10, 0}, {arc}), {{6, 0, 0, 1, 0}},
                          Obstacles(boxTriangles({-outer - 5, -1, -5}, {-outer, 1, 5})), {0.01});
    };
    QVERIFY(along(13.02).empty());
    QCOMPARE(along(12.9).size(), std::size_t(1));
  }
  void aWallThatIsTouchedIsNotHit() {
    const Obstacles walls(boxTriangles({-30, 3, -10}, {30, 8, 10}));
    QVERIFY(collisionsOf(pathOf({-25, 0, 0}, {to({25, 0, 0}), to({25, 0, -5}), to({-25, 0, -2})}), {{6, 0, 0, 1, 0}}, walls,
                         {0.001})
                .empty());
    QCOMPARE(collisionsOf(pathOf({-25, 0.01, 0}, {to({25, 0.01, 0})}), {{6, 0, 0, 1, 0}}, walls, {0.001}).size(),
             std::size_t(1));
  }
  /// Just as deep as is allowed, to and fro along a wall: told or not, but at once.
  void waysAlongWhatIsAllowedAreNoTrouble() {
    const Obstacles walls(boxTriangles({-30, 3, -10}, {30, 8, 10}));
    for (const double beyond : {-1e-7, -1e-9, 0.0, 1e-9, 1e-7}) {
      std::vector<ToolMove> moves;
      for (int k = 0; k < 200; ++k) moves.push_back(to({k % 2 == 0 ? 25.0 : -25.0, 0.001 + beyond, 0}));
      const auto found = collisionsOf(pathOf({-25, 0.001 + beyond, 0}, moves), {{6, 0, 0, 1, 0}}, walls, {0.001});
      QVERIFY(found.empty() || found.size() == moves.size());
    }
  }
};

BLOSSOM_TEST(PocketCollisionTest)
#include "pocket_collision_test.moc"
