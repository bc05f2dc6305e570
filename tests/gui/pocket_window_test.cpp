#include <QDir>
#include <QFile>

#include "exchange/format/format.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/check/simulate.h"
#include "support/planar_parts.h"
#include "support/rs274.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// A spline outline with a round island, as another program would have drawn it.
Curves drawing() { return {{test::wavyPath({0, 0}, 40, 7, 5), test::circlePath({4, 3}, 9)}, FillRule::EvenOdd}; }

}  // namespace

/// A drawing is imported, a pocket of it cut and saved as a program: the way of a user through the real window.
class PocketWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void aPocketProgramIsSaved();
  void aWrongOptionKeepsTheExportOpen();
  void theSavedProgramIsSimulated();
  void aToolThatDoesNotFitIsRefusedAndTheDocumentLivesOn();
  void rapidsPlungesAndFeedsAreToldApart();
  void aClampThatIsMovedIntoTheWayIsTold();
  void picturesOfThePocket();

 private:
  [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  void pocketTheDrawing();
  void takePictures(const std::string& name);
  [[nodiscard]] Toolpath toolpath(const FeatureId& id) const {
    return *window_->session().view(id)->result->evaluated.shape.get<Toolpath>();
  }
  FeatureId drawing_, pocket_;
};

void PocketWindowTest::init() {
  openWindow();
  run("file.new");
  pocketTheDrawing();
}

/// From the file to the toolpath.
void PocketWindowTest::pocketTheDrawing() {
  writeShape(*window_->session().app().formats, drawing(), path("cover.dxf").toStdString());
  QVERIFY(drop({path("cover.dxf")}));
  waitUntilComputed();
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{1});
  waitUntilComputed();
  drawing_ = last();
  window_->tree().select(drawing_);
  run("feature.pocket.pocket");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{2});
  pocket_ = last();
  edit("tool-diameter", "8 mm");
  edit("depth", "6 mm");
  edit("stepdown", "3 mm");
  edit("stepover", "40%");
  edit("finish", "0.2 mm");
  waitUntilComputed();
  const auto view = window_->session().view(pocket_);
  QVERIFY2(!view->result->error, view->result->error ? view->result->error->what() : "");
}

void PocketWindowTest::aPocketProgramIsSaved() {
  QCOMPARE(measureOf(pocket_, "passes"), 2.0);
  QCOMPARE(measureOf(pocket_, "residue_mm2"), 0.0);
  QVERIFY(measureOf(pocket_, "gouge_mm") < 0.005);
  QVERIFY(measureOf(pocket_, "length_mm") > 1000);
  window_->tree().select(pocket_);
  exportAs("gcode", path("cover.ngc"));
  QVERIFY(QFile::exists(path("cover.ngc")));
  // Whoever takes the file to a machine reads what was doubtful.
  for (const std::string& warning : window_->session().view(pocket_)->result->evaluated.warnings)
    QVERIFY2(window_->errors().hint().contains(QString::fromStdString(warning)), warning.c_str());
  if (!test::haveInterpreter()) QSKIP("LinuxCNC's interpreter rs274 is not installed");
  const test::Interpreted run = test::interpret(path("cover.ngc").toStdString());
  QVERIFY2(run.good, run.log.c_str());
  Toolpath driven = run.path;
  driven.cutter.diameter = 8;
  const pocket::SimulationResult swept = pocket::simulate(driven, toRegion(drawing()), {.depth = 6, .tolerance = 0.02});
  QVERIFY(swept.gouge < 0.0055);
  QCOMPARE(*swept.residue, 0.0);
  QCOMPARE(swept.rapidsInStock, std::size_t{0});
}

void PocketWindowTest::aWrongOptionKeepsTheExportOpen() {
  window_->tree().select(pocket_);
  run("file.export");
  const QPointer<ExportDialog> dialog = window_->findChild<ExportDialog*>();
  QVERIFY(dialog);
  dialog->choose(QStringLiteral("gcode"));
  ParameterField* decimals = nullptr;
  for (auto* field : dialog->findChildren<ParameterField*>())
    if (field->spec().name == "decimals") decimals = field;
  QVERIFY(decimals);
  auto* const line = decimals->findChild<QLineEdit*>();
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("0"));
  dialog->accept();
  QVERIFY(dialog && dialog->isVisible());
  QVERIFY2(decimals->problem().contains(QStringLiteral("between 2 and 6")), qPrintable(decimals->problem()));
  dialog->reject();
}

void PocketWindowTest::theSavedProgramIsSimulated() {
  window_->tree().select(pocket_);
  exportAs("gcode", path("again.ngc"));
  QVERIFY(drop({path("again.ngc")}));
  waitUntilComputed();
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{3});
  waitUntilComputed();
  const FeatureId program = last();
  window_->tree().selectThese({program, drawing_});
  run("feature.pocket.simulate");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{4});
  waitUntilComputed();
  const auto view = window_->session().view(last());
  QVERIFY2(!view->result->error, view->result->error ? view->result->error->what() : "");
  QCOMPARE(window_->page().document().at(last()).inputs, (std::vector<FeatureId>{program, drawing_}));
  QCOMPARE(measureOf(last(), "residue_mm2"), 0.0);
  QVERIFY(measureOf(last(), "gouge_mm") < 0.0055);
  // a larger tool in the spindle than the program was made for
  edit("tool-diameter", "9 mm");
  waitUntilComputed();
  COMPARE_NEAR(measureOf(last(), "gouge_mm"), 0.5, 0.006);
}

void PocketWindowTest::aToolThatDoesNotFitIsRefusedAndTheDocumentLivesOn() {
  window_->tree().select(pocket_);
  edit("tool-diameter", "60 mm");
  waitUntilComputed();
  const auto view = window_->session().view(pocket_);
  QVERIFY(view->result->error);
  const QString hint = QString::fromStdString(view->result->error->hint());
  const QRegularExpressionMatch fits = QRegularExpression(QStringLiteral("diameter of ([0-9.]+) mm")).match(hint);
  QVERIFY2(fits.hasMatch(), qPrintable(hint));
  edit("tool-diameter", fits.captured(1).toLatin1().constData());
  waitUntilComputed();
  QVERIFY(!window_->session().view(pocket_)->result->error);
  window_->session().undo();
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(toolpath(pocket_).cutter.diameter, 8.0);
}

void PocketWindowTest::rapidsPlungesAndFeedsAreToldApart() {
  window_->tree().select(drawing_);
  window_->view().fitTo({{-50, -50, -8}, {50, 50, 6}}, false);
  window_->tree().select({});
  const QImage picture = canvas();
  // the colours of what cuts and of what goes down, as the tessellation gives them
  QVERIFY(colored(picture, QColor::fromRgbF(0.16F, 0.62F, 0.56F)) > 0.01);
  QVERIFY(colored(picture, QColor::fromRgbF(0.86F, 0.27F, 0.36F)) > 0.0002);
  const Toolpath path = toolpath(pocket_);
  for (const MoveKind kind : {MoveKind::Rapid, MoveKind::Plunge, MoveKind::Feed})
    QVERIFY(std::any_of(path.moves.begin(), path.moves.end(), [&](const ToolMove& m) { return m.kind == kind; }));
}

/// The document lives on, and undo brings the toolpath back.
void PocketWindowTest::aClampThatIsMovedIntoTheWayIsTold() {
  openAndWait(QString::fromStdString(test::sample("clamped-block.blossom").string()));
  pocket_ = last();
  QVERIFY(!toolpath(pocket_).moves.empty());
  Feature setup = window_->page().document().at("setup-1");
  setup.parameters["clamps"][0]["corner"] = {30, 15, 18};
  window_->session().commit(window_->page().document().with(setup), QStringLiteral("Move a clamp"));
  waitUntilComputed();
  const auto error = window_->session().view(pocket_)->result->error;
  QVERIFY(error);
  QVERIFY2(error->message().find("clamp 1") != std::string::npos, error->message().c_str());
  run("edit.undo");
  waitUntilComputed();
  QVERIFY(!window_->session().view(pocket_)->result->error);
}

void PocketWindowTest::picturesOfThePocket() {
  window_->resize(1280, 800);
  takePictures("pocket-of-import");
  for (const char* name : {"pocket-cover", "pocket-sign", "clamped-block"}) {
    openAndWait(QString::fromStdString(test::sample(name + std::string(".blossom")).string()));
    pocket_ = last();
    takePictures(name);
  }
}

/// Kept where BLOSSOM_PICTURES says, to be looked at.
void PocketWindowTest::takePictures(const std::string& name) {
  window_->tree().select(pocket_);
  run("view.home");
  run("view.fit");
  QVERIFY(!canvas().isNull());
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    QVERIFY(!canvas().isNull());
    const char* const ending = choice == ThemeChoice::Light ? "-light.png" : "-dark.png";
    const QString file = QDir(folder).filePath(QString::fromStdString(name + ending));
    if (!folder.isEmpty()) QVERIFY(window_->grab().save(file));
  }
}

BLOSSOM_WINDOW_TEST(PocketWindowTest)
#include "pocket_window_test.moc"
