// The region that is drawn where a pull would change the surface, against what a pull changes; and the keys for its level.
#include "geometry/bspline/bspline.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/manipulators/edit_region.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

PullMode modeOf(int wayKey, int level, int fold = 1) {
  PullMode mode;
  mode.key(wayKey);
  for (int k = 0; k < level; ++k) mode.key(Qt::Key_Plus);
  for (int k = 0; k > level; --k) mode.key(Qt::Key_Minus);
  mode.key(Qt::Key_0 + fold);
  return mode;
}

/// @param margin share of its width that is left out on each side, where little changes
bool isIn(const EditRegion& region, double u, double v, double margin) {
  const auto within = [&](double t, double first, double last) {
    return t > first + margin * (last - first) && t < last - margin * (last - first);
  };
  bool inU = region.around;
  for (const double turns : {-1.0, 0.0, 1.0}) inU = inU || within(u + turns, region.firstU, region.lastU);
  return inU && within(v, region.firstV, region.lastV);
}

}  // namespace

class SweepRegionTest : public QObject {
  Q_OBJECT

 private slots:
  void theRegionIsWhatChanges() {
    auto random = seededRandom();
    const Motion given = primitiveMotion({.radius = 10, .rows = 16, .columns = 12}).motion;
    int inside = 0, outside = 0;
    for (int k = 0; k < 60; ++k) {
      Motion motion = given;
      if (k % 3 == 2) {  // one that was refined before
        MotionPull fine{{{0.4, 0.6}}, {Vec3(0, 14, 24)}, {0, 0, 1}};
        fine.level = 2;
        motion = pull(motion, fine).motion;
      }
      const int level = k % 6 - 2;
      const int way = k % 2 == 0 ? Qt::Key_S : Qt::Key_T;
      const PullMode mode = modeOf(way, level);
      QCOMPARE(mode.level(), level);
      const MotionPlace at{uniform(random, 0, 1), uniform(random, 0, 1)};
      MotionPull edit{{at}, {evaluate(motion, at.u, at.v).point + Vec3(5, 6, 7)}, mode.weights()};
      edit.level = mode.level();
      const Motion after = pull(motion, edit).motion;
      const EditRegion region = editRegion(motion, at, mode);
      for (int i = 0; i < 300; ++i) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        const double moved = (evaluate(after, u, v).point - evaluate(motion, u, v).point).norm();
        if (isIn(region, u, v, 0.3)) {
          ++inside;
          const double least = k % 3 == 2 ? 0 : 1e-9;  // see below
          QVERIFY2(moved > least, qPrintable(QString("%1 at %2, %3, level %4").arg(moved).arg(u).arg(v).arg(level)));
        } else if (!isIn(region, u, v, 0)) {
          ++outside;
          QVERIFY2(moved < 1e-12, qPrintable(QString("%1 at %2, %3, level %4").arg(moved).arg(u).arg(v).arg(level)));
        }
      }
    }
    QVERIFY(inside > 500 && outside > 1000);
  }

  void theRegionPassesOverTheSeamOfARingAtEveryLevel() {
    auto random = seededRandom();
    const Motion given =
        primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6, .rows = 8, .columns = 32}).motion;
    int inside = 0, outside = 0, over = 0;
    for (int k = 0; k < 60; ++k) {
      Motion motion = given;
      if (k % 3 == 2) {
        MotionPull fine{{{0.4, 0.99}}, {evaluate(given, 0.4, 0.99).point + Vec3(0, 1, 1)}, {0, 0, 1}};
        fine.level = 2;
        motion = pull(motion, fine).motion;
      }
      const PullMode mode = modeOf(k % 2 == 0 ? Qt::Key_S : Qt::Key_T, k % 5 - 2);
      const MotionPlace at{uniform(random, 0, 1), k % 4 < 2 ? uniform(random, 0, 0.04) : uniform(random, 0.96, 1)};
      MotionPull edit{{at}, {evaluate(motion, at.u, at.v).point + Vec3(1, 2, 1)}, mode.weights()};
      edit.level = mode.level();
      const Motion after = pull(motion, edit).motion;
      const EditRegion region = editRegion(motion, at, mode);
      QVERIFY(region.ring && region.lastV - region.firstV < 1);
      if (region.firstV < 0 || region.lastV > 1) ++over;  // fine functions near the seam may end before it
      const auto isInRing = [&](double u, double v, double margin) {
        return isIn(region, u, v, margin) || isIn(region, u, v - 1, margin) || isIn(region, u, v + 1, margin);
      };
      for (int i = 0; i < 300; ++i) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        const double moved = (evaluate(after, u, v).point - evaluate(motion, u, v).point).norm();
        if (isInRing(u, v, 0.3)) {
          ++inside;
          // Beside fine spans, a wide one may be reached only by a function that is hardly above 0 at the place of the edit.
          const double least = k % 3 == 2 ? 0 : 1e-12;  // as little as outside is nothing
          QVERIFY2(moved > least, qPrintable(QString("%1 at %2, %3, level %4").arg(moved).arg(u).arg(v).arg(k % 5 - 2)));
        } else if (!isInRing(u, v, 0)) {
          ++outside;
          QVERIFY2(moved < 1e-12, qPrintable(QString("%1 at %2, %3, level %4").arg(moved).arg(u).arg(v).arg(k % 5 - 2)));
        }
      }
    }
    QVERIFY(inside > 300 && outside > 1000 && over > 30);
  }

  void theRegionsOfCopiesAreWhatChanges() {
    auto random = seededRandom();
    const Motion motion = primitiveMotion({.radius = 10, .rows = 16, .columns = 12}).motion;
    int inside = 0, outside = 0;
    for (int k = 0; k < 20; ++k) {
      const PullMode mode = modeOf(Qt::Key_S, 1 + k % 2, k % 4 < 2 ? 2 : 4);
      const MotionPlace at{uniform(random, 0, 1), uniform(random, 0, 1)};
      const MotionPoint there = evaluate(motion, at.u, at.v);
      MotionPull edit{{at}, {there.point + Vec3(there.point.x(), there.point.y(), 0) / 3}, mode.weights()};
      edit.symmetry = mode.symmetry();
      edit.level = mode.level();
      const Motion after = pull(motion, edit).motion;
      const std::vector<EditRegion> regions = editRegions(motion, at, mode);
      QCOMPARE(regions.size(), static_cast<std::size_t>(mode.symmetry().fold));
      for (int i = 0; i < 900; ++i) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        const double moved = (evaluate(after, u, v).point - evaluate(motion, u, v).point).norm();
        const auto has = [&](double margin) {
          return std::any_of(regions.begin(), regions.end(),
                             [&](const EditRegion& each) { return isIn(each, u, v, margin); });
        };
        if (has(0.3)) {
          ++inside;
          QVERIFY2(moved > 1e-9, qPrintable(QString("%1 at %2, %3").arg(moved).arg(u).arg(v)));
        } else if (!has(0)) {
          ++outside;
          QVERIFY2(moved < 1e-12, qPrintable(QString("%1 at %2, %3").arg(moved).arg(u).arg(v)));
        }
      }
    }
    QVERIFY2(inside > 100 && outside > 1000, qPrintable(QStringLiteral("%1 inside, %2 outside").arg(inside).arg(outside)));
    // Three do not fit on sixteen rows, and sections that are moved go as a whole.
    QCOMPARE(editRegions(motion, {0.3, 0.5}, modeOf(Qt::Key_S, 0, 3)).size(), std::size_t{1});
    QCOMPARE(editRegions(motion, {0.3, 0.5}, modeOf(Qt::Key_T, 0, 4)).size(), std::size_t{1});
  }

  void theFoldDoesNotChangeTheRegionAlongV() {
    for (const PrimitiveKind kind : {PrimitiveKind::Cylinder, PrimitiveKind::Torus}) {
      const Motion motion = primitiveMotion({.kind = kind, .radius = 30, .profile = 6, .rows = 16, .columns = 16}).motion;
      for (const int way : {Qt::Key_S, Qt::Key_R, Qt::Key_T})
        for (int level = -4; level <= 1; ++level) {
          const MotionPlace at{0.1, 0.4};
          const EditRegion alone = editRegion(motion, at, modeOf(way, level)),
                           folded = editRegion(motion, at, modeOf(way, level, 4));
          QCOMPARE(folded.firstV, alone.firstV);
          QCOMPARE(folded.lastV, alone.lastV);
          QCOMPARE(folded.ring, alone.ring);
        }
    }
  }

  void keysChangeTheLevel() {
    PullMode mode;
    QVERIFY(mode.levelText().isEmpty());
    QVERIFY(mode.key(Qt::Key_Equal));
    QCOMPARE(mode.level(), 1);
    QVERIFY(mode.key(Qt::Key_Plus) && !mode.levelText().isEmpty());
    QCOMPARE(mode.level(), 2);
    QVERIFY(mode.levelText().contains("2"));
    for (int k = 0; k < 30; ++k) QVERIFY(mode.key(Qt::Key_Minus));
    QCOMPARE(mode.level(), coarsestLevel);
    for (int k = 0; k < 30; ++k) QVERIFY(mode.key(Qt::Key_Plus));
    QCOMPARE(mode.level(), finestLevel);
    QVERIFY(mode.key(Qt::Key_0));
    QCOMPARE(mode.level(), 0);
    QCOMPARE(mode.symmetry().fold, 1);
  }
};

BLOSSOM_TEST(SweepRegionTest)
#include "sweep_region_test.moc"
