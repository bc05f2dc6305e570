// A part and a morph from an empty window with few clicks, as somebody who knows the program makes them: the mouse sends X
// events, which are counted; commands come from menus and from the palette (Ctrl+K).
#include <QToolButton>
#include <numbers>

#include "exchange/format/format.h"
#include "geometry/measure/measure.h"
#include "menu_clicks.h"
#include "ui/page/page.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/tree/document_delegate.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"
#include "x_mouse.h"

using namespace blossom;
using namespace blossom::ui;

class FirstPartTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openNewDocument();
    window_->resize(1280, 720);
    mouse_ = std::make_unique<test::XMouse>();
    QVERIFY2(mouse_->there(), "The X server takes no events: libXtst.so.6 is not there.");
  }
  void cleanup() {
    mouse_.reset();
    window_.reset();
  }
  void aPartInSixteenClicks();
  void aPlayingMorphInFive();

 private:
  [[nodiscard]] ViewWidget& view() { return window_->view(); }
  [[nodiscard]] DocumentTree& tree() { return window_->tree(); }
  [[nodiscard]] const Document& document() { return window_->page().document(); }
  void click(QWidget* widget, QPoint at, bool control = false) { mouse_->click(widget, at, control); }
  void click(QWidget* widget) { click(widget, widget->rect().center()); }
  void clickView(const Vec3& p, bool control = false) { click(&view(), screenOf(p), control); }

  void menu(const QString& title, const char* command) {
    test::clickMenu(*mouse_, *window_, title, command);
    waitUntilComputed();
  }
  /// A command by its name, with the keyboard alone.
  void palette(const char* words) {
    shortcut(Qt::Key_K);
    QTRY_VERIFY(QApplication::focusWidget() && QApplication::focusWidget()->inherits("QLineEdit"));
    QTest::keyClicks(QApplication::focusWidget(), QLatin1String(words));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCoreApplication::processEvents();
    waitUntilComputed();
  }
  /// A value for a field: one click, or none when Tab has gone there.
  void type(const char* parameter, const char* value, bool tab = false) {
    ParameterField* field = window_->page().properties().field(QLatin1String(parameter));
    QVERIFY2(field, parameter);
    auto* line = field->findChild<QLineEdit*>();
    for (int k = 0; tab && k < 3 && !line->hasFocus(); ++k) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    if (!tab) click(line);
    QTRY_VERIFY2(line->hasFocus(), parameter);
    QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(line, QLatin1String(value));
    QTest::keyClick(line, Qt::Key_Return);
    ++values_;
    waitUntilComputed();
  }
  /// A key of the window, which a window manager would have made active again after a dialog.
  void shortcut(Qt::Key key) {
    window_->activateWindow();
    QTRY_VERIFY(window_->isActiveWindow());
    QTest::keyClick(window_.get(), key, Qt::ControlModifier);
  }
  /// The name of a file in the dialog that a command opens.
  void answerFile(const QString& file) {
    auto* answering = new QTimer(window_.get());
    connect(answering, &QTimer::timeout, answering, [answering, file] {
      auto* chooser = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!chooser) return;
      answering->deleteLater();
      auto* name = chooser->findChild<QLineEdit*>();
      name->setText(file);
      QTest::keyClick(name, Qt::Key_Return);
    });
    answering->start(20);
  }
  void unfold(const FeatureId& id) {
    const QModelIndex row = static_cast<DocumentModel*>(tree().model())->indexOf(id);
    if (row.data(DocumentModel::FoldedRole).toBool())
      click(tree().viewport(), DocumentDelegate::foldRect(tree().visualRect(row), row).center());
  }

  std::unique_ptr<test::XMouse> mouse_;
  int values_ = 0;
};

void FirstPartTest::aPartInSixteenClicks() {
  const double pi = std::numbers::pi;
  menu(QStringLiteral("Modeling"), "feature.modeling.rectangle");
  const FeatureId rectangle = last();
  type("width", "60");
  type("height", "40", true);
  COMPARE_NEAR(measureOf(rectangle, "area"), 2400.0, 1e-9);
  palette("extrude");
  type("height", "20");
  COMPARE_NEAR(measureOf(last(), "volume"), 48000.0, 1e-6);

  view().lookFrom(QStringLiteral("iso"), false);
  QTRY_VERIFY(view().sharp());
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_3, Qt::ShiftModifier);
  clickView({-30, -20, 10});
  clickView({30, -20, 10}, true);
  palette("fillet");
  type("radius", "5");
  const double corner = (1 - pi / 4) * 25;
  COMPARE_NEAR(measureOf(last(), "volume"), (2400 - 2 * corner) * 20, 1e-3);
  const FeatureId rounded = last();

  palette("cylinder");
  type("radius", "8");
  palette("boolean");
  auto* operation = window_->page().properties().field(QStringLiteral("operation"))->findChild<QComboBox*>();
  click(operation);
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("diff"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  waitUntilComputed();
  const FeatureId part = last();
  QCOMPARE(document().at(part).inputs.front(), rounded);
  COMPARE_NEAR(measureOf(part, "volume"), (2400 - 2 * corner - pi * 64) * 20, 1e-3);

  unfold(part);
  unfold(rounded);
  const QModelIndex row = static_cast<DocumentModel*>(tree().model())->indexOf(rectangle);
  QVERIFY(!tree().isRowHidden(row.row()));
  click(tree().viewport(), tree().visualRect(row).center());
  type("width", "70");
  const auto changed = [&] { return (2800 - 2 * corner - pi * 64) * 20; };
  COMPARE_NEAR(measureOf(part, "volume"), changed(), 1e-3);
  for (const auto& feature : document().features()) QVERIFY(feature->visible);

  const QString file = folder_.filePath(QStringLiteral("part.blossom")),
                step = folder_.filePath(QStringLiteral("part.step"));
  answerFile(file);
  shortcut(Qt::Key_S);
  QTRY_VERIFY(QFile::exists(file) && !window_->session().writing());
  answerFile(file);
  shortcut(Qt::Key_W);
  QTRY_VERIFY(document().features().empty());
  shortcut(Qt::Key_O);
  QTRY_VERIFY(!document().features().empty());
  waitUntilComputed();
  COMPARE_NEAR(measureOf(part, "volume"), changed(), 1e-3);

  exportAs("step", step);
  const Imported read = readShape(*window_->session().app().formats, step.toStdString());
  for (const Measure& measure : measure(read.shape).values)
    if (measure.name == "volume") COMPARE_NEAR(std::get<double>(measure.value), changed(), 1e-3);
  qInfo("figure part_clicks %d", mouse_->clicks());
  qInfo("figure part_values %d", values_);
  QVERIFY(mouse_->clicks() <= 16);
  QVERIFY(values_ <= 6);
}

void FirstPartTest::aPlayingMorphInFive() {
  const auto button = [&](const char* command) -> QToolButton* {
    QAction* action = window_->commands().action(QLatin1String(command));
    for (QToolButton* each : window_->findChildren<QToolButton*>())
      if (each->defaultAction() == action && each->isVisible()) return each;
    return nullptr;
  };
  QVERIFY(button("feature.modeling.circle") && button("feature.minkowski.morph"));
  click(button("feature.modeling.circle"));
  waitUntilComputed();
  menu(QStringLiteral("Modeling"), "feature.modeling.star");
  click(button("feature.minkowski.morph"));
  waitUntilComputed();
  QCOMPARE(document().at(last()).type, std::string("minkowski.morph"));
  QTRY_VERIFY(window_->findChild<TimelineBar*>()->isVisible());
  QToolButton* play = nullptr;
  for (QToolButton* each : window_->findChild<TimelineBar*>()->findChildren<QToolButton*>())
    if (each->isVisible() && each->accessibleName().startsWith(QStringLiteral("Play"))) play = each;
  QVERIFY(play);
  click(play);
  QTRY_VERIFY(window_->page().playback().playing());
  qInfo("figure morph_clicks %d", mouse_->clicks());
  QVERIFY(mouse_->clicks() <= 5);
}

BLOSSOM_WINDOW_TEST(FirstPartTest)
#include "first_part_test.moc"
