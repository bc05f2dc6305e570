#include "geometry/numeric/cubic_slopes.h"

#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<double> randomSteps(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> step(0.1, 3);
  std::vector<double> steps(count);
  for (double& h : steps) h = step(random);
  return steps;
}

NumberRows randomRows(std::mt19937_64& random, Eigen::Index rows) {
  std::uniform_real_distribution<double> value(-5, 5);
  return NumberRows::NullaryExpr(rows, 4, [&] { return value(random); });
}

/// Second derivative, at one end, of the cubic from one row to another with slopes given.
Eigen::RowVectorXd bending(const NumberRows& f, const NumberRows& m, Eigen::Index i, Eigen::Index k, double h, bool atEnd) {
  const Eigen::RowVectorXd chord = (f.row(k) - f.row(i)) / h;
  if (atEnd) return (4 * m.row(k) + 2 * m.row(i) - 6 * chord) / h;
  return (6 * chord - 4 * m.row(i) - 2 * m.row(k)) / h;
}

}  // namespace

class CubicSlopesTest : public QObject {
  Q_OBJECT

 private slots:
  void theSecondDerivativeIsContinuousAndTheEndsAreAsAsked() {
    auto random = seededRandom();
    for (const std::size_t steps : {1, 2, 3, 40}) {
      const auto h = randomSteps(random, steps);
      const auto last = static_cast<Eigen::Index>(steps);
      const NumberRows f = randomRows(random, last + 1);
      const Eigen::RowVectorXd tangent = randomRows(random, 1);
      for (const bool natural : {true, false}) {
        const NumberRows m = natural ? cubicSlopes(h, f) : cubicSlopes(h, f, tangent, Eigen::RowVectorXd(2 * tangent));
        QCOMPARE(m.rows(), f.rows());
        for (Eigen::Index i = 1; i < last; ++i) {
          const auto k = static_cast<std::size_t>(i);
          COMPARE_NEAR((bending(f, m, i - 1, i, h[k - 1], true) - bending(f, m, i, i + 1, h[k], false)).norm(), 0, 1e-9);
        }
        const Eigen::RowVectorXd first = natural ? bending(f, m, 0, 1, h[0], false) : Eigen::RowVectorXd(m.row(0) - tangent);
        const Eigen::RowVectorXd second =
            natural ? bending(f, m, last - 1, last, h.back(), true) : Eigen::RowVectorXd(m.row(last) - 2 * tangent);
        COMPARE_NEAR(first.norm(), 0, 1e-9);
        COMPARE_NEAR(second.norm(), 0, 1e-9);
      }
    }
  }

  void aClosedFunctionHasNoEnds() {
    auto random = seededRandom();
    for (const std::size_t steps : {2, 3, 4, 40}) {
      const auto h = randomSteps(random, steps);
      const auto rows = static_cast<Eigen::Index>(steps);
      const NumberRows f = randomRows(random, rows), m = periodicCubicSlopes(h, f);
      QCOMPARE(m.rows(), rows);
      for (Eigen::Index i = 0; i < rows; ++i) {
        const Eigen::Index before = (i + rows - 1) % rows, after = (i + 1) % rows;
        COMPARE_NEAR((bending(f, m, before, i, h[static_cast<std::size_t>(before)], true) -
                      bending(f, m, i, after, h[static_cast<std::size_t>(i)], false))
                         .norm(),
                     0, 1e-9);
      }
    }
    QVERIFY(periodicCubicSlopes(std::vector<double>{2.0}, NumberRows::Ones(1, 3)).isZero(0));
  }

  void cubicsComeBackAsTheyAre() {
    const std::vector<double> h{1, 0.5, 2};
    NumberRows f(4, 1), slopes(4, 1);
    double x = -1;
    for (Eigen::Index i = 0; i < 4; ++i) {
      f(i, 0) = x * x * x - 2 * x;
      slopes(i, 0) = 3 * x * x - 2;
      if (i < 3) x += h[static_cast<std::size_t>(i)];
    }
    const NumberRows m = cubicSlopes(h, f, slopes.row(0), slopes.row(3));
    COMPARE_NEAR((m - slopes).norm(), 0, 1e-12);
  }

  /// Steps far below the rounding of their sum.
  void tinyStepsStayFinite() {
    QVERIFY(
        cubicSlopes(std::vector<double>{1, 1e-200, 1}, (NumberRows(4, 1) << 0, 1, 1 + 1e-200, 2).finished()).allFinite());
  }
};

BLOSSOM_TEST(CubicSlopesTest)
#include "cubic_slopes_test.moc"
