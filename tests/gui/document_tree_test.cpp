#include "ui/tree/document_tree.h"

#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>

#include "document/edits.h"
#include "support/mouse.h"
#include "tree_fixture.h"
#include "ui/tree/document_delegate.h"
#include "ui/tree/document_tree_panel.h"

using namespace blossom;
using namespace blossom::ui;

class DocumentTreeTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openChain(); }
  void cleanup() { closeTestWindow(); }

  void renamedInPlace();
  void isolatedAndBack();
  void movedWhereItMayStand();
  void refusedWhereItMayNot();
  void draggedOntoAPlace();
  void movedTogetherInEveryOrder();
  void deletedWithWhatUsesIt();
  void aStepIsDeletedAlone();
  void aControlShapeIsDeletedFromItsMorph();
  void theOfferGoesWhenTheDocumentChanges();
  void whatIsSelectedKeepsItsTurn();
  void suppressedInsteadOfDeleted();
  void suppressedAndComputedAgain();
  void foundByNameTypeAndState();
  void eyeHidesAndShows();
  void contextMenuIsMadeOfCommands();
  void commandsSayWhyTheyCannot();

 private:
  [[nodiscard]] int shownRows() {
    int shown = 0;
    for (int row = 0; row < window_->tree().model()->rowCount(); ++row) shown += window_->tree().isRowHidden(row) ? 0 : 1;
    return shown;
  }
  QPushButton* offered(const QString& label) {
    for (QPushButton* button : window_->errors().findChildren<QPushButton*>())
      if (button->text() == label && !button->isHidden()) return button;
    return nullptr;
  }
};

void DocumentTreeTest::renamedInPlace() {
  choose({"b"});
  QTest::keyClick(&window_->tree(), Qt::Key_F2);
  auto* editor = window_->tree().viewport()->findChild<QLineEdit*>();
  QVERIFY(editor);
  editor->selectAll();
  QTest::keyClicks(editor, QStringLiteral("Bracket"));
  QTest::keyClick(editor, Qt::Key_Return);
  QTRY_COMPARE(document().at("b").name, std::string("Bracket"));
  QCOMPARE(undoText(), QStringLiteral("Rename b"));
  undo();
  QCOMPARE(document().at("b").name, std::string("b"));
}

void DocumentTreeTest::isolatedAndBack() {
  choose({"c"});
  trigger("edit.show-hide");
  QVERIFY(!document().at("c").visible);
  choose({"a", "b"});
  trigger("edit.isolate");
  QVERIFY(areOnlyVisible(document(), {"a", "b"}));
  QCOMPARE(undoText(), QStringLiteral("Isolate 2 features"));
  trigger("edit.isolate");
  QVERIFY(document().at("a").visible && document().at("b").visible && document().at("d").visible);
  QVERIFY2(!document().at("c").visible, "what was hidden before stays hidden");
  undo();
  QVERIFY(areOnlyVisible(document(), {"a", "b"}));
  undo();
  QVERIFY(document().at("d").visible && !document().at("c").visible);
}

void DocumentTreeTest::movedWhereItMayStand() {
  choose({"c"});
  QTest::keyClick(window_.get(), Qt::Key_Up, Qt::AltModifier);
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "c", "b", "d"}));
  QCOMPARE(window_->tree().selected(), std::vector<FeatureId>{"c"});
  QTest::keyClick(window_.get(), Qt::Key_Up, Qt::AltModifier);
  QCOMPARE(order(), (std::vector<FeatureId>{"c", "a", "b", "d"}));
  QTest::keyClick(window_.get(), Qt::Key_Up, Qt::AltModifier);  // it stands at the top already
  QCOMPARE(order(), (std::vector<FeatureId>{"c", "a", "b", "d"}));
  undo();
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "c", "b", "d"}));
  undo();
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c", "d"}));
  QCOMPARE(window_->tree().model()->rowCount(), 4);
}

void DocumentTreeTest::refusedWhereItMayNot() {
  const QString before = undoText();
  choose({"b"});
  QTest::keyClick(window_.get(), Qt::Key_Up, Qt::AltModifier);
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c", "d"}));
  QVERIFY(window_->errors().isVisible());
  QCOMPARE(window_->errors().message(), QStringLiteral("\"b\" cannot stand before its input \"a\"."));
  window_->tree().moveSelectedBefore(4);
  QCOMPARE(window_->errors().message(), QStringLiteral("\"b\" cannot stand after \"d\", which uses it."));
  QCOMPARE(undoText(), before);
}

void DocumentTreeTest::draggedOntoAPlace() {
  DocumentTree& tree = window_->tree();
  choose({"c"});
  const std::unique_ptr<QMimeData> rows(tree.model()->mimeData({row("c")}));
  const QRect first = tree.visualRect(row("a"));
  QDropEvent drop(QPointF(first.center().x(), first.top() + 2), Qt::MoveAction, rows.get(), Qt::LeftButton, {});
  struct Opened : DocumentTree {
    using DocumentTree::dropEvent;
  };
  (tree.*&Opened::dropEvent)(&drop);  // Qt hands on what the desktop drags, nothing else
  QCOMPARE(order(), (std::vector<FeatureId>{"c", "a", "b", "d"}));
  undo();
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c", "d"}));
}

// Whatever is moved wherever: inputs stay before users, nothing is lost, the others keep their order.
void DocumentTreeTest::movedTogetherInEveryOrder() {
  std::mt19937_64 random = test::seededRandom();
  for (int round = 0; round < 300; ++round) {
    std::vector<Feature> features;
    for (int i = 0; i < 9; ++i) {
      std::vector<FeatureId> inputs;
      if (i > 0 && random() % 3 == 0) inputs.push_back(std::to_string(random() % static_cast<unsigned>(i)));
      features.push_back(feature(std::to_string(i), "test.block", inputs));
    }
    const Document before = Document::of(features);
    std::vector<FeatureId> moving;
    for (const auto& each : before.features())
      if (random() % 3 == 0) moving.push_back(each->id);
    const std::size_t target = random() % 10;
    std::vector<FeatureId> expected;
    std::size_t place = 0;
    for (const bool wanted : {false, true, false}) {
      for (std::size_t i = 0; i < 9; ++i) {
        const FeatureId id = before.features()[i]->id;
        const bool moves = std::find(moving.begin(), moving.end(), id) != moving.end();
        if (wanted ? moves : !moves && (place == 0 ? i < target : i >= target)) expected.push_back(id);
      }
      ++place;
    }
    std::set<FeatureId> seen;
    bool possible = true;
    for (const FeatureId& id : expected) {
      for (const FeatureId& input : before.at(id).inputs) possible = possible && seen.contains(input);
      seen.insert(id);
    }
    if (!possible) {
      VERIFY_ERROR(withMoved(before, moving, target), ErrorCode::InvalidInput);
      continue;
    }
    std::vector<FeatureId> ids;
    const Document after = withMoved(before, moving, target);
    for (const auto& each : after.features()) ids.push_back(each->id);
    QCOMPARE(ids, expected);
  }
}

void DocumentTreeTest::deletedWithWhatUsesIt() {
  choose({"a"});
  trigger("edit.delete");
  QCOMPARE(order().size(), std::size_t(4));
  QCOMPARE(window_->errors().message(), QStringLiteral("\"a\" is used by \"b\" and \"d\"."));
  QPushButton* all = offered(QStringLiteral("Delete all 3"));
  QVERIFY(all);
  QTest::mouseClick(all, Qt::LeftButton);
  QCOMPARE(order(), std::vector<FeatureId>{"c"});
  QVERIFY(window_->errors().isHidden());
  undo();
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c", "d"}));
  choose({"d"});
  trigger("edit.delete");
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c"}));
  undo();
}

/// What goes on from a step is made of what the step was made of.
void DocumentTreeTest::aStepIsDeletedAlone() {
  QCOMPARE(document().at("b").inputs, std::vector<FeatureId>{"a"});
  QCOMPARE(document().usersOf("b"), std::vector<FeatureId>{"d"});
  choose({"b"});
  trigger("edit.delete");
  QPushButton* alone = offered(QStringLiteral("Delete alone"));
  QVERIFY(alone);
  QTest::mouseClick(alone, Qt::LeftButton);
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "c", "d"}));
  QCOMPARE(document().at("d").inputs, (std::vector<FeatureId>{"a", "c"}));
  undo();
}

/// What takes other shapes as well does without; what takes one shape cannot.
void DocumentTreeTest::aControlShapeIsDeletedFromItsMorph() {
  Feature morph = feature("morph", "minkowski.morph", {"p", "q", "r"}), solid = feature("solid", "modeling.extrude", {"p"});
  morph.parameters = {{"offsets", {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}}};
  const Document drawn = Document::of(
      {feature("p", "modeling.circle"), feature("q", "modeling.circle"), feature("r", "modeling.rectangle"), morph, solid});
  window_->session().commit(drawn, QStringLiteral("Draw"));
  waitUntilComputed();
  choose({"p"});
  trigger("edit.delete");
  QVERIFY(offered(QStringLiteral("Delete all 3")));
  QVERIFY(!offered(QStringLiteral("Delete alone")));
  choose({"q"});
  trigger("edit.delete");
  QPushButton* alone = offered(QStringLiteral("Delete alone"));
  QVERIFY(alone);
  QTest::mouseClick(alone, Qt::LeftButton);
  QCOMPARE(document().at("morph").inputs, (std::vector<FeatureId>{"p", "r"}));
  QCOMPARE(document().at("morph").parameters.at("offsets"), Value::parse("[[1,0,0],[3,0,0]]"));
  QVERIFY(!document().contains("q"));
  choose({"r"});  // a morph takes two
  trigger("edit.delete");
  QVERIFY(!offered(QStringLiteral("Delete alone")));
  undo();
  QCOMPARE(document().at("morph").inputs, (std::vector<FeatureId>{"p", "q", "r"}));
}

/// What is told of a document is not told of another one.
void DocumentTreeTest::theOfferGoesWhenTheDocumentChanges() {
  choose({"c"});
  trigger("edit.duplicate");
  choose({"a"});
  trigger("edit.delete");
  QVERIFY(!window_->errors().isHidden());
  undo();
  QVERIFY(window_->errors().isHidden());
}

void DocumentTreeTest::whatIsSelectedKeepsItsTurn() {
  window_->tree().select("c");
  window_->tree().select("a", true);
  window_->tree().select("d", true);
  QCOMPARE(window_->tree().selectedInTurn(), (std::vector<FeatureId>{"c", "a", "d"}));
  QCOMPARE(window_->tree().selected(), (std::vector<FeatureId>{"a", "c", "d"}));
  window_->tree().select("a", true);
  QCOMPARE(window_->tree().selectedInTurn(), (std::vector<FeatureId>{"c", "d"}));
  // What selects itself, as a new feature does, has no turn: then the first made is the first.
  window_->tree().selectAdded("d");
  window_->tree().select("a", true);
  QCOMPARE(window_->tree().selectedInTurn(), (std::vector<FeatureId>{"a", "d"}));
  // A click on it gives it a turn, though it is selected already.
  window_->tree().selectAdded("d");
  const QModelIndex row = window_->tree().model()->index(static_cast<int>(window_->tree().model()->rowCount()) - 1, 0);
  QCOMPARE(window_->tree().currentIndex(), row);
  QTest::mouseClick(window_->tree().viewport(), Qt::LeftButton, {}, window_->tree().visualRect(row).center());
  window_->tree().select("a", true);
  QCOMPARE(window_->tree().selectedInTurn(), (std::vector<FeatureId>{"d", "a"}));
}

void DocumentTreeTest::suppressedInsteadOfDeleted() {
  choose({"b"});
  trigger("edit.delete");
  QTest::mouseClick(offered(QStringLiteral("Suppress")), Qt::LeftButton);
  QVERIFY(document().at("b").suppressed);
  QCOMPARE(undoText(), QStringLiteral("Suppress b"));
  undo();
  QVERIFY(!document().at("b").suppressed);
}

void DocumentTreeTest::suppressedAndComputedAgain() {
  choose({"b", "c"});
  trigger("edit.suppress");
  QVERIFY(document().at("b").suppressed && document().at("c").suppressed);
  QCOMPARE(row("b").data(DocumentModel::StateRole).toString(), QStringLiteral("suppressed"));
  QCOMPARE(window_->commands().action(QStringLiteral("edit.suppress"))->text(), QStringLiteral("Compute a&gain"));
  trigger("edit.suppress");
  QVERIFY(!document().at("b").suppressed && !document().at("c").suppressed);
  undo();
  undo();
  waitUntilComputed();
  QVERIFY(row("b").data(DocumentModel::StateRole).toString().startsWith(QStringLiteral("mesh")));
}

void DocumentTreeTest::foundByNameTypeAndState() {
  window_->session().commit(
      document().with(feature("f", "test.failing", {}, "Pocket of the lid")).with(feature("s", "sweep.sweep")), {});
  waitUntilComputed();
  trigger("edit.find");
  QLineEdit* field = window_->page().treePanel().searchField();
  QTRY_VERIFY(field->hasFocus());
  QTest::keyClicks(field, QStringLiteral("lid pock"));
  QCOMPARE(shownRows(), 1);
  QVERIFY(!window_->tree().isRowHidden(row("f").row()));
  field->setText(QStringLiteral("block"));
  QCOMPARE(shownRows(), 4);
  field->setText(QStringLiteral("error"));
  QCOMPARE(shownRows(), 2);
  QTest::keyClick(field, Qt::Key_Return);
  QCOMPARE(window_->tree().selected(), std::vector<FeatureId>{"f"});
  window_->tree().selectAll();
  QCOMPARE(window_->tree().selected().size(), std::size_t(2));
  QTest::keyClick(field, Qt::Key_Escape);
  QCOMPARE(shownRows(), 6);
  QVERIFY(field->isHidden());
}

void DocumentTreeTest::eyeHidesAndShows() {
  DocumentTree& tree = window_->tree();
  const QPoint eye = DocumentDelegate::eyeRect(tree.visualRect(row("c"))).center();
  test::moveMouse(tree.viewport(), eye);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, eye);
  QVERIFY(!document().at("c").visible);
  QCOMPARE(undoText(), QStringLiteral("Hide c"));
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, eye);
  QVERIFY(document().at("c").visible);
  choose({"a", "b"});
  QTest::keyClick(&tree, Qt::Key_Space);
  QVERIFY(!document().at("a").visible && !document().at("b").visible);
  undo();
  QVERIFY(document().at("a").visible && document().at("b").visible);
}

void DocumentTreeTest::contextMenuIsMadeOfCommands() {
  DocumentTree& tree = window_->tree();
  const QPoint at = tree.visualRect(row("c")).center();
  QContextMenuEvent wanted(QContextMenuEvent::Mouse, at, tree.viewport()->mapToGlobal(at));
  QApplication::sendEvent(tree.viewport(), &wanted);
  QPointer<QMenu> menu = window_->findChild<QMenu*>(QStringLiteral("contextMenu"));
  QVERIFY(menu);
  QCOMPARE(tree.selected(), std::vector<FeatureId>{"c"});
  for (const char* id : {"edit.rename", "edit.isolate", "edit.suppress", "edit.delete", "file.export"})
    QVERIFY2(menu->actions().contains(window_->commands().action(QLatin1String(id))), id);
  menu->close();
  QTRY_VERIFY(menu.isNull());
}

void DocumentTreeTest::commandsSayWhyTheyCannot() {
  window_->tree().clearSelection();
  const Command* remove = window_->commands().find(QStringLiteral("edit.delete"));
  QVERIFY(remove && !remove->action->isEnabled());
  QCOMPARE(remove->whyNot, QStringLiteral("Select a feature first."));
  choose({"a"});
  QVERIFY(remove->action->isEnabled() && remove->whyNot.isEmpty());
}

BLOSSOM_WINDOW_TEST(DocumentTreeTest)
#include "document_tree_test.moc"
