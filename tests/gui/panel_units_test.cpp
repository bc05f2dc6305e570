#include <QEnterEvent>
#include <QLabel>
#include <QSignalSpy>

#include "panel_fixture.h"
#include "ui/controls/stepping.h"
#include "ui/fields/list_field.h"
#include "ui/fields/list_row.h"
#include "ui/look/text.h"
#include "ui/look/units.h"
#include "ui/panel/result_rows.h"

using namespace blossom;
using namespace blossom::ui;

/// Lengths in the unit that the user prefers, while the document stays in mm.
class PanelUnitsTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openPanel(); }
  void cleanup() { closePanel(); }
  void lengthsAreShownAndTypedInInches();
  void errorsAndExamplesNameTheUnit();
  void keysStepInRoundInches();
  void labelsAreScrubbedInRoundInches();
  void stepsStayWithinTheirBounds_data();
  void stepsStayWithinTheirBounds();
  void pointsAreShownInInches();
  void listsAndRecordsAreShownInInches();
  void resultsAreShownInInches();
  void figuresAreShownInInches();
  void otherKindsStayAsTheyAre();
  void whatIsTypedSurvivesTheChange();
  void withMillimetresAllIsAsBefore();

 private:
  // As the window does.
  void prefer(const char* unit) {
    Preferences::instance().set("length-unit", unit);
    panel_->show(panel_->shown());
  }
  void make(const Feature& feature) {
    session_->commit(session_->document().with(feature), QStringLiteral("Make"));
    settle();
  }
  void setLength(double millimetres) {
    Feature feature = session_->document().at("e");
    feature.parameters["length"] = millimetres;
    make(feature);
  }
  [[nodiscard]] QString shown(const char* name) const { return editor<QLineEdit>(name)->text(); }
  /// "6 in²" of the result of that name; empty when there is none.
  [[nodiscard]] QString result(const char* name) const {
    for (const ResultRow& row : panel_->findChild<ResultRows*>()->rows())
      if (row.name == QLatin1String(name)) return (row.value() + u' ' + row.unit).trimmed();
    return {};
  }
};

void PanelUnitsTest::lengthsAreShownAndTypedInInches() {
  setLength(25.4);
  prefer("in");
  QCOMPARE(shown("length"), QStringLiteral("1 in"));
  QCOMPARE(now("length"), Value(25.4));
  oneStep("length", 50.8, [&] { type(editor<QLineEdit>("length"), QStringLiteral("2")); });
  QCOMPARE(shown("length"), QStringLiteral("2 in"));
  oneStep("length", 10.0, [&] { type(editor<QLineEdit>("length"), QStringLiteral("10 mm")); });
  COMPARE_NEAR(parseLength(shown("length").toStdString()), 10, 1e-11);
  QVERIFY(shown("length").endsWith(QStringLiteral(" in")));
  oneStep("length", 12.7, [&] { type(editor<QLineEdit>("length"), QStringLiteral("1/2")); });
  // An expression stays one; in a document, whose own lengths are in mm, with its unit.
  QCOMPARE(session_->document().at("e").parameters.at("length"), Value("(1/2) in"));
  QCOMPARE(shown("length"), QStringLiteral("(1/2) in"));
  oneStep("limit", 101.6, [&] { type(editor<QLineEdit>("limit"), QStringLiteral("max(2, 4)")); });
  QCOMPARE(shown("limit"), QStringLiteral("(max(2, 4)) in"));
  oneStep("length", 12 * 25.4 + 10.0, [&] { type(editor<QLineEdit>("length"), QStringLiteral("12+1cm")); });
  QCOMPARE(session_->document().at("e").parameters.at("length"), Value("12 in+1cm"));
  // To look at a length and to leave it again is no edit, even if it has more digits than are shown.
  setLength(10.0 / 3);
  const std::string before = toJson(session_->document());
  editor<QLineEdit>("length")->setFocus();
  QTest::keyClick(editor<QLineEdit>("length"), Qt::Key_Return);
  editor<QLineEdit>("angle")->setFocus();
  QCOMPARE(toJson(session_->document()), before);
}

void PanelUnitsTest::errorsAndExamplesNameTheUnit() {
  prefer("in");
  auto* line = editor<QLineEdit>("length");
  for (const char* wrong : {"-3", "3 deg", "3 apples"}) {
    type(line, QLatin1String(wrong));
    QVERIFY2(field("length")->problem().contains(QStringLiteral("kept")), wrong);
    QCOMPARE(now("length"), Value(10.0));
    QTest::keyClick(line, Qt::Key_Escape);
  }
  // The result that stands below what is typed is in the unit too.
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("1 + 25.4 mm"));
  const auto* note = field("length")->findChild<QLabel*>(QStringLiteral("note"));
  QCOMPARE(note->text(), QStringLiteral("= 2 in"));
  // So are the bounds that the status line tells.
  ParameterSpec spec = blossom::length();
  spec.minimum = 12.7;
  QCOMPARE(describe(spec, lengthUnit()), std::string("length in inches, at least 0.5 in"));
  spec.maximum = 25.4;
  QCOMPARE(describe(spec, lengthUnit()), std::string("length in inches, from 0.5 to 1 in"));
  QCOMPARE(describe(spec), std::string("length in mm, from 12.7 to 25.4 mm"));
  QSignalSpy hints(field("length"), &ParameterField::hint);
  QEnterEvent enters(QPointF(4, 4), QPointF(4, 4), QPointF(4, 4));
  QApplication::sendEvent(field("length"), &enters);
  QVERIFY(!hints.isEmpty());
  QVERIFY2(hints.last().front().toString().contains(QStringLiteral("Length in inches")),
           qPrintable(hints.last().front().toString()));
}

void PanelUnitsTest::keysStepInRoundInches() {
  prefer("in");
  auto* line = editor<QLineEdit>("length");
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(line, key, modifiers); };
  setLength(50.8);
  line->setFocus();
  press(Qt::Key_Up);
  QCOMPARE(shown("length"), QStringLiteral("3 in"));
  COMPARE_NEAR(now("length").get<double>(), 76.2, 1e-12);
  press(Qt::Key_Down, Qt::ShiftModifier);
  QCOMPARE(shown("length"), QStringLiteral("2.9 in"));
  press(Qt::Key_Up, Qt::ControlModifier);
  QCOMPARE(shown("length"), QStringLiteral("10 in"));
  // From a length that is not round the steps lead to round ones.
  setLength(60);
  press(Qt::Key_Up);
  QCOMPARE(shown("length"), QStringLiteral("3 in"));
  setLength(10);
  press(Qt::Key_Up);
  QCOMPARE(shown("length"), QStringLiteral("0.4 in"));
  for (int i = 0; i < 7; ++i) press(Qt::Key_Up);
  QCOMPARE(shown("length"), QStringLiteral("0.47 in"));
  COMPARE_NEAR(now("length").get<double>(), 0.47 * 25.4, 1e-12);
  prefer("ft");
  setLength(3048);
  press(Qt::Key_Down);
  QCOMPARE(shown("length"), QStringLiteral("9 ft"));
}

void PanelUnitsTest::labelsAreScrubbedInRoundInches() {
  prefer("in");
  setLength(254);
  FieldLabel* label = labelOf("length");
  const QPoint from = middle(label);
  QTest::mousePress(label, Qt::LeftButton, {}, from);
  test::moveMouse(label, from + QPoint(20, 0));
  QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(20, 0));
  settle();
  QCOMPARE(shown("length"), QStringLiteral("15 in"));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change length of All"));
}

void PanelUnitsTest::stepsStayWithinTheirBounds_data() {
  QTest::addColumn<QString>("unit");
  for (const char* unit : {"mm", "cm", "m", "in", "ft"}) QTest::newRow(unit) << QString::fromLatin1(unit);
}

// A bound in mm is rarely round in another unit: what a key makes of it must still be a value that can be.
void PanelUnitsTest::stepsStayWithinTheirBounds() {
  QFETCH(QString, unit);
  Preferences::instance().set("length-unit", unit.toStdString());
  for (int i = 1; i < 300; ++i) {
    const double bound = i / 100.0;
    ParameterSpec spec = blossom::length();
    spec.name = "length";
    spec.minimum = bound;
    spec.maximum = 3 * bound;
    const double start = 2 * bound, coarse = stepOf(spec, start, Qt::ControlModifier);
    for (const bool open : {false, true}) {
      spec.aboveMinimum = open;
      const double low = checked(spec, stepped(spec, start, -100, coarse)).get<double>();
      const double high = checked(spec, stepped(spec, start, 100, coarse)).get<double>();
      QVERIFY2(low < start && high > start, qPrintable(QString::number(bound)));
      QCOMPARE(high, 3 * bound);
      if (!open) QCOMPARE(low, bound);
    }
  }
}

void PanelUnitsTest::pointsAreShownInInches() {
  Feature feature = session_->document().at("e");
  feature.parameters["point"] = Value::array({25.4, 50.8, -12.7});
  make(feature);
  prefer("in");
  const auto line = [&](const char* of, const char* axis) { return field(of)->findChild<QLineEdit*>(QLatin1String(axis)); };
  QCOMPARE(line("point", "x")->text(), QStringLiteral("1"));
  QCOMPARE(line("point", "y")->text(), QStringLiteral("2"));
  QCOMPARE(line("point", "z")->text(), QStringLiteral("-0.5"));
  oneStep("point", Value::array({25.4, 101.6, -12.7}), [&] { type(line("point", "y"), QStringLiteral("4")); });
  oneStep("point", Value::array({10.0, 101.6, -12.7}), [&] { type(line("point", "x"), QStringLiteral("10 mm")); });
  line("point", "y")->setFocus();
  QTest::keyClick(line("point", "y"), Qt::Key_Up);
  QCOMPARE(line("point", "y")->text(), QStringLiteral("5"));
  COMPARE_NEAR(now("point").at(1).get<double>(), 127, 1e-12);
  // What is picked is in mm, as all geometry is.
  pickButton("point")->click();
  panel_->offerPick(pickOf(SubShapeKind::Whole, -1));
  QCOMPARE(now("point"), Value::array({1.0, 2.5, -3.0}));
  QCOMPARE(line("shift", "y")->text(), QStringLiteral("1"));
  oneStep("shift", Value::array({50.8, 25.4, 0.0}), [&] { type(line("shift", "x"), QStringLiteral("2")); });
  // A direction has no unit.
  QCOMPARE(line("vector", "z")->text(), QStringLiteral("1"));
  type(line("vector", "x"), QStringLiteral("2"));
  QCOMPARE(now("vector"), Value::array({2.0, 0.0, 1.0}));
}

void PanelUnitsTest::listsAndRecordsAreShownInInches() {
  Feature feature = session_->document().at("e");
  feature.parameters["lengths"] = Value::array({25.4, 12.7});
  feature.parameters["pin"] = Value{{"diameter", 50.8}, {"shape", "ball"}, {"at", Value::array({0.0, 0.0, 0.0})}};
  feature.parameters["tools"] = Value::array({feature.parameters["pin"]});
  make(feature);
  prefer("in");
  const auto& rows = static_cast<ListField*>(field("lengths"))->rows();
  QCOMPARE(rows[0]->findChild<QLineEdit*>()->text(), QStringLiteral("1 in"));
  QCOMPARE(rows[1]->findChild<QLineEdit*>()->text(), QStringLiteral("0.5 in"));
  oneStep("lengths", Value::array({25.4, 101.6}), [&] { type(rows[1]->findChild<QLineEdit*>(), QStringLiteral("4")); });
  auto* diameter = field("pin")->findChild<ParameterField*>(QStringLiteral("parameter:diameter"));
  QCOMPARE(diameter->findChild<QLineEdit*>()->text(), QStringLiteral("2 in"));
  const auto* row = static_cast<ListField*>(field("tools"))->rows()[0];
  QVERIFY(row->findChild<QToolButton*>(QStringLiteral("rowTitle"))->text().contains(QStringLiteral("2 in · ball")));
}

void PanelUnitsTest::resultsAreShownInInches() {
  Feature cube = made("c", "test.cube", "Cube");
  cube.parameters["size"] = 50.8;
  make(cube);
  panel_->show(FeatureId("c"));
  QTRY_VERIFY(!result("Volume").isEmpty());
  const QString thin(QChar(0x2009));
  QTRY_COMPARE(result("Area"), QStringLiteral("15") + thin + QStringLiteral("483.8 mm²"));
  QCOMPARE(result("Volume"), QStringLiteral("131") + thin + QStringLiteral("097 mm³"));
  prefer("in");
  QTRY_COMPARE(result("Area"), QStringLiteral("24 in²"));
  QCOMPARE(result("Volume"), QStringLiteral("8 in³"));
  prefer("cm");
  QTRY_COMPARE(result("Area"), QStringLiteral("154.838 cm²"));
  QCOMPARE(result("Volume"), QStringLiteral("131.097 cm³"));
}

// Figures that are no measures have their unit in their names.
void PanelUnitsTest::figuresAreShownInInches() {
  QTRY_COMPARE(result("Chosen"), QStringLiteral("12.25 mm"));
  prefer("in");
  QTRY_COMPARE(result("Chosen"), QStringLiteral("0.48228 in"));
  QCOMPARE(statUnit("uncut_within_mm2"), QStringLiteral(" in²"));
  QCOMPARE(shownStat("uncut_within_mm2", 25.4 * 25.4).get<double>(), 1.0);
  const Value place = shownStat("min_normal_place", {25.4, -50.8, 1e-15});
  QCOMPARE(place[0].get<double>(), 1.0);
  QCOMPARE(place[1].get<double>(), -2.0);
  QCOMPARE(place[2].get<double>(), 0.0);
  QCOMPARE(statUnit("worker_ms") + statUnit("time_s"), QStringLiteral(" ms s"));
  QCOMPARE(shownStat("worker_ms", 12), Value(12));
  QCOMPARE(statUnit("chosen"), QString());
}

void PanelUnitsTest::otherKindsStayAsTheyAre() {
  prefer("in");
  QCOMPARE(shown("angle"), QStringLiteral("45°"));
  QCOMPARE(shown("number"), QStringLiteral("1"));
  QCOMPARE(shown("count"), QStringLiteral("3"));
  oneStep("angle", 30.0, [&] { type(editor<QLineEdit>("angle"), QStringLiteral("30")); });
  oneStep("number", 2.0, [&] { type(editor<QLineEdit>("number"), QStringLiteral("2")); });
  editor<QLineEdit>("angle")->setFocus();
  QTest::keyClick(editor<QLineEdit>("angle"), Qt::Key_Up);
  QCOMPARE(now("angle"), Value(31.0));
}

void PanelUnitsTest::whatIsTypedSurvivesTheChange() {
  auto* line = editor<QLineEdit>("length");
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("2"));
  prefer("in");
  QCOMPARE(line->text(), QStringLiteral("2"));
  QTest::keyClick(line, Qt::Key_Return);
  QCOMPARE(now("length"), Value(50.8));
  QCOMPARE(line->text(), QStringLiteral("2 in"));
}

void PanelUnitsTest::withMillimetresAllIsAsBefore() {
  const std::string before = toJson(session_->document());
  const std::string history = session_->history().undoText();
  const auto texts = [&] {
    QStringList all;
    for (const QLineEdit* line : panel_->findChildren<QLineEdit*>()) all << line->text();
    return all;
  };
  const QStringList shownBefore = texts();
  const QString area = result("Area");
  for (const char* unit : {"in", "ft", "m", "cm"}) {
    prefer(unit);
    QVERIFY(texts() != shownBefore);
  }
  prefer("mm");
  QCOMPARE(texts(), shownBefore);
  QTRY_COMPARE(result("Area"), area);
  QCOMPARE(toJson(session_->document()), before);
  QCOMPARE(session_->history().undoText(), history);
  oneStep("length", 2.0, [&] { type(editor<QLineEdit>("length"), QStringLiteral("2")); });
  QCOMPARE(shown("length"), QStringLiteral("2 mm"));
  editor<QLineEdit>("length")->setFocus();
  QTest::keyClick(editor<QLineEdit>("length"), Qt::Key_Up);
  QCOMPARE(now("length"), Value(3.0));
}

BLOSSOM_WIDGET_TEST(PanelUnitsTest)
#include "panel_units_test.moc"
