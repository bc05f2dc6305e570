#include <QPushButton>

#include "tree_fixture.h"
#include "ui/panel/fault_bar.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// Mean difference of the pixels, 0 to 255.
double pictureContrast(const QImage& a, const QImage& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      sum += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
    }
  return sum / 3 / a.width() / a.height();
}

}  // namespace

/// What failed or is out of date, as tree and view show it.
class ShownFailuresTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openChain(); }
  void cleanup() { closeTestWindow(); }

  void failuresSayWhyAndWhatToDo();
  void failuresAreToldAboveTheView();
  void whatIsOutOfDateIsDrawnFaintly();
};

void ShownFailuresTest::failuresSayWhyAndWhatToDo() {
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

void ShownFailuresTest::failuresAreToldAboveTheView() {
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

void ShownFailuresTest::whatIsOutOfDateIsDrawnFaintly() {
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
  const double whole = pictureContrast(ready, canvas());
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
  QVERIFY2(pictureContrast(canvas(), empty) < 0.6 * whole,
           qPrintable(QString::number(pictureContrast(canvas(), empty) / whole)));
  QVERIFY(pictureContrast(canvas(), empty) > 0.1 * whole);
  session.cancelEvaluation();
  window_->errors().hide();  // the view has the size of before
  QVERIFY(session.outdated("w"));
  QTRY_COMPARE(canvas().size(), empty.size());
  QVERIFY(pictureContrast(canvas(), empty) < 0.6 * whole);
  letGo_ = true;
  session.compute();
  QVERIFY(session.outdated("w"));  // it was waited for before
  waitUntilComputed();
  QVERIFY(!session.outdated("w"));
  QCOMPARE(canvas(), ready);
}

BLOSSOM_WINDOW_TEST(ShownFailuresTest)
#include "shown_failures_test.moc"
