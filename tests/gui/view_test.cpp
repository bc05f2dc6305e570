#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <QApplication>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <algorithm>

#include "geometry/occt/sub_shape.h"
#include "geometry/shape/brep.h"
#include "support/mouse.h"
#include "support/support.h"
#include "ui/look/theme.h"
#include "ui/view/curvature_legend.h"
#include "ui/view/view_widget.h"
#include "view_fixture.h"
#include "widget_test.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

class Host : public ToolHost {
 public:
  [[nodiscard]] const Document& document() const override { return document_; }
  [[nodiscard]] std::shared_ptr<const FeatureResult> result(const FeatureId&) const override { return nullptr; }
  [[nodiscard]] const Registry& registry() const override { return registry_; }
  [[nodiscard]] const Look& look() const override { return look_; }
  [[nodiscard]] double gridSpacing() const override { return 1; }
  [[nodiscard]] std::vector<FeatureId> selection() const override { return {}; }
  void select(const FeatureId&) override {}
  void preview(Document) override {}
  void endPreview() override {}
  void commit(Document, const QString&) override {}

 private:
  Document document_;
  Registry registry_;
  Look look_ = Look::dark();
};

/// Writes down what it is asked.
class ScribeTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;
  [[nodiscard]] QString hint() const override { return QStringLiteral("scribe"); }
  [[nodiscard]] PickMode picks() const override { return wanted; }
  bool press(const ToolEvent& e) override { return note("press", e); }
  bool move(const ToolEvent& e) override { return note("move", e); }
  bool release(const ToolEvent& e) override { return note("release", e); }
  bool doubleClick(const ToolEvent& e) override { return note("double", e); }
  bool key(const QKeyEvent& e) override {
    log << QStringLiteral("key %1").arg(e.key());
    return takes && e.key() != Qt::Key_Escape;
  }
  QStringList log;
  ToolEvent last;
  bool takes = true;
  PickMode wanted = PickMode::Any;

 private:
  bool note(const char* what, const ToolEvent& event) {
    log << QLatin1String(what);
    last = event;
    return takes;
  }
};

}  // namespace

class ViewTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpApplication();
    ThemeManager::instance().apply(ThemeChoice::Dark);
    box_ = sceneOf(box());
    ball_ = sceneOf(Brep(BRepPrimAPI_MakeSphere(gp_Pnt(60, 0, 10), 10).Shape()));
  }
  void init() {
    view_ = openView();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    QVERIFY2(view_->problem().isEmpty(), qPrintable(view_->problem()));
    view_->setItems({{"box", box_}, {"ball", ball_}});
    view_->lookFrom(QStringLiteral("iso"), false);
  }
  void cleanup() { view_.reset(); }

  void pointsAreSeenWhereTheirRaysGo() {
    for (const bool parallel : {false, true}) {
      view_->setParallel(parallel);
      for (const Vec3& p : {Vec3(10, -10, 20), Vec3(60, 0, 20), Vec3(0, 0, 0)}) {
        const Ray ray = view_->camera().rayThrough(at(p));
        COMPARE_NEAR((p - ray.origin - (p - ray.origin).dot(ray.direction) * ray.direction).norm(), 0, 1e-9);
      }
    }
  }

  void partsAreFoundWhereTheyAreDrawn_data() {
    QTest::addColumn<bool>("parallel");
    QTest::newRow("perspective") << false;
    QTest::newRow("parallel") << true;
  }
  void partsAreFoundWhereTheyAreDrawn() {
    QFETCH(bool, parallel);
    view_->setParallel(parallel);
    view_->fit(false);
    const Pick face = view_->pickAt(at({2, 1, 20}), PickMode::Face);
    QCOMPARE(face.feature, FeatureId("box"));
    QVERIFY(face.part.kind == SubShapeKind::Face);
    COMPARE_NEAR((face.part.normal - Vec3::UnitZ()).norm(), 0, 1e-6);
    COMPARE_NEAR((face.part.point - Vec3(2, 1, 20)).norm(), 0, 1e-6);
    const Pick edge = view_->pickAt(at({3, -10, 20}) + QPointF(0, 2), PickMode::Any);
    QVERIFY(edge.part.kind == SubShapeKind::Edge);
    COMPARE_NEAR(edge.part.point.y(), -10, 1e-9);
    COMPARE_NEAR(edge.part.point.z(), 20, 1e-9);
    const Pick vertex = view_->pickAt(at({10, -10, 20}) + QPointF(2, 1), PickMode::Any);
    QVERIFY(vertex.part.kind == SubShapeKind::Vertex);
    COMPARE_NEAR((vertex.part.point - Vec3(10, -10, 20)).norm(), 0, 1e-9);
    QVERIFY(view_->pickAt(at({-10, 10, 0}), PickMode::Vertex).feature.empty());  // behind the block
    const Pick ball = view_->pickAt(at({60, 0, 10}), PickMode::Feature);
    QCOMPARE(ball.feature, FeatureId("ball"));
    QVERIFY(ball.part.kind == SubShapeKind::Whole);
    QVERIFY(view_->pickAt({4, 4}, PickMode::Any).feature.empty());
  }

  /// One may be on its way, of a camera that has moved on since; and the cube turns with what is shown.
  void aPictureAskedForIsTheOneOfNow() {
    view_->lookFrom(QStringLiteral("top"), false);
    const QImage top = view_->grabFramebuffer();
    view_->lookFrom(QStringLiteral("front"), false);
    const QImage front = view_->grabFramebuffer();
    QVERIFY(top != front);
    for (int i = 0; i < 5; ++i) {
      view_->lookFrom(QStringLiteral("top"), false);
      QCoreApplication::processEvents();  // begins a frame, and takes it where the graphics are fast
      view_->lookFrom(QStringLiteral("front"), false);
      QVERIFY(view_->grabFramebuffer() == front);
    }
    QTRY_VERIFY(view_->sharp());
    const int drawn = view_->framesDrawn();
    view_->repaint();
    QTest::qWait(50);
    QCOMPARE(view_->framesDrawn(), drawn);  // painting alone draws nothing
  }

  void hoveringLightsUp() {
    QSignalSpy spy(view_.get(), &ViewWidget::hovered);
    const QImage plain = view_->grabFramebuffer();
    test::moveMouse(view_.get(), at({2, 1, 20}).toPoint());
    QCOMPARE(view_->hoveredPick().feature, FeatureId("box"));
    QCOMPARE(spy.size(), 1);
    const QImage whole = view_->grabFramebuffer();
    QVERIFY(whole != plain);
    test::moveMouse(view_.get(), at({3, 0, 20}).toPoint());
    QCOMPARE(spy.size(), 1);  // the same feature
    view_->setPickMode(PickMode::Face);
    test::moveMouse(view_.get(), at({2, 1, 20}).toPoint());
    QVERIFY(view_->hoveredPick().part.kind == SubShapeKind::Face);
    // The face alone changes its colour: the one beside it stays.
    const QImage lit = view_->grabFramebuffer();
    const QPoint top = at({2, 1, 20}).toPoint(), side = at({2, -10, 6}).toPoint();
    QVERIFY(lit.pixel(top) != plain.pixel(top));
    QCOMPARE(lit.pixel(side), plain.pixel(side));
    test::moveMouse(view_.get(), QPoint(5, 5));
    QVERIFY(view_->hoveredPick().feature.empty());
  }

  void clicksSelectPartsAndKeysExtend() {
    view_->setPickMode(PickMode::Face);
    QSignalSpy features(view_.get(), &ViewWidget::picked), parts(view_.get(), &ViewWidget::partsSelected);
    const QPoint top = at({2, 1, 20}).toPoint(), front = at({2, -10, 6}).toPoint();
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, top);
    QCOMPARE(view_->selectedParts().size(), std::size_t{1});
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ControlModifier, front);
    QCOMPARE(view_->selectedParts().size(), std::size_t{2});
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ControlModifier, top);
    QCOMPARE(view_->selectedParts().size(), std::size_t{1});
    COMPARE_NEAR((view_->selectedParts().front().part.normal + Vec3::UnitY()).norm(), 0, 1e-6);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, QPoint(5, 5));
    QVERIFY(view_->selectedParts().empty());
    QCOMPARE(parts.size(), 4);
    QCOMPARE(features.size(), 1);  // beside everything no feature stays selected either
    QVERIFY(features.takeFirst().front().toString().isEmpty());
    // A new shape has new numbers.
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, top);
    view_->setItems({{"box", sceneOf(box())}, {"ball", ball_}});
    QVERIFY(view_->selectedParts().empty());
    view_->setPickMode(PickMode::Feature);
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ControlModifier, top);
    QCOMPARE(features.takeFirst(), (QList<QVariant>{QStringLiteral("box"), true}));
  }

  void boxesSelectToTheRightWholeToTheLeftTouched() {
    QSignalSpy boxed(view_.get(), &ViewWidget::selectionBoxed);
    const auto drag = [&](QPoint from, QPoint to) {
      QTest::mousePress(view_.get(), Qt::LeftButton, Qt::ControlModifier, from);
      test::moveMouse(view_.get(), (from + to) / 2);
      test::moveMouse(view_.get(), to);
      QTest::mouseRelease(view_.get(), Qt::LeftButton, Qt::ControlModifier, to);
      const auto found = boxed.takeLast().front().value<std::vector<Pick>>();
      QStringList names;
      for (const Pick& pick : found) names << QString::fromStdString(pick.feature);
      return names.join(u' ');
    };
    const QPoint ball = at({60, 0, 10}).toPoint();
    const int radius = static_cast<int>(13 / view_->camera().millimetresPerPixel());
    const QPoint low = ball - QPoint(radius, radius), high = ball + QPoint(radius, radius);
    QCOMPARE(drag(low, high), QStringLiteral("ball"));
    QCOMPARE(drag(high, ball), QStringLiteral("ball"));  // touches it
    QCOMPARE(drag(ball, high), QString());               // does not hold all of it
    QCOMPARE(drag(QPoint(2, 2), QPoint(797, 597)), QStringLiteral("ball box"));
    view_->setPickMode(PickMode::Vertex);
    drag(QPoint(2, 2), QPoint(797, 597));
    QVERIFY(view_->selectedParts().size() >= 8);
  }

  void orbitingKeepsThePointUnderTheMouse() {
    const Vec3 point(2, 1, 20);
    const QPoint from = at(point).toPoint();
    const Vec3 pivot = view_->pickAt(from, PickMode::Face).part.point;
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) test::moveMouse(view_.get(), from + QPoint(12 * i, 5 * i));
    const Turn turned = view_->camera().turn();
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, from + QPoint(60, 25));
    QVERIFY(std::abs(turned.yaw - 35) > 5);
    const QPointF now = at(pivot);
    COMPARE_NEAR(now.x(), from.x(), 1e-6);
    COMPARE_NEAR(now.y(), from.y(), 1e-6);
  }

  void everyStyleDoesWhatItsTableSays() {
    using enum DragAction;
    QVERIFY(dragAction(NavigationStyle::Blossom, Qt::LeftButton, {}) == Orbit);
    QVERIFY(dragAction(NavigationStyle::Rhino, Qt::RightButton, {}) == Orbit);
    QVERIFY(dragAction(NavigationStyle::Rhino, Qt::RightButton, Qt::ShiftModifier) == Pan);
    QVERIFY(dragAction(NavigationStyle::Fusion, Qt::MiddleButton, {}) == Pan);
    QVERIFY(dragAction(NavigationStyle::Fusion, Qt::MiddleButton, Qt::ShiftModifier) == Orbit);
    QVERIFY(dragAction(NavigationStyle::FreeCad, Qt::LeftButton, {}) == Orbit);
    for (const char* name : {"blossom", "freecad", "rhino", "fusion"}) {
      const NavigationStyle style = navigationStyle(QLatin1String(name));
      for (const DragAction action : {Orbit, Pan, Zoom, Box}) {
        const auto& table = dragBindings(style);
        QVERIFY2(std::any_of(table.begin(), table.end(), [&](const auto& binding) { return binding.action == action; }) ||
                     action == Zoom,
                 name);
      }
      view_->setNavigation(style);
      for (const DragBinding& binding : dragBindings(style)) {
        if (binding.buttons == (Qt::LeftButton | Qt::MiddleButton)) continue;
        const Turn turn = view_->camera().turn();
        const Vec3 target = view_->camera().target();
        const double scale = view_->camera().millimetresPerPixel();
        const auto button = static_cast<Qt::MouseButton>(binding.buttons.toInt());
        QTest::mousePress(view_.get(), button, binding.modifiers, {40, 500});
        for (int i = 1; i <= 3; ++i) test::moveMouse(view_.get(), {40 + 10 * i, 500 - 8 * i});
        QTest::mouseRelease(view_.get(), button, binding.modifiers, {70, 476});
        const CameraControl& camera = view_->camera();
        QCOMPARE(camera.turn().yaw != turn.yaw, binding.action == Orbit);
        QCOMPARE(camera.millimetresPerPixel() != scale, binding.action == Zoom);
        if (binding.action == Pan) QVERIFY((camera.target() - target).norm() > scale);
        if (binding.action == Box) QVERIFY(camera.target() == target);
      }
    }
  }

  void touchpadsPanAndPinch() {
    const Vec3 target = view_->camera().target();
    const double scale = view_->camera().millimetresPerPixel();
    const QPointF middle(400, 300);
    QWheelEvent scroll(middle, view_->mapToGlobal(middle), QPoint(0, 30), QPoint(0, 60), Qt::NoButton, {}, Qt::ScrollUpdate,
                       false);
    QApplication::sendEvent(view_.get(), &scroll);
    COMPARE_NEAR((view_->camera().target() - target).norm(), 30 * scale, 1e-6);
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2, middle, middle, middle,
                              0.2, QPointF());
    QApplication::sendEvent(view_.get(), &pinch);
    COMPARE_NEAR(view_->camera().millimetresPerPixel(), scale * std::exp(-0.2), 1e-9);
  }

  void toolsComeFirst() {
    Host host;
    ScribeTool tool(host);
    view_->setTool(&tool);
    QSignalSpy picked(view_.get(), &ViewWidget::picked), dismissed(view_.get(), &ViewWidget::toolDismissed);
    const Turn turn = view_->camera().turn();
    const QPoint top = at({2, 1, 20}).toPoint();
    test::moveMouse(view_.get(), top);
    QCOMPARE(tool.log, QStringList{QStringLiteral("move")});
    QVERIFY(tool.last.pick.part.kind == SubShapeKind::Face && tool.last.pick.feature == "box");
    tool.log.clear();
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, top);
    test::moveMouse(view_.get(), top + QPoint(30, 10));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, top + QPoint(30, 10));
    QCOMPARE(tool.log.join(u' '), QStringLiteral("press move release"));
    QCOMPARE(view_->camera().turn().yaw, turn.yaw);
    tool.log.clear();
    QTest::keyClick(view_.get(), Qt::Key_4);
    QCOMPARE(tool.log.size(), 1);  // asked once
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QCOMPARE(dismissed.size(), 1);

    tool.takes = false;  // the camera moves as always, and the tool still hears of the release
    tool.log.clear();
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, top);
    for (int i = 1; i <= 4; ++i) test::moveMouse(view_.get(), top + QPoint(10 * i, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, top + QPoint(40, 0));
    QCOMPARE(tool.log.join(u' '), QStringLiteral("press release"));
    QVERIFY(view_->camera().turn().yaw != turn.yaw);
    QCOMPARE(picked.size(), 0);

    view_->setTool(&tool, true);  // handles leave the rest to the view
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, QPoint(5, 5));
    QCOMPARE(picked.size(), 1);
    view_->setTool(nullptr);
  }

  void displayModesAndPixelRatio() {
    const QImage edges = view_->grabFramebuffer();
    QCOMPARE(edges.width(), qRound(view_->width() * view_->devicePixelRatioF()));
    view_->setDisplayMode(DisplayMode::Shaded);
    const QImage shaded = view_->grabFramebuffer();
    view_->setDisplayMode(DisplayMode::Wireframe);
    const QImage wires = view_->grabFramebuffer();
    QVERIFY(edges != shaded && shaded != wires);
    QVERIFY(view_->pickAt(at({2, 1, 20}), PickMode::Any).feature.empty());        // nothing is drawn there
    QVERIFY(!view_->pickAt(at({-10, 10, 0}), PickMode::Vertex).feature.empty());  // seen through the block
  }

  /// The stripes of a ball of one colour are dark and light; back in the plain mode, the picture is the one before.
  void displaysOfSurfacesLeaveThePlainPicture() {
    const QImage plain = still();
    const auto study = std::make_shared<const SurfaceStudy>(studySurfaces(
        Brep(BRepPrimAPI_MakeSphere(gp_Pnt(60, 0, 10), 10).Shape()), {.chord = 0.01, .angle = 0.1}, 5, Progress::none()));
    const auto darkPixels = [&](const QImage& image) {
      int dark = 0;
      const QPointF middle = at({60, 0, 10}) * view_->devicePixelRatioF();
      for (int y = -20; y <= 20; ++y)
        for (int x = -20; x <= 20; ++x) dark += qGreen(image.pixel(middle.toPoint() + QPoint(x, y))) < 40;
      return dark;
    };
    QCOMPARE(darkPixels(plain), 0);
    view_->setDisplayMode(DisplayMode::Zebra);
    QVERIFY(darkPixels(still()) > 300);
    view_->setDisplayMode(DisplayMode::ShadedWithEdges);
    QVERIFY(still() == plain);

    const auto& legend = *view_->findChild<CurvatureLegend*>();
    view_->setDisplayMode(DisplayMode::MeanCurvature);
    QVERIFY(!legend.range());  // there is no study yet: drawn as ever
    QVERIFY(still() == plain);
    view_->setSelectedParts({view_->pickAt(at({60, 0, 20}), PickMode::Face)});
    view_->setItems({{"box", box_}, {"ball", ball_, ItemRole::Plain, Presence::Whole, study}});
    QCOMPARE(view_->selectedParts().size(), std::size_t{1});  // it is the same shape
    view_->setSelectedParts({});
    QVERIFY(legend.range() == (CurvatureRange{-0.1, 0.1}) && legend.isVisible());
    test::moveMouse(view_.get(), at({60, 0, 20}).toPoint());
    QVERIFY(legend.value().has_value());
    COMPARE_NEAR(*legend.value(), 0.1, 1e-6);
    test::moveMouse(view_.get(), QPoint(5, 5));
    QVERIFY(!legend.value());
    const QImage curved = still();
    QVERIFY(curved != plain);
    view_->setDisplayMode(DisplayMode::IsoCurves);
    QVERIFY(!legend.range() && !legend.isVisible());
    const QImage lines = still();
    QVERIFY(lines != plain && lines != curved);
    view_->setDisplayMode(DisplayMode::Shaded);
    view_->setDisplayMode(DisplayMode::ShadedWithEdges);
    QVERIFY(still() == plain);
    QCOMPARE(displayModeNames().size(), 8);
    for (const QString& name : displayModeNames()) QVERIFY(displayModeOf(name).has_value());
    QVERIFY(displayModeOf(QStringLiteral("plain")) == DisplayMode::ShadedWithEdges);
    QVERIFY(!displayModeOf(QStringLiteral("leopard")));
  }

 private:
  QImage still() {
    (void)QTest::qWaitFor([&] { return view_->sharp(); }, 60'000);
    return view_->grabFramebuffer().copy();
  }
  [[nodiscard]] QPointF at(const Vec3& p) const { return view_->camera().project(p); }
  SceneData box_, ball_;
  std::unique_ptr<ViewWidget> view_;
};

BLOSSOM_WIDGET_TEST(ViewTest)
#include "view_test.moc"
