// What is edited while a long computation runs, through the real window.
#include "support/gate.h"
#include "ui/jobs/jobs_list.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;
using test::Gate;

namespace {

FeatureType heldType(const std::shared_ptr<Gate>& held) {
  FeatureType type;
  type.id = "test.held";
  type.command = "held";
  type.title = "Held";
  type.summary = "A triangle that comes when it is let go.";
  ParameterSpec size = positiveLength();
  size.name = "size";
  size.help = "Length of an edge.";
  size.fallback = 10.0;
  type.parameters = {size};
  type.evaluate = [held](const Value& values, const Inputs&, const Progress& progress) {
    progress.report(0.5);
    held->pass(progress);
    const double s = values.at("size").get<double>();
    Mesh mesh;
    mesh.points = {Vec3::Zero(), s * Vec3::UnitX(), s * Vec3::UnitY()};
    mesh.faceVertices = {0, 1, 2};
    mesh.faceStarts = {0, 3};
    Evaluated out;
    out.shape = mesh;
    return out;
  };
  return type;
}

Feature feature(const char* type, const FeatureId& id, const Value& parameters = Value::object()) {
  Feature made;
  made.id = made.name = id;
  made.type = type;
  made.parameters = parameters;
  return made;
}

}  // namespace

class UndisturbedWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void cleanup() {
    held_->open = true;
    window_.reset();
  }
  void aBoxIsShownWhileAnotherFeatureIsComputed();
  void theWindowClosesWhileItComputes();

 private:
  void begin();
  std::shared_ptr<Gate> held_;
};

/// A window whose document computes one feature that is held.
void UndisturbedWindowTest::begin() {
  held_ = std::make_shared<Gate>();
  App app = loadApp({test::buildFolder() / "lib/blossom/plugins"});
  auto registry = std::make_shared<Registry>(*app.registry);
  registry->add(heldType(held_));
  app.registry = registry;
  window_ = std::make_unique<MainWindow>(app);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  run("file.new");
  window_->session().commit(Document().with(feature("test.held", "held")), QStringLiteral("Begin"));
  QTRY_COMPARE(held_->entered.load(), 1);
}

void UndisturbedWindowTest::aBoxIsShownWhileAnotherFeatureIsComputed() {
  begin();
  Session& session = window_->session();
  auto* const jobs = window_->findChild<JobsList*>();
  QTRY_COMPARE(jobs->running(), 1);
  const int rows = jobs->rowCount();
  const auto fraction = [&] { return jobs->data(jobs->index(0), JobsList::FractionRole).toDouble(); };
  QTRY_VERIFY(fraction() > 0.1);
  session.commit(session.document().with(feature("modeling.box", "box")), QStringLiteral("Add Box"));
  QTRY_VERIFY(session.view("box"));
  QVERIFY(!session.view("box")->result->error && !session.awaited("box"));
  QVERIFY(session.evaluating() && !session.view("held"));
  QTRY_VERIFY(session.awaited("held"));
  QCOMPARE(jobs->rowCount(), rows);  // it goes on in its row
  QCOMPARE(jobs->running(), 1);
  QTRY_VERIFY(fraction() > 0.1);
  QCOMPARE(held_->entered.load(), 1);
  QCOMPARE(held_->cancelled.load(), 0);

  // The cross ends all of it; what was ready stays.
  jobs->cancel(0);
  QVERIFY(!session.evaluating());
  QTRY_COMPARE(held_->cancelled.load(), 1);
  QVERIFY(session.view("box") && session.cancelled("held"));
  held_->open = true;
  session.compute();
  QTRY_VERIFY(session.view("held") && !session.evaluating());
  QCOMPARE(held_->entered.load(), 2);
  session.abandon();
}

void UndisturbedWindowTest::theWindowClosesWhileItComputes() {
  begin();
  Session& session = window_->session();
  session.commit(session.document().with(feature("modeling.box", "box")), QStringLiteral("Add Box"));
  session.abandon();
  window_.reset();
  QCOMPARE(held_->cancelled.load(), held_->entered.load());
}

BLOSSOM_WINDOW_TEST(UndisturbedWindowTest)
#include "undisturbed_window_test.moc"
