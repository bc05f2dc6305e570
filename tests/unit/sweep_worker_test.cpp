#include <BRepBuilderAPI_MakeEdge.hxx>
#include <TopoDS_Edge.hxx>

#include "geometry/bspline/bspline.h"
#include "support/fake_worker.h"
#include "support/modeling.h"
#include "support/motion_sizes.h"
#include "sweep/kernel/begin/motion_from_curve.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

Motion hubMotion() { return primitiveMotion({.radius = 10, .height = 36}).motion; }

Shape railEdge() { return Brep(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 3, 40)).Edge(), "Rail"); }

Value onePull() {
  const Value pull{{"u", 0.125}, {"v", 0.5}, {"to", {14.0, 14.0, 18.0}}};
  return {{"pulls", Value::array({pull})}};
}

Value onePlace() {
  const Value place{{"u", 0.125}, {"v", 0.5}};
  return {{"places", Value::array({place})}};
}

}  // namespace

/// Solids of motions, and curves in B-reps, are OCCT's and wait in a process of their own; motions and surfaces need none.
class SweepWorkerTest : public QObject {
  Q_OBJECT
 private slots:
  void aCrashIsAnErrorOfTheFeature() {
    const FakeWorker crashing(crashingWorker);
    VERIFY_REFUSED(refusal("sweep", {{"solid", true}}, {hubMotion()}), ErrorCode::WorkerDied,
                   "for the solid of the sweep crashed (SIGSEGV)");
    VERIFY_REFUSED(refusal("sweep", {{"solid", true}, {"mode", "cubic"}}, {hubMotion()}), ErrorCode::WorkerDied, "crashed");
    VERIFY_REFUSED(refusal("sweep-along", Value::object(), {railEdge()}), ErrorCode::WorkerDied,
                   "for the sweep along the curve crashed");
  }

  void motionsAndSurfacesNeedNoWorker() {
    const FakeWorker crashing(crashingWorker);
    const Shape ring = made("sweep-motion", {{"kind", "torus"}}).shape;
    QVERIFY(made("sweep-refine", {{"v", Value::array({0.3})}}, {ring}).shape.get<Motion>());
    QVERIFY(made("sweep-pull", onePull(), {hubMotion()}).shape.get<Motion>());
    QVERIFY(made("sweep-twist", onePlace(), {hubMotion()}).shape.get<Motion>());
    QVERIFY(made("sweep", Value::object(), {ring}).shape.get<Surface>());
    QVERIFY(made("sweep", {{"mode", "cubic"}}, {ring}).shape.get<Surface>());
    QVERIFY(
        made("sweep-along", Value::object(), {Curve{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {0, 3, 40, 1}}}}).shape.get<Motion>());
  }

  void whatHangsIsCancelled() {
    const FakeWorker hanging(hangingWorker);
    const CancelToken token;
    VERIFY_ERROR(made("sweep", {{"solid", true}}, {hubMotion()}, cancellingWhenItHangs(token)), ErrorCode::Cancelled);
  }

  void solidsAreTheSameToTheBit() {
    const Motion pulled = *made("sweep-pull", onePull(), {hubMotion()}).shape.get<Motion>();
    const Evaluated solid = made("sweep", {{"solid", true}}, {pulled});
    QVERIFY(isSound(solid) && solid.stats.contains("worker_ms"));
    const Shape here = Brep(makeSolid(productSurface(pulled).surface).solid);
    QCOMPARE(volume(solid), figure(here, "volume"));
    QCOMPARE(surfaceArea(solid), figure(here, "area"));
  }

  void motionsComeBackToTheBit() {
    const Evaluated tube = made("sweep-along", {{"radius", 4}}, {railEdge()});
    QVERIFY(tube.stats.contains("worker_ms"));
    const Motion here = motionFromCurve({1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {0, 3, 40, 1}}}, {.radius = 4}).motion;
    const Motion& motion = *tube.shape.get<Motion>();
    QVERIFY(sameBits(motion.scaling.poles, here.scaling.poles) && motion.closedU == here.closedU);
    // OCCT lays a line through its ends by its length: the last digit may differ.
    for (std::size_t i = 0; i < here.trajectory.poles.size(); ++i)
      QVERIFY((motion.trajectory.poles.at(i) - here.trajectory.poles[i]).norm() < 1e-13);
    QCOMPARE(tube.stats.at("poles_v").get<std::size_t>(), here.orientation.countV());
  }
};

BLOSSOM_TEST(SweepWorkerTest)
#include "sweep_worker_test.moc"
