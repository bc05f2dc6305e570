#include <algorithm>

#include "geometry/bspline/bspline.h"
#include "support/dense.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/least_change.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr std::size_t poles = 30;

/// Four neighbouring poles with random shares.
PlaceRow randomRow(Random& random) {
  const auto first = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(poles) - 4));
  PlaceRow row;
  for (std::size_t i = first; i < first + 4; ++i) {
    row.pole.push_back(i);
    row.share.push_back(uniform(random, 0.1, 1));
  }
  return row;
}

MatrixXd rowsOf(const std::vector<PlaceRow>& places) {
  MatrixXd all = MatrixXd::Zero(static_cast<Index>(places.size()), static_cast<Index>(poles));
  for (std::size_t k = 0; k < places.size(); ++k)
    for (std::size_t i = 0; i < places[k].pole.size(); ++i)
      all(static_cast<Index>(k), static_cast<Index>(places[k].pole[i])) = places[k].share[i];
  return all;
}

MatrixXd onAllPoles(const PoleChange& change) {
  MatrixXd all = MatrixXd::Zero(static_cast<Index>(poles), change.by.cols());
  for (std::size_t k = 0; k < change.pole.size(); ++k)
    all.row(static_cast<Index>(change.pole[k])) = change.by.row(static_cast<Index>(k));
  return all;
}

MatrixXd randomWanted(Random& random, std::size_t rows) {
  MatrixXd wanted(static_cast<Index>(rows), 3);
  for (Index i = 0; i < wanted.size(); ++i) wanted.data()[i] = uniform(random, -5, 5);
  return wanted;
}

}  // namespace

class SweepLeastChangeTest : public QObject {
  Q_OBJECT

 private slots:
  /// Rows that come several times and contradict themselves: the least-squares solution of least norm of all rows as given.
  void equalRowsAreMetByTheirMean() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
      std::vector<PlaceRow> rows;
      // Far enough apart that no two of them nearly depend on each other.
      const int different = uniformInt(random, 1, 3);
      for (int i = 0; i < different; ++i) {
        PlaceRow row = randomRow(random);
        for (std::size_t& pole : row.pole) pole = pole % 8 + 10 * static_cast<std::size_t>(i);
        std::sort(row.pole.begin(), row.pole.end());
        rows.insert(rows.end(), static_cast<std::size_t>(uniformInt(random, 1, 6)), row);
      }
      std::shuffle(rows.begin(), rows.end(), random);
      const MatrixXd wanted = randomWanted(random, rows.size()), all = rowsOf(rows);
      const PoleChange change = leastChange(rows, wanted, {});
      const MatrixXd expected = shortestSolution(all, wanted);
      worst = std::max(worst, (onAllPoles(change) - expected).norm() / expected.norm());
      if (rows.size() > 1)
        COMPARE_NEAR(change.residual, (all * expected - wanted).rowwise().norm().maxCoeff(), 1e-12 * wanted.norm());
    }
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  /// Beside pins: they hold, and what is left is across all that poles can still do.
  void equalRowsBesidePinsAreLeastSquares() {
    auto random = seededRandom();
    double pinned = 0, across = 0;
    for (int k = 0; k < 200; ++k) {
      std::vector<PlaceRow> rows;
      for (int i = 0; i < 3; ++i)
        rows.insert(rows.end(), static_cast<std::size_t>(uniformInt(random, 1, 4)), randomRow(random));
      const std::vector<PlaceRow> pins{randomRow(random)};
      const MatrixXd wanted = randomWanted(random, rows.size()), a = rowsOf(rows), p = rowsOf(pins),
                     by = onAllPoles(leastChange(rows, wanted, pins));
      const MatrixXd off = a.transpose() * (a * by - wanted);
      pinned = std::max(pinned, (p * by).norm() / by.norm());
      across = std::max(across, (off - p.transpose() * (p * off) / p.squaredNorm()).norm() / wanted.norm());
    }
    QVERIFY2(pinned < 1e-13, qPrintable(QString::number(pinned)));
    QVERIFY2(across < 1e-9, qPrintable(QString::number(across)));
  }

  /// Copies around a motion ask the same functions of its trajectory for different things; knots of any size.
  void copiesOnTheTrajectoryGiveNumbers() {
    for (const double range : {1.0, 1e-5, 1e-7, 1e6})
      for (const int level : {0, 1, 2})
        for (const int fold : {2, 4}) {
          Motion motion = primitiveMotion({.radius = 10, .height = 40}).motion;
          for (std::vector<double>* knots : {&motion.trajectory.knots, &motion.orientation.knotsV, &motion.scaling.knotsV})
            for (double& knot : *knots) knot *= range;
          MotionPull edit{{{0.3, 0.5 * range}}, {{-5, 12, 22}}, {1, 0, 0}};
          edit.symmetry.fold = fold, edit.level = level;
          const EditResult result = pull(motion, edit);
          QVERIFY(std::isfinite(result.remainder));
          validate(result.motion);
          // The copies agree along the axis alone.
          const Vec3 way = point(result.motion.trajectory, 0.5 * range) - point(motion.trajectory, 0.5 * range);
          QVERIFY2((way - Vec3(0, 0, 2)).norm() < 1e-12, qPrintable(QString::number(way.z())));
        }
  }

  void whatIsBeyondAllNumbersIsRefusedWithItsPlace() {
    const Motion motion = primitiveMotion({.radius = 10, .height = 40}).motion;
    for (const PullWeights& weights : {PullWeights{1, 0, 0}, PullWeights{0, 0, 1}}) {
      try {
        (void)pull(motion, {{{0.25, 0.5}}, {{1e200, 0, 0}}, weights});
        QFAIL("pulled");
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::Degenerate);
        QVERIFY2(error.message().starts_with("At u = 0.25, v = 0.5, "), error.what());
      }
    }
  }
};

BLOSSOM_TEST(SweepLeastChangeTest)
#include "sweep_least_change_test.moc"
