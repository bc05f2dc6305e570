#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include <vtkActor.h>
#include <vtkProp.h>

#include "app/app.h"
#include "document/storage.h"
#include "support/support.h"
#include "ui/application.h"
#include "ui/document_tree.h"
#include "ui/error_bar.h"
#include "ui/main_window.h"
#include "ui/parameter_field.h"
#include "ui/property_panel.h"
#include "ui/ratio_slider.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/view_widget.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

QString propeller() { return QString::fromStdString(test::sample("propeller.json").string()); }

/// Share of pixels of two pictures that differ clearly.
double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 1;
  qint64 different = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      if (std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > 40) ++different;
    }
  return double(different) / (double(a.width()) * a.height());
}

/// The canvas without the cube in its corner.
QImage canvas(MainWindow& window) { return window.view().grabFramebuffer().convertToFormat(QImage::Format_RGB32); }

double colored(const QImage& image, const QColor& color) {
  qint64 found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int turn = std::abs(pixel.hsvHue() - color.hsvHue());
      if (pixel.hsvSaturation() > 90 && std::min(turn, 360 - turn) < 14) ++found;
    }
  return double(found) / (double(image.width()) * image.height());
}

}  // namespace

class WindowTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void anEmptyWindowOffersSamples();
  void theSampleIsComputedAndDrawn();
  void draggingOrbitsAndWheelZooms();
  void fitBringsEverythingBack();
  void clickingSelects();
  void idleDrawsNothing();
  void undoAndRedoOfAParameter();
  void aWrongValueKeepsTheOldOneAndSaysWhy();
  void namesAndVisibilityAreEdits();
  void savedAndOpenedAgainItIsTheSame();
  void aBrokenFileIsSaidInPlace();
  void aDamagedDocumentOffersWhatIsReadable();
  void themesChangeCanvasAndPalette();
  void aFeatureIsAddedFromItsMenu();
  void exportedPictureIsAPicture();
  void unsavedChangesAreAskedFor();
  void escapeCancelsWork();
  void droppedFilesAreOpenedOrAdded();
  void selectedFeaturesAreHiddenByOneEdit();
  void figuresReadWell();

 private:
  void openPropeller();
  FeatureId sweep() const;
  void answer(QMessageBox::StandardButton, bool& asked);
  std::unique_ptr<MainWindow> window_;
  QTemporaryDir folder_;
};

void WindowTest::initTestCase() {
  setUpApplication();
  qputenv("XDG_CACHE_HOME", folder_.path().toLocal8Bit());
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void WindowTest::init() {
  window_ = std::make_unique<MainWindow>(loadApp({test::buildFolder() / "lib/blossom/plugins"}));
  window_->resize(1000, 700);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  QApplication::setActiveWindow(window_.get());  // no window manager does it; shortcuts need it
  QVERIFY2(window_->view().problem().isEmpty(), qPrintable(window_->view().problem()));
}

void WindowTest::cleanup() { window_.reset(); }

FeatureId WindowTest::sweep() const {
  for (const auto& feature : window_->session().document().features())
    if (feature->type == "sweep.sweep") return feature->id;
  return {};
}

void WindowTest::openPropeller() {
  QSignalSpy finished(&window_->session(), &Session::evaluationFinished);
  window_->openFile(propeller());
  QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty() && !window_->session().evaluating(), 60000);
  QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
  QVERIFY(!sweep().empty());
  const int frames = window_->view().framesDrawn();
  window_->view().update();
  QTRY_VERIFY(window_->view().framesDrawn() > frames);
}

void WindowTest::anEmptyWindowOffersSamples() {
  auto* card = window_->findChild<QWidget*>(QStringLiteral("startCard"));
  QVERIFY(card && card->isVisible());
  QVERIFY(card->findChildren<QPushButton*>(QStringLiteral("tile")).size() >= 5);
  openPropeller();
  QVERIFY(!card->isVisible());
}

void WindowTest::theSampleIsComputedAndDrawn() {
  openPropeller();
  const auto view = window_->session().view(sweep());
  QVERIFY(view && !view->result->error);
  QCOMPARE(QString::fromStdString(view->measures.kind), QStringLiteral("surface"));
  QVERIFY(stateLine(view->measures).startsWith(QStringLiteral("surface 9 × 12, ")));
  QVERIFY(view->scene.faces->GetNumberOfPolys() > 1000);
  QVERIFY(!window_->session().modified());
  // Selected, hence in the warm accent.
  QCOMPARE(window_->tree().current(), sweep());
  QVERIFY2(colored(canvas(*window_), theme().color("made")) > 0.05, "the propeller is not seen");
}

void WindowTest::draggingOrbitsAndWheelZooms() {
  openPropeller();
  ViewWidget& view = window_->view();
  const QImage before = canvas(*window_);
  const QPoint from(200, 400), to(330, 350);
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(&view, from + (to - from) * i / 5);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  const QImage orbited = canvas(*window_);
  QVERIFY(difference(before, orbited) > 0.03);

  qInfo("frame of the propeller (%lld triangles) at %d x %d: %.1f ms",
        static_cast<long long>(window_->session().view(sweep())->scene.faces->GetNumberOfPolys()), view.width(),
        view.height(), view.lastFrameMs());

  const Turn turn = view.camera().turn();
  QTest::mousePress(&view, Qt::RightButton, {}, from);
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(&view, from + (to - from) * i / 5);
  QTest::mouseRelease(&view, Qt::RightButton, {}, to);
  QCOMPARE(view.camera().turn().yaw, turn.yaw);
  QVERIFY(difference(orbited, canvas(*window_)) > 0.03);

  // The point under the cursor stays there.
  const QPointF at(420, 260);
  const double scale = view.camera().millimetresPerPixel();
  const auto pointUnder = [&] {
    const auto ray = view.camera().rayThrough(at);
    const Vec3 back = view.camera().turn().toCamera();
    return Vec3(ray.origin - ray.direction * ((ray.origin - view.camera().target()).dot(back) / ray.direction.dot(back)));
  };
  const Vec3 under = pointUnder();
  QWheelEvent wheel(at, view.mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view, &wheel);
  QVERIFY(view.camera().millimetresPerPixel() < scale);
  COMPARE_NEAR((pointUnder() - under).norm(), 0, 1e-9 * (1 + under.norm()));
}

void WindowTest::fitBringsEverythingBack() {
  openPropeller();
  ViewWidget& view = window_->view();
  view.fit(false);
  const QImage fitted = canvas(*window_);
  for (int i = 0; i < 8; ++i) view.zoomBy(2.5);
  QVERIFY(difference(fitted, canvas(*window_)) > 0.03);
  QTest::keyClick(window_.get(), Qt::Key_F);
  QTRY_VERIFY(difference(fitted, canvas(*window_)) < 0.001);
  QTest::keyClick(window_.get(), Qt::Key_5);
  QTRY_COMPARE(view.camera().turn().pitch, 90.0);
}

void WindowTest::clickingSelects() {
  openPropeller();
  ViewWidget& view = window_->view();
  view.lookFrom(QStringLiteral("top"), false);
  QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(12, view.height() - 12));
  QVERIFY(window_->tree().selected().empty());
  const double grey = colored(canvas(*window_), theme().color("made"));
  QVERIFY(grey < 0.01);
  // Somewhere on a line through the middle there is the shape.
  for (int x = 40; x < view.width() - 40 && window_->tree().selected().empty(); x += 20)
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(x, view.height() / 2));
  QCOMPARE(window_->tree().current(), sweep());
  QVERIFY(colored(canvas(*window_), theme().color("made")) > 0.03);
}

void WindowTest::idleDrawsNothing() {
  openPropeller();
  QTRY_VERIFY(window_->view().sharp());
  QTest::qWait(100);
  const int frames = window_->view().framesDrawn();
  QTest::qWait(300);
  QCOMPARE(window_->view().framesDrawn(), frames);
}

void WindowTest::undoAndRedoOfAParameter() {
  openPropeller();
  ParameterField* mode = window_->properties().field(QStringLiteral("mode"));
  QVERIFY(mode);
  auto* box = mode->findChild<QComboBox*>();
  QTest::keyClick(box, Qt::Key_Down);
  QCOMPARE(window_->session().document().at(sweep()).parameters.at("mode").get<std::string>(), std::string("cubic"));
  QVERIFY(window_->isWindowModified());
  QCOMPARE(qt(window_->session().history().undoText()), QStringLiteral("Change mode of Sweep"));
  const auto degree = [&] {
    const auto view = window_->session().view(sweep());
    for (const Measure& measure : view->measures.values)
      if (measure.name == "degree_u" && !view->result->error) return std::get<std::int64_t>(measure.value);
    return std::int64_t(-1);
  };
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && degree() == 3, 60000);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && degree() == 9, 60000);
  QVERIFY(!window_->isWindowModified());
  QCOMPARE(box->currentText(), QStringLiteral("exact"));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && degree() == 3, 60000);
}

void WindowTest::aWrongValueKeepsTheOldOneAndSaysWhy() {
  openPropeller();
  ParameterField* tolerance = window_->properties().field(QStringLiteral("tolerance"));
  QVERIFY(tolerance);
  auto* line = tolerance->findChild<QLineEdit*>();
  const Value before = tolerance->value();
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("-3 mm"));
  QTest::keyClick(line, Qt::Key_Return);
  QVERIFY(!tolerance->problem().isEmpty());
  QVERIFY2(tolerance->problem().front().isUpper() || tolerance->problem().front() == u'"', qPrintable(tolerance->problem()));
  QCOMPARE(tolerance->value(), before);
  QVERIFY(!window_->session().modified());
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("1/4 in"));
  QTest::keyClick(line, Qt::Key_Return);
  QVERIFY2(tolerance->problem().isEmpty(), qPrintable(tolerance->problem()));
  COMPARE_NEAR(tolerance->value().get<double>(), 6.35, 1e-12);
  QCOMPARE(line->text(), QStringLiteral("6.35 mm"));
  QVERIFY(window_->session().modified());
}

void WindowTest::namesAndVisibilityAreEdits() {
  openPropeller();
  DocumentTree& tree = window_->tree();
  QVERIFY(tree.model()->setData(tree.currentIndex(), QStringLiteral("Blades"), Qt::EditRole));
  QCOMPARE(window_->session().document().at(sweep()).name, std::string("Blades"));
  tree.toggleVisible(sweep());
  QVERIFY(colored(canvas(*window_), theme().color("made")) < 0.01);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(colored(canvas(*window_), theme().color("made")) > 0.03);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window_->session().document().at(sweep()).name, std::string("Sweep"));
}

void WindowTest::savedAndOpenedAgainItIsTheSame() {
  openPropeller();
  const std::filesystem::path file = folder_.filePath(QStringLiteral("saved.blossom")).toStdString();
  DocumentTree& tree = window_->tree();
  tree.model()->setData(tree.currentIndex(), QStringLiteral("Blades"), Qt::EditRole);
  bool saved = false;
  window_->session().save(file, [&] { saved = true; });
  QTRY_VERIFY(saved);
  QVERIFY(!window_->isWindowModified());
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("saved.blossom")));
  const std::string written = toJson(window_->session().document());
  const auto area = [&] { return stateLine(window_->session().view(sweep())->measures); };
  QTRY_VERIFY(!window_->session().evaluating());
  const QString before = area();

  window_->session().clear();
  QVERIFY(window_->session().document().features().empty());
  QSignalSpy finished(&window_->session(), &Session::evaluationFinished);
  window_->openFile(qt(file.string()));
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !finished.isEmpty() && !window_->session().evaluating(), 60000);
  QCOMPARE(toJson(window_->session().document()), written);
  QCOMPARE(area(), before);
}

void WindowTest::aBrokenFileIsSaidInPlace() {
  const QString file = folder_.filePath(QStringLiteral("broken.step"));
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("ISO-10303-21; nothing of the sort");
  out.close();
  window_->openFile(file);
  const auto failedFeature = [&] {
    for (const auto& feature : window_->session().document().features()) {
      const auto view = window_->session().view(feature->id);
      if (view && view->result->error) return true;
    }
    return false;
  };
  // Either the file is refused, or the import feature keeps the error.
  QTRY_VERIFY_WITH_TIMEOUT(window_->errors().isVisible() || failedFeature(), 60000);
  window_->openFile(folder_.filePath(QStringLiteral("not-there.step")));
  QTRY_VERIFY(window_->errors().isVisible());
  QVERIFY(!window_->errors().message().isEmpty());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QVERIFY(window_->errors().isHidden());
}

void WindowTest::aDamagedDocumentOffersWhatIsReadable() {
  openPropeller();
  const QString file = folder_.filePath(QStringLiteral("damaged.blossom"));
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("PK\003\004 cut off");
  out.close();
  const std::string before = toJson(window_->session().document());
  window_->openFile(file);
  QTRY_VERIFY(window_->errors().isVisible());
  QCOMPARE(toJson(window_->session().document()), before);
  QVERIFY(window_->errors().findChild<QPushButton*>()->isVisible());
}

void WindowTest::themesChangeCanvasAndPalette() {
  openPropeller();
  const int dark = QApplication::palette().color(QPalette::Window).lightness();
  const int darkCanvas = qGray(canvas(*window_).pixel(20, 60));
  ThemeManager::instance().apply(ThemeChoice::Light);
  QVERIFY(QApplication::palette().color(QPalette::Window).lightness() > dark + 100);
  QVERIFY(qGray(canvas(*window_).pixel(20, 60)) > darkCanvas + 100);
  ThemeManager::instance().apply(ThemeChoice::Dark);
  QVERIFY(qGray(canvas(*window_).pixel(20, 60)) < darkCanvas + 10);
}

void WindowTest::aFeatureIsAddedFromItsMenu() {
  openPropeller();
  const FeatureId motion = window_->session().document().at(sweep()).inputs.front();
  window_->tree().select(motion);
  QAction* add = nullptr;
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->text() == QLatin1String("Sweep") && !action->menu()) add = action;
  QVERIFY(add);
  add->trigger();
  QCOMPARE(window_->session().document().features().size(), std::size_t(3));
  QCOMPARE(window_->session().document().features().back()->inputs, std::vector<FeatureId>{motion});
  QCOMPARE(qt(window_->session().history().undoText()), QStringLiteral("Add Sweep"));
}

void WindowTest::exportedPictureIsAPicture() {
  openPropeller();
  const QString file = folder_.filePath(QStringLiteral("propeller.png"));
  window_->session().exportFeature(sweep(), file.toStdString(), Value{{"size", "320x200"}});
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().job().running(), 60000);
  QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
  QCOMPARE(QImage(file).size(), QSize(320, 200));
  // Drawing elsewhere has left the window's own context alone.
  QVERIFY(colored(canvas(*window_), theme().color("made")) > 0.03);
}

// Answers the next question by the button given; `asked` tells that there was one.
void WindowTest::answer(QMessageBox::StandardButton button, bool& asked) {
  QTimer::singleShot(0, window_.get(), [this, button, &asked] {
    auto* question = window_->findChild<QMessageBox*>();
    asked = question != nullptr;
    if (question) question->button(button)->click();
  });
}

void WindowTest::unsavedChangesAreAskedFor() {
  openPropeller();
  window_->tree().model()->setData(window_->tree().currentIndex(), QStringLiteral("Blades"), Qt::EditRole);
  const std::string before = toJson(window_->session().document());
  bool asked = false;
  answer(QMessageBox::Cancel, asked);
  QVERIFY(!window_->close());
  QVERIFY(asked && window_->isVisible());
  asked = false;
  answer(QMessageBox::Cancel, asked);
  window_->openFile(propeller());
  QVERIFY(asked);
  QCOMPARE(toJson(window_->session().document()), before);

  // Saved first: the file has the change, then the window closes.
  const QString file = folder_.filePath(QStringLiteral("guarded.blossom"));
  bool saved = false;
  window_->session().save(file.toStdString(), [&] { saved = true; });
  QTRY_VERIFY(saved);
  window_->tree().model()->setData(window_->tree().currentIndex(), QStringLiteral("Four blades"), Qt::EditRole);
  asked = false;
  answer(QMessageBox::Save, asked);
  window_->close();
  QVERIFY(asked);
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(openDocument(file.toStdString()).document.at(sweep()).name, std::string("Four blades"));
}

void WindowTest::escapeCancelsWork() {
  openPropeller();
  std::optional<Error> end;
  bool ended = false;
  window_->session().job().start(
      QStringLiteral("Working"),
      [](const Progress& progress) {
        for (;;) progress.check();
      },
      [&](const std::optional<Error>& error) {
        end = error;
        ended = true;
      });
  QVERIFY(window_->session().job().running());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QTRY_VERIFY(ended);
  QVERIFY(end && end->code() == ErrorCode::Cancelled);
  QVERIFY(!window_->session().job().running());

  // An evaluation that is cancelled leaves what was there, and the next edit computes again.
  auto* box = window_->properties().field(QStringLiteral("mode"))->findChild<QComboBox*>();
  QTest::keyClick(box, Qt::Key_Down);
  window_->session().cancel();
  QVERIFY(!window_->session().evaluating());
  QVERIFY(window_->session().view(sweep()));
  window_->session().undo();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating(), 60000);
  QVERIFY(!window_->session().view(sweep())->result->error);
}

void WindowTest::droppedFilesAreOpenedOrAdded() {
  const auto drop = [&](const QStringList& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent event(QPointF(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &event);
    return event.isAccepted();
  };
  QVERIFY(!drop({}));
  QVERIFY(drop({propeller()}));
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !window_->session().evaluating(), 60000);
  const std::size_t count = window_->session().document().features().size();
  const QString drawing = folder_.filePath(QStringLiteral("drawing.svg"));
  QFile out(drawing);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("<svg xmlns='http://www.w3.org/2000/svg'><rect width='40' height='20'/></svg>");
  out.close();
  QVERIFY(drop({drawing}));
  QTRY_COMPARE_WITH_TIMEOUT(window_->session().document().features().size(), count + 1, 60000);
  QVERIFY(window_->session().modified());
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating(), 60000);
  window_->session().undo();
  QCOMPARE(window_->session().document().features().size(), count);
}

void WindowTest::selectedFeaturesAreHiddenByOneEdit() {
  openPropeller();
  window_->tree().selectAll();
  QTest::keyClick(window_.get(), Qt::Key_H);
  const auto features = window_->session().document().features();
  QVERIFY(std::all_of(features.begin(), features.end(),
                      [&](const auto& feature) { return feature->visible == features.front()->visible; }));
  window_->session().undo();
  QVERIFY(!window_->isWindowModified());
}

void WindowTest::figuresReadWell() {
  QCOMPARE(counted(QStringLiteral("84"), QStringLiteral("vertex")), QStringLiteral("84 vertices"));
  QCOMPARE(counted(QStringLiteral("4"), QStringLiteral("assembly")), QStringLiteral("4 assemblies"));
  QCOMPARE(counted(QStringLiteral("1"), QStringLiteral("face")), QStringLiteral("1 face"));
  QCOMPARE(counted(QStringLiteral("29"), QStringLiteral("LINE")), QStringLiteral("29 LINE"));
  QCOMPARE(measureLabel("trajectory_degree_u"), QStringLiteral("Trajectory degree in u"));
  QCOMPARE(measureLabel("length_mm") + statUnit("length_mm"), QStringLiteral("Length mm"));
  QVERIFY(!worthReading("refinements", 0) && worthReading("refinements", 2) && !worthReading("skipped", Value::object()));
  const QString thin(QChar(0x2009));
  QCOMPARE(readable(1842.6), QStringLiteral("1") + thin + QStringLiteral("842.6"));
  QCOMPARE(readable(0.0), QStringLiteral("0"));
  QCOMPARE(readable(0.25), QStringLiteral("0.25"));
  QCOMPARE(readable(-1234567.0),
           QChar(0x2212) + QStringLiteral("1") + thin + QStringLiteral("234") + thin + QStringLiteral("567"));
  QCOMPARE(readable(std::int64_t(999)), QStringLiteral("999"));
  QCOMPARE(readable(3e-7), QStringLiteral("3.00e") + QChar(0x2212) + QStringLiteral("07"));
}

int main(int argc, char** argv) {
  prepareApplication();
  QApplication application(argc, argv);
  WindowTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "window_test.moc"
