#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>

#include "panel_fixture.h"
#include "ui/controls/number_line.h"
#include "ui/controls/ratio_slider.h"
#include "ui/controls/swatch.h"

using namespace blossom;
using namespace blossom::ui;

/// Fields that are typed in or chosen from.
class PanelTypingTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openPanel(); }
  void cleanup() { closePanel(); }
  void expressionsAreTyped();
  void expressionsStayAsTheyWereTyped();
  void expressionsOfCoordinatesStay();
  void exponentsStayInSight();
  void narrowNumbersStayTheirNumbers();
  void aWrongValueIsKeptOut();
  void whatIsTakenBackIsNotWrong();
  void keysOfTheWindowReachIt();
  void closingWithSomethingTypedIsHarmless();
  void escapeTakesBackWhatIsTyped();
  void optionalValuesAreCleared();
  void flagsChoicesAndTexts();
  void coloursAreTypedAndChosen();
  void filesAreDroppedAndWritten();
};

void PanelTypingTest::expressionsAreTyped() {
  auto* length = editor<QLineEdit>("length");
  oneStep("length", 72.7, [&] { type(length, QStringLiteral("1/2 in + 3*(2 cm)")); });
  QCOMPARE(length->text(), QStringLiteral("1/2 in + 3*(2 cm)"));
  QCOMPARE(field("length")->findChild<QLabel*>(QStringLiteral("note"))->text(), QStringLiteral("= 72.7 mm"));
  oneStep("angle", parseText(declared("angle", angle()), "pi/4 rad + 1"),
          [&] { type(editor<QLineEdit>("angle"), QStringLiteral("pi/4 rad + 1")); });
  oneStep("number", std::sqrt(2.0), [&] { type(editor<QLineEdit>("number"), QStringLiteral("sqrt(2)")); });
  oneStep("count", 12, [&] { type(editor<QLineEdit>("count"), QStringLiteral("3*4")); });
  oneStep("ratio", 0.75, [&] {
    auto* slider = editor<RatioSlider>("ratio");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_F2);
    type(slider, QStringLiteral("3/4"));
  });
}

void PanelTypingTest::expressionsStayAsTheyWereTyped() {
  auto* length = editor<QLineEdit>("length");
  const auto inDocument = [&] { return session_->document().at("e").parameters.at("length"); };
  oneStep("length", 22.0, [&] { type(length, QStringLiteral("12+1cm")); });
  QCOMPARE(length->text(), QStringLiteral("12+1cm"));
  QCOMPARE(inDocument(), Value("12+1cm"));
  // To look at it and to leave it is no edit; another feature and back, and it still stands there.
  const std::string document = toJson(session_->document());
  length->setFocus();
  QTest::keyClick(length, Qt::Key_Return);
  panel_->show(FeatureId("b"));
  panel_->show(FeatureId("e"));
  length = editor<QLineEdit>("length");
  QCOMPARE(length->text(), QStringLiteral("12+1cm"));
  QCOMPARE(toJson(session_->document()), document);
  // The document, saved and opened, evaluates to the same.
  const Document again = fromJson(document).document;
  QCOMPARE(completed(everything().parameters, again.at("e").parameters).at("length"), Value(22.0));
  // The same value written otherwise is an edit, as is the plain number.
  type(length, QStringLiteral("20+2"));
  QCOMPARE(inDocument(), Value("20+2"));
  type(length, QStringLiteral("22"));
  QCOMPARE(inDocument(), Value(22.0));
  QCOMPARE(length->text(), QStringLiteral("22 mm"));
  // A number with its unit is a value, and a step from an expression leads to one.
  type(length, QStringLiteral("3 cm"));
  QCOMPARE(inDocument(), Value(30.0));
  type(length, QStringLiteral("2*5"));
  QTest::keyClick(length, Qt::Key_Up);
  QTest::keyRelease(length, Qt::Key_Up);
  QCOMPARE(inDocument(), Value(11.0));
  QCOMPARE(length->text(), QStringLiteral("11 mm"));
  // What is wrong leaves the expression before.
  type(length, QStringLiteral("2*6"));
  type(length, QStringLiteral("2*apples"));
  QTest::keyClick(length, Qt::Key_Escape);
  QCOMPARE(length->text(), QStringLiteral("2*6"));
  QCOMPARE(inDocument(), Value("2*6"));
}

void PanelTypingTest::expressionsOfCoordinatesStay() {
  const auto line = [&](const char* axis) { return field("point")->findChild<QLineEdit*>(QLatin1String(axis)); };
  const auto inDocument = [&] { return session_->document().at("e").parameters.at("point"); };
  const Value start = now("point");
  oneStep("point", Value::array({27.4, start[1], start[2]}), [&] { type(line("x"), QStringLiteral("1in+2")); });
  QCOMPARE(line("x")->text(), QStringLiteral("1in+2"));
  QCOMPARE(inDocument(), Value::array({"1in+2", start[1], start[2]}));
  QCOMPARE(field("point")->findChild<QLabel*>(QStringLiteral("note"))->text(), QStringLiteral("x = 27.4 mm"));
  // It stays beside others that are typed, when another feature was shown, and when the document was saved.
  type(line("y"), QStringLiteral("7"));
  type(line("z"), QStringLiteral("2*4"));
  QCOMPARE(inDocument(), Value::array({"1in+2", 7.0, "2*4"}));
  const std::string document = toJson(session_->document());
  panel_->show(FeatureId("b"));
  panel_->show(FeatureId("e"));
  QCOMPARE(line("x")->text(), QStringLiteral("1in+2"));
  QCOMPARE(line("y")->text(), QStringLiteral("7"));
  QCOMPARE(line("z")->text(), QStringLiteral("2*4"));
  line("x")->setFocus();
  QTest::keyClick(line("x"), Qt::Key_Return);
  QCOMPARE(toJson(session_->document()), document);
  QCOMPARE(completed(everything().parameters, fromJson(document).document.at("e").parameters).at("point"),
           Value::array({27.4, 7.0, 8.0}));
  // The same value written otherwise is an edit; a step leads to a number; what is wrong leaves what stood there.
  type(line("z"), QStringLiteral("8"));
  QCOMPARE(inDocument(), Value::array({"1in+2", 7.0, 8.0}));
  QTest::keyClick(line("z"), Qt::Key_Up);
  QTest::keyRelease(line("z"), Qt::Key_Up);
  QCOMPARE(inDocument(), Value::array({"1in+2", 7.0, 9.0}));
  type(line("x"), QStringLiteral("1in+pears"));
  QVERIFY(!field("point")->problem().isEmpty());
  QTest::keyClick(line("x"), Qt::Key_Escape);
  QCOMPARE(line("x")->text(), QStringLiteral("1in+2"));
}

// Of a number that is too long for its field the beginning is seen.
void PanelTypingTest::exponentsStayInSight() {
  const QString inSight = QStringLiteral("1.9e-15");
  QCOMPARE(displayText(blossom::length(), 1.8651746813702630e-15), inSight + QStringLiteral(" mm"));
  QCOMPARE(displayText(angle(), -1.8651746813702630e-15), u'-' + inSight + u'°');
  QCOMPARE(displayText(number(), 1e-15), QStringLiteral("1e-15"));
  QCOMPARE(displayText(number(), 1234.56789012), QStringLiteral("1234.56789012"));
}

void PanelTypingTest::narrowNumbersStayTheirNumbers() {
  Feature feature = session_->document().at("e");
  feature.parameters["point"] = Value::array({-31.53421876123, 26.1, -1.3219812345e-14});
  session_->commit(session_->document().with(feature), QStringLiteral("Move"));
  settle();
  const auto line = [&](const char* axis) { return field("point")->findChild<NumberLine*>(QLatin1String(axis)); };
  QCOMPARE(line("z")->text(), QStringLiteral("0"));  // rounding of the others
  NumberLine* const x = line("x");
  QVERIFY(!x->hasFocus());
  QCOMPARE(x->text(), QStringLiteral("-31.53421876123"));
  const QString shown = x->shownText();
  QVERIFY2(x->fontMetrics().horizontalAdvance(shown) < x->width(), qPrintable(shown));
  COMPARE_NEAR(shown.toDouble(), -31.53421876123, 0.5);
  QVERIFY(!x->grab().isNull());
  x->setFocus();
  QCOMPARE(x->shownText(), x->text());
  x->clearFocus();
  QCOMPARE(session_->document().at("e").parameters["point"], feature.parameters["point"]);
  oneStep("point", Value::array({-31.53421876123, 30.0, -1.3219812345e-14}), [&] { type(line("y"), QStringLiteral("30")); });
}

void PanelTypingTest::aWrongValueIsKeptOut() {
  const std::string before = toJson(session_->document());
  const std::vector<std::pair<const char*, QString>> wrong{
      {"length", QStringLiteral("-3")}, {"length", QStringLiteral("3 apples")}, {"length", QStringLiteral("1/0")},
      {"count", QStringLiteral("2.5")}, {"count", QStringLiteral("21")},        {"number", QStringLiteral("3 mm")},
      {"angle", QStringLiteral("")},    {"color", QStringLiteral("no colour")}, {"file", QStringLiteral("/nowhere/x.json")}};
  for (const auto& [name, text] : wrong) {
    auto* line = editor<QLineEdit>(name);
    const Value kept = field(name)->value();
    line->setFocus();
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY2(field(name)->problem().contains(QStringLiteral("kept")), qPrintable(QLatin1String(name) + text));
    QVERIFY(field(name)->problem().front().isUpper() || field(name)->problem().front() == u'"');
    QCOMPARE(field(name)->value(), kept);
    QCOMPARE(toJson(session_->document()), before);
    QTest::keyClick(line, Qt::Key_Escape);
    QVERIFY(field(name)->problem().isEmpty());
    QCOMPARE(line->text(), displayText(field(name)->spec(), kept));
  }
}

/// Undo within the line shows what is kept.
void PanelTypingTest::whatIsTakenBackIsNotWrong() {
  for (const auto& [name, wrong] : {std::pair("length", "-3"), std::pair("count", "21")}) {
    auto* line = editor<QLineEdit>(name);
    const QString kept = line->text();
    type(line, QLatin1String(wrong));
    QVERIFY(field(name)->problem().contains(QStringLiteral("kept")));
    for (int k = 0; k < 3 && line->isModified(); ++k) QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(line->text(), kept);
    QCOMPARE(field(name)->problem(), QString());
    QVERIFY(!line->property("wrong").toBool());
  }
}

/// Undo while nothing is typed, and letters with Ctrl that Qt's line edits take on some systems.
void PanelTypingTest::keysOfTheWindowReachIt() {
  const auto isLeftToTheWindow = [](QLineEdit* line, int key) {
    QKeyEvent asks(QEvent::ShortcutOverride, key, Qt::ControlModifier);
    asks.ignore();
    QCoreApplication::sendEvent(line, &asks);
    return !asks.isAccepted();
  };
  for (const char* name : {"length", "count", "ratio"}) {
    auto* line = editor<QLineEdit>(name);
    QTest::mouseClick(line, Qt::LeftButton);  // begins typing
    for (const int key : {Qt::Key_Z, Qt::Key_E, Qt::Key_D, Qt::Key_K, Qt::Key_U}) QVERIFY(isLeftToTheWindow(line, key));
    for (const int key : {Qt::Key_A, Qt::Key_C, Qt::Key_V}) QVERIFY(!isLeftToTheWindow(line, key));
    QTest::keyClick(line, Qt::Key_7);
    QVERIFY(line->isModified());
    QVERIFY(!isLeftToTheWindow(line, Qt::Key_Z));
    QTest::keyClick(line, Qt::Key_Escape);
  }
}

void PanelTypingTest::closingWithSomethingTypedIsHarmless() {
  auto* length = editor<QLineEdit>("length");
  length->setFocus();
  length->selectAll();
  QTest::keyClicks(length, QStringLiteral("12"));
  QVERIFY(length->isModified());
  panel_.reset();  // the focus goes with it, and the line tells that it was left
  QCOMPARE(now("length"), Value(10.0));
}

void PanelTypingTest::escapeTakesBackWhatIsTyped() {
  const std::string before = toJson(session_->document());
  for (const char* name : {"length", "text", "color", "count"}) {
    auto* line = editor<QLineEdit>(name);
    const QString shown = line->text();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("7"));
    QVERIFY(field(name)->editing());
    QTest::keyClick(line, Qt::Key_Escape);
    QCOMPARE(line->text(), shown);
    QVERIFY(!field(name)->editing());
    line->clearFocus();
    QCOMPARE(toJson(session_->document()), before);
  }
}

void PanelTypingTest::optionalValuesAreCleared() {
  auto* line = editor<QLineEdit>("limit");
  QVERIFY(line->text().isEmpty() && !line->placeholderText().isEmpty());
  oneStep("limit", 30.0, [&] { type(line, QStringLiteral("3 cm")); });
  oneStep("limit", Value(), [&] {
    line->setFocus();
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClick(line, Qt::Key_Return);
  });
}

void PanelTypingTest::flagsChoicesAndTexts() {
  auto* box = editor<QCheckBox>("flag");
  oneStep("flag", true, [&] { QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2)); });
  oneStep("flag", false, [&] { QTest::keyClick(box, Qt::Key_Space); });
  oneStep("choice", "fine", [&] { QTest::keyClick(editor<QComboBox>("choice"), Qt::Key_Down); });
  oneStep("text", " a ; \"b\" ", [&] { type(editor<QLineEdit>("text"), QStringLiteral(" a ; \"b\" ")); });
}

void PanelTypingTest::coloursAreTypedAndChosen() {
  auto* line = editor<QLineEdit>("color");
  oneStep("color", "#112233", [&] { type(line, QStringLiteral("#123")); });
  oneStep("color", "#4682b4", [&] { type(line, QStringLiteral("Steel blue")); });
  oneStep("color", "#00ff00", [&] {
    QTest::mouseClick(editor<Swatch>("color"), Qt::LeftButton);
    auto* dialog = editor<QColorDialog>("color");
    QVERIFY(dialog);
    dialog->setCurrentColor(QColor(QStringLiteral("#0000ff")));
    QTRY_COMPARE(now("color"), Value("#0000ff"));  // previewed
    dialog->setCurrentColor(QColor(QStringLiteral("#00ff00")));
    dialog->accept();
  });
}

void PanelTypingTest::filesAreDroppedAndWritten() {
  const auto written = [&](const char* name) {
    QFile out(folder_.filePath(QLatin1String(name)));
    if (out.open(QIODevice::WriteOnly)) out.write("{}");
    return out.fileName();
  };
  const QString good = written("motion.json"), bad = written("motion.unknown");
  const auto drop = [&](const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(middle(field("file")), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(field("file"), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(middle(field("file")), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(field("file"), &event);
  };
  drop(bad);
  QVERIFY(field("file")->problem().contains(QStringLiteral("json")));
  QVERIFY(now("file").is_null());
  drop(good);
  QTRY_VERIFY(!now("file").is_null());
  QCOMPARE(qt(now("file").at("path").get<std::string>()), QStringLiteral("motion.json"));  // and not where it lay
  QVERIFY(!now("file").at("asset").get<std::string>().empty());                            // its content is in the document
  QVERIFY(field("file")->problem().isEmpty());
  QCOMPARE(editor<QLineEdit>("file")->text(), QStringLiteral("motion.json"));
  session_->undo();
  QVERIFY(now("file").is_null());
}

BLOSSOM_WIDGET_TEST(PanelTypingTest)
#include "panel_typing_test.moc"
