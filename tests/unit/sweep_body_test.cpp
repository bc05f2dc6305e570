#include <QTemporaryDir>
#include <map>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "geometry/occt/sub_shape.h"
#include "support/command_line.h"
#include "support/modeling.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

Motion hub() { return primitiveMotion({.radius = 10, .height = 40, .rows = 16, .columns = 6}).motion; }
Motion ring() { return primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 8}).motion; }

/// Pulled out to four blades at half its height.
Motion fourBlades() {
  const Motion motion = hub();
  const MotionPlace at{0.125, 0.5};
  const Vec3 to = blossom::point(motion.trajectory, at.v) +
                  1.8 * (evaluate(motion, at.u, at.v).point - blossom::point(motion.trajectory, at.v));
  return pull(motion, {{at}, {to}, {0, 0, 1}, Vec3::Zero(), {}, {4, false}}).motion;
}

/// A ring that is thicker at its seam in v, on one side.
Motion swollenRing() {
  const Motion motion = ring();
  const Vec3 centre = blossom::point(motion.trajectory, 0), at = evaluate(motion, 0.1, 0).point;
  return pull(motion, {{{0.1, 1}}, {centre + 1.5 * (at - centre)}, {0, 0, 1}}).motion;
}

Shape swept(const Motion& motion, const char* mode = "exact") {
  return made("sweep", {{"solid", true}, {"mode", mode}}, {motion}).shape;
}

Shape box(const Vec3& low, const Vec3& size) {
  return made("box", {{"anchor", "corner"},
                      {"position", Value::array({low.x(), low.y(), low.z()})},
                      {"width", size.x()},
                      {"depth", size.y()},
                      {"height", size.z()}})
      .shape;
}

Evaluated combined(const char* operation, const Shape& a, const Shape& b) {
  return made("boolean", {{"operation", operation}}, {a, b});
}

double volumeOfShape(const Shape& shape) { return figure(shape, "volume"); }

/// A flat face whose middle lies at this height.
int flatFaceAt(const Shape& shape, double z) {
  const Brep& brep = *shape.get<Brep>();
  for (int i = 0; i < static_cast<int>(figure(shape, "faces")); ++i) {
    const Bounds all = bounds(Shape(Brep(faceOf(brep, i))));
    if (all.high.z() - all.low.z() < 1e-3 && std::abs(all.low.z() - z) < 1e-3) return i;
  }
  return -1;
}

constexpr double allowed = 1e-6;  // what measuring free-form shapes promises

}  // namespace

/// Solids that motions sweep are solids like others: Booleans, shell and files take them.
class SweepBodyTest : public QObject {
  Q_OBJECT
 private slots:
  /// Four arms pulled out of a hub, and boxes with a face along the seam of its surface: OCCT drops the box, or takes it
  /// for part of the sweep, and finds its result valid. Each operation is right or refused.
  void alongTheSeamNothingIsSilentlyWrong() {
    const Shape hub =
        made("sweep-motion", {{"kind", "cylinder"}, {"radius", 10}, {"height", 36}, {"rows", 16}, {"columns", 14}}, {})
            .shape;
    const Value pull = {{"u", 0.869}, {"v", 0.495}, {"to", {35.31, -38.03, 17.8}}};
    const Shape pulled =
        made("sweep-pull", {{"pulls", Value::array({pull})}, {"scale", 1}, {"rotate", 0}, {"fold", 4}}, {hub}).shape;
    const Shape body = made("sweep", {{"solid", true}}, {pulled}).shape;
    int right = 0;
    for (const Vec3& low : {Vec3(0, 0, 0), Vec3(3, 0, 1)}) {
      const Shape block = box(low, {40, 30, 20});
      std::map<std::string, double> volumes;
      for (const char* operation : {"union", "difference", "intersection"}) try {
          volumes[operation] = volumeOfShape(combined(operation, body, block).shape);
          ++right;
        } catch (const Error& error) {
          QVERIFY2(error.message().find("comes out wrong") != std::string::npos, error.what());
        }
      // By triangles: of the block, the sweep holds between a twelfth and a sixth.
      const double whole = volumeOfShape(body), ofBlock = 40 * 30 * 20;
      for (const auto& [operation, volume] : volumes) {
        const double common = operation == "union"        ? whole + ofBlock - volume
                              : operation == "difference" ? whole - volume
                                                          : volume;
        QVERIFY2(common > ofBlock / 12 && common < ofBlock / 4, (operation + std::to_string(common)).c_str());
      }
    }
    QVERIFY2(right >= 3, std::to_string(right).c_str());
  }

  void halvesOfARing_data() {
    QTest::addColumn<QString>("mode");
    QTest::newRow("exact") << "exact";
    QTest::newRow("cubic") << "cubic";
  }
  /// A plane through the axis, one across it, and one through the seams of the ring.
  void halvesOfARing() {
    QFETCH(QString, mode);
    const Shape solid = swept(ring(), qPrintable(mode));
    const double all = volumeOfShape(solid);
    COMPARE_NEAR(all, 2 * pi * pi * 30 * 64, (mode == "exact" ? allowed : 1e-3) * all);
    const Shape halves[] = {box({-50, -50, 0}, {100, 100, 50}), box({0, -50, -50}, {50, 100, 100}),
                            box({-50, 0, -50}, {100, 50, 100})};
    for (const Shape& half : halves) {
      const Evaluated left = combined("difference", solid, half), kept = combined("intersection", solid, half);
      QVERIFY(isSound(left) && isSound(kept));
      COMPARE_NEAR(volume(left) + volume(kept), all, 2 * allowed * all);
      COMPARE_NEAR(volume(kept), all / 2, (mode == "exact" ? 2 * allowed : 1e-3) * all);
    }
  }

  void aHubIsDrilledAndCut() {
    const Shape solid = swept(hub());
    const double all = pi * 100 * 40;
    const Evaluated square = combined("difference", solid, box({-3, -3, -10}, {6, 6, 60}));
    QVERIFY(isSound(square));
    COMPARE_NEAR(volume(square), all - 36 * 40, allowed * all);
    const Evaluated round = combined("difference", solid, made("cylinder", {{"radius", 4}, {"height", 40}}).shape);
    QVERIFY(isSound(round));
    COMPARE_NEAR(volume(round), all - pi * 16 * 40, allowed * all);
    const Evaluated low = combined("intersection", solid, box({-20, -20, -1}, {40, 40, 14}));
    QVERIFY(isSound(low));
    COMPARE_NEAR(volume(low), pi * 100 * 13, allowed * all);
  }

  void anArmGrowsOnAHub() {
    // Of the arm, what lies inside the circle of radius 10 between y = -3 and 3, x above 0, is counted once.
    const double inside = 3 * std::sqrt(91.0) + 100 * std::asin(0.3);
    const Evaluated arm = combined("union", swept(hub()), box({0, -3, 10}, {30, 6, 10}));
    QVERIFY(isSound(arm));
    const double wanted = pi * 100 * 40 + 10 * (180 - inside);
    COMPARE_NEAR(volume(arm), wanted, allowed * wanted);
  }

  /// Against OCCT's own cylinder and torus.
  void motionsCombineAsOtherSolidsDo() {
    const Shape post = made("cylinder", {{"radius", 5}, {"height", 40}, {"position", Value::array({30, 0, -20})}}).shape,
                torus = made("torus", {{"radius", 30}, {"tube", 8}}).shape;
    for (const char* operation : {"union", "difference", "intersection"}) {
      const Evaluated wanted = combined(operation, torus, post), got = combined(operation, swept(ring()), post);
      QVERIFY(isSound(wanted) && isSound(got));
      COMPARE_NEAR(volume(got), volume(wanted), 2 * allowed * volume(wanted));
    }
  }

  void edgedAndPulledOnesTakeHoles() {
    const Shape bore = made("cylinder", {{"radius", 4}, {"height", 40}}).shape;
    const Shape blades = swept(fourBlades());
    const Evaluated bored = combined("difference", blades, bore);
    QVERIFY(isSound(bored));
    COMPARE_NEAR(volume(bored), volumeOfShape(blades) - pi * 16 * 40, allowed * volumeOfShape(blades));
    const Shape swollen = swept(swollenRing());
    QVERIFY(volumeOfShape(swollen) > 2 * pi * pi * 30 * 64);
    const Shape half = box({0, -60, -60}, {60, 120, 120});
    const Evaluated right = combined("intersection", swollen, half), left = combined("difference", swollen, half);
    QVERIFY(isSound(right) && isSound(left));
    COMPARE_NEAR(volume(right) + volume(left), volumeOfShape(swollen), 2 * allowed * volumeOfShape(swollen));
    // The seam lies at x = 38, on the right; the functions that are pulled there reach a little over a quarter of the ring.
    QVERIFY(volume(left) > pi * pi * 30 * 64 && volume(left) < volume(right));
  }

  void twoMotionsMeet() {
    const Shape other =
        made("transform", {{"move", Value::array({30, 0, -20})}}, {swept(primitiveMotion({.radius = 5}).motion)}).shape;
    const Shape solid = swept(ring());
    const Evaluated both = combined("union", solid, other), common = combined("intersection", solid, other);
    QVERIFY(isSound(both) && isSound(common));
    const double sum = volumeOfShape(solid) + volumeOfShape(other);
    COMPARE_NEAR(volume(both) + volume(common), sum, 2 * allowed * sum);
  }

  /// OpenCASCADE offsets blades that are thinner than two walls through each other, and calls the result valid.
  void wallsThatPassThroughEachOtherAreRefused() {
    const Motion motion = hub();
    const MotionPlace at{0.125, 0.5};
    const Vec3 centre = blossom::point(motion.trajectory, at.v);
    const Vec3 to = centre + 3.5 * (evaluate(motion, at.u, at.v).point - centre);
    const Shape propeller = swept(pull(motion, {{at}, {to}, {0, 0, 1}, Vec3::Zero(), {}, {4, false}}).motion);
    VERIFY_REFUSED(refusal("shell", {{"thickness", 3}}, {propeller}), ErrorCode::InvalidInput, "pass through each other");
  }

  void shellsHaveTheirWalls() {
    const Shape post = swept(hub());
    const Evaluated hollow = made("shell", {{"thickness", 1}}, {post});
    QVERIFY(isSound(hollow));
    const double closed = pi * (100 * 40 - 81 * 38);
    COMPARE_NEAR(volume(hollow), closed, 1e-4 * closed);
    const int top = flatFaceAt(post, 40);
    QVERIFY(top >= 0);
    const Value face{{"input", "shape"}, {"kind", "face"}, {"index", top}};
    const Evaluated cup = made("shell", {{"thickness", 1}, {"faces", Value::array({face})}}, {post});
    QVERIFY(isSound(cup));
    const double open = pi * (100 * 40 - 81 * 39);
    COMPARE_NEAR(volume(cup), open, 1e-4 * open);
    const Evaluated tube = made("shell", {{"thickness", 2}}, {swept(ring())});
    QVERIFY(isSound(tube));
    const double wall = 2 * pi * pi * 30 * (64 - 36);
    COMPARE_NEAR(volume(tube), wall, 1e-4 * wall);
  }

  void filesKeepThem() {
    const QTemporaryDir folder;
    const auto run = [&](const QStringList& arguments) { return answerOf(folder.path(), arguments); };
    QCOMPARE(run({"sweep-motion", "--kind", "torus", "--radius", "30", "--profile", "8", "-o", "ring.json"}).code, 0);
    QCOMPARE(run({"box", "--anchor", "corner", "--position", "0,-50,-50", "--width", "50", "--depth", "100", "--height",
                  "100", "-o", "half.step"})
                 .code,
             0);
    QCOMPARE(run({"sweep", "ring.json", "--solid", "-o", "ring.step"}).code, 0);
    const double wanted = pi * pi * 30 * 64, area = 2 * pi * pi * 30 * 8 + 2 * pi * 64;
    const QStringList files{"half.step", "half.iges", "half.brep", "half.stl", "half.obj", "half.ply", "half.3mf"};
    for (QString file : files) {
      file.replace("half", "cut");
      const Answer cut = run({"boolean", "ring.step", "half.step", "--operation", "difference", "-o", file});
      QVERIFY2(cut.code == 0, qPrintable(file));
      const bool exact = file.endsWith("step") || file.endsWith("iges") || file.endsWith("brep");
      const Answer read = run({"info", file});
      QVERIFY2(read.code == 0, qPrintable(file));
      COMPARE_NEAR(read.result("area"), area, (exact ? 1e-5 : 1e-2) * area);
      if (!file.endsWith("iges")) COMPARE_NEAR(read.result("volume"), wanted, (exact ? 1e-5 : 1e-2) * wanted);
    }
  }
};

BLOSSOM_TEST(SweepBodyTest)
#include "sweep_body_test.moc"
