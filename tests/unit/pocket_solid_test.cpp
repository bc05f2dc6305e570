#include <cmath>
#include <numeric>

#include "core/error.h"
#include "geometry/measure/measure.h"
#include "geometry/shape/bounds.h"
#include "support/block_solids.h"
#include "support/modeling.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Evaluated pocketOn(const Shape& solid, int face, Value parameters) {
  parameters["face"] = pocketOnFace(face);
  return made("pocket", parameters, {solid});
}

/// mm by which the tool, a cylinder above its tip, enters a block on its way; sampled.
double intoBlock(const Toolpath& path, const Block& block) {
  const double radius = path.cutter.diameter / 2;
  double worst = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const std::vector<Vec3> points = polylineOf(startOf(path, i), path.moves[i], 1e-3);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const int steps = 1 + static_cast<int>((points[k + 1] - points[k]).norm() / 0.05);
      for (int s = 0; s <= steps; ++s) {
        const Vec3 tip = points[k] + (points[k + 1] - points[k]) * s / steps;
        if (tip.z() >= block.high.z()) continue;
        const Vec2 inside = tip.head<2>().cwiseMax(block.low.head<2>()).cwiseMin(block.high.head<2>());
        worst = std::max(worst, radius - (tip.head<2>() - inside).norm());
      }
    }
  }
  return worst;
}

struct Heights {
  double lowest = 1e300, highest = -1e300, lowestAcross = 1e300;  ///< across: rapids that move in x or y
};
Heights heightsOf(const Toolpath& path) {
  Heights h;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i), to = path.moves[i].to;
    h.lowest = std::min(h.lowest, to.z());
    h.highest = std::max(h.highest, to.z());
    if (path.moves[i].kind == MoveKind::Rapid && (to - from).head<2>().norm() > 1e-9)
      h.lowestAcross = std::min({h.lowestAcross, from.z(), to.z()});
  }
  return h;
}

std::string told(const Evaluated& made) {
  return std::accumulate(made.warnings.begin(), made.warnings.end(), std::string());
}

const Block solidPlate{{0, 0, 0}, {80, 60, 20}};
const Block boss{{30, 20, 20}, {50, 40, 45}};
const Value endMill = {{"tool-diameter", 6}, {"depth", 5}, {"stepdown", 5}};

}  // namespace

/// Pockets on faces of solids: heights come from all of the solid, and what would hit it is refused.
class PocketSolidTest final : public QObject {
  Q_OBJECT
 private slots:
  /// Rapids crossed the boss at 5 mm above the face.
  void theToolCrossesAboveABoss() {
    const Shape solid = with(solidOf(solidPlate), boss);
    const Evaluated cut = pocketOn(solid, faceWithin(solid, {0, 0, 20}, {80, 60, 20}), endMill);
    const Toolpath& path = *cut.shape.get<Toolpath>();
    const Heights heights = heightsOf(path);
    COMPARE_NEAR(heights.lowest, 15, 1e-9);  // the face keeps its height
    QVERIFY(heights.lowestAcross >= 50 - 1e-9);
    QVERIFY(intoBlock(path, boss) <= 0.005 + 1e-6);
    QVERIFY((path.stock.low - Vec3(-5, -5, 0)).norm() < 1e-6 && (path.stock.high - Vec3(85, 65, 45)).norm() < 1e-6);
    std::printf("figure boss_hit_mm %.3g\nfigure boss_lowest_rapid_mm %.4g\n", intoBlock(path, boss), heights.lowestAcross);
  }

  void theFloorOfAPocketIsItsFloor() {
    const Shape solid = without(solidOf(solidPlate), {{10, 10, 5}, {70, 50, 20}});
    const int floor = faceWithin(solid, {10, 10, 5}, {70, 50, 5});
    const Evaluated cut = pocketOn(solid, floor, endMill);
    const Toolpath& path = *cut.shape.get<Toolpath>();
    const Heights heights = heightsOf(path);
    COMPARE_NEAR(heights.lowest, 5, 1e-9);
    QVERIFY(heights.lowestAcross >= 25 - 1e-9);
    QCOMPARE(path.passes, std::size_t(3));
    for (const Block& wall : {Block{{0, 0, 0}, {10, 60, 20}}, Block{{70, 0, 0}, {80, 60, 20}},
                              Block{{0, 0, 0}, {80, 10, 20}}, Block{{0, 50, 0}, {80, 60, 20}}})
      QVERIFY(intoBlock(path, wall) <= 0.005 + 1e-6);
    QVERIFY2(told(cut).find("the floor of a pocket 15.000 mm deep") != std::string::npos, told(cut).c_str());
    Value whole = endMill;
    whole["depth"] = 15;
    QCOMPARE(told(pocketOn(solid, floor, whole)), std::string());
    // deeper still, when the face is said to be the top: down from it, above the walls all the same
    Value deeper = endMill;
    deeper["face-is"] = "top";
    deeper["depth"] = 2;
    const Heights below = heightsOf(*pocketOn(solid, floor, deeper).shape.get<Toolpath>());
    COMPARE_NEAR(below.lowest, 3, 1e-9);
    QVERIFY(below.lowestAcross >= 25 - 1e-9);
    std::printf("figure floor_lowest_mm %.6g\nfigure floor_lowest_rapid_mm %.4g\n", heights.lowest, heights.lowestAcross);
  }

  /// A boss beside the pocket: the tool crosses above it, and begins to cut where the pocket opens.
  void aBossBesideThePocketLiftsRapidsAlone() {
    const Shape solid = with(without(solidOf(solidPlate), {{10, 10, 5}, {40, 50, 20}}), {{60, 20, 20}, {70, 40, 45}});
    const Evaluated cut = pocketOn(solid, faceWithin(solid, {10, 10, 5}, {40, 50, 5}), endMill);
    const Toolpath& path = *cut.shape.get<Toolpath>();
    QCOMPARE(path.passes, std::size_t(3));  // 15 mm by 5, not 40
    COMPARE_NEAR(heightsOf(path).lowest, 5, 1e-9);
    QVERIFY(heightsOf(path).lowestAcross >= 50 - 1e-9);
  }

  void whatStandsOverTheFaceIsRefusedWithItsPlace() {
    // a stem with a head over the face, and a bridge over the floor of a pocket
    const Block head{{25, 15, 35}, {55, 45, 45}};
    const Shape mushroom = with(with(solidOf(solidPlate), {{35, 25, 20}, {45, 35, 40}}), head);
    const Error hit = refusal("pocket",
                              [&] {
                                Value p = endMill;
                                p["face"] = pocketOnFace(faceWithin(mushroom, {0, 0, 20}, {80, 60, 20}));
                                return p;
                              }(),
                              {mushroom});
    VERIFY_REFUSED(hit, ErrorCode::InvalidInput, "The tool would hit the solid");
    QVERIFY(!hit.hint().empty());
    double depth = 0, x = 0, y = 0, z = 0;
    QCOMPARE(std::sscanf(hit.what(), "The tool would hit the solid by %lf mm near (%lf, %lf, %lf)", &depth, &x, &y, &z), 4);
    QVERIFY2(x > 22 && x < 58 && y > 12 && y < 48 && z >= 15 && z <= 21 + 1e-9, hit.what());
    QVERIFY(depth > 2.9);
    const Shape bridge = with(without(solidOf(solidPlate), {{10, 10, 5}, {70, 50, 20}}), {{35, 5, 15}, {45, 55, 20}});
    Value p = endMill;
    p["face"] = pocketOnFace(faceWithin(bridge, {10, 10, 5}, {70, 50, 5}));
    VERIFY_REFUSED(refusal("pocket", p, {bridge}), ErrorCode::InvalidInput, "The tool would hit the solid");
  }

  void aFaceThatLooksAside() {
    const Shape solid = with(solidOf({{0, 0, 0}, {80, 20, 60}}), {{30, -25, 20}, {50, 0, 40}});
    const Evaluated cut = pocketOn(solid, faceWithin(solid, {0, 0, 0}, {80, 0, 60}), endMill);
    const Heights heights = heightsOf(*cut.shape.get<Toolpath>());
    COMPARE_NEAR(heights.lowest, -30, 1e-9);  // below the stock's top, which is the boss
    COMPARE_NEAR(heights.lowestAcross, 5, 1e-9);
  }

  void throughTheSolidIsTold() {
    const Shape solid = solidOf(solidPlate);
    Value through = endMill;
    through["depth"] = 20.5;
    const Evaluated cut = pocketOn(solid, faceWithin(solid, {0, 0, 20}, {80, 60, 20}), through);
    QVERIFY2(told(cut).find("goes through the solid, which is 20.000 mm thick") != std::string::npos, told(cut).c_str());
    COMPARE_NEAR(heightsOf(*cut.shape.get<Toolpath>()).lowest, -0.5, 1e-9);
    Value floor = endMill;
    floor["face-is"] = "floor";
    floor["face"] = pocketOnFace(faceWithin(solid, {0, 0, 20}, {80, 60, 20}));
    VERIFY_REFUSED(refusal("pocket", floor, {solid}), ErrorCode::InvalidInput, "nothing of the solid rises above it");
  }
};

BLOSSOM_TEST(PocketSolidTest)
#include "pocket_solid_test.moc"
