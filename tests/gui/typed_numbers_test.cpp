// Numbers that were typed are kept: at the sides of what was drawn, as expressions, and under names, in the real window.
#include <QSignalSpy>
#include <QTableWidget>

#include "document/named_numbers.h"
#include "ui/fields/list_field.h"
#include "ui/fields/list_row.h"
#include "ui/look/preferences.h"
#include "ui/numbers/numbers_dialog.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class TypedNumbersTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openNewDocument(); }
  void cleanup() { window_.reset(); }
  void sidesOfARectangleAreTyped();
  void sidesOfADrawnRectangleAreTyped();
  void expressionsAtSidesOfADrawnOutline();
  void thePanelKeepsExpressionsOfOtherPoints();
  void aSlantedSideRefusesNames();
  void theSizeFieldBeginsWithThePresentSize();
  void enterAndEscapeLeaveTheEditing();
  void draggingKeepsWhatWasTyped();
  void namesAreUsedInFields();
  void theTableIsEditedInItsDialog();

 private:
  [[nodiscard]] ViewWidget& view() { return window_->view(); }
  [[nodiscard]] const Document& document() { return window_->page().document(); }
  void lookAtPlane() {
    view().lookFrom(QStringLiteral("top"), false);
    view().setParallel(true);
    QTRY_VERIFY(view().sharp());
  }
  /// Double-clicks the number that stands beside a side, away from it.
  void openNumber(const Vec3& middle, const Vec3& away, double pixels) {
    const QPoint at = screenOf(middle + pixels * view().camera().millimetresPerPixel() * away);
    test::moveMouse(&view(), at);
    QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(&view(), Qt::LeftButton, {}, at);
  }
  void setNumbers(const std::vector<NamedNumber>& table) {
    window_->session().commit(withNumbers(document(), *window_->session().app().registry, table), {});
    waitUntilComputed();
  }
  /// A closed outline of lines through these points, from the origin, selected and seen from above.
  FeatureId addOutline(const std::vector<Vec2>& corners) {
    Value segments = Value::array();
    for (const Vec2& corner : corners) segments.push_back({{"to", {corner.x(), corner.y(), 0}}});
    const FeatureId outline = add("modeling.outline", {{"start", {0, 0, 0}}, {"segments", segments}});
    lookAtPlane();
    window_->tree().select(outline);
    return outline;
  }
  void type(const char* text) {
    QTest::keyClicks(&view(), QLatin1String(text));
    QTest::keyClick(&view(), Qt::Key_Return);
    waitUntilComputed();
  }
  [[nodiscard]] Value parameter(const FeatureId& id, const char* name) { return document().at(id).parameters.at(name); }
};

void TypedNumbersTest::sidesOfARectangleAreTyped() {
  const FeatureId rectangle = add("modeling.rectangle", {{"width", 60}, {"height", 40}});
  lookAtPlane();
  window_->tree().select(rectangle);
  openNumber({0, 20, 0}, Vec3::UnitY(), 17);
  QCOMPARE(window_->tree().selected(), std::vector<FeatureId>{rectangle});
  type("2*35 mm");
  QCOMPARE(parameter(rectangle, "width"), Value("2*35 mm"));
  COMPARE_NEAR(measureOf(rectangle, "area"), 70.0 * 40, 1e-9);
  openNumber({35, 0, 0}, Vec3::UnitX(), 34);
  QTest::keyClicks(&view(), QStringLiteral("99"));
  QTest::keyClick(&view(), Qt::Key_Escape);
  QCOMPARE(document().at(rectangle).parameters.at("height").get<double>(), 40.0);
  openNumber({35, 0, 0}, Vec3::UnitX(), 34);
  type("5 kg");  // is refused, and can be corrected
  QCOMPARE(document().at(rectangle).parameters.at("height").get<double>(), 40.0);
  for (int k = 0; k < 4; ++k) QTest::keyClick(&view(), Qt::Key_Backspace);
  type("30");
  COMPARE_NEAR(measureOf(rectangle, "area"), 70.0 * 30, 1e-9);
  QCOMPARE(document().at(rectangle).type, std::string("modeling.rectangle"));
}

void TypedNumbersTest::sidesOfADrawnRectangleAreTyped() {
  run("feature.modeling.outline");
  QTRY_COMPARE(view().camera().turn().pitch, 90.0);
  clickAt({0, 0, 0});
  for (const char* entry : {"60<0", "40<90", "60<180"}) {
    moveTo({11, 7, 0});
    type(entry);
  }
  clickAt({0, 0, 0});
  waitUntilComputed();
  const FeatureId outline = last();
  COMPARE_NEAR(measureOf(outline, "area"), 60.0 * 40, 1e-9);
  lookAtPlane();
  window_->tree().select(outline);
  openNumber({30, 0, 0}, -Vec3::UnitY(), 17);
  type("75");
  COMPARE_NEAR(measureOf(outline, "area"), 75.0 * 40, 1e-9);
  openNumber({75, 20, 0}, Vec3::UnitX(), 34);
  type("1 in");
  COMPARE_NEAR(measureOf(outline, "area"), 75.0 * 25.4, 1e-9);
  QCOMPARE(measureOf(outline, "lines"), 4.0);
}

void TypedNumbersTest::expressionsAtSidesOfADrawnOutline() {
  setNumbers({{"width", "60 mm"}});
  const FeatureId outline = addOutline({{60, 0}, {60, 40}, {0, 40}});
  openNumber({30, 0, 0}, -Vec3::UnitY(), 17);
  type("width+20");
  COMPARE_NEAR(measureOf(outline, "area"), 80.0 * 40, 1e-9);
  const Value end{{"expression", "width+20"}, {"value", 80.0}};
  QCOMPARE(parameter(outline, "segments").at(0).at("to").at(0), end);
  setNumbers({{"width", "90 mm"}});
  COMPARE_NEAR(measureOf(outline, "area"), 110.0 * 40, 1e-9);
  // It is there again for the next edit, and goes on being one.
  lookAtPlane();
  openNumber({55, 0, 0}, -Vec3::UnitY(), 17);
  QTest::keyClick(&view(), Qt::Key_End);
  QTest::keyClick(&view(), Qt::Key_Backspace);
  type("5");
  COMPARE_NEAR(measureOf(outline, "area"), 115.0 * 40, 1e-9);
  setNumbers({{"width", "60 mm"}});
  COMPARE_NEAR(measureOf(outline, "area"), 85.0 * 40, 1e-9);
}

void TypedNumbersTest::thePanelKeepsExpressionsOfOtherPoints() {
  setNumbers({{"width", "60 mm"}});
  const FeatureId outline = addOutline({{60, 0}, {60, 40}, {0, 40}});
  openNumber({30, 0, 0}, -Vec3::UnitY(), 17);
  type("width+20");
  const auto& rows = dynamic_cast<ListField*>(window_->page().properties().field(QStringLiteral("segments")))->rows();
  const auto lineOf = [&](std::size_t row, const char* axis) {
    rows[row]->open(true);
    return rows[row]->field()->findChild<QLineEdit*>(QLatin1String(axis));
  };
  QCOMPARE(lineOf(0, "x")->text(), QStringLiteral("width+20"));
  QLineEdit* last = lineOf(2, "y");
  last->setFocus();
  last->selectAll();
  QTest::keyClicks(last, QStringLiteral("45"));
  QTest::keyClick(last, Qt::Key_Return);
  waitUntilComputed();
  const Value segments = parameter(outline, "segments");
  QCOMPARE(segments.at(2).at("to").at(1).get<double>(), 45.0);
  for (const int k : {0, 1}) QCOMPARE(segments.at(k).at("to").at(0).at("expression"), Value("width+20"));
}

void TypedNumbersTest::aSlantedSideRefusesNames() {
  setNumbers({{"width", "60 mm"}});
  const FeatureId outline = addOutline({{60, 0}, {60, 60}});
  const Value before = parameter(outline, "segments");
  const QSignalSpy hints(&window_->page(), &DocumentPage::hint);
  openNumber({30, 30, 0}, Vec3(-1, 1, 0).normalized(), 24);
  type("width");
  QCOMPARE(parameter(outline, "segments"), before);
  QVERIFY2(hints.last().at(0).toString().contains(QStringLiteral("slanted")), qPrintable(hints.last().at(0).toString()));
}

void TypedNumbersTest::theSizeFieldBeginsWithThePresentSize() {
  const FeatureId rectangle = add("modeling.rectangle", {{"width", "2*30 mm"}, {"height", 40}});
  lookAtPlane();
  window_->tree().select(rectangle);
  const QSignalSpy hints(&window_->page(), &DocumentPage::hint);
  const auto steps = [&] { return window_->session().history().undoText(); };
  const std::string before = steps();
  openNumber({0, 20, 0}, Vec3::UnitY(), 17);
  QVERIFY2(hints.last().at(0).toString().contains(QStringLiteral("Enter")), qPrintable(hints.last().at(0).toString()));
  QTest::keyClick(&view(), Qt::Key_Return);  // as it is: no edit
  QCOMPARE(steps(), before);
  openNumber({0, 20, 0}, Vec3::UnitY(), 17);
  QTest::keyClick(&view(), Qt::Key_Right);
  type(" + 5 mm");
  QCOMPARE(parameter(rectangle, "width"), Value("2*30 mm + 5 mm"));
  openNumber({32.5, 0, 0}, Vec3::UnitX(), 34);
  type("30");  // takes the place of what is selected
  COMPARE_NEAR(measureOf(rectangle, "area"), 65.0 * 30, 1e-9);
}

void TypedNumbersTest::enterAndEscapeLeaveTheEditing() {
  const FeatureId outline = addOutline({{60, 0}, {60, 40}, {0, 40}});
  for (const Qt::Key leaves : {Qt::Key_Escape, Qt::Key_Return}) {
    window_->tree().select(outline);
    QVERIFY(window_->page().tool());
    QTest::keyClick(&view(), leaves);
    QVERIFY(!window_->page().tool());
  }
}

void TypedNumbersTest::draggingKeepsWhatWasTyped() {
  const FeatureId rectangle = add("modeling.rectangle", {{"width", "2*30 mm"}, {"height", 40}});
  lookAtPlane();
  window_->tree().select(rectangle);
  QTest::mousePress(&view(), Qt::LeftButton, {}, screenOf({0, 0, 0}));
  for (const double x : {4.0, 9.0, 15.0}) QTest::mouseMove(&view(), screenOf({x, 7, 0}));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, screenOf({15, 7, 0}));
  waitUntilComputed();
  const Value& parameters = document().at(rectangle).parameters;
  QVERIFY(parameters.at("centre").at(0).get<double>() > 1);
  QCOMPARE(parameters.at("width"), Value("2*30 mm"));
  QVERIFY2(!parameters.contains("rotation"), "what has its default is not written");
}

void TypedNumbersTest::namesAreUsedInFields() {
  window_->session().commit(withNumbers(document(), *window_->session().app().registry, {{"w", "20 mm"}}), {});
  const FeatureId box = add("modeling.box", {{"depth", 10}, {"height", 5}});
  window_->tree().select(box);
  edit("width", "2*w");
  waitUntilComputed();
  COMPARE_NEAR(measureOf(box, "volume"), 40.0 * 10 * 5, 1e-9);
  QCOMPARE(parameter(box, "width"), (Value{{"expression", "2*w"}, {"value", 40.0}}));
  auto* line = window_->page().properties().field(QStringLiteral("width"))->findChild<QLineEdit*>();
  QCOMPARE(line->text(), QStringLiteral("2*w"));
  window_->session().commit(withNumbers(document(), *window_->session().app().registry, {{"w", "30 mm"}}), {});
  waitUntilComputed();
  COMPARE_NEAR(measureOf(box, "volume"), 60.0 * 10 * 5, 1e-9);
  QCOMPARE(line->text(), QStringLiteral("2*w"));
  window_->session().undo();
  waitUntilComputed();
  COMPARE_NEAR(measureOf(box, "volume"), 40.0 * 10 * 5, 1e-9);
}

void TypedNumbersTest::theTableIsEditedInItsDialog() {
  run("edit.numbers");
  const auto dialogOf = [&] { return window_->findChild<NumbersDialog*>(); };
  auto* table = dialogOf()->findChild<QTableWidget*>();
  QCOMPARE(table->rowCount(), 1);
  table->item(0, 0)->setText(QStringLiteral("half"));
  table->item(0, 1)->setText(QStringLiteral("width/2"));
  QCOMPARE(table->rowCount(), 2);
  auto* problem = dialogOf()->findChild<QLabel*>(QStringLiteral("fieldError"));
  QVERIFY2(problem->text().contains(QStringLiteral("\"width\" is not known")), qPrintable(problem->text()));
  table->item(1, 0)->setText(QStringLiteral("width"));
  table->item(1, 1)->setText(QStringLiteral("60 mm"));
  QVERIFY2(problem->text().isEmpty(), qPrintable(problem->text()));
  QCOMPARE(table->item(0, 2)->text(), QStringLiteral("30 mm"));
  Preferences::instance().set("length-unit", "cm");
  table->item(0, 1)->setText(QStringLiteral("width*2"));
  QCOMPARE(table->item(1, 2)->text(), QStringLiteral("6 cm"));
  QCOMPARE(table->item(0, 2)->text(), QStringLiteral("12 cm"));
  Preferences::instance().set("length-unit", "mm");
  table->item(0, 1)->setText(QStringLiteral("width/2"));
  QCOMPARE(table->item(0, 2)->text(), QStringLiteral("30 mm"));
  dialogOf()->accept();
  QCOMPARE(numbersOf(document()), (std::vector<NamedNumber>{{"half", "width/2"}, {"width", "60 mm"}}));
  const FeatureId box = add("modeling.box", {{"width", {{"expression", "half"}, {"value", 30}}}});
  // A number that is used cannot go, but can be called otherwise.
  run("edit.numbers");
  QPointer<NumbersDialog> again = window_->findChild<NumbersDialog*>();
  table = again->findChild<QTableWidget*>();
  table->setCurrentCell(0, 0);
  again->findChild<QPushButton*>(QStringLiteral("removeRow"))->click();
  again->accept();
  QVERIFY(again && again->isVisible());
  QVERIFY(again->findChild<QLabel*>(QStringLiteral("fieldError"))->text().contains(QStringLiteral("half")));
  again->reject();
  QTRY_VERIFY(!again);
  run("edit.numbers");
  again = window_->findChild<NumbersDialog*>();
  table = again->findChild<QTableWidget*>();
  table->item(0, 0)->setText(QStringLiteral("mitte"));
  again->accept();
  QCOMPARE(parameter(box, "width").at("expression").get<std::string>(), std::string("mitte"));
  QCOMPARE(window_->session().history().undoText(), std::string("Change named numbers"));
}

BLOSSOM_WINDOW_TEST(TypedNumbersTest)
#include "typed_numbers_test.moc"
