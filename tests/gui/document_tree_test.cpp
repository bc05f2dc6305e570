#include "ui/tree/document_tree.h"

#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>

#include "document/edits.h"
#include "support/mouse.h"
#include "tree_fixture.h"
#include "ui/panel/fault_bar.h"
#include "ui/tree/document_clipboard.h"
#include "ui/tree/document_delegate.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree_panel.h"
#include "ui/window/status_line.h"

using namespace blossom;
using namespace blossom::ui;

class DocumentTreeTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openTestWindow();
    showChain();
  }
  void cleanup() {
    letGo_ = true;
    window_.reset();
    letGo_ = false;
  }
  void renamedInPlace();
  void isolatedAndBack();
  void movedWhereItMayStand();
  void refusedWhereItMayNot();
  void draggedOntoAPlace();
  void movedTogetherInEveryOrder();
  void deletedWithWhatUsesIt();
  void suppressedInsteadOfDeleted();
  void suppressedAndComputedAgain();
  void foundByNameTypeAndState();
  void duplicatedWithTheSameInputs();
  void pastedIntoAnotherDocument();
  void pastedFromText();
  void failuresSayWhyAndWhatToDo();
  void failuresAreToldAboveTheView();
  void whatIsOutOfDateIsDrawnFaintly();
  void eyeHidesAndShows();
  void contextMenuIsMadeOfCommands();
  void commandsSayWhyTheyCannot();

 private:
  [[nodiscard]] int shownRows() {
    int shown = 0;
    for (int row = 0; row < window_->tree().model()->rowCount(); ++row) shown += window_->tree().isRowHidden(row) ? 0 : 1;
    return shown;
  }
  [[nodiscard]] QModelIndex row(const char* id) {
    const auto found = window_->tree().model()->match(window_->tree().model()->index(0, 0), DocumentModel::IdRole,
                                                      QLatin1String(id), 1, Qt::MatchExactly);
    return found.isEmpty() ? QModelIndex() : found.front();
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

void DocumentTreeTest::duplicatedWithTheSameInputs() {
  choose({"b", "d"});
  trigger("edit.duplicate");
  QCOMPARE(order().size(), std::size_t(6));
  QCOMPARE(undoText(), QStringLiteral("Duplicate 2 features"));
  const std::vector<FeatureId> copies = window_->tree().selected();
  QCOMPARE(copies.size(), std::size_t(2));
  QCOMPARE(document().at(copies[0]).inputs, std::vector<FeatureId>{"a"});
  QCOMPARE(document().at(copies[1]).inputs, (std::vector<FeatureId>{copies[0], "c"}));
  QCOMPARE(document().at(copies[0]).name, std::string("b 2"));
  undo();
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c", "d"}));
}

void DocumentTreeTest::pastedIntoAnotherDocument() {
  choose({"b"});
  trigger("edit.copy");
  trigger("edit.paste");
  QCOMPARE(order().size(), std::size_t(5));  // made from the "a" that is there
  undo();
  window_->addPage();
  trigger("edit.paste");
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b"}));
  QCOMPARE(document().at("b").inputs, std::vector<FeatureId>{"a"});
  undo();
  QVERIFY(order().empty());
}

// Another program sees text; what comes from one is checked.
void DocumentTreeTest::pastedFromText() {
  const auto content = std::make_shared<const std::string>("solid nothing");
  Feature file = feature("file", "exchange.import");
  file.parameters = {{"file", {{"asset", contentHash(*content)}, {"name", "nothing.stl"}}}};
  const Document source = Document::of({file}).withAsset(contentHash(*content), content);
  const std::unique_ptr<QMimeData> own(toMimeData({source, {"file"}}));
  QMimeData foreign;
  for (const QString& format : own->formats()) foreign.setData(format, own->data(format));
  QVERIFY(own->text().contains(QStringLiteral("exchange.import")));
  const auto read = fromMimeData(&foreign);
  QVERIFY(read);
  QCOMPARE(read->wanted, std::vector<FeatureId>{"file"});
  QCOMPARE(read->document.at("file").parameters, file.parameters);
  QCOMPARE(*read->document.assets().at(contentHash(*content)), *content);
  QMimeData damaged;
  damaged.setData(own->formats().front(), "{\"blossom\": 1, \"features\": [");
  VERIFY_ERROR(fromMimeData(&damaged), ErrorCode::FormatDamaged);
}

void DocumentTreeTest::failuresSayWhyAndWhatToDo() {
  const int plain = window_->tree().visualRect(row("a")).height();
  window_->session().commit(document().with(feature("f", "test.failing", {}, "Pocket")), {});
  waitUntilComputed();
  const QModelIndex failed = row("f");
  QVERIFY(failed.data(DocumentModel::FailedRole).toBool());
  QCOMPARE(failed.data(DocumentModel::StateRole).toString(), QStringLiteral("The tool of 12 mm is too large."));
  QCOMPARE(failed.data(DocumentModel::RemedyRole).toString(), QStringLiteral("A tool of 4.8 mm would fit."));
  const QString tip = failed.data(Qt::ToolTipRole).toString();
  QVERIFY(tip.contains(QStringLiteral("too large")) && tip.contains(QStringLiteral("would fit")));
  QTRY_VERIFY2(window_->tree().visualRect(failed).height() > plain, "the remedy has a line of its own");
}

void DocumentTreeTest::failuresAreToldAboveTheView() {
  window_->resize(1024, 700);
  const FaultBar& bar = window_->page().faults();
  QVERIFY(bar.isHidden());
  window_->session().commit(document().with(feature("f", "test.failing", {}, "Pocket")), {});
  waitUntilComputed();
  choose({"f"});
  QTRY_VERIFY(bar.isVisible());
  QCOMPARE(bar.message(), QStringLiteral("Pocket: The tool of 12 mm is too large."));
  QCOMPARE(bar.hint(), QStringLiteral("A tool of 4.8 mm would fit."));
  // All of it is seen, at the top of the view, whatever the panel shows.
  QCoreApplication::processEvents();
  QCOMPARE(bar.visibleRegion().boundingRect(), bar.rect());
  const QRect canvas(window_->view().mapTo(window_.get(), QPoint()), window_->view().size());
  const QRect place(bar.mapTo(window_.get(), QPoint()), bar.size());
  QVERIFY(canvas.contains(place) && place.bottom() < canvas.center().y());
  const auto offers = [&] {
    int shown = 0;
    for (const auto* button : bar.findChildren<QPushButton*>()) shown += button->isHidden() ? 0 : 1;
    return shown;
  };
  QCOMPARE(offers(), 0);

  // Seen from another feature it offers the way; it goes with the failure, and Esc dismisses it until there is another.
  choose({"a"});
  QVERIFY(bar.isVisible());
  QCOMPARE(offers(), 1);
  bar.findChild<QPushButton*>()->click();
  QCOMPARE(window_->tree().current(), FeatureId("f"));
  QVERIFY(bar.isVisible());
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QVERIFY(bar.isHidden());
  Feature other = document().at("a");
  other.visible = false;
  window_->session().commit(document().with(other), {});
  waitUntilComputed();
  QVERIFY(bar.isHidden());
  window_->session().commit(document().with(feature("g", "test.failing", {}, "Slot")), {});
  waitUntilComputed();
  choose({"g"});
  QVERIFY(bar.isVisible() && bar.message().startsWith(QStringLiteral("Slot: ")));
  window_->session().commit(document().without("g").without("f"), {});
  waitUntilComputed();
  QVERIFY(bar.isHidden());
}

/// Mean difference of the pixels, 0 to 255.
static double contrast(const QImage& a, const QImage& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      sum += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
    }
  return sum / 3 / a.width() / a.height();
}

void DocumentTreeTest::whatIsOutOfDateIsDrawnFaintly() {
  Session& session = window_->session();
  Feature input = feature("a", "test.block"), shown = feature("w", "test.waiting");
  input.visible = false;
  letGo_ = true;
  session.commit(Document::of({input, shown}), QStringLiteral("Begin"));
  waitUntilComputed();
  window_->view().fit(false);
  const QImage ready = canvas();
  Feature hidden = shown;
  hidden.visible = false;
  session.commit(document().with(hidden), QStringLiteral("Hide"));
  waitUntilComputed();
  const double whole = contrast(ready, canvas());
  const QImage empty = canvas();
  QVERIFY(whole > 1);
  undo();
  waitUntilComputed();
  QCOMPARE(canvas(), ready);

  letGo_ = false;
  Feature changed = shown;
  changed.inputs = {"a"};
  session.commit(document().with(changed), QStringLiteral("Change"));
  QTRY_VERIFY(session.outdated("w"));
  QVERIFY(!session.outdated("a"));
  // Drawn with 3/10, it differs from the ground by less than 51/100 even where two of its sides lie on each other.
  QVERIFY2(contrast(canvas(), empty) < 0.6 * whole, qPrintable(QString::number(contrast(canvas(), empty) / whole)));
  QVERIFY(contrast(canvas(), empty) > 0.1 * whole);
  session.cancelEvaluation();
  window_->errors().hide();  // the view has the size of before
  QVERIFY(session.outdated("w"));
  QTRY_COMPARE(canvas().size(), empty.size());
  QVERIFY(contrast(canvas(), empty) < 0.6 * whole);
  letGo_ = true;
  session.compute();
  QVERIFY(session.outdated("w"));  // it was waited for before
  waitUntilComputed();
  QVERIFY(!session.outdated("w"));
  QCOMPARE(canvas(), ready);
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

BLOSSOM_WINDOW_TEST_MAIN(DocumentTreeTest)
#include "document_tree_test.moc"
