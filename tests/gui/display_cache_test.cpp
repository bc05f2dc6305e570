#include "ui/view/display_cache.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::ui;

class DisplayCacheTest : public QObject {
  Q_OBJECT
 private slots:
  void whatCannotBeDrawnKeepsItsReason();
  void theSameShapeIsDrawnOnce();
};

// An empty motion once threw std::out_of_range through the evaluating thread and ended the program.
void DisplayCacheTest::whatCannotBeDrawnKeepsItsReason() {
  auto result = std::make_shared<FeatureResult>();
  result->evaluated.shape = Motion();
  DisplayCache cache;
  const auto view = cache.view(result, 0, Progress::none());
  QVERIFY(view && view->result);
  QVERIFY(view->result->error || view->scene.empty());
}

void DisplayCacheTest::theSameShapeIsDrawnOnce() {
  auto result = std::make_shared<FeatureResult>();
  Region square;
  square.loops.push_back(
      {{Line2{{0, 0}, {4, 0}}, Line2{{4, 0}, {4, 4}}, Line2{{4, 4}, {0, 4}}, Line2{{0, 4}, {0, 0}}}, true, {}, {}});
  result->evaluated.shape = square;
  DisplayCache cache;
  const auto first = cache.view(result, 0, Progress::none()), second = cache.view(result, 0, Progress::none());
  QVERIFY(first->scene.faces && first->scene.faces == second->scene.faces);
}

QTEST_GUILESS_MAIN(DisplayCacheTest)
#include "display_cache_test.moc"
