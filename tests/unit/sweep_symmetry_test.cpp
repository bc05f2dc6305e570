#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "support/support.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

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

  /// A single pull refines one side of the motion; above its reach the sections are what they were.
  void aFineEditElsewhereLeavesTheSymmetry() {
    auto random = seededRandom();
    const Motion plain = primitiveMotion({.radius = 10, .height = 40}).motion;
    MotionPull single{{{0.1, 0.15}}, {{10, 8, 6}}};
    single.level = 2;
    const Motion fine = pull(plain, single).motion;
    QVERIFY(fine.orientation.countU() != plain.orientation.countU());
    double worst = 0, off = 0;
    for (const EditSymmetry& symmetry : {EditSymmetry{4, false}, {3, false}, {1, true}, {4, true}})
      for (const int level : {-1, 0, 1, 2}) {
        const MotionPlace at{uniform(random, 0.03, 0.1), uniform(random, 0.7, 0.9)};
        MotionPull edit{{at}, {evaluate(plain, at.u, at.v).point + anyVector(random, 4)}, {0.4, 1, 1}};
        edit.symmetry = symmetry, edit.level = level;
        const MotionTwist turn{{at}, anyVector(random, 1), uniform(random, -60, 60), {}, symmetry, level};
        const auto edited = [&](const Motion& motion) { return twist(pull(motion, edit).motion, turn).motion; };
        const Motion after = edited(fine), expected = edited(plain);
        for (int i = 0; i < 200; ++i) {
          // The edit adds the same to all factors, fine or not, and so is as symmetric as it would be without the single
          // one.
          const double u = randomIn(random, plain.domainU()), v = randomIn(random, plain.domainV());
          const auto change = [&](Surface Motion::*factor) {
            return Vec4(evaluate(after.*factor, u, v) - evaluate(fine.*factor, u, v) -
                        (evaluate(expected.*factor, u, v) - evaluate(plain.*factor, u, v)));
          };
          worst = std::max({worst, change(&Motion::orientation).norm(), change(&Motion::scaling).norm() / 10});
          // Beyond the reach of the single edit they are the same surface.
          const double above = uniform(random, 0.6, 1);
          off = std::max(off, (evaluate(after, u, above).point - evaluate(expected, u, above).point).norm());
        }
      }
    QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));
    QVERIFY2(off < 1e-10, qPrintable(QString::number(off)));
    // Where the single edit reaches, nothing is fourfold.
    MotionPull there{{{0.1, 0.15}}, {{20, 10, 6}}};
    there.symmetry.fold = 4;
    try {
      (void)pull(fine, there);
      QFAIL("pulled");
    } catch (const Error& error) {
      QVERIFY2(error.message().find("not 4-fold") != std::string::npos, error.what());
    }
  }

  /// Domains whose coordinates are much larger than they are long: rounding of the parameters is no other knot.
  void domainsFarFromZeroAreFolded() {
    for (const auto& [first, length] : {std::pair{1000.0, 1e-3}, {-1e6, 1.0}, {1e5, 1e-3}, {1e6, 1e6}}) {
      Motion motion = primitiveMotion({.radius = 10, .height = 40}).motion;
      for (std::vector<double>* knots : {&motion.orientation.knotsU, &motion.scaling.knotsU})
        for (double& knot : *knots) knot = first + length * knot;
      for (Surface* factor : {&motion.orientation, &motion.scaling}) {
        const std::vector<double> period(factor->knotsU.begin() + factor->degreeU, factor->knotsU.end() - factor->degreeU);
        factor->knotsU = unwrappedKnots(factor->degreeU, period);
      }
      for (const EditSymmetry& symmetry : {EditSymmetry{4, false}, {1, true}}) {
        MotionPull edit{{{first + 0.1 * length, 0.5}}, {{12, 9, 20}}, {0, 1, 1}};
        edit.symmetry = symmetry;
        const EditResult result = pull(motion, edit);
        const double step = 10 * std::numeric_limits<double>::epsilon() * std::abs(first) / length;
        for (int k = 0; k < symmetry.fold; ++k) {
          const Vec3 wanted = Eigen::AngleAxisd(k * pi / 2, Vec3::UnitZ()) * edit.to[0];
          const Vec3 found = evaluate(result.motion, first + (0.1 + 0.25 * k) * length, 0.5).point;
          QVERIFY2((found - wanted).norm() < 1e-11 + 200 * step, qPrintable(QString::number((found - wanted).norm())));
        }
      }
    }
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
};

BLOSSOM_TEST(SweepSymmetryTest)
#include "sweep_symmetry_test.moc"
