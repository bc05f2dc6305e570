#include <Eigen/Geometry>
#include <numbers>

#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "support/motion_sizes.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

Motion readMotionOf(const char* name) {
  return *motionFormat().read(sample(name), Value::object(), Progress::none()).shape.get<Motion>();
}

/// Full knots over one period, the same in each of `parts`.
std::vector<double> repeatedPeriod(Random& random, int parts, int rowsPerPart) {
  std::vector<double> steps, knots{0};
  for (int i = 0; i < rowsPerPart; ++i) steps.push_back(uniform(random, 0.5, 1.5));
  double sum = 0;
  for (const double step : steps) sum += step;
  for (int k = 0; k < parts; ++k) {
    double at = 0;
    for (int i = 0; i < rowsPerPart; ++i) at += steps[static_cast<std::size_t>(i)], knots.push_back((k + at / sum) / parts);
  }
  knots.back() = 1;
  return knots;
}

/// A motion of random rows that are the same, turned about `axis`, in each n-th of the period.
Motion foldedMotion(Random& random, int fold, const Vec3& axis, int rowsPerPart) {
  Motion motion = randomMotion(random, ClosedU::AntiPeriodic);
  const auto surface = [&](const Surface& like, double sign, auto pole) {
    const std::size_t columns = like.countV();
    std::vector<Vec4> first, poles;
    for (std::size_t k = 0; k < static_cast<std::size_t>(rowsPerPart) * columns; ++k)
      first.push_back(pole(static_cast<double>(k / columns) / rowsPerPart, 0));
    for (int part = 0; part < fold; ++part)
      for (const Vec4& each : first)
        poles.push_back(sign < 0 ? times(rotationAbout(axis, 2 * pi * part / fold), each) : each);
    const int degree = uniformInt(random, 1, 3);
    return unwrapped(degree, like.degreeV, repeatedPeriod(random, fold, rowsPerPart), like.knotsV, poles, sign);
  };
  const Vec4 lean = randomQuaternion(random, uniform(random, 0, 3));
  motion.orientation = surface(motion.orientation, -1, [&](double along, int) {
    return times(times(rotationAbout(axis, 2 * pi * along / fold), lean), randomQuaternion(random, 0));
  });
  motion.scaling = surface(motion.scaling, 1, [&](double, int) { return randomScale(random); });
  validate(motion);
  return motion;
}

Vec3 anyVector(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

/// The largest distance of x(place(u), v) - t from the copy of x(u, v) - t, as a share of the poles' size.
template <class Place>
double asymmetry(Random& random, const Motion& motion, const Eigen::Matrix3d& turn, Place place, double v0 = -1) {
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const double u = randomIn(random, motion.domainU()), v = v0 < 0 ? randomIn(random, motion.domainV()) : v0;
    if (evaluate(motion.orientation, u, v).norm() < 0.05) continue;
    const Vec3 centre = blossom::point(motion.trajectory, v);
    const Vec3 copy = centre + turn * (evaluate(motion, u, v).point - centre);
    worst = std::max(worst, (evaluate(motion, place(u), v).point - copy).norm() / sizeOfPoles(motion, u, v));
  }
  return worst;
}

}  // namespace

class SweepSymmetryTest : public QObject {
  Q_OBJECT

 private slots:
  void foldedEditsStayFolded() {
    auto random = seededRandom();
    double worst = 0, off = 0;
    int arrived = 0;
    for (int k = 0; k < 300; ++k) {
      const int fold = uniformInt(random, 2, 7);
      const Vec3 axis = anyVector(random, 1).normalized();
      const Motion motion = foldedMotion(random, fold, axis, uniformInt(random, 1, 4));
      const MotionPlace at{randomIn(random, motion.domainU()), randomIn(random, motion.domainV())};
      if (evaluate(motion.orientation, at.u, at.v).norm() < 0.1) continue;
      MotionPull edit{{at}, {anyVector(random, 20)}, {k % 2 == 0 ? 0.5 : 0, 1, 1}};
      edit.symmetry.fold = fold;
      const EditResult pulled = pull(motion, edit);
      const MotionTwist turn{{at}, anyVector(random, 1), uniform(random, -90, 90), {}, {fold, false}};
      const EditResult twisted = twist(pulled.motion, turn);
      const Eigen::Matrix3d step = Eigen::AngleAxisd(2 * pi / fold, axis).toRotationMatrix();
      const auto next = [&](double u) { return u + 1.0 / fold < 1 ? u + 1.0 / fold : u + 1.0 / fold - 1; };
      for (const Motion* each : {&pulled.motion, &twisted.motion})
        worst = std::max(worst, asymmetry(random, *each, step, next));
      if (!pulled.obstacles.empty()) continue;
      ++arrived;
      Vec3 to = edit.to[0];
      const Vec3 centre = blossom::point(motion.trajectory, at.v);
      for (int i = 0; i < fold; ++i) {
        const double u = std::fmod(at.u + i / static_cast<double>(fold), 1);
        off = std::max(off, (evaluate(pulled.motion, u, at.v).point - to).norm() / sizeOfPoles(pulled.motion, u, at.v));
        to = centre + step * (to - centre);
      }
    }
    std::printf("figure fold_asymmetry %.3g\nfigure fold_miss_share %.3g\nfigure folds_arrived %d\n", worst, off, arrived);
    QVERIFY(arrived > 200);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
    QVERIFY2(off <= 1e-12, qPrintable(QString::number(off)));
  }

  void onePullMakesFourBlades() {
    const Motion motion = readMotionOf("cylinder.json");
    MotionPull edit{{{0.125, 0.5}}, {{30, 30, 20}}};
    edit.symmetry.fold = 4;
    const EditResult blades = pull(motion, edit);
    QVERIFY(blades.obstacles.empty());
    for (int k = 0; k < 4; ++k) {
      const double angle = pi / 4 + k * pi / 2, radius = std::hypot(30, 30);
      const Vec3 wanted(radius * std::cos(angle), radius * std::sin(angle), 20);
      QVERIFY((evaluate(blades.motion, 0.125 + 0.25 * k, 0.5).point - wanted).norm() < 1e-12 * radius);
    }
    // Each blade is then turned about its own spoke, which its tip lies on.
    const EditResult turned = twist(blades.motion, {edit.at, Vec3(1, 1, 0), 40, {}, {4, false}});
    QVERIFY(turned.obstacles.empty());
    for (int k = 0; k < 4; ++k)
      QVERIFY((evaluate(turned.motion, 0.125 + 0.25 * k, 0.5).point - evaluate(blades.motion, 0.125 + 0.25 * k, 0.5).point)
                  .norm() < 1e-12 * 43);
    auto random = seededRandom();
    const Eigen::Matrix3d quarter = Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()).toRotationMatrix();
    QVERIFY(asymmetry(random, turned.motion, quarter, [](double u) { return std::fmod(u + 0.25, 1); }) < 1e-12);
    // A trajectory is shared by the blades: it goes along the axis alone.
    edit.weights = {0.5, 1, 1}, edit.to = {{30, 30, 24}};
    const Motion raised = pull(motion, edit).motion;
    QVERIFY((blossom::point(raised.trajectory, 0.5) - Vec3(0, 0, 22)).norm() < 1e-13 * 40);
    QVERIFY((evaluate(raised, 0.125, 0.5).point - Vec3(30, 30, 24)).norm() < 1e-12 * 40);
  }

  void bentMotionsTakeTheAxisOfTheSection() {
    // Three lobes along a bend: the axis of the section v is the tangent of the bend there.
    const Motion motion = readMotionOf("twisted-tube.json");
    auto random = seededRandom();
    for (int k = 0; k < 50; ++k) {
      const double v = randomIn(random, motion.domainV());
      MotionPull edit{{{randomIn(random, motion.domainU()), v}}, {}};
      const Vec3 centre = blossom::point(motion.trajectory, v);
      edit.to = {centre + anyVector(random, 15)};
      edit.symmetry.fold = 3;
      const EditResult result = pull(motion, edit);
      QVERIFY(result.obstacles.empty());
      // x(u) - t turns by a third about the same axis for each u of the motion given.
      const Vec3 a = evaluate(motion, 0.1, v).point - centre, b = evaluate(motion, 0.1 + 1 / 3.0, v).point - centre,
                 c = evaluate(motion, 0.1 + 2 / 3.0, v).point - centre;
      const Vec3 axis = (b - a).cross(c - b).normalized();
      const Eigen::Matrix3d third = Eigen::AngleAxisd(2 * pi / 3, axis).toRotationMatrix();
      for (int i = 0; i < 3; ++i) {
        const double u = std::fmod(edit.at[0].u + i / 3.0, 1);
        const Vec3 wanted = centre + (i == 0   ? Eigen::Matrix3d::Identity()
                                      : i == 1 ? third
                                               : Eigen::Matrix3d(third * third)) *
                                         (edit.to[0] - centre);
        QVERIFY((evaluate(result.motion, u, v).point - wanted).norm() < 1e-12 * 60);
      }
    }
  }

  void mirroredEditsStayMirrored() {
    auto random = seededRandom();
    const Motion cylinder = readMotionOf("cylinder.json");
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
      // The cylinder leaned over, then edited at random places by mirrored edits, one after another; some of them fourfold.
      Motion motion = cylinder;
      const Vec4 lean = randomQuaternion(random, uniform(random, 0, 3)).normalized();
      for (Vec4& pole : motion.orientation.poles) pole = times(lean, pole);
      const Eigen::Matrix3d leaned = Eigen::Quaterniond(lean[0], lean[1], lean[2], lean[3]).toRotationMatrix();
      const Vec3 normal = leaned * Vec3::UnitY();
      const Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose();
      const int fold = k % 2 == 0 ? 1 : 4;
      for (int i = 0; i < 3; ++i) {
        const MotionPlace at{uniform(random, 0.02, 0.1), randomIn(random, motion.domainV())};
        const Vec3 target = blossom::point(motion.trajectory, at.v) + leaned * (Vec3(15, 8, 0) + anyVector(random, 4));
        MotionPull edit{{at}, {target}, {i == 1 ? 0.3 : 0, 1, 1}};
        edit.symmetry = {fold, true};
        motion = pull(motion, edit).motion;
        motion = twist(motion, {{at}, anyVector(random, 1), uniform(random, -20, 20), {}, {fold, true}}).motion;
      }
      worst = std::max(worst, asymmetry(random, motion, mirror, [](double u) { return 1 - u; }));
      const Eigen::Matrix3d quarter = leaned * Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()) * leaned.transpose();
      if (fold == 4)
        worst = std::max(worst, asymmetry(random, motion, quarter, [](double u) { return std::fmod(u + 0.25, 1); }));
    }
    std::printf("figure mirror_asymmetry %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void openMotionsAreMirroredOverTheirMiddle() {
    // A ribbon from x = -5 to 5, made by a scaling that changes its sign.
    Motion motion;
    motion.point = Vec3(1, 0, 1);
    motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 20, 1)}};
    motion.orientation = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 0, 0, 0))};
    motion.scaling = {3, 3, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, {}};
    for (const double x : {-5.0, -2.0, 2.0, 5.0})
      for (int j = 0; j < 4; ++j) motion.scaling.poles.emplace_back(x, 1, 1, 1);
    validate(motion);
    const EditResult result = pull(motion, {{{0.2, 0.4}}, {{-4, 0, 11}}, {0, 0, 1}, Vec3::Zero(), {}, {1, true}});
    QVERIFY(result.obstacles.empty());
    QVERIFY((evaluate(result.motion, 0.8, 0.4).point - Vec3(4, 0, 11)).norm() < 1e-12 * 20);
    // On the mirror itself, only within it.
    const EditResult stuck = pull(motion, {{{0.5, 0.4}}, {{1, 0, 11}}, {0, 0, 1}, Vec3::Zero(), {}, {1, true}});
    QVERIFY(!stuck.obstacles.empty() && stuck.obstacles[0].why == Unreached::Symmetry);
    COMPARE_NEAR(stuck.remainder, 1, 1e-12);
  }

  void whatRowsDoNotAllowIsRefused() {
    const auto refusal = [](const Motion& motion, const EditSymmetry& symmetry, const char* words) {
      MotionPull edit{{{0.1, 0.5}}, {{20, 3, 20}}};
      edit.symmetry = symmetry;
      try {
        (void)pull(motion, edit);
      } catch (const Error& error) {
        QVERIFY2(error.code() == ErrorCode::InvalidInput || error.code() == ErrorCode::InvalidParameter, error.what());
        QVERIFY2(error.message().find(words) != std::string::npos, error.what());
        QVERIFY(error.code() == ErrorCode::InvalidParameter || !error.hint().empty());
        return;
      }
      QFAIL(words);
    };
    const Motion cylinder = readMotionOf("cylinder.json");
    refusal(readMotionOf("helicoid.json"), {4, false}, "closed in u");
    refusal(cylinder, {3, false}, "8 rows");
    refusal(cylinder, {0, false}, "between 1 and 360");
    Motion uneven = cylinder;
    uneven.orientation =
        unwrapped(3, 3, {0, 0.1, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1}, uneven.orientation.knotsV,
                  {uneven.orientation.poles.begin(),
                   uneven.orientation.poles.begin() + 8 * static_cast<std::ptrdiff_t>(uneven.orientation.countV())},
                  -1);
    refusal(uneven, {4, false}, "do not come back");
    refusal(uneven, {1, true}, "read backwards");
    Motion lopsided = pull(cylinder, {{{0.3, 0.5}}, {{0, 20, 25}}}).motion;
    refusal(lopsided, {4, false}, "not 4-fold");
    refusal(lopsided, {1, true}, "mirror image");
    Motion still = cylinder;
    still.closedU = ClosedU::Periodic;
    std::fill(still.orientation.poles.begin(), still.orientation.poles.end(), Vec4(1, 0, 0, 0));
    refusal(still, {4, false}, "turned as before");
  }
};

QTEST_GUILESS_MAIN(SweepSymmetryTest)
#include "sweep_symmetry_test.moc"
