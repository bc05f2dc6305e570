#include "panel_fixture.h"
#include "ui/controls/chip.h"
#include "ui/panel/input_editor.h"
#include "ui/panel/input_slots.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// An edge of 20 mm as a document keeps it.
Value keptEdge(int index, const Vec3& place) {
  const Value likeness = toJson(Likeness{"line", place, 20});
  return {{"input", "base"}, {"kind", "edge"}, {"index", index}, {"signature", {{"likeness", likeness}}}};
}

/// Without those that were replaced, which wait for being deleted.
QList<Chip*> shownChips(const ParameterField& field) {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return field.findChildren<Chip*>();
}

}  // namespace

/// What is picked in the view or among the features.
class PanelPickingTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openPanel(); }
  void cleanup() { closePanel(); }
  void pointsAndVectors();
  void subShapesArePicked();
  void inputsAreReplacedAddedAndRemoved();
  void circlesAndWrongKindsAreRefused();
  void lostPartsAreMarkedAndTakenAnew();
  void chosenPartsAreMarkedInTheView();
  void theChipUnderTheMouseIsMarkedInTheView();
};

void PanelPickingTest::pointsAndVectors() {
  auto* y = field("point")->findChild<QLineEdit*>(QStringLiteral("y"));
  oneStep("point", Value::array({0.0, 25.4, 0.0}), [&] { type(y, QStringLiteral("1 in")); });
  type(y, QStringLiteral("3 deg"));
  QVERIFY(!field("point")->problem().isEmpty());
  QCOMPARE(now("point"), Value::array({0.0, 25.4, 0.0}));
  QTest::keyClick(y, Qt::Key_Escape);

  QSignalSpy wanted(panel_.get(), &PropertyPanel::pickWanted), ended(panel_.get(), &PropertyPanel::pickEnded);
  oneStep("point", Value::array({1.0, 2.5, -3.0}), [&] {
    QTest::mouseClick(pickButton("point"), Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(panel_->wanted() && panel_->wanted()->want == PickRequest::Want::Point);
    QCOMPARE(panel_->wanted()->parameter, QStringLiteral("point"));
    panel_->offerPick(pickOf(SubShapeKind::Whole, -1));
  });
  QCOMPARE(ended.size(), 1);
  QVERIFY(!panel_->wanted());
  oneStep("vector", Value::array({0.0, 1.0, 0.0}), [&] {
    pickButton("vector")->click();
    panel_->offerPick(pickOf(SubShapeKind::Face, 0));
  });
  // A second click on the button gives up.
  auto* button = pickButton("vector");
  button->click();
  button->click();
  QVERIFY(!panel_->wanted() && !button->isChecked());
}

void PanelPickingTest::subShapesArePicked() {
  const Value face{{"input", "base"}, {"kind", "face"}, {"index", 4}};
  auto* pickFace = pickButton("face");
  QSignalSpy wanted(panel_.get(), &PropertyPanel::pickWanted);
  oneStep("face", face, [&] {
    QTest::mouseClick(pickFace, Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(panel_->wanted()->kind == SubShapeKind::Face && panel_->wanted()->features == std::vector<FeatureId>{"a"});
    panel_->offerPick(pickOf(SubShapeKind::Edge, 4));
    QVERIFY(field("face")->problem().contains(QStringLiteral("edge")));
    panel_->offerPick(pickOf(SubShapeKind::Face, 4, "b"));
    QVERIFY(!field("face")->problem().isEmpty() && panel_->wanted());
    panel_->offerPick(pickOf(SubShapeKind::Face, 4));
    QVERIFY(!panel_->wanted());
  });
  QCOMPARE(editor<Chip>("face")->text(), QStringLiteral("Face 4 of Plate"));
  oneStep("face", Value(), [&] {
    editor<Chip>("face")->setFocus();
    QTest::keyClick(editor<Chip>("face"), Qt::Key_Delete);
  });

  const auto edge = [](int index) { return Value{{"input", "base"}, {"kind", "edge"}, {"index", index}}; };
  pickButton("edges")->click();
  oneStep("edges", Value::array({edge(1)}), [&] { panel_->offerPick(pickOf(SubShapeKind::Edge, 1)); });
  oneStep("edges", Value::array({edge(1), edge(2)}), [&] { panel_->offerPick(pickOf(SubShapeKind::Edge, 2)); });
  oneStep("edges", Value::array({edge(2)}), [&] { panel_->offerPick(pickOf(SubShapeKind::Edge, 1)); });
  QVERIFY(panel_->wanted());
  panel_->endPick();
  QVERIFY(!pickButton("edges")->isChecked());
  oneStep("edges", Value::array(), [&] {
    Chip* chip = editor<Chip>("edges");
    QTest::mouseClick(chip, Qt::LeftButton, {}, QPoint(chip->width() - 14, chip->height() / 2));
  });
}

void PanelPickingTest::inputsAreReplacedAddedAndRemoved() {
  const auto inputs = [&] { return session_->document().at("e").inputs; };
  using Ids = std::vector<FeatureId>;
  InputEditor* base = panel_->input(QStringLiteral("base"));
  InputEditor* others = panel_->input(QStringLiteral("others"));
  QVERIFY(base && others);
  QCOMPARE(base->findChildren<Chip*>().size(), 1);
  QCOMPARE(base->findChild<Chip*>()->text(), QStringLiteral("Plate"));
  others->take(0, "b");
  QCOMPARE(inputs(), (Ids{"a", "b"}));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change others of All"));
  settle();
  base->take(0, "b");
  QCOMPARE(inputs(), (Ids{"b", "b"}));
  session_->undo();
  QCOMPARE(inputs(), (Ids{"a", "b"}));

  // Picked in the view.
  QSignalSpy wanted(panel_.get(), &PropertyPanel::pickWanted);
  for (auto* button : base->findChildren<QToolButton*>())
    if (button->isCheckable()) button->click();
  QCOMPARE(wanted.size(), 1);
  QVERIFY(panel_->wanted()->want == PickRequest::Want::Feature);
  QCOMPARE(panel_->wanted()->features, (Ids{"b"}));
  panel_->offerPick(pickOf(SubShapeKind::Face, 0, "b"));
  QCOMPARE(inputs(), (Ids{"b", "b"}));
  QVERIFY(!panel_->wanted());

  // The last one of a run that may be empty is let go of by its cross.
  QTRY_COMPARE(others->findChildren<Chip*>().size(), 1);
  Chip* chip = others->findChild<Chip*>();
  chip->setFocus();
  QTest::keyClick(chip, Qt::Key_Delete);
  QCOMPARE(inputs(), (Ids{"b"}));
  // The one that is needed stays.
  Chip* needed = base->findChild<Chip*>();
  needed->setFocus();
  QTest::keyClick(needed, Qt::Key_Delete);
  QCOMPARE(inputs(), (Ids{"b"}));
}

void PanelPickingTest::circlesAndWrongKindsAreRefused() {
  const std::string before = toJson(session_->document());
  InputEditor* others = panel_->input(QStringLiteral("others"));
  others->take(0, "f");
  QVERIFY2(others->problem().contains(QStringLiteral("circle")), qPrintable(others->problem()));
  others->take(0, "e");
  QVERIFY(others->problem().contains(QStringLiteral("circle")));
  others->take(0, "m");
  QVERIFY2(others->problem().contains(QStringLiteral("curve")), qPrintable(others->problem()));
  QCOMPARE(toJson(session_->document()), before);
  const FeatureType everyKind = everything();
  const InputSlots offered(*session_, session_->document().at("e"), everyKind);
  QCOMPARE(offered.candidates(0), std::vector<FeatureId>{"b"});
}

// Another edge may have the number of a lost one: a click on it does not take the lost one away.
void PanelPickingTest::lostPartsAreMarkedAndTakenAnew() {
  const Value lost = keptEdge(0, {0, 0, 10}), farLost = keptEdge(5, {0, 90, 10}), found = keptEdge(3, {60, 0, 10});
  auto context = std::make_shared<FieldContext>();
  context->sources = {{"base", "a", QStringLiteral("Plate")}};
  context->lost = {lost, farLost};
  context->likenessOf = [](const Pick& pick) { return Likeness{"line", pick.part.point, 20}; };
  const std::unique_ptr<ParameterField> edges(
      ParameterField::make(declared("edges", list(subShape("edge")), Value::array()), nullptr, context));
  const Value before = Value::array({found, farLost, lost});
  edges->setValue(before);
  const auto chips = shownChips(*edges);
  QCOMPARE(chips.size(), 3);
  QVERIFY(chips[0]->problem().isEmpty());
  QVERIFY(!chips[1]->problem().isEmpty() && !chips[2]->problem().isEmpty());

  const auto pickAt = [&](int index, const Vec3& place) {
    Pick pick = pickOf(SubShapeKind::Edge, index);
    pick.part.point = place;
    QVERIFY(edges->takePick(pick));
  };
  const auto picked = [](int index) { return Value{{"input", "base"}, {"kind", "edge"}, {"index", index}}; };
  pickAt(0, {1, 2, 10});
  QCOMPARE(edges->value(), Value::array({found, farLost, picked(0)}));
  const auto after = shownChips(*edges);
  QVERIFY(!after[1]->problem().isEmpty() && after[2]->problem().isEmpty());
  pickAt(0, {1, 2, 10});  // chosen: let go of again
  QCOMPARE(edges->value(), Value::array({found, farLost}));

  edges->setValue(before);
  pickAt(7, {40, 40, 10});  // near to none of them: one more
  QCOMPARE(edges->value(), Value::array({found, farLost, lost, picked(7)}));
  edges->setValue(before);
  pickAt(3, {60, 0, 10});
  QCOMPARE(edges->value(), Value::array({farLost, lost}));
}

void PanelPickingTest::chosenPartsAreMarkedInTheView() {
  MarkedParts marked;
  connect(panel_.get(), &PropertyPanel::partsMarked, this, [&](const MarkedParts& parts) { marked = parts; });
  const auto numbers = [&] {
    std::vector<int> all;
    for (const Pick& pick : marked.chosen)
      if (pick.feature == "a" && pick.part.kind == SubShapeKind::Edge) all.push_back(pick.part.index);
    return all;
  };
  pickButton("edges")->click();
  panel_->offerPick(pickOf(SubShapeKind::Edge, 1));
  panel_->offerPick(pickOf(SubShapeKind::Edge, 2));
  QCOMPARE(numbers(), (std::vector<int>{1, 2}));
  panel_->offerPick(pickOf(SubShapeKind::Edge, 1));
  QCOMPARE(numbers(), std::vector<int>{2});
  session_->undo();
  QCOMPARE(numbers(), (std::vector<int>{1, 2}));
  panel_->endPick();
  QVERIFY(marked.chosen.empty());
  pickButton("edges")->click();  // they are lit before anything is picked
  QCOMPARE(numbers(), (std::vector<int>{1, 2}));
  pickButton("vector")->click();  // another field wants something
  QVERIFY(marked.chosen.empty());
  panel_->disconnect(this);
}

void PanelPickingTest::theChipUnderTheMouseIsMarkedInTheView() {
  pickButton("edges")->click();
  panel_->offerPick(pickOf(SubShapeKind::Edge, 1));
  panel_->offerPick(pickOf(SubShapeKind::Edge, 2));
  panel_->endPick();
  MarkedParts marked;
  connect(panel_.get(), &PropertyPanel::partsMarked, this, [&](const MarkedParts& parts) { marked = parts; });
  const auto chips = shownChips(*field("edges"));
  QCOMPARE(chips.size(), 2);
  const QPointF at(chips[1]->rect().center());
  QEnterEvent enter(at, at, chips[1]->mapToGlobal(at));
  QApplication::sendEvent(chips[1], &enter);
  QVERIFY(marked.pointed && marked.pointed->feature == "a");
  QCOMPARE(marked.pointed->part.index, 2);
  QVERIFY(marked.chosen.empty());  // nothing is being picked
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(chips[1], &leave);
  QVERIFY(!marked.pointed);

  // The chip of another field: what is chosen for this one stays lit.
  pickButton("face")->click();
  panel_->offerPick(pickOf(SubShapeKind::Face, 0));
  pickButton("edges")->click();
  Chip* const other = shownChips(*field("face")).front();
  QApplication::sendEvent(other, &enter);
  QVERIFY(marked.pointed && marked.pointed->part.kind == SubShapeKind::Face);
  QCOMPARE(marked.chosen.size(), std::size_t{2});
  QApplication::sendEvent(other, &leave);
  QVERIFY(!marked.pointed);
  QCOMPARE(marked.chosen.size(), std::size_t{2});
  panel_->disconnect(this);
}

BLOSSOM_WIDGET_TEST(PanelPickingTest)
#include "panel_picking_test.moc"
