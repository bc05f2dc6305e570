#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/check/simulate.h"
#include "pocket/kernel/check/uncut.h"
#include "pocket/kernel/path/pocket_path.h"
#include "support/bent_slots.h"
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

PocketOptions toolOf(double diameter) {
  PocketOptions o;
  o.cutter.diameter = diameter;
  o.depth = diameter / 4;
  o.stepdown = diameter / 4;
  return o;
}

/// What came of a slot. Of a slot that is refused, all stays.
struct SlotCut {
  bool isRefused = false;
  double off = 0;     ///< of the part: cut by columns, and told to be uncut, less the part
  double uncut = 0;   ///< mm2
  double within = 0;  ///< error bound of that, a share of the part
  double gouge = 0;   ///< mm
  double told = 0;    ///< diameter of the largest tool, when refused
};

SlotCut cutSlot(const Region& part, double diameter) {
  SlotCut found;
  const double area = areaOf(part), depth = diameter / 4;
  try {
    const Toolpath path = pocketPath(part, toolOf(diameter)).path;
    const Uncut uncut = uncutOf(part, path, {.floor = -depth});
    found.uncut = uncut.area;
    found.within = uncut.within / area;
    found.off = std::abs(Columns(path, -depth).cutArea() + uncut.area - area) / area;
    found.gouge = simulate(path, part, {.depth = depth}).gouge;
  } catch (const Error& error) {
    if (error.message().find("does not fit into the part") == std::string::npos) throw;
    found.isRefused = true;
    found.told = std::stod(error.hint().substr(error.hint().rfind("of ") + 3));
  }
  return found;
}

/// Most that a tool leaves in the square corners of two ends, which bent walls make wider or narrower, and of a slot that is
/// wider than it along both walls.
double leftAtEnds(const BentSlot& slot, double diameter) {
  const double corners = slot.hasRoundEnds ? 0 : 1.5 * (4 - pi) * diameter * diameter / 4;
  return corners + (slot.width - diameter > 0 ? 2 * (slot.width - diameter) * slot.length : 0);
}

}  // namespace

/// Slots and holes just as wide as the tool.
class PocketSlotTest final : public QObject {
  Q_OBJECT
 private slots:
  /// Half of them were refused or left out: the chords of arcs and splines decided.
  void bentSlotsAsWideAsTheToolAreCut() {
    auto random = seededRandom();
    double off = 0, gouge = 0;
    for (int k = 0; k < 40; ++k) {
      const double diameter = std::pow(2, k % 4);
      const BentSlot slot = k % 3 == 2 ? splineSlot(random, diameter) : arcSlot(random, diameter);
      const SlotCut found = cutSlot(slot.part, diameter);
      const std::string which = fmt::format("slot {}: {}", k, slot.told);
      QVERIFY2(!found.isRefused, which.c_str());
      QVERIFY2(found.uncut <= leftAtEnds(slot, diameter) + 2e-4 * areaOf(slot.part),
               fmt::format("{} leaves {} of {}", which, found.uncut, areaOf(slot.part)).c_str());
      QVERIFY2(found.off <= 1e-4, fmt::format("{} off {} gouge {}", which, found.off, found.gouge).c_str());
      QVERIFY2(found.within <= 2e-5, fmt::format("{} known within {}", which, found.within).c_str());
      off = std::max(off, found.off);
      gouge = std::max(gouge, found.gouge);
    }
    QVERIFY2(gouge <= 0.005 + 1e-6, QByteArray::number(gouge));
    std::printf("figure bent_slots_cut_and_uncut_off %.3g\nfigure bent_slots_gouge_mm %.3g\n", off, gouge);
  }

  /// A little wider or narrower: cut or told, and refused only by a tool that is too wide by more than rounding, with the
  /// width of the slot.
  void bentSlotsAboutAsWideAsTheToolAreCutOrTold() {
    auto random = seededRandom();
    double worst = 0;
    int cut = 0, refused = 0;
    for (int power = -9; power <= -2; ++power)
      for (const double sign : {-1.0, 1.0})
        for (const bool bySpline : {false, true}) {
          const double diameter = 4, e = sign * std::pow(10, power), width = diameter * (1 + e);
          const BentSlot slot = bySpline ? splineSlot(random, width) : arcSlot(random, width);
          const SlotCut found = cutSlot(slot.part, diameter);
          const std::string which = fmt::format("e {:g}: {}", e, slot.told);
          (found.isRefused ? refused : cut)++;
          if (found.isRefused) {
            QVERIFY2(e < -1e-6, which.c_str());
            QVERIFY2(std::abs(found.told - width) <= 1e-4 * width, fmt::format("{} told {}", which, found.told).c_str());
            continue;
          }
          worst = std::max(worst, found.off);
          QVERIFY2(found.off <= 1e-4, fmt::format("{} off {} gouge {}", which, found.off, found.gouge).c_str());
          QVERIFY2(found.within <= 2e-5, fmt::format("{} known within {}", which, found.within).c_str());
          // A tool that is too wide by more than rounding may leave parts of the slot, and all that it leaves is told.
          if (e >= -1e-6) QVERIFY2(found.uncut <= leftAtEnds(slot, diameter) + 2e-4 * areaOf(slot.part), which.c_str());
        }
    QVERIFY(cut > 0 && refused > 0);
    std::printf("figure bent_slots_about_as_wide_off %.3g\n", worst);
  }

  /// Rooms at both ends: nothing is refused, and what is not cut is told.
  void bentSlotsBetweenRoomsAreCutOrTold() {
    auto random = seededRandom();
    for (int k = 0; k < 12; ++k) {
      const double diameter = 3, e = k % 3 == 0 ? 0 : (k % 2 == 0 ? 1 : -1) * std::pow(10, -2 - k % 8);
      const BentSlot slot = withRooms(arcSlot(random, diameter * (1 + e), 0.7));
      const SlotCut found = cutSlot(slot.part, diameter);
      const std::string which = fmt::format("e {:g}: {}", e, slot.told);
      QVERIFY2(!found.isRefused, which.c_str());
      QVERIFY2(found.off <= 1e-4, fmt::format("{} off {} gouge {}", which, found.off, found.gouge).c_str());
      if (e >= -1e-7) QVERIFY2(found.uncut < 0.1 * slot.width * slot.length + 2 * diameter * diameter, which.c_str());
    }
  }

  /// A tool goes straight down into a hole as wide as it is; one sentence is told, and a true one.
  void holesAsWideAsTheToolAreCut() {
    for (const double wider : {0.0, 1e-7, 1e-6, 1e-4, 1e-3, 2e-3})
      for (const bool alone : {true, false}) {
        Region part{{circlePath({4, 5}, 3 + wider / 2)}};
        if (!alone) part.loops.push_back(boxPath(20, 0, 50, 20));
        const Evaluated made = test::made("pocket", {{"tool-diameter", 6}, {"depth", 2}}, {part});
        const Toolpath& path = *made.shape.get<Toolpath>();
        const double corners = alone ? 0 : (4 - pi) * 9;
        COMPARE_NEAR(figureOf(made, "uncut_mm2"), areaOf(part) - pi * 9 - (alone ? 0 : 600) + corners, 0.01);
        QVERIFY(path.gouge && *path.gouge <= 1e-4);
        QCOMPARE(made.warnings.size(), std::size_t(1));
        QVERIFY2(made.warnings[0].find("1 entry has no room for a ramp: the tool plunges there.") == 0,
                 made.warnings[0].c_str());
      }
    // what is told of a narrower one is not said to be within reach
    const Evaluated narrow =
        made("pocket", {{"tool-diameter", 6}, {"depth", 2}}, {Region{{circlePath({4, 5}, 2.999), boxPath(20, 0, 50, 20)}}});
    for (const std::string& warning : narrow.warnings)
      QVERIFY2(warning.find("could reach") == std::string::npos, warning.c_str());
    QVERIFY(figureOf(narrow, "uncut_mm2") > pi * 8.99);
  }

  /// There is more than one way through: a square takes the tool at its middle alone.
  void aSquareAsWideAsTheToolIsCutAtItsMiddle() {
    const Region square{{boxPath(1, 2, 7, 8)}};
    const SlotCut found = cutSlot(square, 6);
    QVERIFY(!found.isRefused);
    COMPARE_NEAR(found.uncut, (4 - pi) * 9, 1e-3);
  }
};

BLOSSOM_TEST(PocketSlotTest)
#include "pocket_slot_test.moc"
