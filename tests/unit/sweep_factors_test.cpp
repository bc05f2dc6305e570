#include <Eigen/Geometry>

#include "geometry/bspline/bspline.h"
#include "support/modeling.h"
#include "support/motions.h"
#include "support/support.h"
#include "support/sweep_formulas.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/factor_changes.h"
#include "sweep/kernel/grid/factor_comb.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/manipulators/motion_lines.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

Vec3 randomVector(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

std::size_t randomIndex(Random& random, std::size_t count) {
  return static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(count) - 1));
}

std::size_t periodOf(const Motion& motion, const Surface& factor) {
  return factor.countU() - (motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(factor.degreeU));
}

FactorPole randomPoleOf(Random& random, const Motion& motion, const Surface& factor) {
  return {randomIndex(random, periodOf(motion, factor)), randomIndex(random, factor.countV())};
}

/// Small turns, so that no quaternion comes to vanish.
FactorChanges randomChanges(Random& random, const Motion& motion, bool absolute) {
  FactorChanges changes;
  const auto is = [&] { return absolute && uniformInt(random, 0, 1) == 1; };
  for (int k = uniformInt(random, 0, 3); k > 0; --k)
    changes.trajectory.push_back({randomIndex(random, motion.trajectory.poles.size()), is(), randomVector(random, 9)});
  for (int k = uniformInt(random, 0, 3); k > 0; --k)
    changes.weights.push_back({randomIndex(random, motion.trajectory.poles.size()), uniform(random, 0.2, 4)});
  for (int k = uniformInt(random, 0, 3); k > 0; --k)
    changes.orientation.push_back(
        {randomPoleOf(random, motion, motion.orientation), false, randomVector(random, 1), uniform(random, -15, 15)});
  for (int k = uniformInt(random, 0, 3); k > 0; --k)
    changes.scaling.push_back(
        {randomPoleOf(random, motion, motion.scaling), is(), randomVector(random, 3), uniform(random, 0.2, 4)});
  return changes;
}

/// Every pole with its repetitions.
template <class Change>
void changePole(const Motion& motion, Surface& factor, const FactorPole& at, double closure, const Change& change) {
  const Vec4 now = change(factor.pole(at.row, at.column));
  double sign = 1;
  for (std::size_t i = at.row; i < factor.countU(); i += periodOf(motion, factor), sign *= closure)
    factor.pole(i, at.column) = sign * now;
}

/// What the changes say, with Eigen's rotations.
Motion changedByFormula(Motion motion, const FactorChanges& changes) {
  for (const TrajectoryMove& each : changes.trajectory) {
    Vec4& pole = motion.trajectory.poles[each.pole];
    const Vec3 at = each.absolute ? each.vector : Vec3(pole.head<3>() / pole[3] + each.vector);
    pole.head<3>() = pole[3] * at;
  }
  for (const TrajectoryWeight& each : changes.weights) {
    Vec4& pole = motion.trajectory.poles[each.pole];
    pole *= each.weight / pole[3];
  }
  const double turn = motion.closedU == ClosedU::AntiPeriodic ? -1 : 1;
  for (const OrientationTurn& each : changes.orientation)
    changePole(motion, motion.orientation, each.pole, turn, [&](const Vec4& q) {
      const Eigen::Quaterniond dq(Eigen::AngleAxisd(each.angle * std::numbers::pi / 180, each.axis.normalized()));
      const Eigen::Quaterniond now = dq * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
      return Vec4(now.w(), now.x(), now.y(), now.z());
    });
  for (const ScalingChange& each : changes.scaling)
    changePole(motion, motion.scaling, each.pole, 1, [&](const Vec4& s) {
      const Vec3 factors = s.head<3>() / s[3], now = each.absolute ? each.factors : Vec3(factors.cwiseProduct(each.factors));
      const double weight = s[3] * each.weight;
      return Vec4(weight * now.x(), weight * now.y(), weight * now.z(), weight);
    });
  return motion;
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.message();
  }
  return "no error";
}

/// The rotation matrix at a place.
Eigen::Matrix3d frameAt(const Motion& motion, double u, double v) {
  const Vec4 r = blossom::evaluate(motion.orientation, u, v);
  return Eigen::Quaterniond(r[0], r[1], r[2], r[3]).normalized().toRotationMatrix();
}

}  // namespace

class SweepFactorsTest : public QObject {
  Q_OBJECT
 private slots:
  void polesChangeByTheFormulas() {
    auto random = seededRandom();
    double worst = 0;
    int vanished = 0;
    for (int k = 0; k < 400; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const FactorChanges changes = randomChanges(random, motion, true);
      FactorChangeResult result;
      try {
        result = withChangedFactors(motion, changes);
      } catch (const Error& error) {
        QVERIFY2(error.code() == ErrorCode::Degenerate, error.what());
        ++vanished;
        continue;
      }
      validate(result.motion);
      const Motion wanted = changedByFormula(motion, changes);
      worst = std::max(worst, poleDifference(wanted, result.motion));
      // What no change names stays to the last bit, and is not counted.
      std::size_t other = 0;
      const auto count = [&](const std::vector<Vec4>& a, const std::vector<Vec4>& b, std::size_t most) {
        for (std::size_t i = 0; i < most; ++i) other += a[i] != b[i] ? 1 : 0;
      };
      const Motion& now = result.motion;
      count(motion.trajectory.poles, now.trajectory.poles, now.trajectory.poles.size());
      count(motion.orientation.poles, now.orientation.poles, periodOf(now, now.orientation) * now.orientation.countV());
      count(motion.scaling.poles, now.scaling.poles, periodOf(now, now.scaling) * now.scaling.countV());
      QCOMPARE(result.changedPoles, other);
      QVERIFY(other <=
              changes.trajectory.size() + changes.weights.size() + changes.orientation.size() + changes.scaling.size());
    }
    QVERIFY(vanished < 100);
    std::printf("figure factors_pole_difference %.3g\n", worst);
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  void onlyTheSupportOfAPoleChanges() {
    auto random = seededRandom();
    int changed = 0, unreached = 0;
    for (int k = 0; k < 60; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), true);
      const FactorPole pole = randomPoleOf(random, motion, motion.scaling);
      const Motion now = withChangedFactors(motion, {.scaling = {{pole, false, {2, 2, 2}, 1}}}).motion;
      const Surface& s = motion.scaling;
      for (int i = 0; i < 60; ++i) {
        const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
        const double closure = motion.closedU == ClosedU::No ? 0 : 1;
        const Eigen::MatrixXd row = surfaceRow(s, u, v, closure);
        const bool reached = row(static_cast<Eigen::Index>(pole.row), static_cast<Eigen::Index>(pole.column)) != 0;
        const bool same = evaluate(motion, u, v).point == evaluate(now, u, v).point;
        QVERIFY(reached || same);
        changed += same ? 0 : 1;
        unreached += reached ? 0 : 1;
      }
    }
    QVERIFY(changed > 0 && unreached > 0);
  }

  void anAbsoluteTurnKeepsLengthAndSide() {
    auto random = seededRandom();
    for (int k = 0; k < 100; ++k) {
      const Motion motion = randomMotion(random, ClosedU::No);
      const FactorPole pole = randomPoleOf(random, motion, motion.orientation);
      const Vec4 before = motion.orientation.pole(pole.row, pole.column);
      // Near the rotation it has, so that nothing vanishes on the way.
      const Eigen::Quaterniond q = Eigen::Quaterniond(before[0], before[1], before[2], before[3]).normalized() *
                                   Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vec3::UnitX()));
      const Eigen::AngleAxisd turn(q);
      const OrientationTurn change{pole, true, turn.axis(), turn.angle() * 180 / std::numbers::pi};
      const Vec4 now = withChangedFactors(motion, {.orientation = {change}}).motion.orientation.pole(pole.row, pole.column);
      COMPARE_NEAR(now.norm(), before.norm(), 1e-14);
      QVERIFY(now.dot(before) > 0);
      const Eigen::Quaterniond is(now[0], now[1], now[2], now[3]);
      QVERIFY(is.normalized().angularDistance(q) < 1e-7);
    }
  }

  void twoListsAreOne() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), true);
      const FactorChanges first = randomChanges(random, motion, true), second = randomChanges(random, motion, true);
      try {
        const Motion twice = withChangedFactors(withChangedFactors(motion, first).motion, second).motion;
        const FactorChanges joined = followedBy(first, second);
        worst = std::max(worst, poleDifference(twice, withChangedFactors(motion, joined).motion));
      } catch (const Error& error) {
        QVERIFY2(error.code() == ErrorCode::Degenerate, error.what());
      }
    }
    QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));

    // One pole, dragged twice: one change.
    const FactorPole pole{1, 2};
    const FactorChanges moved = followedBy({.trajectory = {{3, true, {1, 2, 3}}}}, {.trajectory = {{3, false, {1, 0, 0}}}});
    QVERIFY(moved == (FactorChanges{.trajectory = {{3, true, {2, 2, 3}}}}));
    const FactorChanges scaled =
        followedBy({.scaling = {{pole, false, {2, 1, 1}, 2}}}, {.scaling = {{pole, false, {1, 3, 1}, 2}}});
    QVERIFY(scaled == (FactorChanges{.scaling = {{pole, false, {2, 3, 1}, 4}}}));
    const FactorChanges turned =
        followedBy({.orientation = {{pole, false, {0, 0, 2}, 20}}}, {.orientation = {{pole, false, {0, 0, 1}, 30}}});
    QCOMPARE(turned.orientation.size(), std::size_t(1));
    COMPARE_NEAR(turned.orientation.front().angle, 50, 1e-12);
    // Of a turn that was set, the sign is not known: what follows stands beside it.
    const FactorChanges set =
        followedBy({.orientation = {{pole, true, {0, 0, 1}, 20}}}, {.orientation = {{pole, false, {0, 0, 1}, 30}}});
    QCOMPARE(set.orientation.size(), std::size_t(2));
  }

  void whatCannotBeIsRefusedWithItsPlace() {
    const Motion motion = primitiveMotion({}).motion;
    const double nan = std::nan("");
    const auto refused = [&](const FactorChanges& changes, const char* place) {
      const std::string message = messageOf([&] { (void)withChangedFactors(motion, changes); });
      QVERIFY2(message.find(place) != std::string::npos, message.c_str());
      VERIFY_ERROR(withChangedFactors(motion, changes), ErrorCode::InvalidParameter);
    };
    const std::size_t poles = motion.trajectory.poles.size(), rows = freeRows(motion, motion.scaling);
    refused({.trajectory = {{0, false, {1, 0, 0}}, {poles, false, {1, 0, 0}}}}, "trajectory[1], pole ");
    refused({.trajectory = {{0, false, {nan, 0, 0}}}}, "trajectory[0], pole 0");
    refused({.weights = {{1, 0}}}, "weights[0], pole 1: its weight would be 0");
    refused({.weights = {{1, -2}}}, "weights[0]");
    refused({.weights = {{1, nan}}}, "weights[0]");
    refused({.weights = {{1, 1e10}}}, "weights[0], pole 1: a number is beyond 1e9");
    refused({.trajectory = {{0, false, {0, -2e9, 0}}}}, "trajectory[0], pole 0: a number is beyond 1e9");
    refused({.scaling = {{{0, 0}, true, {1, -1e12, 1}, 1}}}, "scaling[0], pole (0, 0): a number is beyond 1e9");
    refused({.orientation = {{{0, 99}, false, {0, 0, 1}, 5}}}, "orientation[0], pole (0, 99)");
    refused({.orientation = {{{rows, 0}, false, {0, 0, 1}, 5}}}, "orientation[0]");
    refused({.orientation = {{{0, 0}, false, {0, 0, 0}, 5}}}, "its axis has no length");
    refused({.orientation = {{{0, 0}, false, {0, 0, 1}, 361}}}, "360 degrees");
    refused({.scaling = {{{0, 0}, false, {1, 1, 1}, 1}, {{1, 1}, false, {1, 1, 1}, 0}}}, "scaling[1], pole (1, 1)");
    refused({.scaling = {{{rows, 0}, false, {1, 1, 1}, 1}}}, "scaling[0]");
    refused({.scaling = {{{0, 0}, true, {1, nan, 1}, 1}}}, "scaling[0]");
    QVERIFY(withChangedFactors(motion, {}).motion == motion);
  }

  /// A full turn of one of two neighbours takes the straight line between them through zero.
  void anOrientationThatVanishesIsRefusedWithItsPlace() {
    Motion motion = primitiveMotion({.kind = PrimitiveKind::Plane}).motion;
    Surface& r = motion.orientation;
    r = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}}};
    const std::string message = messageOf([&] {
      (void)withChangedFactors(motion, {.orientation = {{{1, 1}, false, {0, 0, 1}, 360}}});
    });
    QVERIFY2(message.find("u = ") != std::string::npos && message.find("v = ") != std::string::npos, message.c_str());
    VERIFY_ERROR(withChangedFactors(motion, {.orientation = {{{1, 1}, false, {0, 0, 1}, 360}}}), ErrorCode::Degenerate);
    (void)withChangedFactors(motion, {.orientation = {{{1, 1}, false, {0, 0, 1}, 100}}});
  }

  void theFeatureReadsItsLists() {
    const Motion motion = primitiveMotion({}).motion;
    const Value parameters = Value::parse(R"({
      "trajectory": [{"pole": 1, "vector": [8, 0, 1]}, {"pole": 2, "how": "place", "vector": [1, 2, 30]}],
      "weights": [{"pole": 1, "weight": 2}],
      "orientation": [{"row": 2, "column": 1, "axis": [1, 1, 0], "angle": 20}],
      "scaling": [{"row": 2, "column": 3, "factors": [2, 2, 1]}, {"row": 3, "column": 3, "how": "set", "weight": 3}]})");
    const Evaluated out = made("sweep.factors", parameters, {motion});
    const FactorChanges changes{{{1, false, {8, 0, 1}}, {2, true, {1, 2, 30}}},
                                {{1, 2}},
                                {{{2, 1}, false, {1, 1, 0}, 20}},
                                {{{2, 3}, false, {2, 2, 1}, 1}, {{3, 3}, true, {1, 1, 1}, 3}}};
    QVERIFY(*out.shape.get<Motion>() == withChangedFactors(motion, changes).motion);
    QVERIFY(out.warnings.empty());
    QCOMPARE(out.stats.at("moved_poles").get<int>(), 5);
    const Evaluated nothing = made("sweep.factors", Value::object(), {motion});
    QVERIFY(*nothing.shape.get<Motion>() == motion && nothing.warnings.size() == 1);
    const std::string message = messageOf(
        [&] { (void)made("sweep.factors", Value::parse(R"({"scaling": [{"row": 500, "column": 0}]})"), {motion}); });
    QVERIFY2(message.find("scaling[0], pole (500, 0)") != std::string::npos, message.c_str());
  }

  /// A quarter of a circle with radius 7 as a rational parabola.
  void theCombOfACircleIsItsCurvature() {
    Motion motion = primitiveMotion({}).motion;
    const double w = std::sqrt(0.5), radius = 7;
    motion.trajectory = {2, {0, 0, 0, 1, 1, 1}, {{radius, 0, 5, 1}, {w * radius, w * radius, 5 * w, w}, {0, radius, 5, 1}}};
    const TrajectoryComb comb = trajectoryComb(motion, 33);
    for (std::size_t k = 0; k < comb.at.size(); ++k) {
      const Vec3 toCentre = Vec3(0, 0, 5) - comb.point[k];
      COMPARE_NEAR(toCentre.norm(), radius, 1e-13);
      QVERIFY((comb.curvature[k] - toCentre / (radius * radius)).norm() < 1e-13);
    }
    VERIFY_ERROR(trajectoryComb(motion, 1), ErrorCode::InvalidParameter);
  }

  void combsAreTheDerivativesOfTheFactors() {
    auto random = seededRandom();
    constexpr std::size_t samples = 9;
    constexpr double h = 1e-4;
    for (int k = 0; k < 40; ++k) {
      Motion motion = randomMotion(random, ClosedU::No);
      // One span of degree 3 in each direction: differences do not meet knots.
      for (Surface* factor : {&motion.orientation, &motion.scaling}) {
        std::vector<Vec4> poles;
        for (int i = 0; i < 16; ++i)
          poles.push_back(factor == &motion.orientation ? randomQuaternion(random, 0.1 * i) : randomScale(random));
        *factor = {3, 3, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, poles};
      }
      const CombAlong along = k % 2 == 0 ? CombAlong::U : CombAlong::V;
      const double across = uniform(random, 0.1, 0.9);
      const auto scale = [&](double t) {
        const Vec4 s = along == CombAlong::U ? blossom::evaluate(motion.scaling, t, across)
                                             : blossom::evaluate(motion.scaling, across, t);
        return Vec3(s.head<3>() / s[3]);
      };
      const auto frame = [&](double t) {
        return along == CombAlong::U ? frameAt(motion, t, across) : frameAt(motion, across, t);
      };
      const ScalingComb scaling = scalingComb(motion, along, across, samples);
      const OrientationComb orientation = orientationComb(motion, along, across, samples);
      for (std::size_t i = 1; i + 1 < samples; ++i) {
        const double t = scaling.at[i];
        QVERIFY((scaling.factors[i] - scale(t)).norm() < 1e-13);
        const Vec3 first = (scale(t + h) - scale(t - h)) / (2 * h);
        const Vec3 second = (scale(t + h) - 2 * scale(t) + scale(t - h)) / (h * h);
        for (int c = 0; c < 3; ++c)
          COMPARE_NEAR(scaling.curvature[i][c], second[c] / std::pow(1 + first[c] * first[c], 1.5), 1e-3);
        // R' R^T is the cross product with the angular velocity.
        const Eigen::Matrix3d spin = (frame(t + h) - frame(t - h)) / (2 * h) * frame(t).transpose();
        const Vec3 velocity(spin(2, 1), spin(0, 2), spin(1, 0));
        QVERIFY2((orientation.velocity[i] - velocity).norm() < 1e-4 * (1 + velocity.norm()),
                 qPrintable(QString::number((orientation.velocity[i] - velocity).norm())));
      }
    }
  }

  /// Around a cylinder the frame makes one full turn about its axis.
  void aCylinderTurnsOnce() {
    const Motion motion = primitiveMotion({}).motion;
    constexpr std::size_t samples = 2001;
    const OrientationComb comb = orientationComb(motion, CombAlong::U, 0.5, samples);
    double turned = 0;
    for (std::size_t k = 0; k + 1 < samples; ++k) turned += comb.velocity[k].z() / (samples - 1);
    COMPARE_NEAR(std::abs(turned), 2 * std::numbers::pi, 1e-6);
    for (const Vec3& velocity : comb.velocity) QVERIFY(velocity.head<2>().norm() < 1e-12);
  }

  void framesStandOnTheSurface() {
    auto random = seededRandom();
    const Motion motion = randomMotion(random, ClosedU::No);
    constexpr std::size_t countU = 4, countV = 3;
    const std::array<Polylines, 3> axes = frameLines(motion, countU, countV, 2);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      QCOMPARE(axes[k].size(), countU * countV);
      for (std::size_t n = 0; n < axes[k].size(); ++n) {
        const double u = static_cast<double>(n / countV) / (countU - 1), v = static_cast<double>(n % countV) / (countV - 1);
        const Vec3 from = axes[k][n].front(), arm = axes[k][n].back() - from;
        QVERIFY((from - evaluate(motion, u, v).point).norm() < 1e-12);
        QVERIFY(arm.normalized().cross(frameAt(motion, u, v).col(static_cast<Eigen::Index>(k))).norm() < 1e-12);
        longest = std::max(longest, arm.norm());
      }
    }
    COMPARE_NEAR(longest, 2, 1e-12);
  }
};

BLOSSOM_TEST(SweepFactorsTest)
#include "sweep_factors_test.moc"
