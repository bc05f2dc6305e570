#include <future>

#include "core/file.h"
#include "support/fake_worker.h"
#include "support/modeling.h"
#include "worker/worker.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// Solids whose union takes OCCT many seconds.
std::vector<Shape> manyBalls() {
  std::vector<Shape> balls;
  for (int i = 0; i < 300; ++i)
    balls.push_back(
        made("sphere", {{"radius", 10}, {"position", {0.37 * i, 3 * std::sin(0.9 * i), 3 * std::cos(1.3 * i)}}}).shape);
  return balls;
}

}  // namespace

class ModelingWorkerTest : public QObject {
  Q_OBJECT

 private slots:
  void aCrashIsAnErrorOfTheFeature() {
    const Shape box = made("box").shape;
    const FakeWorker crashing(crashingWorker);
    for (const char* command : {"fillet", "chamfer", "shell"})
      VERIFY_REFUSED(refusal(command, {}, {box}), ErrorCode::WorkerDied, "crashed (SIGSEGV)");
    VERIFY_REFUSED(refusal("boolean", {}, {box, box}), ErrorCode::WorkerDied, "for the Boolean operation crashed");
    VERIFY_REFUSED(refusal("loft", {}, {rectangle(0, 0, 1, 1), rectangle(0, 0, 2, 2)}), ErrorCode::WorkerDied,
                   "for the loft");
    VERIFY_REFUSED(refusal("mirror", {{"join", true}}, {box}), ErrorCode::WorkerDied, "for the mirror image");
  }

  void cheapFeaturesNeedNoWorker() {
    const FakeWorker crashing(crashingWorker);
    const Shape box = made("box").shape;
    QVERIFY(isSound(made("pattern", {}, {box})));
    QVERIFY(isSound(made("mirror", {}, {box})));
    QVERIFY(isSound(made("transform", {{"scale", 2}}, {box})));
    QVERIFY(isSound(made("extrude", {}, {rectangle(0, 0, 1, 1)})));
  }

  void whatHangsIsCancelled() {
    const Shape box = made("box").shape;
    const FakeWorker hanging(hangingWorker);
    const CancelToken token;
    VERIFY_ERROR(made("fillet", {}, {box}, cancellingWhenItHangs(token)), ErrorCode::Cancelled);
  }

  void longWorkIsCancelledInTheMiddle() {
    const auto balls = manyBalls();
    const CancelToken token;
    std::atomic<bool> worked = false;
    const Progress cancelling(token, [&](double fraction, const std::string& stage) {
      if (stage != "Combining" || fraction <= 0) return;
      worked = true;
      token.cancel();
    });
    VERIFY_ERROR(made("boolean", {}, balls, cancelling), ErrorCode::Cancelled);
    QVERIFY(worked);
  }

  void cancelledBeforeItBegins() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(made("fillet", {}, {made("box").shape}, Progress(token)), ErrorCode::Cancelled);
  }

  void aModuleThatCannotBeLoadedIsNamed() {
    (void)theApp();
    const TemporaryFolder folder;
    for (const fs::path& module : {fs::path("/nowhere/libmissing.so"), buildFolder() / "lib/libblossom_core.so"}) {
      const WorkerOptions options{.module = module};
      VERIFY_ERROR(runInWorker("modeling.fillet", Value::object(), folder.path(), Progress::none(), options),
                   ErrorCode::PluginBroken);
    }
  }

  void severalAtATime() {
    const Shape box = made("box").shape;
    std::vector<std::future<double>> volumes;
    for (int i = 0; i < 4; ++i)
      volumes.push_back(std::async(std::launch::async, [&box, i] {
        return volume(made("fillet", {{"radius", 1 + i}}, {box}));
      }));
    double before = 24000;
    for (auto& each : volumes) {
      const double v = each.get();
      QVERIFY(v < before);
      before = v;
    }
  }

  void theSameEveryTime() {
    const Shape box = made("box").shape;
    QCOMPARE(volume(made("fillet", {}, {box})), volume(made("fillet", {}, {box})));
  }

  void drawingsArriveExactly() {
    // A loft gets its outlines as numbers: lines, arcs and splines whose area is known.
    const Spline2 arch = ellipticArc({0, 0}, {10, 0}, 0.5, 0, std::numbers::pi);
    Path dome;
    dome.closed = true;
    dome.segments = {arch, Line2{{-10, 0}, {10, 0}}};
    const Evaluated solid = made("loft", {{"ruled", true}, {"spacing", 3}}, {Region{{dome}}, Region{{dome}}});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), 3 * 25 * std::numbers::pi, 1e-5);
  }
};

BLOSSOM_TEST(ModelingWorkerTest)
#include "modeling_worker_test.moc"
