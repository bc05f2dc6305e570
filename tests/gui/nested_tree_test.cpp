// The tree shows what is final, and beneath it, folded, the steps that have gone into it, in the real window.
#include "document/storage.h"
#include "ui/tree/document_delegate.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"
#include "ui/tree/document_tree_panel.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class NestedTreeTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openNewDocument(); }
  void cleanup() { window_.reset(); }
  void stepsAreNestedUnderWhatIsFinal();
  void controlsAreNoSteps();
  void foldedByArrowAndKeys();
  void aStepThatIsSelectedIsShown();
  void theFilterFindsFoldedSteps();
  void stepsMoveWithTheirResult();
  void manyResultsOpenAtTheTop();

 private:
  [[nodiscard]] DocumentTree& tree() { return window_->tree(); }
  [[nodiscard]] QModelIndex row(const FeatureId& id) { return static_cast<DocumentModel*>(tree().model())->indexOf(id); }
  /// The rows that are shown, each indented by two blanks a level.
  [[nodiscard]] QStringList rows() {
    QStringList shown;
    for (int k = 0; k < tree().model()->rowCount(); ++k) {
      const QModelIndex index = tree().model()->index(k, 0);
      if (!tree().isRowHidden(k))
        shown << QString(2 * index.data(DocumentModel::DepthRole).toInt(), u' ') +
                     index.data(DocumentModel::IdRole).toString();
    }
    return shown;
  }
  /// A block with a hole, rounded, and a ball beside it.
  void addRoundedBlock() {
    outline_ = add("modeling.rectangle", {{"width", 60}, {"height", 40}});
    block_ = add("modeling.extrude", {{"height", 20}}, {outline_});
    pin_ = add("modeling.cylinder", {{"radius", 8}, {"height", 60}});
    cut_ = add("modeling.boolean", {{"operation", "difference"}}, {block_, pin_});
    rounded_ = add("modeling.fillet", {{"radius", 2}}, {cut_});
    ball_ = add("modeling.sphere", {{"radius", 5}, {"position", {80, 0, 0}}});
    tree().select({});
  }
  static QString indented(int level, const FeatureId& id) { return QString(2 * level, u' ') + QString::fromStdString(id); }
  [[nodiscard]] QStringList unfolded() const {
    return {indented(0, rounded_), indented(1, cut_), indented(2, block_),
            indented(2, outline_), indented(2, pin_), indented(0, ball_)};
  }
  FeatureId outline_, block_, pin_, cut_, rounded_, ball_;
};

void NestedTreeTest::stepsAreNestedUnderWhatIsFinal() {
  addRoundedBlock();
  tree().setFolded(rounded_, true);
  tree().setFolded(cut_, true);
  QCOMPARE(rows(), QStringList({indented(0, rounded_), indented(0, ball_)}));
  QVERIFY(row(rounded_).data(DocumentModel::StepsRole).toBool());
  QVERIFY(!row(ball_).data(DocumentModel::StepsRole).toBool());
  tree().setFolded(rounded_, false);
  QCOMPARE(rows(), QStringList({indented(0, rounded_), indented(1, cut_), indented(0, ball_)}));
  tree().setFolded(cut_, false);
  QCOMPARE(rows(), unfolded());
  // What used them is gone: they are final again.
  window_->session().commit(window_->page().document().without(rounded_).without(cut_), QStringLiteral("Delete"));
  waitUntilComputed();
  tree().setFolded(block_, true);
  QCOMPARE(rows(), QStringList({indented(0, block_), indented(0, pin_), indented(0, ball_)}));
}

void NestedTreeTest::controlsAreNoSteps() {
  const FeatureId circle = add("modeling.circle", {{"radius", 20}}), star = add("modeling.star");
  const FeatureId morph = add("minkowski.morph", Value::object(), {circle, star});
  QCOMPARE(rows(), QStringList({indented(0, circle), indented(0, star), indented(0, morph)}));
}

void NestedTreeTest::foldedByArrowAndKeys() {
  addRoundedBlock();
  tree().setFolded(rounded_, true);
  const auto clickArrow = [&](const FeatureId& id) {
    const QPoint at = DocumentDelegate::foldRect(tree().visualRect(row(id)), row(id)).center();
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, at);
  };
  clickArrow(rounded_);
  QVERIFY(rows().contains(indented(1, cut_)));
  QVERIFY2(tree().selected().empty(), "the arrow selects nothing");
  clickArrow(rounded_);
  QCOMPARE(rows().size(), 2);
  tree().select(rounded_);
  QTest::keyClick(&tree(), Qt::Key_Right);
  QVERIFY(rows().contains(indented(1, cut_)));
  tree().select(cut_);
  tree().setFolded(rounded_, true);  // what is selected is folded away: its result is selected instead
  QCOMPARE(tree().selected(), std::vector<FeatureId>{rounded_});
  QTest::keyClick(&tree(), Qt::Key_Right);
  QTest::keyClick(&tree(), Qt::Key_Left);
  QCOMPARE(rows().size(), 2);
}

void NestedTreeTest::aStepThatIsSelectedIsShown() {
  addRoundedBlock();
  tree().setFolded(rounded_, true);
  tree().setFolded(cut_, true);
  tree().select(outline_);
  QCOMPARE(rows(), unfolded());
  QCOMPARE(tree().selected(), std::vector<FeatureId>{outline_});
}

void NestedTreeTest::theFilterFindsFoldedSteps() {
  addRoundedBlock();
  tree().setFolded(rounded_, true);
  tree().setFilter(QStringLiteral("cylinder"));
  QCOMPARE(rows(), QStringList{indented(2, pin_)});
  tree().setFilter({});
  QCOMPARE(rows(), QStringList({indented(0, rounded_), indented(0, ball_)}));
}

void NestedTreeTest::stepsMoveWithTheirResult() {
  addRoundedBlock();
  tree().setFolded(rounded_, true);
  tree().select(rounded_);
  tree().moveSelectedBefore(static_cast<std::size_t>(tree().model()->rowCount()));
  std::vector<FeatureId> order;
  for (const auto& feature : window_->page().document().features()) order.push_back(feature->id);
  QCOMPARE(order, (std::vector<FeatureId>{ball_, outline_, block_, pin_, cut_, rounded_}));
  QCOMPARE(rows(), QStringList({indented(0, ball_), indented(0, rounded_)}));
  tree().select(ball_);
  tree().moveSelectedBefore(static_cast<std::size_t>(tree().model()->rowCount()));
  QCOMPARE(window_->page().document().features().back()->id, ball_);
  QCOMPARE(window_->page().document().features().front()->id, outline_);
}

void NestedTreeTest::manyResultsOpenAtTheTop() {
  Document document;
  for (int k = 0; k < 60; ++k) {
    Feature ball;
    ball.id = ball.name = "ball-" + std::to_string(k);
    ball.type = "modeling.sphere";
    document = document.with(std::move(ball));
  }
  const QString file = folder_.filePath(QStringLiteral("balls.blossom"));
  saveDocument(document, file.toStdString());
  openAndWait(file);
  QCOMPARE(tree().indexAt(QPoint(60, 10)).data(DocumentModel::IdRole).toString(), QStringLiteral("ball-0"));
}

BLOSSOM_WINDOW_TEST(NestedTreeTest)
#include "nested_tree_test.moc"
