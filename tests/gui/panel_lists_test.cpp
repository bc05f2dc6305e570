#include <QComboBox>
#include <QEnterEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include "panel_fixture.h"
#include "ui/controls/ratio_slider.h"
#include "ui/fields/list_field.h"
#include "ui/fields/list_row.h"
#include "ui/fields/record_field.h"

using namespace blossom;
using namespace blossom::ui;

/// Lists, records and lists of records.
class PanelListsTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openPanel(); }
  void cleanup() { closePanel(); }
  void listsAreEdited();
  void aNewItemTakesWhatIsTyped();
  void listsOfRecords();
  void recordsAreToldInShort();
  void recordsAreGroups();
  void longListsAreShownBitByBit();
  void aListFillsItselfWithOneForEachShape();
  void itemsOfAListFillThemselves();

 private:
  static QToolButton* addButtonOf(const ParameterField* list) {
    for (auto* button : list->findChildren<QToolButton*>())
      if (button->property("role") == QStringLiteral("add")) return button;
    return nullptr;
  }
};

void PanelListsTest::listsAreEdited() {
  auto* lengths = static_cast<ListField*>(field("lengths"));
  QCOMPARE(lengths->rows().size(), std::size_t(3));
  oneStep("lengths", Value::array({1.0, 20.0, 3.0}),
          [&] { type(lengths->rows()[1]->findChild<QLineEdit*>(), QStringLiteral("2 cm")); });
  oneStep("lengths", Value::array({1.0, 20.0, 3.0, 3.0}), [&] { addButtonOf(lengths)->click(); });  // as the last
  oneStep("lengths", Value::array({20.0, 1.0, 3.0, 3.0}), [&] { emit lengths->rows()[1]->moveWanted(-1); });
  oneStep("lengths", Value::array({20.0, 3.0, 3.0, 1.0}), [&] {
    // The number in front is dragged below the last row.
    auto* number = lengths->rows()[1]->findChild<QLabel*>(QStringLiteral("rowNumber"));
    QTest::mousePress(number, Qt::LeftButton, {}, middle(number));
    const QPoint below = number->mapFromGlobal(lengths->rows()[3]->mapToGlobal(QPoint(5, lengths->rows()[3]->height())));
    test::moveMouse(number, (middle(number) + below) / 2);
    test::moveMouse(number, below);
    QTest::mouseRelease(number, Qt::LeftButton, {}, below);
  });
  oneStep("lengths", Value::array({20.0, 3.0, 1.0}), [&] { emit lengths->rows()[1]->removeWanted(); });
  oneStep("lengths", Value::array({20.0, 20.0, 3.0, 1.0}), [&] { emit lengths->rows()[0]->copyWanted(); });
  type(lengths->rows()[0]->findChild<QLineEdit*>(), QStringLiteral("3 deg"));
  QVERIFY(!lengths->rows()[0]->field()->problem().isEmpty());
  QCOMPARE(now("lengths").at(0), Value(20.0));
  // It must keep one.
  for (int i = 0; i < 4; ++i) emit lengths->rows()[0]->removeWanted();
  QCOMPARE(now("lengths"), Value::array({1.0}));
  QVERIFY(lengths->problem().contains(QStringLiteral("at least 1 item")));

  auto* points = static_cast<ListField*>(field("points"));
  oneStep("points", Value::parse("[[0.0,0.0,0.0]]"), [&] { addButtonOf(points)->click(); });
  oneStep("points", Value::parse("[[1.0,2.5,-3.0]]"), [&] {
    points->rows()[0]->field()->findChild<QToolButton*>(QStringLiteral("fieldButton"))->click();
    QCOMPARE(panel_->wanted()->parameter, QStringLiteral("points/0"));
    panel_->offerPick(pickOf(SubShapeKind::Vertex, 0));
  });
}

/// Digits that follow the click are not for the shortcuts of the view.
void PanelListsTest::aNewItemTakesWhatIsTyped() {
  const auto typed = [](const char* digits) {
    auto* const line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    QVERIFY(line);
    QCOMPARE(line->selectedText(), line->text());
    QTest::keyClicks(line, QLatin1String(digits));
    QTest::keyClick(line, Qt::Key_Return);
  };
  const auto addTo = [this](const char* name) {
    auto* const list = static_cast<ListField*>(field(name));
    addButtonOf(list)->click();
    QTRY_VERIFY(list->rows().back()->isAncestorOf(QApplication::focusWidget()));
  };
  addTo("lengths");
  typed("7");
  QCOMPARE(now("lengths"), Value::array({1.0, 2.0, 3.0, 7.0}));
  addTo("points");
  typed("5");
  QCOMPARE(now("points"), Value::parse("[[5.0,0.0,0.0]]"));
  addTo("points");  // from where the last is
  typed("6");
  QCOMPARE(now("points"), Value::parse("[[5.0,0.0,0.0],[6.0,0.0,0.0]]"));
  addTo("tools");  // begins as declared
  typed("8");
  addTo("tools");
  QCOMPARE(now("tools").at(0).at("diameter"), Value(8.0));
  QCOMPARE(now("tools").at(1).at("diameter"), Value(6.0));
}

void PanelListsTest::listsOfRecords() {
  auto* tools = static_cast<ListField*>(field("tools"));
  const Value fresh{{"diameter", 6.0}, {"shape", "flat"}, {"at", Value::array({0.0, 0.0, 0.0})}};
  Value ball = fresh;
  ball["shape"] = "ball";
  oneStep("tools", Value::array({fresh}), [&] { addButtonOf(tools)->click(); });
  ListRow* row = tools->rows()[0];
  row->open(true);
  QTRY_VERIFY(row->field() && row->field()->isVisible());
  oneStep("tools", Value::array({ball}), [&] { QTest::keyClick(row->findChild<QComboBox*>(), Qt::Key_Down); });
  row->findChild<QToolButton*>(QStringLiteral("rowTitle"))->click();
  QVERIFY(row->field()->isHidden());
  QVERIFY(row->findChild<QToolButton*>(QStringLiteral("rowTitle"))->text().contains(QStringLiteral("6 mm · ball")));
  row->open(true);
  auto* pick = row->findChild<QToolButton*>(QStringLiteral("fieldButton"));
  pick->click();
  QCOMPARE(panel_->wanted()->parameter, QStringLiteral("tools/0/at"));
  Value moved = ball;
  moved["at"] = Value::array({1.0, 2.5, -3.0});
  oneStep("tools", Value::array({moved}), [&] { panel_->offerPick(pickOf(SubShapeKind::Whole, -1)); });
  // Dragging inside of a record inside of a list is previewed and one step too.
  auto* label = row->field()->findChild<ParameterField*>(QStringLiteral("parameter:diameter"))->findChild<FieldLabel*>();
  Value wider = moved;
  wider["diameter"] = 16.0;
  oneStep("tools", Value::array({wider}), [&] {
    QTest::mousePress(label, Qt::LeftButton, {}, QPoint(5, 5));
    test::moveMouse(label, QPoint(25, 5));
    test::moveMouse(label, QPoint(45, 5));
    QTRY_COMPARE(now("tools").at(0).at("diameter"), Value(16.0));
    QTest::mouseRelease(label, Qt::LeftButton, {}, QPoint(45, 5));
  });
}

void PanelListsTest::recordsAreToldInShort() {
  const ParameterSpec place = record({declared("u", number()), declared("v", number()), declared("to", point())});
  const Value pulled{{"u", 0.75570620912}, {"v", 0.5}, {"to", Value::array({18.3360636553537, -2.1000000004, 1e-15})}};
  QCOMPARE(summaryOf(place, pulled),
           QStringLiteral("u 0.756 · v 0.5 · to 18.3, %1, 0").arg(QChar(0x2212) + QStringLiteral("2.1")));
  // JSON is for the command line.
  QSignalSpy hinted(field("tools"), &ParameterField::hint);
  QEnterEvent enter{QPointF(), QPointF(), QPointF()};
  QCoreApplication::sendEvent(field("tools"), &enter);
  QCOMPARE(hinted.size(), 1);
  const QString said = hinted.front().front().toString();
  QVERIFY2(said.endsWith(QStringLiteral("Each with diameter, shape, at.")), qPrintable(said));
}

void PanelListsTest::recordsAreGroups() {
  Value wider = now("pin");
  wider["diameter"] = 50.8;
  auto* diameter = field("pin")->findChild<ParameterField*>(QStringLiteral("parameter:diameter"));
  oneStep("pin", wider, [&] { type(diameter->findChild<QLineEdit*>(), QStringLiteral("2\"")); });
  type(diameter->findChild<QLineEdit*>(), QStringLiteral("-1"));
  QVERIFY(!diameter->problem().isEmpty());
  QCOMPARE(now("pin"), wider);
  QTest::keyClick(diameter->findChild<QLineEdit*>(), Qt::Key_Escape);
  QVERIFY(diameter->problem().isEmpty());
}

void PanelListsTest::longListsAreShownBitByBit() {
  Feature feature = session_->document().at("e");
  Value many = Value::array();
  for (int i = 0; i < 1000; ++i) many.push_back(double(i));
  feature.parameters["lengths"] = many;
  session_->commit(session_->document().with(feature), QStringLiteral("Many"));
  auto* lengths = static_cast<ListField*>(field("lengths"));
  QVERIFY(lengths->rows().size() < 50);
  auto* more = lengths->findChild<QPushButton*>(QStringLiteral("link"));
  QVERIFY(more->isVisible());
  const std::size_t before = lengths->rows().size();
  more->click();
  QVERIFY(lengths->rows().size() > before);
  Value changed = many;
  changed[before] = 5.5;
  oneStep("lengths", changed, [&] { type(lengths->rows()[before]->findChild<QLineEdit*>(), QStringLiteral("5.5")); });
}

void PanelListsTest::aListFillsItselfWithOneForEachShape() {
  const Document sources =
      session_->document().with(made("c", "test.source", "Nut")).with(made("d", "test.source", "Washer"));
  session_->commit(sources.with(made("s", "test.blend", "Blended", {"a", "b"})), QStringLiteral("Blend"));
  panel_->show(FeatureId("s"));
  settle();
  const auto levels = [this] { return session_->document().at("s").parameters.value("levels", Value::array()); };
  const auto add = [this] {
    for (auto* button : field("levels")->findChildren<QToolButton*>())
      if (button->property("role") == QStringLiteral("add")) return button;
    return static_cast<QToolButton*>(nullptr);
  };
  add()->click();
  QCOMPARE(levels(), Value::array({0.25}));
  QVERIFY(!add()->isEnabled());  // there are two shapes
  Feature more = session_->document().at("s");
  more.inputs = {"a", "b", "c", "d"};
  more.parameters["t"] = 0.75;
  session_->commit(session_->document().with(more), QStringLiteral("More"));
  QVERIFY(add()->isEnabled());
  add()->click();  // all that are missing
  QCOMPARE(levels(), Value::array({0.25, 0.75, 0.75}));
  QVERIFY(!add()->isEnabled());
  // Each has a slider of its own.
  const auto rows = static_cast<ListField*>(field("levels"))->rows();
  QCOMPARE(rows.size(), std::size_t{3});
  for (ListRow* row : rows) QVERIFY(row->findChild<RatioSlider*>());
  auto* const slider = rows[1]->findChild<RatioSlider*>();
  QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, 5));
  QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, 5));
  COMPARE_NEAR(levels().at(1).get<double>(), 0.5, 0.02);
  QCOMPARE(levels().at(0), Value(0.25));
  emit rows[2]->removeWanted();
  QCOMPARE(levels().size(), std::size_t{2});
  QVERIFY(add()->isEnabled());
}

/// Each item is a list with a number for each shape after the first.
void PanelListsTest::itemsOfAListFillThemselves() {
  const Document sources = session_->document().with(made("c", "test.source", "Nut"));
  session_->commit(sources.with(made("s", "test.blend", "Blended", {"a", "b", "c"})), QStringLiteral("Blend"));
  panel_->show(FeatureId("s"));
  settle();
  const auto path = [this] { return session_->document().at("s").parameters.value("path", Value::array()); };
  auto* const list = static_cast<ListField*>(field("path"));
  const auto add = [](const ListField* to) {
    for (auto* button : to->findChildren<QToolButton*>())
      if (button->property("role") == QStringLiteral("add") && button->toolTip() == QStringLiteral("Add an item"))
        return button;
    return static_cast<QToolButton*>(nullptr);
  };
  add(list)->click();
  QCOMPARE(path(), Value::parse("[[0.25,0.25]]"));
  add(list)->click();
  QCOMPARE(path(), Value::parse("[[0.25,0.25],[0.25,0.25]]"));
  auto* const second = dynamic_cast<ListField*>(list->rows()[1]->field());
  QVERIFY(second && second->rows().size() == 2);
  auto* const slider = second->rows()[0]->findChild<RatioSlider*>();
  QVERIFY(slider);
  QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, 5));
  QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, 5));
  COMPARE_NEAR(path().at(1).at(0).get<double>(), 0.5, 0.02);
  QCOMPARE(path().at(1).at(1), Value(0.25));
  QCOMPARE(path().at(0), Value::parse("[0.25,0.25]"));
  emit list->rows()[0]->removeWanted();
  QCOMPARE(path().size(), std::size_t{1});
}

BLOSSOM_WIDGET_TEST(PanelListsTest)
#include "panel_lists_test.moc"
