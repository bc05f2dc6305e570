#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include <vtkActor.h>
#include <vtkProp.h>

#include "document/storage.h"
#include "ui/controls/ratio_slider.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/text.h"
#include "ui/panel/property_panel.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

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

}  // namespace

class WindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void anEmptyWindowOffersSamples();
  void theSampleIsComputedAndDrawn();
  void draggingOrbitsAndWheelZooms();
  void fitBringsEverythingBack();
  void clickingSelects();
  void idleDrawsNothing();
  void undoAndRedoOfAParameter();
  void undoWhereAValueWasTyped();
  void aWrongValueKeepsTheOldOneAndSaysWhy();
  void namesAndVisibilityAreEdits();
  void themesChangeCanvasAndPalette();
  void aFeatureIsAddedFromItsMenu();
  void escapeCancelsWork();
  void selectedFeaturesAreHiddenByOneEdit();
};

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
  QVERIFY2(colored(canvas(), theme().color("made")) > 0.05, "the propeller is not seen");
}

void WindowTest::draggingOrbitsAndWheelZooms() {
  openPropeller();
  ViewWidget& view = window_->view();
  const QImage before = canvas();
  const QPoint from(200, 400), to(330, 350);
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 5; ++i) test::moveMouse(&view, from + (to - from) * i / 5);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  const QImage orbited = canvas();
  QVERIFY(difference(before, orbited) > 0.03);

  qInfo("frame of the propeller (%lld triangles) at %d x %d: %.1f ms",
        static_cast<long long>(window_->session().view(sweep())->scene.faces->GetNumberOfPolys()), view.width(),
        view.height(), view.lastFrameMs());

  const Turn turn = view.camera().turn();
  QTest::mousePress(&view, Qt::RightButton, {}, from);
  for (int i = 1; i <= 5; ++i) test::moveMouse(&view, from + (to - from) * i / 5);
  QTest::mouseRelease(&view, Qt::RightButton, {}, to);
  QCOMPARE(view.camera().turn().yaw, turn.yaw);
  QVERIFY(difference(orbited, canvas()) > 0.03);

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
  const QImage fitted = canvas();
  for (int i = 0; i < 8; ++i) view.zoomBy(2.5);
  QVERIFY(difference(fitted, canvas()) > 0.03);
  QTest::keyClick(window_.get(), Qt::Key_F);
  QTRY_VERIFY(difference(fitted, canvas()) < 0.001);
  QTest::keyClick(window_.get(), Qt::Key_5);
  QTRY_COMPARE(view.camera().turn().pitch, 90.0);
}

void WindowTest::clickingSelects() {
  openPropeller();
  ViewWidget& view = window_->view();
  view.lookFrom(QStringLiteral("top"), false);
  QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(12, view.height() - 12));
  QVERIFY(window_->tree().selected().empty());
  const double grey = colored(canvas(), theme().color("made"));
  QVERIFY(grey < 0.01);
  // Somewhere on a line through the middle there is the shape.
  for (int x = 40; x < view.width() - 40 && window_->tree().selected().empty(); x += 20)
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(x, view.height() / 2));
  QCOMPARE(window_->tree().current(), sweep());
  QVERIFY(colored(canvas(), theme().color("made")) > 0.03);
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

// The keyboard stays in the field after Return: the key belongs to the document then, and to the text while one is typed.
void WindowTest::undoWhereAValueWasTyped() {
  openPropeller();
  QTest::keyClick(window_->properties().field(QStringLiteral("mode"))->findChild<QComboBox*>(), Qt::Key_Down);
  const auto tolerance = [&] {
    const Value& set = window_->session().document().at(sweep()).parameters;
    return set.value("tolerance", 0.001);
  };
  const double before = tolerance();
  edit("tolerance", "0.5 mm");
  QCOMPARE(tolerance(), 0.5);
  auto* const line = window_->properties().field(QStringLiteral("tolerance"))->findChild<QLineEdit*>();
  QVERIFY(line->hasFocus());
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(tolerance(), before);
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(tolerance(), 0.5);
  QTest::keyClicks(line, QStringLiteral("7"));
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(tolerance(), 0.5);
  waitUntilComputed();
}

void WindowTest::aWrongValueKeepsTheOldOneAndSaysWhy() {
  openPropeller();
  ParameterField* tolerance = window_->properties().field(QStringLiteral("tolerance"));
  QVERIFY(tolerance && !tolerance->isVisible());  // the exact surface has none
  QTest::keyClick(window_->properties().field(QStringLiteral("mode"))->findChild<QComboBox*>(), Qt::Key_Down);
  QVERIFY(tolerance->isVisible());
  auto* line = tolerance->findChild<QLineEdit*>();
  const Value before = tolerance->value();
  const std::string document = toJson(window_->session().document());
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("-3 mm"));
  QTest::keyClick(line, Qt::Key_Return);
  QVERIFY(!tolerance->problem().isEmpty());
  QVERIFY2(tolerance->problem().front().isUpper() || tolerance->problem().front() == u'"', qPrintable(tolerance->problem()));
  QCOMPARE(tolerance->value(), before);
  QCOMPARE(toJson(window_->session().document()), document);
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("1/4 in"));
  QTest::keyClick(line, Qt::Key_Return);
  QVERIFY2(tolerance->problem().isEmpty(), qPrintable(tolerance->problem()));
  COMPARE_NEAR(tolerance->value().get<double>(), 6.35, 1e-12);
  QCOMPARE(line->text(), QStringLiteral("1/4 in"));  // what was typed stays
  QVERIFY(toJson(window_->session().document()) != document);
  waitUntilComputed();
}

void WindowTest::namesAndVisibilityAreEdits() {
  openPropeller();
  DocumentTree& tree = window_->tree();
  QVERIFY(tree.model()->setData(tree.currentIndex(), QStringLiteral("Blades"), Qt::EditRole));
  QCOMPARE(window_->session().document().at(sweep()).name, std::string("Blades"));
  tree.toggleVisible(sweep());
  QVERIFY(colored(canvas(), theme().color("made")) < 0.01);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(colored(canvas(), theme().color("made")) > 0.03);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window_->session().document().at(sweep()).name, std::string("Sweep"));
}

void WindowTest::themesChangeCanvasAndPalette() {
  openPropeller();
  const int dark = QApplication::palette().color(QPalette::Window).lightness();
  const int darkCanvas = qGray(canvas().pixel(20, 60));
  ThemeManager::instance().apply(ThemeChoice::Light);
  QVERIFY(QApplication::palette().color(QPalette::Window).lightness() > dark + 100);
  QVERIFY(qGray(canvas().pixel(20, 60)) > darkCanvas + 100);
  ThemeManager::instance().apply(ThemeChoice::Dark);
  QVERIFY(qGray(canvas().pixel(20, 60)) < darkCanvas + 10);
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

void WindowTest::selectedFeaturesAreHiddenByOneEdit() {
  openPropeller();
  const auto ids = [&] {
    std::vector<FeatureId> all;
    for (const auto& feature : window_->session().document().features()) all.push_back(feature->id);
    return all;
  };
  window_->tree().selectThese(ids());  // a step that has gone into the result is among them
  QTest::keyClick(window_.get(), Qt::Key_H);
  const auto features = window_->session().document().features();
  QVERIFY(!features.front()->visible);
  QVERIFY(std::all_of(features.begin(), features.end(),
                      [&](const auto& feature) { return feature->visible == features.front()->visible; }));
  window_->session().undo();
  QVERIFY(!window_->isWindowModified());
}

BLOSSOM_WINDOW_TEST(WindowTest)
#include "window_test.moc"
