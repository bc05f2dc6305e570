/// Weights of swept surfaces: those that quaternions nearly cancel in become larger by more knots, others stay as they are.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/modeling.h"
#include "support/motion_samples.h"
#include "support/support.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"
#include "sweep/kernel/validity.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

constexpr double cylinderRadius = 10, cylinderHeight = 40;

/// A cylinder by two rows of quaternions, the first of which turns by twice this half-angle. With it, |r|^2 has the
/// coefficients 1, cos, 1; over the scaling of degree 1 they become 1, (1 + 2 cos) / 3 twice, and 1.
Motion cylinderInTwoArcs(double half) {
  const std::vector<double> line{0, 0, 1, 1};
  Motion motion;
  motion.closedU = ClosedU::AntiPeriodic;
  motion.point = Vec3::UnitX();
  motion.trajectory = {1, line, {Vec4(0, 0, 0, 1), Vec4(0, 0, cylinderHeight, 1)}};
  const Vec4 turned(std::cos(half), 0, 0, std::sin(half));
  motion.orientation = unwrapped(1, 1, {0, 0.5, 1}, line, {Vec4::UnitX(), Vec4::UnitX(), turned, turned}, -1);
  motion.scaling = unwrapped(1, 1, {0, 0.5, 1}, line, std::vector<Vec4>(4, Vec4(10, 10, 10, 1)), 1);
  return motion;
}

double smallestShareOf(const Surface& surface) {
  double least = 1, largest = 0;
  for (const Vec4& pole : surface.poles) least = std::min(least, pole[3]), largest = std::max(largest, pole[3]);
  return least / largest;
}

}  // namespace

class SweepWeightsTest : public QObject {
  Q_OBJECT
 private slots:
  /// At 120 degrees a coefficient is zero, and what rounding leaves of it may be positive.
  void weightsThatCancelBecomeLargerByKnots() {
    for (const double degrees : {120.0, 119.9999, 119.99, 119.9, 119.5}) {
      const Motion motion = cylinderInTwoArcs(degrees * pi / 180);
      const ProductResult product = productSurface(motion);
      QVERIFY(product.refinements > 0);
      QVERIFY2(smallestShareOf(product.surface) > 0.01, qPrintable(QString::number(degrees)));
      double worst = 0;
      for (int i = 0; i <= 400; ++i)
        for (const double v : {0.0, 0.3, 1.0}) {
          const Vec3 p = point(product.surface, i / 400.0, v);
          worst =
              std::max({worst, std::abs(std::hypot(p.x(), p.y()) - cylinderRadius), std::abs(p.z() - cylinderHeight * v)});
        }
      QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
      const Shape solid = Brep(makeSolid(product.surface).solid);
      COMPARE_NEAR(figure(solid, "volume"), pi * 100 * 40, 1e-6 * pi * 100 * 40);
    }
  }

  /// Short quaternions make small weights, too, without any cancellation: more knots would not help.
  void otherSmallWeightsStayAsTheyAre() {
    for (const double length : {1.0, 0.1, 1e-3, 1e-5}) {
      Motion motion = cylinderInTwoArcs(pi / 2);
      for (std::size_t i = 0; i < motion.orientation.countU(); ++i) motion.orientation.pole(i, 1) *= length;
      const ProductResult product = productSurface(motion);
      QCOMPARE(product.refinements, 0);
      COMPARE_NEAR(smallestShareOf(product.surface), length * length / 3, 1e-9 * length * length);
    }
    for (const char* name : {"cylinder.json", "torus.json", "propeller.json"})
      QCOMPARE(productSurface(readMotionOf(name)).refinements, 0);
  }

  /// What is told of the weights is that of the surface, with the knots that were inserted.
  void theWeightsToldAreThoseOfTheSurface() {
    const Motion motion = cylinderInTwoArcs(120 * pi / 180);
    const ProductResult product = productSurface(motion);
    const SmallestWeight found = smallestWeightOf(product.surface, motion);
    QCOMPARE(found.weight, product.smallestWeight);
    QVERIFY(found.place == evaluate(motion, found.u, found.v).point);
    const Evaluated swept = made("sweep", {}, {motion});
    QCOMPARE(swept.stats["min_weight_at"][0].get<double>(), found.u);
    QCOMPARE(swept.stats["min_weight"].get<double>(), found.weight);
    for (const std::string& warning : swept.warnings)
      QVERIFY2(warning.find("smallest weight") == std::string::npos, warning.c_str());
  }

  /// On the axis of the turn, or where the frame begins, a point sweeps a line; beside it, however thin a tube.
  void whatHasNoAreaIsRefused() {
    Motion motion = readMotionOf("cylinder.json");
    for (const Vec3& p : {Vec3(0, 0, 1), Vec3(0, 0, 0)}) {
      motion.point = p;
      VERIFY_ERROR(made("sweep", {}, {motion}), ErrorCode::Degenerate);
      VERIFY_ERROR(made("sweep", {{"mode", "cubic"}}, {motion}), ErrorCode::Degenerate);
    }
    for (const double x : {1e-3, 1e-7}) {
      motion.point = Vec3(x, 0, 1);
      requireArea(motion);
    }
    for (const char* name : {"torus.json", "helicoid.json", "propeller.json"}) requireArea(readMotionOf(name));
  }
};

BLOSSOM_TEST(SweepWeightsTest)
#include "sweep_weights_test.moc"
