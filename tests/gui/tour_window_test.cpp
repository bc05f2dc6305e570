// The tour over the real window, as on its first start.
#include <QPushButton>

#include "ui/help/tour.h"
#include "ui/help/tour_bubble.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class TourWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void whoBeginsByTheMenuIsNotHeldUp();
};

/// The step about the start page goes with the first shape, and the keys after *Skip* are not for the name of that.
void TourWindowTest::whoBeginsByTheMenuIsNotHeldUp() {
  run("help.tour");
  const auto* const tour = window_->findChild<Tour*>();
  QVERIFY(tour && tour->running());
  QCOMPARE(tour->step(), std::size_t{0});
  run("feature.sweep.primitive");
  waitUntilComputed();
  run("feature.sweep.sweep");
  waitUntilComputed();
  QVERIFY(tour->running());
  QCOMPARE(tour->step(), std::size_t{1});
  QTest::mouseClick(tour->bubble()->findChild<QPushButton*>(QStringLiteral("link")), Qt::LeftButton);
  QVERIFY(QApplication::focusWidget() && !qobject_cast<QLineEdit*>(QApplication::focusWidget()));
  const std::string name = window_->page().document().at(last()).name;
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_T);
  QCOMPARE(window_->page().document().at(last()).name, name);
}

BLOSSOM_WINDOW_TEST(TourWindowTest)
#include "tour_window_test.moc"
