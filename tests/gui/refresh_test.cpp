// How often the parts of the window are brought up to date, against event turns and pictures.
#include <array>
#include <random>

#include "ui/thread/refreshes.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

constexpr std::array<std::pair<WindowPart, const char*>, 8> parts{{{WindowPart::View, "view"},
                                                                   {WindowPart::Handles, "handles"},
                                                                   {WindowPart::Actors, "actors"},
                                                                   {WindowPart::Tree, "tree"},
                                                                   {WindowPart::Panel, "panel"},
                                                                   {WindowPart::Tabs, "tabs"},
                                                                   {WindowPart::Actions, "actions"},
                                                                   {WindowPart::StartPage, "start_page"}}};
using Counts = std::array<int, parts.size()>;

Counts countsNow() {
  Counts counts{};
  for (std::size_t i = 0; i < parts.size(); ++i) counts[i] = refreshes(parts[i].first);
  return counts;
}

/// Counts the events that are delivered to the window's thread, each a turn with all that is delivered within it, and the
/// refreshes of the busiest turn.
class CountingApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (QThread::currentThread() != thread() || depth_ > 0) return QApplication::notify(receiver, event);
    const Counts before = countsNow();
    ++depth_;
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    ++turns_;
    const Counts after = countsNow();
    for (std::size_t i = 0; i < parts.size(); ++i) busiest_[i] = std::max(busiest_[i], after[i] - before[i]);
    return taken;
  }

  void restart() {
    turns_ = 0;
    busiest_ = {};
    start_ = countsNow();
  }
  [[nodiscard]] int turns() const { return turns_; }
  [[nodiscard]] int busiest(WindowPart part) const { return busiest_[place(part)]; }
  [[nodiscard]] int count(WindowPart part) const { return refreshes(part) - start_[place(part)]; }

  void print(const char* scene) const {
    qInfo("figure %s_turns %d", scene, turns_);
    for (const auto& [part, name] : parts) {
      qInfo("figure %s_%s %d", scene, name, count(part));
      qInfo("figure %s_%s_most_in_a_turn %d", scene, name, busiest(part));
    }
  }

 private:
  static std::size_t place(WindowPart part) {
    return static_cast<std::size_t>(
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.first == part; }) - parts.begin());
  }

  int depth_ = 0, turns_ = 0;
  Counts busiest_{}, start_{};
};

CountingApplication& application() { return *static_cast<CountingApplication*>(QCoreApplication::instance()); }

/// A tetrahedron of a size, beside the one that it takes as input.
FeatureType tetrahedron() {
  FeatureType type;
  type.id = "test.tetrahedron";
  type.command = "tetrahedron";
  type.title = "Tetrahedron";
  type.summary = "A tetrahedron beside another one.";
  type.inputs = {
      {.name = "beside", .help = "What it stands beside.", .kinds = {ShapeKind::Mesh}, .minimum = 0, .maximum = 1}};
  ParameterSpec size = positiveLength();
  size.name = "size";
  size.help = "Length of an edge along an axis.";
  size.fallback = 10.0;
  ParameterSpec place = point();
  place.name = "place";
  place.help = "Where it stands.";
  place.fallback = Value::array({0.0, 0.0, 0.0});
  type.parameters = {size, place};
  type.evaluate = [](const Value& values, const Inputs& inputs, const Progress&) {
    Vec3 origin;
    for (int i = 0; i < 3; ++i) origin[i] = values.at("place").at(static_cast<std::size_t>(i)).get<double>();
    if (!inputs.of(0).empty()) origin.z() += inputs.get<Mesh>().points.back().z();
    const double s = values.at("size").get<double>();
    Mesh mesh;
    mesh.points = {origin, origin + s * Vec3::UnitX(), origin + s * Vec3::UnitY(), origin + s * Vec3::UnitZ()};
    mesh.faceVertices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    mesh.faceStarts = {0, 3, 6, 9, 12};
    Evaluated out;
    out.shape = mesh;
    return out;
  };
  return type;
}

constexpr int featureCount = 200, followers = 9;

/// Two hundred of them in a square; the first has followers.
Document crowd() {
  std::vector<Feature> features;
  for (int i = 0; i < featureCount; ++i) {
    Feature feature;
    feature.id = "t" + std::to_string(i);
    feature.type = "test.tetrahedron";
    feature.name = "Tetrahedron " + std::to_string(i);
    feature.parameters = Value{{"size", 8.0}, {"place", Value::array({12.0 * (i % 15), 12.0 * (i / 15), 0.0})}};
    if (i >= 1 && i <= followers) feature.inputs = {"t0"};
    features.push_back(std::move(feature));
  }
  return Document::of(std::move(features));
}

const char* const square =
    "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>"
    "<path d='M0 0H20V20H0Z'/></svg>";
const char* const slab =
    "<svg xmlns='http://www.w3.org/2000/svg' width='90mm' height='20mm' viewBox='0 0 90 20'>"
    "<path d='M50 0H90V10H50Z'/></svg>";

}  // namespace

class RefreshTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void cleanup() { window_.reset(); }
  void aDragRefreshesOnceATurn();
  void anEditOfManyFeaturesRefreshesOnceAPicture();

 private:
  void openCrowd();
  void resizeFirst(double size);
};

/// A control shape of a morph is dragged over a hundred moves, with all that comes of it.
void RefreshTest::aDragRefreshesOnceATurn() {
  openWindow();
  run("file.new");
  for (const auto& [name, text] : {std::pair{"square.svg", square}, std::pair{"slab.svg", slab}}) {
    QFile file(folder_.filePath(QLatin1String(name)));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    window_->session().import({file.fileName().toStdString()});
    waitUntilComputed();
  }
  window_->tree().selectThese({window_->page().document().features()[0]->id, last()});
  run("feature.minkowski.morph");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{3});
  waitUntilComputed();
  const FeatureId morph = last();
  window_->tree().select(morph);
  run("view.top");
  window_->view().fitTo({{-30, -40, 0}, {110, 60, 0}}, false);
  QTRY_VERIFY(window_->view().sharp());

  const Bounds shape =
      bounds(window_->session().view(window_->page().document().features()[1]->id)->result->evaluated.shape);
  const QPoint start = screenOf(shape.center());
  constexpr int moves = 100;
  test::moveMouse(&window_->view(), start);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, start);
  int pictures = 0;
  const auto painted = connect(&window_->view(), &ViewWidget::framePainted, this, [&] { ++pictures; });
  application().restart();
  for (int i = 1; i <= moves; ++i) {
    test::moveMouse(&window_->view(), start + QPoint(i, i / 2));
    QCoreApplication::processEvents();
  }
  waitUntilComputed();
  QTRY_VERIFY(window_->view().sharp());
  disconnect(painted);
  QVERIFY(window_->session().previewing());
  qInfo("figure drag_moves %d", moves);
  qInfo("figure drag_pictures %d", pictures);
  application().print("drag");
  for (const auto& [part, name] : parts)
    if (part != WindowPart::Actors) QVERIFY2(application().busiest(part) <= 1, name);
  // The title, the undo texts and the tabs stay the same until the shape is let go.
  QCOMPARE(application().count(WindowPart::Tabs), 0);
  QCOMPARE(application().count(WindowPart::Actions), 0);
  QCOMPARE(application().count(WindowPart::StartPage), 0);
  // Only the morph changes, in each evaluation once.
  QVERIFY(application().count(WindowPart::Actors) <= application().count(WindowPart::View));

  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, start + QPoint(moves, moves / 2));
  const Value offsets = window_->page().document().at(morph).parameters.at("offsets");
  QVERIFY2(offsets.at(1).at(0).get<double>() > 5, offsets.dump().c_str());
}

void RefreshTest::openCrowd() {
  App app = loadApp({});
  auto registry = std::make_shared<Registry>(*app.registry);
  registry->add(tetrahedron());
  app.registry = registry;
  window_ = std::make_unique<MainWindow>(app);
  window_->resize(1000, 700);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  run("file.new");
  window_->session().commit(crowd(), QStringLiteral("Begin"));
  waitUntilComputed();
  window_->view().fit(false);
  window_->tree().select("t3");
  QTRY_VERIFY(window_->view().sharp());
}

void RefreshTest::resizeFirst(double size) {
  Feature first = window_->page().document().at("t0");
  first.parameters["size"] = size;
  window_->session().commit(window_->page().document().with(first), QStringLiteral("Resize"));
}

void RefreshTest::anEditOfManyFeaturesRefreshesOnceAPicture() {
  auto random = test::seededRandom();
  openCrowd();
  int pictures = 0;
  connect(&window_->view(), &ViewWidget::framePainted, this, [&] { ++pictures; });
  resizeFirst(std::uniform_real_distribution(2.0, 11.0)(random));
  waitUntilComputed();  // as after any edit: results are at hand
  QTRY_VERIFY(window_->view().sharp());

  pictures = 0;
  const int drawnBefore = window_->view().framesDrawn();
  application().restart();
  resizeFirst(12 + std::uniform_real_distribution(2.0, 11.0)(random));
  waitUntilComputed();
  QTRY_VERIFY(window_->view().sharp());
  const int drawn = window_->view().framesDrawn() - drawnBefore;
  qInfo("figure crowd_pictures %d", drawn);
  qInfo("figure crowd_pictures_on_screen %d", pictures);
  application().print("crowd");

  QVERIFY(application().count(WindowPart::View) >= 1);
  QVERIFY(application().count(WindowPart::View) <= drawn);
  QCOMPARE(application().count(WindowPart::Actors), 1 + followers);
  for (const auto& [part, name] : parts)
    if (part != WindowPart::Actors) QVERIFY2(application().busiest(part) <= 1, name);
  QCOMPARE(application().count(WindowPart::StartPage), 0);
}

static int runRefreshTest(int argc, char** argv) {
  blossom::ui::prepareApplication();
  return blossom::test::runTest<RefreshTest, CountingApplication>(argc, argv);
}
BLOSSOM_TEST_RUN(RefreshTest, runRefreshTest)
#include "refresh_test.moc"
