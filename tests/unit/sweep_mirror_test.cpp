#include <Eigen/Geometry>
#include <numbers>

#include "support/support.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

class SweepMirrorTest : public QObject {
  Q_OBJECT

 private slots:
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

BLOSSOM_TEST(SweepMirrorTest)
#include "sweep_mirror_test.moc"
