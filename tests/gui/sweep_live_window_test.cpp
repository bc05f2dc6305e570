#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>

#include "drag_frames.h"
#include "support/sweep_formulas.h"
#include "sweep_fixture.h"
#include "ui/thread/stall_watch.h"
#include "ui/tree/document_tree.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// The shaded surface that follows the mouse, in the real window: where it is, how it looks, and how quickly it comes.
class SweepLiveWindowTest : public SweepFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void whatIsShownIsTheEditedSurface();
  void theSurfaceLooksAsAtRest_data();
  void theSurfaceLooksAsAtRest();
  void whatWasLetGoStaysUntilItIsComputed();
  void faultsOfTheResultAreNotShownInADrag();
  void aPressWhileThatIsComputedIsADrag();
  void thePlaceIsShownWhereTheMouseLetGo();
  void aWindowThatIsToCloseTakesTheDragBack();
  void framesAreMeasured();
  void aLargeMotionIsDraggedLive();

 private:
  [[nodiscard]] std::optional<StandIn> standIn() const { return window_->page().tool()->standIn(); }
  void setSolid(bool solid);
};

void SweepLiveWindowTest::setSolid(bool solid) {
  Feature feature = document().at(sweep_);
  feature.parameters["solid"] = solid;
  window_->session().commit(document().with(feature), QStringLiteral("Solid"));
  waitUntilComputed();
}

/// Places of the picture lie on the surface that comes out, and its normals are those of that surface.
void SweepLiveWindowTest::whatIsShownIsTheEditedSurface() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  QVERIFY(!standIn());
  mouse(QEvent::MouseButtonPress, from);
  QVERIFY(!standIn());  // it may be a click
  for (const int x : {20, 90, 55}) mouse(QEvent::MouseMove, from + QPoint(x, -x / 3));
  const auto shown = standIn();
  QVERIFY(shown);
  QCOMPARE(shown->insteadOf, std::vector<FeatureId>{sweep_});
  vtkPolyData& faces = *shown->faces;
  mouse(QEvent::MouseButtonRelease, from + QPoint(55, -18));
  waitUntilComputed();
  const Motion& after = motionOf(only("sweep.pull").id);

  constexpr int side = 128;  // at least
  QVERIFY(faces.GetNumberOfPoints() >= side * side);
  const auto count = static_cast<int>(std::lround(std::sqrt(static_cast<double>(faces.GetNumberOfPoints()))));
  QCOMPARE(static_cast<vtkIdType>(count) * count, faces.GetNumberOfPoints());
  const auto [u0, u1] = after.domainU();
  const auto [v0, v1] = after.domainV();
  constexpr double step = 1e-5;
  for (int k = 1; k < count - 1; k += 9)
    for (int l = 1; l < count - 1; l += 7) {
      const double u = u0 + (u1 - u0) * k / (count - 1), v = v0 + (v1 - v0) * l / (count - 1);
      Vec3 point, normal;
      faces.GetPoint(static_cast<vtkIdType>(k) * count + l, point.data());
      faces.GetPointData()->GetNormals()->GetTuple(static_cast<vtkIdType>(k) * count + l, normal.data());
      QVERIFY((point - PlaceOfMotion(after, u, v).x).norm() < 1e-11);
      const Vec3 alongU = PlaceOfMotion(after, u + step, v).x - PlaceOfMotion(after, u - step, v).x,
                 alongV = PlaceOfMotion(after, u, v + step).x - PlaceOfMotion(after, u, v - step).x;
      QVERIFY((normal - alongU.cross(alongV).normalized()).norm() < 1e-4);
    }
}

void SweepLiveWindowTest::theSurfaceLooksAsAtRest_data() {
  QTest::addColumn<bool>("solid");
  QTest::newRow("surface") << false;
  QTest::newRow("solid") << true;
}

void SweepLiveWindowTest::theSurfaceLooksAsAtRest() {
  QFETCH(bool, solid);
  window_->resize(1280, 720);
  openSample("cylinder.json");
  if (solid) setSolid(true);
  const QPoint from = onTheSide(), to = from + QPoint(80, -20);
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  for (int k = 1; k <= 4; ++k) mouse(QEvent::MouseMove, from + (to - from) * k / 4);
  QVERIFY(standIn());
  const QImage during = canvas();
  keepPictures(solid ? "pull-live-solid" : "pull-live", to);
  mouse(QEvent::MouseButtonRelease, to);
  waitUntilComputed();
  QVERIFY(!standIn());
  mouse(QEvent::MouseMove, QPoint(5, 5));
  const QImage rest = canvas();
  QCOMPARE(rest.size(), during.size());
  const double ratio = rest.width() / static_cast<double>(window_->view().width());
  const QRectF marks(QPointF(to - QPoint(90, 90)) * ratio, QSizeF(180, 150) * ratio);  // the ring, and numbers above it
  int other = 0;
  for (int y = 0; y < rest.height(); ++y)
    for (int x = 0; x < rest.width(); ++x) {
      if (marks.contains(x, y)) continue;
      const QColor a = during.pixelColor(x, y), b = rest.pixelColor(x, y);
      if (std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) > 60) ++other;
    }
  const double share = other / static_cast<double>(rest.width() * rest.height());
  qInfo("figure live_pixels_apart %.5f", share);
  QVERIFY2(share < 0.01, qPrintable(QString::number(share)));  // the way is gone
}

/// A side that is scaled through the trajectory crosses others. That is told of the result, not of what comes of the drag.
void SweepLiveWindowTest::faultsOfTheResultAreNotShownInADrag() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  key(Qt::Key_S);
  const auto place = window_->page().tool()->whereabouts();
  QVERIFY(place);
  key(Qt::Key_Return);
  QTest::keyClicks(&window_->view(),
                   QStringLiteral("@%1, %2, 0").arg(-2.5 * place->x(), 0, 'g', 17).arg(-2.5 * place->y(), 0, 'g', 17));
  key(Qt::Key_Return);
  QVERIFY2(!window_->page().tool()->entering(), qPrintable(hint()));
  waitUntilComputed();
  QTRY_VERIFY(!standIn());
  const Value& stats = window_->session().view(sweep_)->result->evaluated.stats;
  QVERIFY(stats.contains("crossing_place"));
  const QPoint crossing = screenOf(vectorOf(stats.at("crossing_place")));
  const QPoint above = screenOf(Vec3(0, -10, 38));
  hover(above);
  // Of the point that marks the place; the rest of the picture has the same hue here and there.
  const auto faulty = [&] {
    const QImage picture = canvas();
    const double ratio = picture.width() / static_cast<double>(window_->view().width());
    const QRectF around(QPointF(crossing - QPoint(6, 6)) * ratio, QSizeF(12, 12) * ratio);
    return colored(picture.copy(around.toRect()), qtColor(Look::dark().fault));
  };
  const double atRest = faulty();
  mouse(QEvent::MouseButtonPress, above);
  mouse(QEvent::MouseMove, above + QPoint(12, 0));
  QVERIFY(standIn());
  const double during = faulty();
  mouse(QEvent::MouseButtonRelease, above + QPoint(12, 0));
  QVERIFY2(atRest > 0.2 && during < atRest / 4, qPrintable(QStringLiteral("%1 %2").arg(atRest).arg(during)));
}

void SweepLiveWindowTest::whatWasLetGoStaysUntilItIsComputed() {
  openSample("propeller.json");
  const QPoint from = onABlade();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(20, 20));
  const auto during = standIn();
  QVERIFY(during);
  mouse(QEvent::MouseButtonRelease, from + QPoint(20, 20));
  QVERIFY(standIn());  // no result can be there without an event
  QVERIFY(standIn()->faces == during->faces);
  waitUntilComputed();
  QTRY_VERIFY(!standIn());

  // Undo does not wait for it.
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(-15, 25));
  mouse(QEvent::MouseButtonRelease, from + QPoint(-15, 25));
  QVERIFY(standIn());
  window_->session().undo();
  QVERIFY(!standIn());
  waitUntilComputed();
}

/// Who goes on at once finds neither the view turned nor the second drag lost, though nothing can be taken hold of yet.
void SweepLiveWindowTest::aPressWhileThatIsComputedIsADrag() {
  openSample("cylinder.json");
  const QPoint from = onTheSide(), to = from + QPoint(30, -10), on = to + QPoint(20, 15);
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, to);
  mouse(QEvent::MouseButtonRelease, to);
  const Value first = only("sweep.pull").parameters;
  const Vec3 eye = window_->view().camera().turn().toCamera();
  mouse(QEvent::MouseButtonPress, to);
  mouse(QEvent::MouseMove, on);
  QTRY_VERIFY2_WITH_TIMEOUT(hint().startsWith(QStringLiteral("Let go to pull")), qPrintable(hint()), 60000);
  QVERIFY(window_->view().camera().turn().toCamera() == eye);
  mouse(QEvent::MouseButtonRelease, on);
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  const Vec3 goal = vectorOf(only("sweep.pull").parameters["pulls"][0]["to"]);
  QVERIFY(only("sweep.pull").parameters != first);
  QVERIFY2((screenOf(goal) - on).manhattanLength() <= 2, "the point is where the mouse let go");

  // Beside the surface the press is for the camera.
  mouse(QEvent::MouseButtonPress, on);
  mouse(QEvent::MouseMove, on + QPoint(10, 10));
  mouse(QEvent::MouseButtonRelease, on + QPoint(10, 10));
  mouse(QEvent::MouseButtonPress, QPoint(20, window_->view().height() - 20));
  mouse(QEvent::MouseMove, QPoint(60, window_->view().height() - 60));
  mouse(QEvent::MouseButtonRelease, QPoint(60, window_->view().height() - 60));
  QVERIFY(window_->view().camera().turn().toCamera() != eye);
  waitUntilComputed();
}

/// Without another movement: what was pulled can be pulled on.
void SweepLiveWindowTest::thePlaceIsShownWhereTheMouseLetGo() {
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  drag(from, from + QPoint(30, -10));
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  QTRY_VERIFY2_WITH_TIMEOUT(hint().startsWith(QStringLiteral("Drag to pull further")), qPrintable(hint()), 60000);
  window_->page().tool()->documentChanged();  // as for anything else that changes: the place is still the same
  QVERIFY2(hint().startsWith(QStringLiteral("Drag to pull further")), qPrintable(hint()));
}

/// The button is let go over the question, unseen.
void SweepLiveWindowTest::aWindowThatIsToCloseTakesTheDragBack() {
  openSample("cylinder.json");
  Feature renamed = document().at(sweep_);
  renamed.name = "Tube";
  window_->session().commit(document().with(renamed), QStringLiteral("Rename"));
  waitUntilComputed();
  const QPoint from = onTheSide();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  for (const int x : {20, 60}) mouse(QEvent::MouseMove, from + QPoint(x, -x / 3));
  QVERIFY(standIn());
  bool asked = false;
  answer(QMessageBox::Cancel, asked);
  QVERIFY(!window_->close());
  QVERIFY(asked);
  QVERIFY(!standIn());
  held_ = false;
  mouse(QEvent::MouseMove, from + QPoint(30, -10));
  QVERIFY(!standIn());
  QVERIFY(all("sweep.pull").empty());
}

/// What is told is measured here and judged by tests/acceptance: frames on the screen while the mouse moves, and how long
/// after its last movement every pixel is drawn, and all edges are smooth.
void SweepLiveWindowTest::framesAreMeasured() {
  window_->resize(1280, 720);
  openSample("cylinder.json");
  const QPoint from = onTheSide();
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  mouse(QEvent::MouseMove, from + QPoint(10, 0));
  (void)canvas();  // the first picture sends the surface to the graphics card

  constexpr int wantedMoves = 250;
  int moves = 0;
  const auto move = [&] {
    ++moves;
    mouse(QEvent::MouseMove, from + QPoint(40 + qRound(35 * std::sin(moves * 0.05)), qRound(25 * std::cos(moves * 0.07))));
  };
  const DragFrames frames(window_->view(), wantedMoves, [&](int) { move(); });
  QVERIFY(frames.count() > 5);
  qInfo("figure pull_frames_measured %zu", frames.count());
  qInfo("figure pull_frames_quick_percent %.1f", frames.shareWithin(33));
  qInfo("figure pull_frame_95_ms %.1f", frames.slowestOf(95));

  std::vector<double> detailed, smooth;
  const auto wait = [](const QElapsedTimer& rest, const auto& reached) {
    while (!reached() && rest.elapsed() < 5000) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 2);
    return static_cast<double>(rest.nsecsElapsed()) / 1e6;
  };
  for (int k = 0; k < 7; ++k) {
    for (int i = 0; i < 5; ++i) move();
    QElapsedTimer rest;
    rest.start();
    detailed.push_back(wait(rest, [&] { return window_->view().detailed(); }));
    smooth.push_back(wait(rest, [&] { return window_->view().sharp(); }));
  }
  std::sort(detailed.begin(), detailed.end());
  std::sort(smooth.begin(), smooth.end());
  qInfo("figure pull_detailed_ms %.1f", detailed[detailed.size() / 2]);
  qInfo("figure pull_smooth_ms %.1f", smooth[smooth.size() / 2]);
  QVERIFY(window_->view().sharp());
  mouse(QEvent::MouseButtonRelease, from);
  waitUntilComputed();
}

/// Prints what a user feels; what is checked is that the surface follows the mouse.
void SweepLiveWindowTest::aLargeMotionIsDraggedLive() {
  openSample("propeller.json");
  const QPoint from = onABlade();
  StallWatch watch;
  hover(from);
  qInfo("figure pull_hover_stall_ms %.1f", watch.overall().wall);
  watch.reset();
  mouse(QEvent::MouseButtonPress, from);
  QElapsedTimer dragging;
  dragging.start();
  constexpr int wantedMoves = 90;
  const DragFrames frames(window_->view(), wantedMoves,
                          [&](int k) { mouse(QEvent::MouseMove, from + QPoint(k / 2, k / 3)); });
  const double seconds = static_cast<double>(dragging.elapsed()) / 1000;
  qInfo("figure pull_frames_per_s %.1f", static_cast<double>(frames.count()) / seconds);
  qInfo("figure pull_stall_ms %.1f", watch.overall().wall);
  qInfo("figure pull_stall_computing_ms %.1f", watch.overall().busy);
  mouse(QEvent::MouseButtonRelease, from + QPoint(wantedMoves / 2, wantedMoves / 3));
  waitUntilComputed();
  QCOMPARE(all("sweep.pull").size(), std::size_t(1));
  QVERIFY(!window_->session().view(sweep_)->result->error);
}

BLOSSOM_WINDOW_TEST(SweepLiveWindowTest)
#include "sweep_live_window_test.moc"
