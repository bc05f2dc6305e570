#include <algorithm>
#include <string>

#include "core/file.h"
#include "geometry/shape/bounds.h"
#include "support/block_solids.h"
#include "support/modeling.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/support.h"
#include "transport/shape_transport.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// 60 x 40 x 20 with a pocket 40 x 20 x 10 in its top.
Shape blockWithPocket() { return without(solidOf({{0, 0, 0}, {60, 40, 20}}), {{10, 10, 10}, {50, 30, 25}}); }
Value pocketFloor(const Shape& solid) { return pocketOnFace(faceWithin(solid, {10, 10, 10}, {50, 30, 10})); }

const Setup& setupIn(const Evaluated& made) { return *made.shape.get<Setup>(); }

Bounds boundsOf(const std::vector<Shape>& shapes) {
  Bounds box;
  for (const Shape& each : shapes) box.add(bounds(each));
  return box;
}

void verifyBox(const Bounds& box, const Vec3& low, const Vec3& high) {
  QVERIFY2((box.low - low).norm() < 1e-6 && (box.high - high).norm() < 1e-6, qPrintable(QString("%1 %2 %3 to %4 %5 %6")
                                                                                            .arg(box.low.x())
                                                                                            .arg(box.low.y())
                                                                                            .arg(box.low.z())
                                                                                            .arg(box.high.x())
                                                                                            .arg(box.high.y())
                                                                                            .arg(box.high.z())));
}

Value clampAt(const Vec3& corner, const Vec3& size) {
  return {{"corner", {corner.x(), corner.y(), corner.z()}}, {"size", {size.x(), size.y(), size.z()}}};
}

int statOf(const Evaluated& made, const char* name) { return made.stats.at(name).get<int>(); }

bool tells(const Evaluated& made, const std::string& words) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [&](const std::string& each) { return each.find(words) != std::string::npos; });
}

}  // namespace

class PocketSetupTest final : public QObject {
  Q_OBJECT
 private slots:
  void theStockStandsAroundThePart() {
    const Evaluated setup =
        made("setup", {{"stock-margin", 5}, {"stock-above", 1}, {"stock-below", 2}}, {blockWithPocket()});
    verifyBox(boundsOf(setupIn(setup).stock), {0, 0, -23}, {70, 50, 0});  // from its corner, at its top
    verifyBox(boundsOf(setupIn(setup).part), {5, 5, -21}, {65, 45, -1});
    COMPARE_NEAR(figure(setup.shape, "stock_z"), 23, 1e-9);
    const Evaluated middle =
        made("setup", {{"zero", "center"}, {"zero-height", "bottom"}, {"stock-form", "cylinder"}}, {blockWithPocket()});
    verifyBox(boundsOf(setupIn(middle).part), {-30, -20, 0}, {30, 20, 20});
    const double radius = std::hypot(30, 20) + 5;
    verifyBox(boundsOf(setupIn(middle).stock), {-radius, -radius, 0}, {radius, radius, 20});
    const Evaluated drawn = made("setup", {{"zero", "drawing"}, {"zero-height", "drawing"}}, {blockWithPocket()});
    verifyBox(boundsOf(setupIn(drawn).part), {0, 0, 0}, {60, 40, 20});
  }
  void aStockMayBeASolid() {
    const Evaluated setup = made("setup", {{"zero", "corner"}}, {blockWithPocket(), solidOf({{-8, -8, -8}, {70, 50, 30}})});
    verifyBox(boundsOf(setupIn(setup).stock), {0, 0, -38}, {78, 58, 0});
    verifyBox(boundsOf(setupIn(setup).part), {8, 8, -30}, {68, 48, -10});
  }
  void clampsAndTravelAreMeasuredFromTheZero() {
    const Evaluated setup =
        made("setup",
             {{"clamps", {clampAt({-15, 10, 5}, {20, 20, 20})}}, {"travel", {400, 300, 100}}, {"zero-at", {100, 80, 60}}},
             {blockWithPocket()});
    QCOMPARE(setupIn(setup).clamps.size(), std::size_t(1));
    verifyBox(setupIn(setup).clamps[0], {-10, 15, -15}, {10, 35, 5});
    verifyBox(setupIn(setup).travel, {-100, -80, -60}, {300, 220, 40});
    QVERIFY(tells(setup, "Clamp 1 reaches into the box around the stock"));
  }
  void whatCannotBeIsRefused() {
    VERIFY_ERROR(made("setup", {{"clamps", {clampAt({0, 0, 0}, {1, 0, 1})}}}, {blockWithPocket()}),
                 ErrorCode::InvalidParameter);
    VERIFY_ERROR(made("setup", {{"travel", {400, 0, 100}}}, {blockWithPocket()}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(made("setup", Value::object(), {Region{{boxPath(0, 0, 60, 40)}}}), ErrorCode::InvalidInput);
  }
  void theFaceThatLooksUpIsOnTop() {
    const Shape solid = blockWithPocket();
    const Evaluated setup =
        made("setup", {{"up", pocketOnFace(faceWithin(solid, {0, 0, 0}, {0, 40, 20}))}, {"stock-margin", 0}}, {solid});
    const Vec3 size = boundsOf(setupIn(setup).part).high - boundsOf(setupIn(setup).part).low;
    COMPARE_NEAR(size.z(), 60, 1e-6);
    COMPARE_NEAR(std::max(size.x(), size.y()), 40, 1e-6);
  }
  /// From the stock's top down, in the same places as without a setup.
  void aPocketIsCutFromTheTopOfItsStock() {
    const Shape solid = blockWithPocket();
    const Evaluated setup =
        made("setup", {{"stock-above", 1.5}, {"clamps", {clampAt({-15, 10, 5}, {15, 20, 40})}}}, {solid});
    const Value options{{"face", pocketFloor(solid)}, {"tool-diameter", 6}, {"stepdown", 2}};
    const Toolpath path = *made("pocket", options, {solid, setup.shape}).shape.get<Toolpath>();
    double lowest = 0, across = 1e9;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      lowest = std::min(lowest, path.moves[i].to.z());
      const Vec3 from = startOf(path, i);
      if (path.moves[i].kind == MoveKind::Rapid && (from - path.moves[i].to).head<2>().norm() > 1e-9)
        across = std::min(across, from.z());
    }
    COMPARE_NEAR(lowest, -11.5, 1e-9);
    QVERIFY2(across >= 23.5 + 5 - 1e-9, qPrintable(QString::number(across)));  // above the clamp
    QCOMPARE(path.passes, std::size_t(6));
    verifyBox(path.stock, {0, 0, -21.5}, {70, 50, 0});
    const Toolpath alone = *made("pocket", options, {solid}).shape.get<Toolpath>();
    Bounds here, there;
    for (const ToolMove& move : path.moves)
      if (move.kind == MoveKind::Feed) here.add(move.to);
    for (const ToolMove& move : alone.moves)
      if (move.kind == MoveKind::Feed) there.add(move.to);
    COMPARE_NEAR(here.low.x(), there.low.x() + 5, 1e-6);
    COMPARE_NEAR(here.high.y(), there.high.y() + 5, 1e-6);
    const Evaluated swept = made("simulate", {{"face", pocketFloor(solid)}}, {path, solid, setup.shape});
    QCOMPARE(statOf(swept, "collisions"), 0);
    COMPARE_NEAR(figure(swept.shape, "gouge_mm"), 0, 1e-6);
  }
  void aClampInTheWayIsRefused() {
    const Shape solid = blockWithPocket();
    const Value options{{"face", pocketFloor(solid)}, {"tool-diameter", 6}};
    const Evaluated setup = made("setup", {{"clamps", {clampAt({20, 5, 20}, {10, 15, 10})}}}, {solid});
    const Error error = refusal("pocket", options, {solid, setup.shape});
    QCOMPARE(error.code(), ErrorCode::InvalidInput);
    QVERIFY2(error.message().find("runs into clamp 1") != std::string::npos, error.message().c_str());
  }
  /// The holder comes down to the top of the block where the tool is shorter than the pocket is deep.
  void aHolderThatIsTooLowIsRefused() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", Value::object(), {solid});
    Value options{
        {"face", pocketFloor(solid)}, {"tool-diameter", 6}, {"flute-length", 5}, {"stick-out", 9}, {"holder-diameter", 25}};
    const Error error = refusal("pocket", options, {solid, setup.shape});
    QVERIFY2(error.message().starts_with("The holder runs into the part"), error.message().c_str());
    options["stick-out"] = 12;
    QCOMPARE(statOf(made("pocket", options, {solid, setup.shape}), "collisions"), 0);
    options["shank-diameter"] = 8;  // wider than the cutter, and the flutes are shorter than the pocket is deep
    QVERIFY(refusal("pocket", options, {solid, setup.shape}).message().starts_with("The shank runs into the part"));
  }
  void faultyProgramsAreTold() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", {{"travel", {100, 100, 60}}, {"zero-at", {20, 20, 40}}}, {solid});
    const Value face{{"face", pocketFloor(solid)}};
    Toolpath path =
        *made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape}).shape.get<Toolpath>();
    const auto swept = [&](const Toolpath& program) { return made("simulate", face, {program, solid, setup.shape}); };
    QCOMPARE(statOf(swept(path), "collisions"), 0);
    QCOMPARE(statOf(swept(path), "moves_outside_travel"), 0);
    Toolpath far = path;
    far.moves.push_back({MoveKind::Rapid, {90, 10, 15}, 0, {0, 0}, 0, 77});
    QVERIFY(tells(swept(far), "leaves the machine's travel on its way to (90.000, 10.000, 15.000), line 77."));
    Toolpath low = path;  // a rapid home below the top of the block
    low.moves.push_back({MoveKind::Rapid, {30, 25, -5}, 0, {0, 0}, 0, 78});
    low.moves.push_back({MoveKind::Rapid, {-10, 25, -5}, 0, {0, 0}, 0, 79});
    const Evaluated told = swept(low);
    QVERIFY(tells(told, "The cutter runs into the part"));
    QVERIFY(tells(told, "line 79"));
    QVERIFY(statOf(told, "collisions") >= 1);
  }
  /// Named or not, the face on top is on top: clamps and zero stay where they were drawn.
  void theTopAsTheFaceThatLooksUpChangesNothing() {
    const Shape solid = blockWithPocket();
    Value values{{"clamps", {clampAt({-15, 10, 5}, {15, 20, 20})}}, {"zero", "drawing"}, {"zero-height", "drawing"}};
    const Setup plain = setupIn(made("setup", values, {solid}));
    values["up"] = pocketFloor(solid);
    const Setup named = setupIn(made("setup", values, {solid}));
    verifyBox(boundsOf(named.part), boundsOf(plain.part).low, boundsOf(plain.part).high);
    verifyBox(boundsOf(named.stock), boundsOf(plain.stock).low, boundsOf(plain.stock).high);
    verifyBox(named.clamps[0], plain.clamps[0].low, plain.clamps[0].high);
    // On its side, the clamp lies with it.
    values["up"] = pocketOnFace(faceWithin(solid, {0, 0, 0}, {0, 40, 20}));
    const Setup turned = setupIn(made("setup", values, {solid}));
    COMPARE_NEAR(turned.clamps[0].low.z(), boundsOf(turned.part).high.z(), 1e-6);
    COMPARE_NEAR((turned.clamps[0].high - turned.clamps[0].low).prod(), 15 * 20 * 20, 1e-6);
  }
  void aRoundStockStandsRoundARoundPart() {
    const Shape disc = made("cylinder", {{"radius", 25}, {"height", 10}}).shape;
    const Evaluated setup = made("setup", {{"stock-form", "cylinder"}, {"stock-margin", 2}}, {disc});
    COMPARE_NEAR(figure(setup.shape, "stock_x"), 54, 0.02);
  }
  /// Rounded corners come nearer to walls, not less near.
  void blendingAllowsNothing() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", Value::object(), {solid});
    Toolpath path =
        *made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape}).shape.get<Toolpath>();
    path.blending = 4;
    path.moves.push_back({MoveKind::Feed, {30, 25, -9}, 0, {0, 0}, 100, 0});
    path.moves.push_back({MoveKind::Feed, {53, 25, -9}, 0, {0, 0}, 100, 0});
    QVERIFY(tells(made("simulate", {{"face", pocketFloor(solid)}}, {path, solid, setup.shape}),
                  "The cutter runs into the part"));
  }
  void whatIsNotLookedAtIsTold() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", Value::object(), {solid});
    const Toolpath path =
        *made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape}).shape.get<Toolpath>();
    const auto simulated = [&](Value values, const Toolpath& program, const Shape& held) {
      values["face"] = pocketFloor(solid);
      return made("simulate", values, {program, solid, held});
    };
    QVERIFY(tells(simulated({{"shank-diameter", 8}}, path, setup.shape), "The shank is not looked at"));
    QVERIFY(tells(simulated({{"holder-diameter", 40}}, path, setup.shape), "The holder is not looked at"));
    QVERIFY(tells(simulated({{"holder-diameter", 40}, {"stick-out", 8}}, path, setup.shape), "The holder runs into"));
    VERIFY_ERROR(simulated({{"stick-out", 8}, {"flute-length", 9}}, path, setup.shape), ErrorCode::InvalidParameter);
    const Evaluated other = made("setup", {{"zero", "center"}}, {solid});
    QVERIFY(tells(simulated(Value::object(), path, other.shape), "written for another zero"));
    Toolpath aside = path;
    for (ToolMove& move : aside.moves) {
      move.to.x() += 200;
      move.center.x() += 200;
    }
    aside.start.x() += 200;
    QVERIFY(tells(simulated(Value::object(), aside, setup.shape), "cuts nothing of the stock"));
  }
  /// A program that tells nothing of its part lies where the setup says.
  void foreignProgramsAreMeasuredInTheSetup() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", {{"stock-above", 2}}, {solid});
    Toolpath path =
        *made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape}).shape.get<Toolpath>();
    path.task.reset();
    const Evaluated swept = made("simulate", {{"face", pocketFloor(solid)}}, {path, solid, setup.shape});
    COMPARE_NEAR(figure(swept.shape, "gouge_mm"), 0, 1e-6);
    QVERIFY(!tells(swept, "through material"));
    QCOMPARE(statOf(swept, "collisions"), 0);
  }
  void whatIsRemovedIsTold() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", {{"stock-above", 1}}, {solid});
    const Evaluated pocket = made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape});
    const double wanted = figureOf(pocket, "cut_mm2") * 11;
    COMPARE_NEAR(pocket.stats.at("removed_mm3").get<double>(), wanted, 2e-3 * wanted);
  }
  void aRapidThroughTheStockIsTold() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", {{"stock-above", 4}}, {solid});
    const Value face{{"face", pocketFloor(solid)}};
    Toolpath path =
        *made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape}).shape.get<Toolpath>();
    path.moves.push_back({MoveKind::Rapid, {30, 25, 10}, 0, {0, 0}, 0, 80});
    path.moves.push_back({MoveKind::Rapid, {30, 25, -2}, 0, {0, 0}, 0, 81});  // into the pocket
    QCOMPARE(statOf(made("simulate", face, {path, solid, setup.shape}), "collisions"), 0);
    path.moves.push_back({MoveKind::Rapid, {80, 25, -2}, 0, {0, 0}, 0, 82});  // above the part, below the top of the stock
    const Evaluated told = made("simulate", face, {path, solid, setup.shape});
    QVERIFY(tells(told, "A rapid goes through the stock"));
    QVERIFY(tells(told, "line 82."));
  }
  /// What is carved away has the volume of the pocket, and what is left can be the stock of the next setup.
  void theStockIsCarved() {
    const Shape solid = blockWithPocket();
    const Evaluated setup = made("setup", {{"stock-above", 1}}, {solid});
    const Evaluated pocket = made("pocket", {{"face", pocketFloor(solid)}, {"tool-diameter", 6}}, {solid, setup.shape});
    const Evaluated carved = made("carve", Value::object(), {pocket.shape, setup.shape});
    const double wanted = figureOf(pocket, "cut_mm2") * 11;
    COMPARE_NEAR(carved.stats.at("removed_mm3").get<double>(), wanted, 0.01 * wanted);
    QVERIFY(figure(carved.shape, "closed") == 1);
    const double rim = 2 * (40 + 20), cell = carved.stats.at("cell_mm").get<double>();  // where a step is a slope
    COMPARE_NEAR(figure(carved.shape, "volume"), 70 * 50 * 21 - wanted, rim * 11 * cell);
    const Evaluated played = made("carve", {{"frames", 5}}, {pocket.shape, setup.shape});
    const auto* frames = played.shape.get<Sequence>();
    QVERIFY(frames && frames->frames.size() == 5);
    double before = 1e9;
    for (const Shape& frame : frames->frames) {
      QVERIFY(figure(frame, "volume") <= before);
      before = figure(frame, "volume");
    }
    COMPARE_NEAR(before, figure(carved.shape, "volume"), 1e-6);
    // In the stock that is left, the same program goes through air.
    const Evaluated next = made("setup", {{"zero", "corner"}}, {solid, carved.shape});
    const Evaluated again = made("simulate", {{"face", pocketFloor(solid)}}, {pocket.shape, solid, next.shape});
    COMPARE_NEAR(again.stats.at("removed_mm3").get<double>(), 0, 0.02 * wanted);
  }
  /// What is sent to another process comes back.
  void aSetupTravels() {
    const Evaluated setup =
        made("setup", {{"clamps", {clampAt({-15, 10, 5}, {20, 20, 20})}}, {"travel", {400, 300, 100}}}, {blockWithPocket()});
    const TemporaryFolder folder;
    const Shape back = loadShape(Value::parse(saveShape(setup.shape, folder.path(), "shape").dump()), folder.path());
    const auto* after = back.get<Setup>();
    QVERIFY(after);
    const Setup& before = setupIn(setup);
    verifyBox(boundsOf(after->part), boundsOf(before.part).low, boundsOf(before.part).high);
    verifyBox(boundsOf(after->stock), boundsOf(before.stock).low, boundsOf(before.stock).high);
    verifyBox(after->clamps.at(0), before.clamps[0].low, before.clamps[0].high);
    verifyBox(after->travel, before.travel.low, before.travel.high);
    for (int row = 1; row <= 3; ++row)
      for (int column = 1; column <= 4; ++column)
        QCOMPARE(after->drawing.Value(row, column), before.drawing.Value(row, column));
  }
};

BLOSSOM_TEST(PocketSetupTest)
#include "pocket_setup_test.moc"
