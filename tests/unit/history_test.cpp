#include "document/history.h"

#include "support/support.h"

using namespace blossom;

namespace {

Document numbered(int n) {
  Feature feature;
  feature.id = "n";
  feature.type = "test.thing";
  feature.parameters["n"] = n;
  return Document().with(feature);
}

int number(const History& history) {
  return history.current().contains("n") ? history.current().at("n").parameters.at("n").get<int>() : 0;
}

}  // namespace

class HistoryTest : public QObject {
  Q_OBJECT

 private slots:
  void undoAndRedoWalkTheSteps() {
    History history;
    QVERIFY(!history.undo() && !history.redo());
    history.commit(numbered(1), "Add");
    history.commit(numbered(2), "Change");
    QCOMPARE(history.undoText(), std::string("Change"));
    QVERIFY(history.undo());
    QCOMPARE(number(history), 1);
    QCOMPARE(history.undoText(), std::string("Add"));
    QCOMPARE(history.redoText(), std::string("Change"));
    QVERIFY(history.undo() && !history.undo());
    QVERIFY(history.redo() && history.redo() && !history.redo());
    QCOMPARE(number(history), 2);
    QCOMPARE(history.redoText(), std::string());
  }

  void aCommitForgetsWhatCouldBeRedone() {
    History history;
    history.commit(numbered(1), "One");
    history.undo();
    history.commit(numbered(5), "Five");
    QVERIFY(!history.redo());
    QCOMPARE(number(history), 5);
  }

  void whatWasSavedIsKnownWhereverUndoHasGone() {
    History history;
    history.commit(numbered(1), "One");
    const auto saved = history.step();
    history.undo();
    history.markSaved(saved);  // the file was written meanwhile
    QVERIFY(history.modified());
    history.redo();
    QVERIFY(!history.modified());
    history.undo();
    history.commit(numbered(2), "Two");
    history.markSaved(saved);  // cannot be reached any more
    QVERIFY(history.modified());
    history.undo();
    QVERIFY(history.modified());
  }

  void previewsLeaveNoTrace() {
    History history(numbered(1));
    history.preview(numbered(7));
    history.preview(numbered(8));
    QCOMPARE(number(history), 8);
    QVERIFY(!history.modified());
    history.revert();
    QCOMPARE(number(history), 1);
    history.preview(numbered(9));
    history.commit(numbered(2), "Drag");
    QVERIFY(history.undo());
    QCOMPARE(number(history), 1);
  }

  void modifiedComparesWithTheSavedStep() {
    History history;
    QVERIFY(!history.modified());
    history.commit(numbered(1), "One");
    QVERIFY(history.modified());
    history.markSaved();
    history.commit(numbered(2), "Two");
    QVERIFY(history.modified());
    history.undo();
    QVERIFY(!history.modified());
    history.undo();
    history.commit(numbered(3), "Three");
    QVERIFY(history.modified());
    history.undo();
    QVERIFY2(history.modified(), "the saved step was forgotten");
  }

  /// Against the simplest model there is: a list of numbers and a place in it.
  void randomWalksFollowTheModel() {
    auto random = test::seededRandom();
    History history;
    std::vector<int> model{0};
    std::size_t place = 0;
    for (int step = 1; step < 5000; ++step) {
      switch (random() % 4) {
        case 0:
          history.commit(numbered(step), "step");
          model.resize(place + 1);
          model.push_back(step);
          ++place;
          break;
        case 1:
          QCOMPARE(history.undo(), place > 0);
          if (place > 0) --place;
          break;
        case 2:
          QCOMPARE(history.redo(), place + 1 < model.size());
          if (place + 1 < model.size()) ++place;
          break;
        default:
          history.preview(numbered(-1)), history.revert();
      }
      QCOMPARE(number(history), model[place]);
    }
  }
};

BLOSSOM_TEST(HistoryTest)
#include "history_test.moc"
