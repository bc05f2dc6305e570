// How long the window's thread does not answer while jobs run. Prints figures; what they have to be is for others to say.
#include <time.h>

#include <QPushButton>

#include "exchange/formats.h"
#include "geometry/mesh/mesh.h"
#include "ui/files/start_page.h"
#include "ui/thread/stall_watch.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// How long this thread has had a processor, ms.
double computedMs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace

class StallTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpOnce();
    makeModels();
  }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void theWatchSeesAStall();
  void jobsLeaveTheWindowAlive_data();
  void jobsLeaveTheWindowAlive();

 private:
  void makeModels();
  /// Turns the event loop and nothing else until all is done.
  template <class Done>
  bool wait(const Done& done) {
    QEventLoop loop;
    QTimer poll;
    connect(&poll, &QTimer::timeout, &loop, [&] {
      if (done()) loop.quit();
    });
    poll.start(10);
    QTimer::singleShot(120000, &loop, [&] { loop.exit(1); });
    return loop.exec() == 0;
  }
  bool quiet() { return !window_->session().evaluating() && !window_->session().job().running(); }
  QString mesh_;
};

// 130,000 triangles of a torus.
void StallTest::makeModels() {
  constexpr int around = 360, across = 180;
  Mesh torus;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across, r = 40 + 12 * std::cos(v);
      torus.points.emplace_back(r * std::cos(u), r * std::sin(u), 12 * std::sin(v));
    }
  const auto at = [](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      torus.addFace(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      torus.addFace(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  mesh_ = folder_.filePath(QStringLiteral("torus.stl"));
  writeShape(standardFormats(), torus, mesh_.toStdString());
}

void StallTest::theWatchSeesAStall() {
  StallWatch watch;
  QVERIFY(wait([&] { return watch.overall().wall > 0; }));
  const double start = computedMs();
  while (computedMs() < start + 200) continue;  // the stall: computing, as time that the host takes away does not count
  QVERIFY(wait([&] { return watch.overall().wall > 140; }));
  QVERIFY(watch.duringWork().wall == 0);
}

void StallTest::jobsLeaveTheWindowAlive_data() {
  QTest::addColumn<QString>("file");
  QTest::newRow("propeller") << propeller();
  QTest::newRow("130000_triangles") << mesh_;
  for (const char* name : {"triangle-to-star", "melting-ice", "flange", "free-form-pocket", "pulled-surface"})
    QTest::newRow(name) << QString::fromStdString(test::sample(std::string(name) + ".blossom").string());
  const auto step = test::sharedData() / "step";
  std::error_code ec;
  std::filesystem::path largest;
  for (const auto& entry : std::filesystem::directory_iterator(step, ec))
    if (largest.empty() || entry.file_size() > std::filesystem::file_size(largest)) largest = entry.path();
  if (!largest.empty()) QTest::newRow("largest_step") << QString::fromStdString(largest.string());
}

void StallTest::jobsLeaveTheWindowAlive() {
  QFETCH(QString, file);
  wait([] { return true; });
  StallWatch watch;
  const auto tell = [&](const char* what) {
    qInfo("figure stall_%s_%s_ms %.1f", what, QTest::currentDataTag(), watch.duringWork().wall);
    qInfo("figure stall_%s_%s_computing_ms %.1f", what, QTest::currentDataTag(), watch.duringWork().busy);
    watch.reset();
  };
  window_->openFile(file);
  QVERIFY(wait([&] { return quiet() && !window_->session().document().features().empty(); }));
  tell("opening");
  bool saved = false;
  const auto document = folder_.filePath(QStringLiteral("stall.blossom")).toStdString();
  window_->session().save(document, [&] { saved = true; });
  QVERIFY(wait([&] { return saved; }));
  tell("saving");
  const FeatureId last = window_->session().document().features().back()->id;
  window_->session().exportFeature(last, folder_.filePath(QStringLiteral("stall.png")).toStdString(), Value::object());
  QVERIFY(wait([&] { return quiet(); }));
  tell("drawing");
  Feature changed = window_->session().document().at(last);
  changed.suppressed = true;
  window_->session().commit(window_->session().document().with(changed), QStringLiteral("Suppress"));
  QVERIFY(wait([&] { return quiet(); }));
  window_->session().undo();
  QVERIFY(wait([&] { return quiet(); }));
  tell("editing");
}

BLOSSOM_WINDOW_TEST(StallTest)
#include "stall_test.moc"
