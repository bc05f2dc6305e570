#include "ui/tools/drag_detail.h"

#include <QtTest>
#include <stdexcept>

#include "support/test_main.h"

namespace blossom::ui {

namespace {

Document documentOf(int number) {
  Feature feature;
  feature.id = feature.name = "f";
  feature.type = "test.shape";
  feature.parameters = {{"number", number}};
  return Document().with(std::move(feature));
}

int numberIn(const Document& document) { return document.at("f").parameters.at("number").get<int>(); }

/// What is sent, as numbers; coarse documents have the number a hundred higher.
struct Sink {
  std::vector<int> sent;
  std::shared_ptr<const FeatureResult> newest = std::make_shared<const FeatureResult>();
  DragDetail detail{[this](const Document& document, const std::optional<Document>& coarser) {
                      sent.push_back(numberIn(coarser ? *coarser : document));
                      shown = numberIn(document);
                    },
                    [this] { return newest; }, [this] { return now; }};
  int shown = 0;
  double now = 0;  ///< ms

  void show(int number) {
    detail.show(documentOf(number), [](const Document& exact) { return documentOf(numberIn(exact) + 100); });
  }
  void answer() {
    newest = std::make_shared<const FeatureResult>();
    detail.resultsChanged();
  }
};

}  // namespace

/// Budgets that nothing keeps, or everything does, and a clock that is set: no time is measured here.
class DragDetailTest : public QObject {
  Q_OBJECT
 private slots:
  void whatIsQuickIsShownAsItIs();
  void whatIsSlowIsCoarseUntilTheHandRests();
  void aCoarseOneIsAwaitedWhenTheHandRests();
  void whatIsNeverAnsweredIsSlow();
  void whatWasAnsweredIsAwaitedAnew();
  void oneThatCannotBeMadeChangesNothing();
  void oneCoarseDocumentAtATime();
  void whatHasNoCoarserOneIsShownAsItIs();
  void slowOnesWithoutACoarserOneComeOneAtATime();
  void nothingComesAfterTheEnd();
};

void DragDetailTest::whatIsQuickIsShownAsItIs() {
  Sink sink;
  sink.detail.setBudget(1e9);
  for (int k = 1; k <= 4; ++k) {
    sink.show(k);
    sink.answer();
  }
  QCOMPARE(sink.sent, (std::vector<int>{1, 2, 3, 4}));
  QCOMPARE(sink.detail.coarseSent(), 0);
}

void DragDetailTest::whatIsSlowIsCoarseUntilTheHandRests() {
  Sink sink;
  sink.detail.setBudget(-1);
  sink.show(1);
  sink.answer();  // slow
  sink.show(2);
  QCOMPARE(sink.shown, 2);  // the document is the whole one
  sink.answer();
  sink.show(3);
  sink.answer();
  QTRY_COMPARE(sink.sent, (std::vector<int>{1, 102, 103, 3}));  // at rest
  QCOMPARE(sink.detail.coarseSent(), 2);
  sink.detail.setBudget(1e9);
  sink.answer();  // quick enough after all
  sink.show(4);
  QCOMPARE(sink.sent.back(), 4);
}

/// The whole would come much later, and the shape would stay behind the hand till then.
void DragDetailTest::aCoarseOneIsAwaitedWhenTheHandRests() {
  Sink sink;
  sink.detail.setBudget(-1);
  sink.show(1);
  sink.answer();
  sink.show(2);
  sink.show(3);
  QTest::qWait(3 * DragDetail::restMs);
  QCOMPARE(sink.sent, (std::vector<int>{1, 102}));
  QVERIFY(sink.detail.isBehind());
  sink.answer();
  QCOMPARE(sink.sent, (std::vector<int>{1, 102, 103}));
  QVERIFY(sink.detail.isBehind());
  sink.answer();
  QVERIFY(!sink.detail.isBehind());
  QTRY_COMPARE(sink.sent, (std::vector<int>{1, 102, 103, 3}));
  // Not for ever.
  sink.show(4);
  sink.now += 2 * DragDetail::coarseWaitMs;
  QTRY_COMPARE(sink.sent, (std::vector<int>{1, 102, 103, 3, 104, 4}));
}

/// Each movement cancels what the one before it asked for.
void DragDetailTest::whatIsNeverAnsweredIsSlow() {
  Sink sink;
  for (int k = 1; k <= 6; ++k, sink.now += 10) sink.show(k);
  QCOMPARE(sink.sent, (std::vector<int>{1, 2, 3, 4, 105}));  // 40 ms after the first
  QCOMPARE(sink.detail.coarseSent(), 1);
}

void DragDetailTest::whatWasAnsweredIsAwaitedAnew() {
  Sink sink;
  for (int k = 1; k <= 20; ++k, sink.now += 10) {
    sink.show(k);
    if (k % 3 == 0) sink.answer();
  }
  QCOMPARE(sink.detail.coarseSent(), 0);
  QCOMPARE(sink.sent.size(), std::size_t{20});
}

void DragDetailTest::oneThatCannotBeMadeChangesNothing() {
  Sink sink;
  sink.detail.setBudget(-1);
  sink.show(1);
  sink.now += 1;
  const DragDetail::Coarser none = [](const Document&) -> Document { throw std::runtime_error("none"); };
  QVERIFY_THROWS_EXCEPTION(std::runtime_error, sink.detail.show(documentOf(2), none));
  QCOMPARE(sink.sent, (std::vector<int>{1}));
  QCOMPARE(sink.detail.coarseSent(), 0);
  sink.show(3);
  QCOMPARE(sink.sent, (std::vector<int>{1, 103}));
}

void DragDetailTest::oneCoarseDocumentAtATime() {
  Sink sink;
  sink.detail.setBudget(-1);
  sink.show(1);
  sink.show(2);  // 1 has been awaited for longer than nothing
  sink.show(3);
  sink.show(4);
  QCOMPARE(sink.sent, (std::vector<int>{1, 102}));
  sink.answer();
  QCOMPARE(sink.sent, (std::vector<int>{1, 102, 104}));  // the newest
  sink.answer();
  QCOMPARE(sink.sent.size(), std::size_t{3});
}

void DragDetailTest::whatHasNoCoarserOneIsShownAsItIs() {
  Sink sink;
  sink.detail.setBudget(1e9);
  for (int k = 1; k <= 3; ++k) sink.detail.show(documentOf(k), {});
  QCOMPARE(sink.sent, (std::vector<int>{1, 2, 3}));
}

/// Cancelled by each movement, none would ever be seen.
void DragDetailTest::slowOnesWithoutACoarserOneComeOneAtATime() {
  Sink sink;
  sink.detail.setBudget(-1);
  for (int k = 1; k <= 3; ++k) sink.detail.show(documentOf(k), {});
  QCOMPARE(sink.sent, (std::vector<int>{1}));
  sink.answer();
  QCOMPARE(sink.sent, (std::vector<int>{1, 3}));  // the newest
  sink.answer();
  QCOMPARE(sink.sent.size(), std::size_t{2});
  sink.detail.show(documentOf(4), {});
  sink.detail.show(documentOf(5), {});
  QTRY_COMPARE(sink.sent, (std::vector<int>{1, 3, 4, 5}));  // at rest, though 4 was not answered
  QTest::qWait(2 * DragDetail::restMs);
  QCOMPARE(sink.sent.size(), std::size_t{4});
}

void DragDetailTest::nothingComesAfterTheEnd() {
  Sink sink;
  sink.detail.setBudget(-1);
  sink.show(1);
  sink.show(2);
  sink.show(3);
  sink.detail.end();
  sink.answer();
  // Another hand that comes to rest later has done so.
  Sink later;
  later.detail.setBudget(-1);
  later.show(1);
  later.show(2);
  later.answer();
  QTRY_COMPARE(later.sent, (std::vector<int>{1, 102, 2}));
  QCOMPARE(sink.sent, (std::vector<int>{1, 102}));
}

}  // namespace blossom::ui

using blossom::ui::DragDetailTest;
BLOSSOM_TEST(DragDetailTest)
#include "drag_detail_test.moc"
