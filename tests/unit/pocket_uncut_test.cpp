#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/check/uncut.h"
#include "pocket/kernel/path/pocket_path.h"
#include "support/column_areas.h"
#include "support/modeling.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;

/// Two chambers of 30 x 40, joined by a slot of 40 mm.
Region chambers(double slot) {
  const double low = 20 - slot / 2, high = 20 + slot / 2;
  return {{polygonPath({{0, 0},
                        {30, 0},
                        {30, low},
                        {70, low},
                        {70, 0},
                        {100, 0},
                        {100, 40},
                        {70, 40},
                        {70, high},
                        {30, high},
                        {30, 40},
                        {0, 40}})}};
}

Region withArm() { return {{polygonPath({{0, 0}, {40, 0}, {40, 17}, {95, 17}, {95, 22}, {40, 22}, {40, 40}, {0, 40}})}}; }

PocketOptions sixMillimetres() {
  PocketOptions o;
  o.cutter.diameter = 6;
  o.depth = 2;
  o.stepdown = 2;
  return o;
}

Eigen::Matrix<double, 2, 3> turn(double angle) {
  Eigen::Matrix<double, 2, 3> by;
  by << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0;
  return by;
}
Region turned(const Region& region, double angle) {
  Region out;
  for (const Path& loop : region.loops) out.loops.push_back(transformed(loop, turn(angle)));
  return out;
}
Toolpath turned(Toolpath path, double angle) {
  const Eigen::Matrix2d by = turn(angle).leftCols<2>();
  for (ToolMove& move : path.moves) {
    move.to.head<2>() = (by * move.to.head<2>()).eval();
    move.center = (by * move.center).eval();
  }
  return path;
}

std::string warningsOf(const Evaluated& made) {
  std::string all;
  for (const std::string& warning : made.warnings) all += warning + "\n";
  return all;
}

/// Wavy splines in a row, as letters are, into the first few of which a tool 8 mm wide plunges.
std::pair<Region, Toolpath> discsInWaves(int count, int cut) {
  Region part;
  Toolpath path;
  path.cutter.diameter = 8;
  path.start = {0, 0, 5};
  for (int i = 0; i < count; ++i) {
    part.loops.push_back(wavyPath({30.0 * i, 0}, 11, 2, 5));
    if (i >= cut) continue;
    path.moves.push_back({MoveKind::Rapid, {30.0 * i, 0, 5}});
    path.moves.push_back({MoveKind::Plunge, {30.0 * i, 0, -1}, 0, {}, 100});
  }
  return {part, path};
}

}  // namespace

/// What a program leaves of a part, from its moves alone.
class PocketUncutTest final : public QObject {
  Q_OBJECT
 private slots:
  void aDiscInARectangle() {
    Toolpath path;
    path.cutter.diameter = 6;
    path.start = {10, 10, 5};
    path.moves.push_back({MoveKind::Plunge, {10, 10, -1}, 0, {}, 100});
    const Uncut uncut = uncutOf({{boxPath(0, 0, 40, 20)}}, path, {.floor = -1});
    COMPARE_NEAR(uncut.area, 800 - 9 * pi, uncut.within + 1e-9);
    QVERIFY2(uncut.within < 800 * 1e-5, qPrintable(QString::number(uncut.within)));
    QCOMPARE(uncut.places.size(), std::size_t(1));
    COMPARE_NEAR(uncut.places[0].area, uncut.area, 1e-3);
    // what is cut higher up does not count
    COMPARE_NEAR(uncutOf({{boxPath(0, 0, 40, 20)}}, path, {.floor = -2}).area, 800, 1e-2);
  }

  /// A full circle around an island of radius 2, in a disc: rings stay within and without.
  void ringsOfAFullCircle() {
    Toolpath path;
    path.cutter.diameter = 4;
    path.start = {6, 0, -1};
    path.moves.push_back({MoveKind::Feed, {6, 0, -1}, 1, {0, 0}, 100});
    const Uncut uncut = uncutOf({{circlePath({0, 0}, 10), circlePath({0, 0}, 2, true)}}, path, {.floor = -1});
    COMPARE_NEAR(uncut.area, pi * (100 - 64 + 16 - 4), uncut.within + 1e-9);
    QCOMPARE(uncut.places.size(), std::size_t(2));
    COMPARE_NEAR(uncut.places[0].area, pi * 36, 1e-3);
    COMPARE_NEAR(uncut.places[1].area, pi * 12, 1e-3);
    COMPARE_NEAR(uncut.places[1].depth, 2, 0.01);
  }

  void roundCornersOfARectangle() {
    const Region box{{boxPath(0, 0, 60, 20)}};
    const Uncut uncut = uncutOf(box, pocketPath(box, sixMillimetres()).path, {.floor = -2});
    COMPARE_NEAR(uncut.area, (4 - pi) * 9, 1e-3);
    QCOMPARE(uncut.places.size(), std::size_t(4));
    for (const UncutPlace& place : uncut.places) QVERIFY(place.depth < 0.42 * 3 && place.depth > 0.4 * 3);
  }

  void randomMovesInRandomParts() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 12; ++k) {
      std::vector<Vec2> corners;
      for (int i = 0; i < 9; ++i) {
        const double angle = fullTurn * (i + 0.7 * unit(random)) / 9, r = 15 + 20 * unit(random);
        corners.emplace_back(r * std::cos(angle), r * std::sin(angle));
      }
      const Region part{{polygonPath(corners), boxPath(-3, -2, 4, 3, true)}};
      Toolpath path;
      path.cutter.diameter = 2 + 8 * unit(random);
      path.start = {0, 0, -1};
      for (int i = 0; i < 25; ++i) {
        ToolMove move;
        move.kind = unit(random) < 0.1 ? MoveKind::Rapid : MoveKind::Feed;
        const Vec2 from = path.moves.empty() ? Vec2(0, 0) : Vec2(path.moves.back().to.head<2>());
        Vec2 to(60 * unit(random) - 30, 60 * unit(random) - 30);
        if (unit(random) < 0.2) to.x() = from.x();  // level and upright ones, too
        if (unit(random) < 0.2) to.y() = from.y();
        if (unit(random) < 0.6 && move.kind == MoveKind::Feed) {
          move.turn = unit(random) < 0.5 ? 1 : -1;
          move.center = from + Vec2(12 * unit(random) - 6, 12 * unit(random) - 6);
          const double angle = fullTurn * unit(random);
          to = move.center + (from - move.center).norm() * Vec2(std::cos(angle), std::sin(angle));
        }
        move.to = {to.x(), to.y(), -1};
        path.moves.push_back(move);
      }
      const Uncut uncut = uncutOf(part, path, {.floor = -1});
      const double found = Columns(path, -1).uncutArea(part, -36, 36);
      QVERIFY(uncut.within <= 1.1e-5 * uncut.partArea);
      COMPARE_NEAR(uncut.partArea, areaOf(part), 1e-9);
      COMPARE_NEAR(uncut.area, found, 1e-4 * areaOf(part));
      // turned, all rows and strips are others; the bounds hold all the same
      const double angle = fullTurn * unit(random);
      const Uncut again = uncutOf(turned(part, angle), turned(path, angle), {.floor = -1});
      COMPARE_NEAR(again.area, uncut.area, again.within + uncut.within);
    }
  }

  /// Splines are taken as lines; what that may be off is told.
  void freeFormPartsAreBounded() {
    const Region part{{wavyPath({0, 0}, 25, 6, 5), wavyPath({2, 1}, 8, 1.5, 3, true)}};
    const Toolpath path = pocketPath(part, sixMillimetres()).path;
    const Uncut uncut = uncutOf(part, path, {.floor = -2});
    QVERIFY(uncut.within <= 2e-5 * uncut.partArea);
    COMPARE_NEAR(Columns(path, -2).cutArea() + uncut.area, areaOf(part), 1e-4 * areaOf(part));
  }

  /// The tool is just as wide as the slot, or a little wider or narrower: what is cut and what is told to stay make the
  /// part.
  void slotsAboutAsWideAsTheTool() {
    const double radius = 3;
    double worst = 0;
    int open = 0, closed = 0;
    for (int power = -9; power <= -2; ++power)
      for (const double sign : {-1.0, 0.0, 1.0}) {
        const double e = sign * std::pow(10, power);
        const Region part = chambers(radius * (2 + e));
        const Toolpath path = pocketPath(part, sixMillimetres()).path;
        const Uncut uncut = uncutOf(part, path, {.floor = -2, .tolerance = 0.01});
        const double area = areaOf(part);
        const double off = std::abs(Columns(path, -2).cutArea() + uncut.area - area) / area;
        worst = std::max(worst, off);
        QVERIFY2(off <= 1e-4, qPrintable(QStringLiteral("e %1 off %2").arg(e).arg(off)));
        const bool told = std::any_of(uncut.places.begin(), uncut.places.end(), [&](const UncutPlace& place) {
          return place.at.x() > 30 && place.at.x() < 70 && place.area > 0.9 * 40 * radius * 2 - 2 * pi * 9;
        });
        (told ? closed : open)++;
        const double corners = 8 * (1 - pi / 4) * radius * radius;
        // a slot that is cut leaves the corners alone
        if (!told) COMPARE_NEAR(uncut.area, corners, 0.02 * area * 1e-2);
      }
    QVERIFY(open > 0 && closed > 0);
    std::printf("figure slots_cut_and_uncut_off %.3g\nfigure slots_cut %d\nfigure slots_told_uncut %d\n", worst, open,
                closed);
  }

  /// The slot of exactly 6 mm was left without a word.
  void aSlotAsWideAsTheToolIsCutAndANarrowerOneTold() {
    const Value tool = {{"tool-diameter", 6}, {"depth", 2}};
    const Evaluated cut = made("pocket", tool, {chambers(6)});
    COMPARE_NEAR(figureOf(cut, "uncut_mm2"), 8 * (1 - pi / 4) * 9, 0.02);
    QCOMPARE(warningsOf(cut), std::string());
    const Evaluated slot = made("pocket", tool, {chambers(5.99)});
    const Toolpath* path = slot.shape.get<Toolpath>();
    COMPARE_NEAR(figureOf(slot, "uncut_mm2") + Columns(*path, -2).cutArea(), areaOf(chambers(5.99)), 0.2);
    QVERIFY2(warningsOf(slot).find("stay uncut near (") != std::string::npos, warningsOf(slot).c_str());
    const auto inSlot = [](const ToolMark& m) {
      return m.at.x() > 33 && m.at.x() < 67 && m.at.z() == -2 && m.kind == MarkKind::Unreachable;
    };
    QVERIFY(std::count_if(path->marks.begin(), path->marks.end(), inSlot) > 20);
    // no word of the round corners of a plain pocket, whose area is told all the same
    const Evaluated plain = made("pocket", {{"tool-diameter", 6}, {"depth", 2}}, {Region{{boxPath(0, 0, 60, 20)}}});
    QCOMPARE(warningsOf(plain), std::string());
    COMPARE_NEAR(figureOf(plain, "uncut_mm2"), (4 - pi) * 9, 1e-3);
  }

  void aNarrowArmIsTold() {
    const Evaluated arm = made("pocket", {{"tool-diameter", 6}, {"depth", 2}}, {withArm()});
    // The tool looks into the arm from the chamber by a segment of its disc.
    const double segment = 9 * std::asin(2.5 / 3) - 2.5 * std::sqrt(9 - 6.25);
    const double uncut = 55 * 5 - segment + (4 - pi) * 9;
    COMPARE_NEAR(figureOf(arm, "uncut_mm2"), uncut, 0.02);
    QVERIFY2(warningsOf(arm).find("stay uncut near (") != std::string::npos, warningsOf(arm).c_str());
    // the rest is said to be the four corners, so that the warning and the figure agree
    const std::string rest = fmt::format("The other {:.2f} of {:.2f} mm² lie at 4 places: in corners that it rounds.",
                                         (4 - pi) * 9, figureOf(arm, "uncut_mm2"));
    QVERIFY2(warningsOf(arm).find(rest) != std::string::npos, warningsOf(arm).c_str());
    const auto inArm = [](const ToolMark& m) {
      return m.at.x() > 42 && m.at.y() > 17 && m.at.y() < 22 && m.kind == MarkKind::Unreachable;
    };
    const Toolpath* path = arm.shape.get<Toolpath>();
    QVERIFY(std::count_if(path->marks.begin(), path->marks.end(), inArm) > 20);
    std::printf("figure arm_uncut_mm2 %.4f\nfigure arm_uncut_off_mm2 %.2g\n", figureOf(arm, "uncut_mm2"),
                std::abs(figureOf(arm, "uncut_mm2") - uncut));
  }

  void itCanBeCancelled() {
    const Region part = chambers(6.1);
    const Toolpath path = pocketPath(part, sixMillimetres()).path;
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(uncutOf(part, path, {.floor = -2}, Progress(token)), ErrorCode::Cancelled);
  }

  /// Parts side by side share all rows; each row once looked at all of them. Four times the parts are to be about four times
  /// the work.
  void theWorkGrowsAsThePartDoes() {
    const auto stepsOf = [](int count) {
      const auto [part, path] = discsInWaves(count, count);
      const Uncut uncut = uncutOf(part, path, {.floor = -1});
      const bool isRight = uncut.places.size() == static_cast<std::size_t>(count) && uncut.within <= 1e-5 * uncut.partArea;
      return isRight ? static_cast<double>(uncut.steps) : std::nan("");
    };
    const double few = stepsOf(8), many = stepsOf(32);
    QVERIFY2(many < 6 * few, qPrintable(QString("%1 steps for 8, %2 for 32").arg(few).arg(many)));
  }

  /// Of equal parts some are cut and some not: what is told does not depend on what else lies on the rows.
  void partsSideBySideAddUp() {
    const auto [part, path] = discsInWaves(9, 5);
    const Uncut all = uncutOf(part, path, {.floor = -1});
    COMPARE_NEAR(all.area, areaOf(part) - 5 * pi * 16, all.within + 1e-9);
    QCOMPARE(all.places.size(), std::size_t(9));
    for (std::size_t i = 0; i < 9; ++i) COMPARE_NEAR(all.places[i].area, areaOf(part) / 9 - (i < 4 ? 0 : pi * 16), 1e-2);
  }

  void itStopsAtEveryStageWhenCancelled() {
    const auto [part, path] = discsInWaves(16, 16);
    std::atomic<std::size_t> all = 0;
    uncutOf(part, path, {.floor = -1}, Progress({}, [&](double, const std::string&) { ++all; }));
    QVERIFY2(all > 10, qPrintable(QString::number(all)));
    for (const std::size_t reports : {std::size_t(1), std::size_t(5)}) {
      CancelToken token;
      std::atomic<std::size_t> seen = 0;
      const Progress progress(token, [&](double, const std::string&) {
        if (++seen >= reports) token.cancel();
      });
      VERIFY_ERROR(uncutOf(part, path, {.floor = -1}, progress), ErrorCode::Cancelled);
      QVERIFY(seen < reports + 8);  // a few threads may be just about to report
    }
  }
};

BLOSSOM_TEST(PocketUncutTest)
#include "pocket_uncut_test.moc"
