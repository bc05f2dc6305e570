#include <cstring>

#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/grid/iso_curves.h"
#include "sweep/kernel/grid/live_grid.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/grid/shown_normals.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// A motion that closes in u with a given number of rows, fewer than its basis functions overlap.
Motion motionOfFewRows(Random& random, ClosedU closed, std::size_t rows) {
  Motion motion = randomMotion(random, ClosedU::No);
  std::vector<double> period;
  for (std::size_t i = 0; i <= rows; ++i) period.push_back(static_cast<double>(i) / static_cast<double>(rows));
  const auto surface = [&](const Surface& like, double sign, auto pole) {
    std::vector<Vec4> poles;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < like.countV(); ++j) poles.push_back(pole(period[i]));
    return unwrapped(uniformInt(random, 2, 3), like.degreeV, period, like.knotsV, poles, sign);
  };
  motion.closedU = closed;
  const double turn = closed == ClosedU::AntiPeriodic ? std::numbers::pi : 0;
  motion.orientation = surface(motion.orientation, closed == ClosedU::AntiPeriodic ? -1 : 1,
                               [&](double at) { return randomQuaternion(random, turn * at); });
  motion.scaling = surface(motion.scaling, 1, [&](double) { return randomScale(random); });
  return motion;
}

/// Open, periodic and anti-periodic in turn, every third closed one with 1 to 3 rows; p on an axis now and then.
Motion motionOfKind(Random& random, int kind) {
  const auto closed = static_cast<ClosedU>(kind % 3);
  Motion motion = closed != ClosedU::No && kind % 9 > 5
                      ? motionOfFewRows(random, closed, static_cast<std::size_t>(uniformInt(random, 1, 3)))
                      : randomMotion(random, closed);
  const int axis = uniformInt(random, 0, 5);
  if (axis < 3) motion.point = 2 * Vec3::Unit(axis);
  validate(motion);
  return motion;
}

double signOf(const Motion& motion, const Surface& factor) {
  return &factor == &motion.orientation && motion.closedU == ClosedU::AntiPeriodic ? -1 : 1;
}

/// Changes some poles of a factor; the rows that repeat the first ones follow.
void editSome(Random& random, Motion& motion, Surface& factor, int poles) {
  const std::size_t repeated = motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(factor.degreeU),
                    free = factor.countU() - repeated;
  for (; poles > 0; --poles) {
    const auto i = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(free) - 1));
    const auto j = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(factor.countV()) - 1));
    factor.pole(i, j) *= uniform(random, 1.01, 1.2);
  }
  for (std::size_t i = free; i < factor.countU(); ++i)
    for (std::size_t j = 0; j < factor.countV(); ++j) factor.pole(i, j) = signOf(motion, factor) * factor.pole(i - free, j);
}

void editSome(Random& random, Motion& motion) {
  const int what = uniformInt(random, 1, 7);  // a bit for each factor
  if (what & 1) editSome(random, motion, motion.orientation, uniformInt(random, 1, 3));
  if (what & 2) editSome(random, motion, motion.scaling, uniformInt(random, 1, 3));
  if (what & 4)
    motion.trajectory
        .poles[static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(motion.trajectory.poles.size()) - 1))][0] +=
        uniform(random, 0.1, 1);
}

/// Ascending parameters, with the ends of the domain and some knots among them.
std::vector<double> randomParameters(Random& random, std::pair<double, double> domain, const std::vector<double>& knots) {
  std::vector<double> result = evenParameters(domain, static_cast<std::size_t>(uniformInt(random, 2, 90)));
  for (const double knot : knots)
    if (knot > domain.first && knot < domain.second) result.push_back(knot);
  std::sort(result.begin(), result.end());
  return result;
}

bool sameNumber(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

using Marks = std::vector<char>;

Marks marked(std::span<const GridRectangle> parts, const MotionGrid& grid) {
  Marks marks(grid.countU * grid.countV, 0);
  for (const GridRectangle& part : parts)
    for (std::size_t k = part.rows.begin; k < part.rows.end; ++k)
      for (std::size_t l = part.columns.begin; l < part.columns.end; ++l) ++marks[k * grid.countV + l];
  return marks;
}

/// Places where two grids differ in any bit, of those with this mark.
std::size_t differences(const MotionGrid& a, const MotionGrid& b, const Marks& marks, char mark) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < marks.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      if (marks[i] == mark && !(sameNumber(a.point[c][i], b.point[c][i]) && sameNumber(a.normal[c][i], b.normal[c][i])))
        ++count;
  return count;
}

/// Does a pole reach t? Its basis function is zero outside these knots, which are told from the definition.
bool reaches(int degree, const std::vector<double>& knots, std::size_t pole, double t) {
  return knots[pole] <= t && t <= knots[pole + static_cast<std::size_t>(degree) + 1];
}

}  // namespace

class SweepLiveTest : public QObject {
  Q_OBJECT
 private slots:
  void theFirstGridIsTheFullOne() {
    auto random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const Motion motion = motionOfKind(random, k);
      const auto us = randomParameters(random, motion.domainU(), motion.orientation.knotsU);
      const auto vs = randomParameters(random, motion.domainV(), motion.scaling.knotsV);
      const LiveGrid live(motion, us, vs);
      MotionGrid full;
      evaluateGrid(motion, us, vs, full);
      QCOMPARE(differences(live.grid(), full, Marks(us.size() * vs.size(), 0), 0), std::size_t{0});
    }
  }

  void editsEqualFullEvaluationBitForBit() {
    auto random = seededRandom();
    std::size_t evaluated = 0, kept = 0;
    for (int k = 0; k < 150; ++k) {
      Motion motion = motionOfKind(random, k);
      const auto us = randomParameters(random, motion.domainU(), motion.orientation.knotsU);
      const auto vs = randomParameters(random, motion.domainV(), motion.scaling.knotsV);
      LiveGrid live(motion, us, vs);
      for (int step = 0; step < 4; ++step) {
        const MotionGrid before = live.grid();
        editSome(random, motion);
        validate(motion);
        const Marks marks = marked(live.update(motion), live.grid());
        MotionGrid full;
        evaluateGrid(motion, us, vs, full);
        const Marks all(marks.size(), 0);
        QCOMPARE(differences(live.grid(), full, all, 0), std::size_t{0});
        QCOMPARE(differences(live.grid(), before, marks, 0), std::size_t{0});
        QVERIFY2(*std::max_element(marks.begin(), marks.end()) <= 1, "no place is evaluated twice");
        const auto count = static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
        evaluated += count, kept += marks.size() - count;
      }
    }
    qInfo("evaluated %zu, kept %zu", evaluated, kept);
    QVERIFY(kept > 0);
  }

  /// What is evaluated lies in the support of the pole, columns rounded to blocks.
  void onlyTheSupportIsEvaluated() {
    auto random = seededRandom();
    for (int k = 0; k < 100; ++k) {
      Motion motion = randomMotion(random, ClosedU::No);
      const auto us = evenParameters(motion.domainU(), 64), vs = evenParameters(motion.domainV(), 300);
      LiveGrid live(motion, us, vs);
      Surface& factor = k % 2 ? motion.orientation : motion.scaling;
      const auto i = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(factor.countU()) - 1));
      const auto j = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(factor.countV()) - 1));
      factor.pole(i, j) *= 1.1;
      for (const GridRectangle& part : live.update(motion)) {
        for (const std::size_t row : {part.rows.begin, part.rows.end - 1})
          QVERIFY(reaches(factor.degreeU, factor.knotsU, i, us[row]));
        const std::size_t from = part.columns.begin, to = part.columns.end;
        QVERIFY(from % blockSize == 0 && (to % blockSize == 0 || to == vs.size()));
        bool first = false, last = false;
        for (std::size_t l = 0; l < blockSize; ++l) {
          first = first || reaches(factor.degreeV, factor.knotsV, j, vs[std::min(from + l, to - 1)]);
          last = last || reaches(factor.degreeV, factor.knotsV, j, vs[to - 1 - std::min(l, to - 1)]);
        }
        QVERIFY(first && last);
      }
    }
  }

  /// A pole next to the seam of a closed motion changes both ends of the domain and not what lies between.
  void editsReachRoundTheSeam() {
    auto random = seededRandom();
    for (const ClosedU closed : {ClosedU::Periodic, ClosedU::AntiPeriodic}) {
      Motion motion = randomMotion(random, closed, true);
      const auto us = evenParameters(motion.domainU(), 100), vs = evenParameters(motion.domainV(), 20);
      LiveGrid live(motion, us, vs);
      Surface& r = motion.orientation;
      const std::size_t free = r.countU() - 3;
      r.pole(1, 0) *= 1.3;
      r.pole(free + 1, 0) = signOf(motion, r) * r.pole(1, 0);
      const Marks marks = marked(live.update(motion), live.grid());
      QVERIFY(marks.front() == 1 && marks[99 * 20] == 1);
      for (std::size_t k = 0; k < 100; ++k)
        if (!reaches(3, r.knotsU, 1, us[k]) && !reaches(3, r.knotsU, free + 1, us[k])) QVERIFY(marks[k * 20] == 0);
      for (std::size_t l = 0; l < 20; ++l) QVERIFY((live.grid().pointAt(0, l) - live.grid().pointAt(99, l)).norm() < 1e-11);
    }
  }

  /// Many parameters of a span are evaluated by powers, a single one by its basis functions.
  void manyParametersOfASpanAreAsOne() {
    auto random = seededRandom();
    double apart = 0;
    for (int k = 0; k < 30; ++k) {
      const Motion motion = motionOfKind(random, k);
      const auto us = evenParameters(motion.domainU(), 200), vs = randomParameters(random, motion.domainV(), {});
      MotionGrid grid, row;
      evaluateGrid(motion, us, vs, grid);
      for (std::size_t i = 0; i < us.size(); i += 7) {
        evaluateGrid(motion, std::span(us).subspan(i, 1), vs, row);
        for (std::size_t l = 0; l < vs.size(); ++l)
          apart = std::max(apart, (grid.pointAt(i, l) - row.pointAt(0, l)).norm() / (1 + row.pointAt(0, l).norm()));
      }
    }
    qInfo("figure spans_apart %.2e", apart);
    QVERIFY2(apart < 1e-12, qPrintable(QString::number(apart)));
  }

  void whatIsTheSameIsNotEvaluated() {
    auto random = seededRandom();
    Motion motion = randomMotion(random, ClosedU::No);
    LiveGrid live(motion, evenParameters(motion.domainU(), 20), evenParameters(motion.domainV(), 30));
    QVERIFY(live.update(motion).empty());
    motion.point *= 2;
    const auto parts = live.update(motion);
    QVERIFY(parts.size() == 1 && parts[0].rows.size() == 20 && parts[0].columns.size() == 30);
    const double u = live.us()[7], v = live.vs()[11];
    QVERIFY((live.grid().pointAt(7, 11) - evaluate(motion, u, v).point).norm() < 1e-11);
  }

  /// Columns without normals borrow those beside them, and are shaded anew with these.
  void borrowedNormalsFollow() {
    auto random = seededRandom();
    for (int round = 0; round < 300; ++round) {
      MotionGrid before;
      before.countU = static_cast<std::size_t>(uniformInt(random, 1, 4)), before.countV = 12;
      const auto fill = [&](MotionGrid& grid, const GridRectangle& part) {
        for (std::size_t k = part.rows.begin; k < part.rows.end; ++k)
          for (std::size_t l = part.columns.begin; l < part.columns.end; ++l) {
            const bool none = uniformInt(random, 0, 2) > 0;
            for (auto& each : grid.normal) each[k * grid.countV + l] = none ? 0 : uniform(random, 0.1, 1);
          }
      };
      for (auto& each : before.normal) each.resize(before.countU * before.countV);
      fill(before, {{0, before.countU}, {0, before.countV}});
      MotionGrid after = before;
      const auto begin = static_cast<std::size_t>(uniformInt(random, 0, 11));
      const GridRectangle part{{0, before.countU},
                               {begin, static_cast<std::size_t>(uniformInt(random, static_cast<int>(begin) + 1, 12))}};
      fill(after, part);
      const Marks shaded = marked(std::vector{withBorrowers(after, part)}, after);
      for (std::size_t k = 0; k < after.countU; ++k)
        for (std::size_t l = 0; l < after.countV; ++l)
          QVERIFY(shaded[k * after.countV + l] || shownNormal(before, k, l) == shownNormal(after, k, l));
    }
  }

  void parametersMustAscend() {
    auto random = seededRandom();
    const Motion motion = randomMotion(random, ClosedU::No);
    VERIFY_ERROR(LiveGrid(motion, {0.5, 0.25}, {0, 1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(LiveGrid(motion, {0.5}, {}), ErrorCode::InvalidParameter);
  }

  void isoCurvesLieOnTheSurface() {
    auto random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const std::vector<double> us{randomIn(random, motion.domainU()), motion.domainU().second},
          vs{motion.domainV().first, randomIn(random, motion.domainV()), randomIn(random, motion.domainV())};
      const IsoCurves curves = isoCurves(motion, us, vs, 17);
      QCOMPARE(curves.constantU.size(), us.size());
      QCOMPARE(curves.constantV.size(), vs.size());
      const auto alongU = evenParameters(motion.domainU(), 17), alongV = evenParameters(motion.domainV(), 17);
      for (std::size_t l = 0; l < 17; ++l) {
        for (std::size_t i = 0; i < us.size(); ++i)
          QVERIFY((curves.constantU[i][l] - evaluate(motion, us[i], alongV[l]).point).norm() < 1e-11);
        for (std::size_t i = 0; i < vs.size(); ++i)
          QVERIFY((curves.constantV[i][l] - evaluate(motion, alongU[l], vs[i]).point).norm() < 1e-11);
      }
    }
    VERIFY_ERROR(isoCurves(randomMotion(random, ClosedU::No), {}, {}, 1), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(SweepLiveTest)
#include "sweep_live_test.moc"
