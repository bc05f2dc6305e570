#include <signal.h>

#include <QFile>
#include <QSlider>

#include "document/edits.h"
#include "geometry/measure/measure.h"
#include "support/polyhedra.h"
#include "ui/tools/view_props.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"
#include "worker/worker.h"

using namespace blossom;
using namespace blossom::ui;
using namespace blossom::test;

namespace {

/// Process ids of the helpers that this process has started.
std::vector<pid_t> helpers() {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    QFile stat(QString::fromStdString((entry.path() / "stat").string()));
    if (!stat.open(QIODevice::ReadOnly)) continue;
    const QByteArray line = stat.readAll();
    const QList<QByteArray> after = line.mid(line.lastIndexOf(')') + 2).split(' ');
    if (line.contains("(blossom-worker)") && after.size() > 1 && after[1].toInt() == ::getpid() && after[0] != "Z")
      found.push_back(std::stoi(name));
  }
  return found;
}

}  // namespace

/// Adding, melting and morphing solids of files, through the real window.
class MorphologyWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void twoSolidsAreAddedOneMeltsAndTheResultIsSaved();
  void theFacetsOfASumAreShown();
  void aMorphPlaysInTheTimeline();
  void whatIsOfTheBallIsHiddenBesideAnElement();
  void theRadiusIsDragged();
  void aRoundedSolidIsDragged();
  void aLongSumIsCancelled();
  void theWindowOutlivesTheHelper();

 private:
  [[nodiscard]] QString file(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  /// A mesh as a file of the trade, as another program would have written it.
  QString written(const Mesh& mesh, const char* name) {
    writeShape(*window_->session().app().formats, mesh, file(name).toStdString());
    return file(name);
  }
  void importMore(const QString& path) {
    window_->session().import({path.toStdString()});
    waitUntilComputed();
  }
  [[nodiscard]] double volumeIn(const QString& path) {
    for (const Measure& each : measure(readShape(*window_->session().app().formats, path.toStdString()).shape).values)
      if (each.name == "volume") return std::get<double>(each.value);
    return std::nan("");
  }
  [[nodiscard]] Shape ballMesh(double radius) const {
    const auto type = window_->session().app().registry->at("ball");
    const Value parameters{{"radius", radius}, {"subdivisions", 1}};
    return type->evaluate(completed(type->parameters, parameters), {}, {}).shape;
  }
  void select(const std::vector<FeatureId>& ids) { window_->tree().selectThese(ids); }
  /// A sum that keeps CGAL busy for minutes.
  FeatureId startLongSum();
  FeatureId featureOfABlock(const char* command, const char* radius);
  void dragRadius(const Vec3& start, const Vec3& end);
  void verifyUsable();
};

void MorphologyWindowTest::twoSolidsAreAddedOneMeltsAndTheResultIsSaved() {
  openAndWait(written(lBlock(), "bracket.step"));
  const FeatureId bracket = last();
  importMore(written(triangulated(cornerTetrahedron()).first, "tool.stl"));
  const FeatureId tool = last();
  select({bracket, tool});
  run("feature.morphology.solid-sum");
  waitUntilComputed();
  const FeatureId sum = last();
  QCOMPARE(window_->page().document().at(sum).inputs, (std::vector<FeatureId>{bracket, tool}));
  COMPARE_NEAR(measureOf(sum, "volume"), 41, 1e-4);  // STL keeps seven digits

  select({sum});
  run("feature.morphology.melt");
  waitUntilComputed();
  const FeatureId core = last();
  edit("radius", "0.2 mm");
  waitUntilComputed();
  edit("subdivisions", "0");
  waitUntilComputed();
  const auto view = window_->session().view(core);
  QVERIFY2(view && !view->result->error, view && view->result->error ? view->result->error->what() : "");
  const double left = measureOf(core, "volume");
  QVERIFY(left > 14 && left < 41);

  for (const char* name : {"core.step", "core.stl"}) {
    bool saved = false;
    const auto connection = connect(&window_->session(), &Session::noted, this, [&] { saved = true; });
    window_->session().exportFeature(core, file(name).toStdString(), Value::object());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->session().job().running() && QFile::exists(file(name)), 30000);
    disconnect(connection);
    COMPARE_NEAR(volumeIn(file(name)), left, 1e-5 * left);
  }
  const QString picture = qEnvironmentVariable("BLOSSOM_TEST_PICTURES");
  if (!picture.isEmpty()) {
    Session& session = window_->session();
    session.commit(withOnlyVisible(session.document(), {core}), QStringLiteral("Isolate"));
    window_->resize(1400, 900);
    run("view.fit");
    (void)canvas();
    window_->grab().save(picture + QStringLiteral("/morphology-window.png"));
  }

  // All of it can be undone and done again.
  while (!window_->session().history().undoText().empty()) window_->session().undo();
  while (!window_->session().history().redoText().empty()) window_->session().redo();
  waitUntilComputed();
  COMPARE_NEAR(measureOf(core, "volume"), left, 1e-9 * left);
}

void MorphologyWindowTest::theFacetsOfASumAreShown() {
  openAndWait(written(lBlock(), "bracket.off"));
  const FeatureId bracket = last();
  importMore(written(triangulated(cornerTetrahedron()).first, "tool.off"));
  select({bracket, last()});
  run("feature.morphology.solid-sum");
  waitUntilComputed();
  const FeatureId sum = last();
  select({sum});
  run("view.fit");
  const Look look = window_->page().look();
  const auto seen = [&](const Color& color) { return colored(canvas(), qtColor(color)); };
  const auto show = [&](const char* facets) {
    Feature feature = window_->page().document().at(sum);
    feature.parameters["facets"] = facets;
    window_->session().commit(window_->page().document().with(feature), QStringLiteral("Show facets"));
  };
  QVERIFY(seen(look.control) < 0.01);
  show("families");
  waitUntilComputed();
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  if (!folder.isEmpty()) QVERIFY(canvas().save(folder + QStringLiteral("/sum-families.png")));
  QVERIFY2(seen(look.control) > 0.005 && seen({0.45, 0.65, 0.35}) > 0.02, "facets have the colours of their families");
  // A section cuts them like the sum.
  const double whole = seen({0.45, 0.65, 0.35});
  std::vector<double> left;
  for (const double height : {-100.0, 100.0}) {
    window_->view().setSection(CutPlane{Vec3::UnitZ(), height});
    left.push_back(seen({0.45, 0.65, 0.35}));
  }
  window_->view().setSection({});
  QVERIFY2(std::min(left[0], left[1]) < 0.3 * whole && std::max(left[0], left[1]) > 0.9 * whole, "cut");
  show("outlines");
  waitUntilComputed();
  (void)canvas();
  if (!folder.isEmpty()) window_->grab().save(folder + QStringLiteral("/sum-parts.png"));
  show("none");
  waitUntilComputed();
  QVERIFY(seen(look.control) < 0.01);
}

void MorphologyWindowTest::aMorphPlaysInTheTimeline() {
  openAndWait(written(cuboid({0, 0, 0}, {1, 2, 3}), "first.off"));
  const FeatureId first = last();
  importMore(written(cuboid({0, 0, 0}, {5, 2, 1}), "second.off"));
  select({first, last()});
  run("feature.morphology.solid-morph");
  waitUntilComputed();
  const FeatureId morph = last();
  edit("frames", "5");
  waitUntilComputed();
  Session& session = window_->session();
  session.commit(withOnlyVisible(session.document(), {morph}), QStringLiteral("Isolate"));
  auto* const timeline = window_->findChild<QWidget*>(QStringLiteral("timeline"));
  QTRY_VERIFY(timeline->isVisible());
  QCOMPARE(window_->page().playback().count(), 5);
  for (const int frame : {0, 2, 4, 1}) {
    timeline->findChild<QSlider*>()->setValue(frame);
    const Bounds box = window_->view().extent();
    COMPARE_NEAR(box.high.x() - box.low.x(), 1 + frame, 1e-6);
    COMPARE_NEAR(box.high.z() - box.low.z(), 3 - 0.5 * frame, 1e-6);
  }
  // Melting plays likewise.
  select({first});
  run("feature.morphology.melt");
  waitUntilComputed();
  edit("radius", "0.4 mm");
  edit("frames", "3");
  waitUntilComputed();
  session.commit(withOnlyVisible(session.document(), {last()}), QStringLiteral("Isolate"));
  QTRY_COMPARE(window_->page().playback().count(), 3);
}

/// Of a block of 40 x 30 x 20, seen from the front.
FeatureId MorphologyWindowTest::featureOfABlock(const char* command, const char* radius) {
  openAndWait(written(cuboid({0, 0, 0}, {40, 30, 20}), "block.off"));
  select({last()});
  run(command);
  waitUntilComputed();
  const FeatureId made = last();
  edit("radius", radius);
  waitUntilComputed();
  run("view.front");
  if (!QTest::qWaitFor([&] { return std::abs(window_->view().camera().turn().pitch) < 1e-9; })) qWarning("no front view");
  QTest::qWait(0);
  window_->tree().select(made);
  return made;
}

void MorphologyWindowTest::whatIsOfTheBallIsHiddenBesideAnElement() {
  const FeatureId inflated = featureOfABlock("feature.morphology.inflate", "5 mm");
  const FeatureId block = window_->page().document().at(inflated).inputs.front();
  const auto seen = [&](const char* name) { return window_->properties().field(QLatin1String(name))->isVisible(); };
  QVERIFY(seen("radius") && seen("subdivisions") && seen("fit") && !seen("size"));
  importMore(written(triangulated(cornerTetrahedron()).first, "tool.off"));
  Feature byElement = window_->page().document().at(inflated);
  byElement.inputs = {block, last()};
  window_->session().commit(window_->page().document().with(byElement), QStringLiteral("Choose"));
  select({inflated});
  waitUntilComputed();
  QVERIFY(!seen("radius") && !seen("subdivisions") && !seen("fit") && seen("size"));
  window_->session().undo();
  QVERIFY(seen("radius") && !seen("size"));
}

void MorphologyWindowTest::theRadiusIsDragged() {
  const FeatureId inflated = featureOfABlock("feature.morphology.inflate", "5 mm");
  const auto radius = [&] { return window_->page().document().at(inflated).parameters.value("radius", 0.0); };
  dragRadius({20, 15, 25}, {20, 15, 30});
  const double pixel = window_->view().camera().millimetresPerPixel();
  COMPARE_NEAR(radius(), 10, 3 * pixel);
  COMPARE_NEAR(measureOf(inflated, "volume"), volumeWithCuboid(*ballMesh(radius()).get<Mesh>(), {40, 30, 20}), 1e-6);
  window_->session().undo();
  COMPARE_NEAR(radius(), 5, 1e-12);
}

void MorphologyWindowTest::aRoundedSolidIsDragged() {
  const FeatureId rounded = featureOfABlock("feature.morphology.solid-round", "3 mm");
  const double volume = measureOf(rounded, "volume");
  dragRadius({20, 15, 17}, {20, 15, 14});
  const double radius = window_->page().document().at(rounded).parameters.at("radius").get<double>();
  COMPARE_NEAR(radius, 6, 3 * window_->view().camera().millimetresPerPixel());
  QVERIFY(measureOf(rounded, "volume") < volume);
}

/// With Ctrl held: without steps.
void MorphologyWindowTest::dragRadius(const Vec3& start, const Vec3& end) {
  const QPoint from = screenOf(start), to = screenOf(end);
  test::moveMouse(&window_->view(), from);
  QTest::mousePress(&window_->view(), Qt::LeftButton, Qt::ControlModifier, from);
  test::moveMouse(&window_->view(), (from + to) / 2);
  QMouseEvent moved(QEvent::MouseMove, to, window_->view().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                    Qt::ControlModifier);
  QApplication::sendEvent(&window_->view(), &moved);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, Qt::ControlModifier, to);
  waitUntilComputed();
}

FeatureId MorphologyWindowTest::startLongSum() {
  std::mt19937_64 random(7);
  openAndWait(written(spikyRing(random, 6, 1.5, 24), "ring.off"));
  const FeatureId ring = last();
  importMore(written(spikyRing(random, 5, 1, 24), "other.off"));
  select({ring, last()});
  endIdleWorkers();  // or one kept for later calls would count as the helper that has started
  run("feature.morphology.solid-sum");
  if (!QTest::qWaitFor([] { return !helpers().empty(); }, 30000)) qWarning("no helper has started");
  return last();
}

void MorphologyWindowTest::verifyUsable() {
  run("feature.modeling.box");
  waitUntilComputed();
  const FeatureId box = last();
  edit("width", "20");
  waitUntilComputed();
  QVERIFY(measureOf(box, "volume") > 0);
}

void MorphologyWindowTest::aLongSumIsCancelled() {
  const FeatureId sum = startLongSum();
  QVERIFY(window_->session().evaluating());
  QElapsedTimer since;
  since.start();
  window_->session().cancelEvaluation();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && helpers().empty(), 30000);
  qInfo("figure window_cancel_ms %lld", static_cast<long long>(since.elapsed()));
  QVERIFY(window_->page().document().contains(sum));
  window_->session().commit(window_->session().document().without(sum), QStringLiteral("Delete"));
  verifyUsable();
}

void MorphologyWindowTest::theWindowOutlivesTheHelper() {
  const FeatureId sum = startLongSum();
  for (const pid_t helper : helpers()) QCOMPARE(::kill(helper, SIGKILL), 0);
  waitUntilComputed();
  // The feature keeps its place, with a sentence.
  QVERIFY(window_->page().document().contains(sum));
  const auto view = window_->session().view(sum);
  QVERIFY(view && view->result->error);
  QCOMPARE(view->result->error->code(), ErrorCode::WorkerDied);
  const std::string sentence = view->result->error->message();
  QVERIFY2(sentence.find("for the sum was ended (SIGKILL)") != std::string::npos, sentence.c_str());
  QVERIFY(!view->result->error->hint().empty());
  QCOMPARE(window_->page().document().features().size(), std::size_t{3});
  // The next edit tries it again; ended again, it is where it was, and what was edited is there.
  window_->session().import({written(cuboid({0, 0, 0}, {1, 1, 1}), "small.off").toStdString()});
  const auto endHelpers = [this] {
    for (const pid_t helper : helpers()) ::kill(helper, SIGKILL);
    return !window_->session().evaluating() && !window_->session().job().running() && last() != FeatureId();
  };
  QTRY_VERIFY_WITH_TIMEOUT(endHelpers() && std::abs(measureOf(last(), "volume") - 1) < 1e-12, 60000);
  QCOMPARE(window_->session().view(sum)->result->error->code(), ErrorCode::WorkerDied);
  window_->session().commit(window_->session().document().without(sum), QStringLiteral("Delete"));
  verifyUsable();
}

BLOSSOM_WINDOW_TEST(MorphologyWindowTest)
#include "morphology_window_test.moc"
