#include <QSignalSpy>

#include "ui/commands/commands.h"
#include "ui/look/preferences.h"
#include "ui/page/page.h"
#include "ui/view/curvature_legend.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// Pixels of two pictures of one size that are not the same.
int differing(const QImage& a, const QImage& b) {
  int count = a.size() == b.size() ? 0 : a.width() * a.height();
  for (int y = 0; count < a.width() * a.height() && y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return count;
}

}  // namespace

/// Stripes, curvatures and iso-curves as a user turns them on, for a swept propeller and for what comes after it.
class SurfaceDisplayWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openWindow();
    openPropeller();
  }
  void cleanup() {
    window_.reset();
    Preferences::instance().reset();
  }

  void theModesAreCommandsOfTheView() {
    const QImage plain = canvas();
    for (const char* mode :
         {"view.zebra", "view.gaussian-curvature", "view.mean-curvature", "view.largest-curvature", "view.iso-curves"}) {
      run(mode);
      QTRY_VERIFY(studied());
      QVERIFY(window_->commands().action(QLatin1String(mode))->isChecked());
      QVERIFY(!window_->commands().action(QStringLiteral("view.shaded-edges"))->isChecked());
      QVERIFY2(canvas() != plain, mode);
      const bool curvature = QByteArray(mode).endsWith("curvature");
      QCOMPARE(legend().isVisible(), curvature);
    }
    run("view.shaded-edges");
    // The triangles come to the card in another order: where an edge and a face lie at one depth, a few pixels may change.
    QTRY_VERIFY(differing(canvas(), plain) < 30);
    QVERIFY(!window_->session().modified());  // it is no edit
  }

  void whatIsAddedLaterIsStudiedToo() {
    run("view.largest-curvature");
    QTRY_VERIFY(studied());
    QVERIFY(legend().range().has_value());
    add("modeling.sphere", {{"radius", 0.5}});
    QTRY_VERIFY(studied());
    QTRY_VERIFY(legend().range() && legend().range()->high >= 2);  // 1 / radius: one scale for all
  }

  void cancellingLeavesShapesPlainUntilTheModeIsChosenAgain() {
    const QImage plain = canvas();
    QSignalSpy ended(&window_->page(), &DocumentPage::workEnded);
    run("view.mean-curvature");
    (void)window_->page().shownItems();  // what the next picture would ask for
    if (window_->page().studying()) {
      window_->page().cancelStudies();
      QVERIFY(!window_->page().studying());
      QVERIFY(!ended.isEmpty());
      QVERIFY(!legend().range());
    }
    run("view.mean-curvature");
    (void)window_->page().shownItems();
    QTRY_VERIFY(studied() && legend().range().has_value());
    QVERIFY(canvas() != plain);
  }

  void preferencesChangeStripesAndCurves() {
    run("view.zebra");
    const QImage twelve = canvas();
    Preferences::instance().set("zebra-stripes", 30);
    QVERIFY(canvas() != twelve);
    Preferences::instance().set("zebra-stripes", 12);
    QVERIFY(canvas() == twelve);
    Preferences::instance().set("zebra-angle", 90.0);
    QVERIFY(canvas() != twelve);
    run("view.iso-curves");
    QTRY_VERIFY(studied());
    const QImage eight = canvas();
    Preferences::instance().set("iso-curves", 20);
    (void)window_->page().shownItems();
    QTRY_VERIFY(studied());
    QVERIFY(canvas() != eight);
  }

 private:
  /// Everything that the display needs is there and in the picture.
  [[nodiscard]] bool studied() { return !window_->page().studying() && window_->view().sharp(); }
  [[nodiscard]] CurvatureLegend& legend() { return *window_->view().findChild<CurvatureLegend*>(); }
};

BLOSSOM_WINDOW_TEST(SurfaceDisplayWindowTest)
#include "surface_display_window_test.moc"
