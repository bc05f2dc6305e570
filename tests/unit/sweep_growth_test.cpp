#include <QTemporaryDir>
#include <cmath>
#include <numbers>

#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "support/command_line.h"
#include "support/errors.h"
#include "support/modeling.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/edit/apply_edits.h"
#include "sweep/kernel/edit/growth.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/motion_mesh.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

constexpr double radian = 180 / std::numbers::pi;

Vec3 pointAt(const Motion& motion, const MotionPlace& at) { return sweep::evaluate(motion, at.u, at.v).point; }

/// Four blades, their twist, a bump and a bend: ways of every kind.
std::vector<MotionEdit> someEdits() {
  MotionPull blades{{{0.125, 0.5}}, {{30, 30, 20}}, {0, 0, 1}};
  blades.symmetry = {4, false};
  MotionTwist twist{{{0.125, 0.5}}, {1, 1, 0}, 50};
  twist.symmetry = {4, false};
  return {blades, twist, MotionPull{{{0.3, 0.2}}, {{-9, 12, 9}}}, MotionPull{{{0, 0.8}}, {{14, 3, 34}}, {1, 0, 0}}};
}

Motion edited() {
  Motion motion = readMotionOf("cylinder.json");
  motion.edits = someEdits();
  return motion;
}

/// The motions before the first edit, after it, and so on, as features give them: of the edits nothing is known.
std::vector<GrowthStep> stepsBetween(const std::vector<Motion>& motions) {
  return growthSteps(motions.front(), std::span(motions).subspan(1));
}

Evaluated grownFeature(const Value& parameters, const std::vector<Motion>& motions) {
  const auto type = theApp().registry->at("sweep.growth");
  const std::vector<Shape> shapes(motions.begin(), motions.end());
  const Evaluated out =
      type->evaluate(completed(type->parameters, parameters), arrangedInputs(*type, shapes), Progress::none());
  checkResult(*type, out.shape);
  return out;
}

}  // namespace

class SweepGrowthTest : public QObject {
  Q_OBJECT
 private slots:
  void itEndsAtTheEditedMotionBitForBit() {
    const Motion motion = edited(), all = withEditsApplied(motion);
    const std::vector<Motion> each = afterEachEdit(motion);
    QCOMPARE(each.size(), motion.edits.size() + 1);
    QVERIFY(each.back() == all);
    for (const auto& steps : {growthSteps(motion, {}), stepsBetween(each)}) {
      QCOMPARE(steps.size(), motion.edits.size());
      for (std::size_t k = 0; k < steps.size(); ++k) {
        QVERIFY(grown(steps[k], 0) == each[k]);
        QVERIFY(grown(steps[k], 1) == each[k + 1]);
      }
    }
    QVERIFY(each.front().edits.empty());
    // Edits of a motion that follows are in it.
    Motion next = each[2];
    next.edits = {motion.edits[2]};
    const std::vector<GrowthStep> mixed = growthSteps(each[0], std::vector<Motion>{each[2], next});
    QVERIFY(mixed.back().to == each[3]);
  }

  void pullsGoStraightToTheirTargets() {
    auto random = seededRandom();
    for (int run = 0; run < 200; ++run) {
      const Motion motion = randomMotion(random, run % 2 ? ClosedU::AntiPeriodic : ClosedU::No, true);
      MotionPull edit{{{randomIn(random, motion.domainU()), randomIn(random, motion.domainV())}}, {anyVector(random, 20)}};
      edit.weights = run % 3 == 0 ? PullWeights{1, 0, 0} : PullWeights{0, 0, 1};
      const EditResult whole = pull(motion, edit);
      if (!whole.obstacles.empty()) continue;
      const Vec3 start = pointAt(motion, edit.at.front());
      const double size = sizeOfPoles(motion, edit.at.front().u, edit.at.front().v) + edit.to.front().norm();
      const double share = uniform(random, 0, 1);
      const Vec3 wanted = start + share * (edit.to.front() - start);
      for (const GrowthStep& step : {GrowthStep{motion, whole.motion, edit}, GrowthStep{motion, whole.motion}}) {
        const double off = (pointAt(grown(step, share), edit.at.front()) - wanted).norm() / size;
        QVERIFY2(off < 1e-12, qPrintable(QString::number(off)));
        largest_ = std::max(largest_, off);
      }
    }
    qInfo("figure growth_off_the_way_share %.3g", largest_);
  }

  void twistsTurnByTheirShare() {
    auto random = seededRandom();
    const Motion motion = readMotionOf("cylinder.json");
    for (int run = 0; run < 200; ++run) {
      const MotionTwist edit{
          {{uniform(random, 0, 1), uniform(random, 0, 1)}}, anyVector(random, 1), uniform(random, -170, 170)};
      const double share = uniform(random, 0, 1);
      const GrowthStep known{motion, twist(motion, edit).motion, edit}, unknown{known.from, known.to};
      MotionTwist part = edit;
      part.angle *= share;
      QVERIFY(grown(known, share) == twist(motion, part).motion);
      // Between motions: about the same axis, by the angle of a straight way from one quaternion to the other.
      const double half = edit.angle / radian / 2;
      const double angle = 2 * std::atan2(share * std::sin(half), 1 - share + share * std::cos(half));
      const auto orientation = [&](const Motion& each) {
        return blossom::evaluate(each.orientation, edit.at.front().u, edit.at.front().v);
      };
      const Vec4 wanted = times(rotationAbout(edit.axis.normalized(), angle), orientation(motion));
      QVERIFY(angleBetween(wanted, orientation(grown(unknown, share))) < 1e-7);
    }
  }

  /// What an edit of a fine level adds to a motion is counted before the frames are made, not only what it begins with.
  void framesThatWouldFillTheMemoryAreRefused() {
    Motion motion = readMotionOf("cylinder.json");
    MotionPull fine{{}, {}, {0, 1, 1}};
    for (int k = 0; k < 20; ++k) {
      fine.at.push_back({k / 20.0 + 0.01, 0.05 + 0.045 * k});
      fine.to.push_back(pointAt(motion, fine.at.back()) + Vec3(0.1, 0.2, 0));
    }
    fine.level = 5;
    motion.edits = {fine};
    const Motion before = afterEachEdit(motion).front(), after = withEditsApplied(motion);
    QVERIFY(1000 * cellsOfMesh(before, {6}) < std::size_t(1) << 24);
    QVERIFY(1000 * cellsOfMesh(after, {6}) > std::size_t(1) << 24);
    for (const char* as : {"mesh", "surface"})
      QCOMPARE(errorOf([&] { grownFeature({{"frames", 1000}, {"as", as}}, {motion}); }).code(), ErrorCode::LimitExceeded);
  }

  void framesFallOnTheEndsOfSteps() {
    for (std::size_t steps = 1; steps < 10; ++steps) {
      for (std::size_t frames = 2; frames < 40; ++frames) {
        QCOMPARE(growthPlace(0, frames, steps), (GrowthPlace{0, 0}));
        QCOMPARE(growthPlace(frames - 1, frames, steps), (GrowthPlace{steps - 1, 1}));
        for (std::size_t k = 0; k < frames; ++k) {
          const GrowthPlace place = growthPlace(k, frames, steps);
          const double way = static_cast<double>(place.step) + place.share,
                       part = static_cast<double>(k) / (double(frames) - 1);
          COMPARE_NEAR(way, part * static_cast<double>(steps), 1e-12);
          if (k * steps % (frames - 1) == 0) QVERIFY(place.share == 0 || place.share == 1);
          const GrowthPlace same = growthPlace(part, steps);
          COMPARE_NEAR(static_cast<double>(same.step) + same.share, way, 1e-12);
        }
      }
    }
  }

  void whatDoesNotGoOnIsRefused() {
    const Motion cylinder = readMotionOf("cylinder.json");
    const Error other = errorOf([&] {
      (void)growthSteps(cylinder, std::vector<Motion>{cylinder, readMotionOf("torus.json")});
    });
    QCOMPARE(other.code(), ErrorCode::InvalidInput);
    QVERIFY2(other.message().find("Motion 3 does not go on") != std::string::npos, other.what());
    const Error nothing = errorOf([&] { (void)growthSteps(cylinder, {}); });
    QCOMPARE(nothing.code(), ErrorCode::InvalidInput);
    QVERIFY2(nothing.message().find("Nothing grows") != std::string::npos, nothing.what());
  }

  void meshesLieOnTheSurfaceAndMeetAtTheSeam() {
    const Motion cylinder = readMotionOf("cylinder.json");  // eight spans around, four along
    const Mesh mesh = motionMesh(cylinder, {3});
    QCOMPARE(mesh.points.size(), std::size_t(24 * 13));
    QCOMPARE(mesh.faceCount(), std::size_t(2 * 24 * 12));
    for (const Vec3& p : mesh.points) COMPARE_NEAR(p.head<2>().norm(), 10.0, 1e-12);
    const Vec3 a = mesh.points[static_cast<std::size_t>(mesh.face(0)[0])],
               b = mesh.points[static_cast<std::size_t>(mesh.face(0)[1])],
               c = mesh.points[static_cast<std::size_t>(mesh.face(0)[2])];
    QVERIFY((b - a).cross(c - a).dot(Vec3(a.x(), a.y(), 0)) > 0);  // seen from outside
  }

  void theFeatureMakesFrames() {
    const Motion motion = edited();
    const Surface first = productSurface(readMotionOf("cylinder.json")).surface,
                  final = productSurface(withEditsApplied(motion)).surface;
    for (const auto& motions : {std::vector<Motion>{motion}, afterEachEdit(motion)}) {
      const Evaluated out = grownFeature({{"frames", 9}, {"as", "surface"}}, motions);
      QCOMPARE(out.stats["steps"], Value(4));
      const Sequence& sequence = *out.shape.get<Sequence>();
      QCOMPARE(sequence.frames.size(), std::size_t(9));
      QCOMPARE(sequence.times.front(), 0.0);
      QCOMPARE(sequence.times.back(), 1.0);
      QVERIFY(*sequence.frames.front().get<Surface>() == first);
      QVERIFY(*sequence.frames.back().get<Surface>() == final);
      QVERIFY(*sequence.frames[4].get<Surface>() == productSurface(afterEachEdit(motion)[2]).surface);
      QVERIFY(*grownFeature({{"t", 1}, {"as", "surface"}}, motions).shape.get<Surface>() == final);
      QVERIFY(*grownFeature({{"t", 1}}, motions).shape.get<Mesh>() == motionMesh(withEditsApplied(motion)));
    }
  }

  void theCommandWritesFramesAndSolids() {
    format_.write(edited(), folder_.filePath("edited.json").toStdString(), Value::object(), Progress::none());
    QCOMPARE(blossom({"sweep-growth", "edited.json", "--frames", "3", "-o", "frame.stl"}).code, 0);
    QCOMPARE(QDir(folder_.path()).entryList({"frame*.stl"}).size(), 3);
    const Answer solid = blossom({"sweep-growth", "edited.json", "--t", "1", "--as", "solid", "-o", "grown.step"});
    QCOMPARE(solid.code, 0);
    const Answer swept = blossom({"sweep", "edited.json", "--solid", "-o", "swept.step"});
    COMPARE_NEAR(solid.result("volume"), swept.result("volume"), 1e-9 * swept.result("volume"));
    QCOMPARE(blossom({"sweep-growth", "edited.json", "--t", "0.5", "-o", "half.step"}).json["result"]["kind"],
             Value("surface"));
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }
  QTemporaryDir folder_;
  Format format_ = motionFormat();
  double largest_ = 0;
};

BLOSSOM_TEST(SweepGrowthTest)
#include "sweep_growth_test.moc"
