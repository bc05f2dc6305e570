#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "support/column_areas.h"
#include "support/modeling.h"
#include "support/planar_parts.h"
#include "support/pockets.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

/// A figure that may be left out.
double figureOr(const Evaluated& made, const std::string& name, double otherwise) {
  for (const Measure& each : made.figures)
    if (each.name == name) return std::get<double>(each.value);
  return otherwise;
}

/// What the shares say beyond the area of the part, as a share of it.
double excessOf(const Evaluated& made) {
  const double part = figureOf(made, "part_mm2");
  const double told = figureOf(made, "cut_mm2") + figureOf(made, "unreachable_mm2") + figureOr(made, "left_mm2", 0) +
                      made.shape.get<Toolpath>()->residue.value_or(0);
  return std::abs(told - part) / part;
}

/// Spikes and dents with islands between them, so that much of it is out of reach.
Region spiky(std::mt19937_64& random) {
  const int spikes = uniformInt(random, 5, 9);
  std::vector<Vec2> outer;
  for (int k = 0; k < 2 * spikes; ++k) {
    const double radius = k % 2 == 0 ? uniform(random, 40, 60) : uniform(random, 22, 32), angle = k * pi / spikes;
    outer.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  Region part{{polygonPath(outer)}};
  const double at = uniform(random, 8, 12), half = uniform(random, 2, 5);
  if (uniformInt(random, 0, 1) == 1) part.loops.push_back(circlePath({at, 0}, half, true));
  if (uniformInt(random, 0, 1) == 1) part.loops.push_back(boxPath(-at - half, -half, -at + half, half, true));
  return part;
}

}  // namespace

/// The area of a part is cut, out of reach, left on purpose or missed: measured by different ways, it adds up.
class PocketCoverageTest : public QObject {
  Q_OBJECT
 private slots:
  void aBoxInClosedForm() {
    const Region box{{boxPath(0, 0, 60, 20)}};
    const double corners = (4 - pi) * 9;
    const Evaluated plain = made("pocket", {{"tool-diameter", 6}, {"depth", 2}}, {box});
    COMPARE_NEAR(figureOf(plain, "part_mm2"), 1200, 1e-9);
    COMPARE_NEAR(figureOf(plain, "cut_mm2"), 1200 - corners, 1e-3);
    COMPARE_NEAR(figureOf(plain, "unreachable_mm2"), corners, 0.02);
    QCOMPARE(figureOr(plain, "left_mm2", -1), -1.0);
    // The corners that stay within the stock that is left are out of reach of any tool as round as this one.
    const Evaluated thick = made("pocket", {{"tool-diameter", 6}, {"depth", 2}, {"leave-wall", 1}}, {box});
    COMPARE_NEAR(figureOf(thick, "cut_mm2"), 58 * 18 - corners, 1e-3);
    COMPARE_NEAR(figureOf(thick, "unreachable_mm2"), corners, 0.02);
    COMPARE_NEAR(figureOf(thick, "left_mm2"), 1200 - 58 * 18, 0.04);
    QVERIFY(excessOf(plain) < 1e-4 && excessOf(thick) < 1e-4);
  }

  /// Dots tell why a place is not cut: beside the walls what is left, in the corners what no tool reaches.
  void dotsTellWhy() {
    const Region box{{boxPath(0, 0, 60, 20)}};
    for (const double leave : {0.0, 1.0}) {
      const Evaluated pocket = made("pocket", {{"tool-diameter", 6}, {"depth", 2}, {"leave-wall", leave}}, {box});
      const std::vector<ToolMark>& marks = pocket.shape.get<Toolpath>()->marks;
      int left = 0, unreachable = 0;
      for (const ToolMark& mark : marks) {
        const Vec2 aside = (mark.at.head<2>() - Vec2(30, 10)).cwiseAbs() - Vec2(27, 7);  // from the middle of a round corner
        const double beyond = aside.minCoeff() > 0 ? aside.norm() - 3 : -1;
        if (std::abs(beyond) < 0.03) continue;  // the tolerance beside the border
        QCOMPARE(mark.kind, beyond > 0 ? MarkKind::Unreachable : MarkKind::Left);
        ++(beyond > 0 ? unreachable : left);
      }
      QVERIFY(unreachable >= 8);
      QCOMPARE(left > 40, leave > 0);
    }
    // What a program leaves out is missed.
    Toolpath cutShort = *made("pocket", {{"tool-diameter", 6}, {"depth", 2}}, {box}).shape.get<Toolpath>();
    std::erase_if(cutShort.moves, [](const ToolMove& move) { return move.kind == MoveKind::Feed && move.to.x() > 40; });
    const Evaluated checked = made("simulate", Value::object(), {cutShort, box});
    const std::vector<ToolMark>& marks = checked.shape.get<Toolpath>()->marks;
    QVERIFY(std::any_of(marks.begin(), marks.end(), [](const ToolMark& mark) { return mark.kind == MarkKind::Missed; }));
  }

  void sharesAddUpToThePart() {
    std::mt19937_64 random = seededRandom();
    double worst = 0, worstOfMoves = 0, out = 0;
    for (int k = 0; k < 24; ++k) {
      const Region part = spiky(random);
      const double diameter = uniform(random, 2, 8);
      const double leave = uniformInt(random, 0, 1) * uniform(random, 0.1, 1);
      const Value options{{"tool-diameter", diameter},
                          {"depth", 2},
                          {"stepover", std::to_string(uniformInt(random, 10, 95)) + "%"},
                          {"leave-wall", leave}};
      const Evaluated pocket = made("pocket", options, {part});
      worst = std::max(worst, excessOf(pocket));
      out = std::max(out, figureOf(pocket, "unreachable_mm2") / areaOf(part));
      const double swept = Columns(*pocket.shape.get<Toolpath>(), -2).cutArea();
      worstOfMoves = std::max(worstOfMoves, std::abs(swept - figureOf(pocket, "cut_mm2")) / areaOf(part));
    }
    std::printf("figure coverage_shares_off %.2g\nfigure coverage_cut_off %.2g\n", worst, worstOfMoves);
    QVERIFY2(worst < 1e-4, qPrintable(QString::number(worst)));
    QVERIFY2(worstOfMoves < 1e-4, qPrintable(QString::number(worstOfMoves)));
    QVERIFY(out > 0.02);  // not of parts alone that the tool reaches all of
  }
};

BLOSSOM_TEST(PocketCoverageTest)
#include "pocket_coverage_test.moc"
