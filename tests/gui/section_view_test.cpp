// Solids as the section of a view shows them.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include <QApplication>
#include <QImage>
#include <set>

#include "support/support.h"
#include "ui/look/theme.h"
#include "ui/view/view_widget.h"
#include "view_fixture.h"
#include "widget_test.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

int offBetween(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

TopoDS_Shape boxWithGroove() {
  const TopoDS_Shape groove = BRepPrimAPI_MakeBox(gp_Pnt(-20, -3, -1), 40, 6, 12).Shape();
  return BRepAlgoAPI_Cut(box().shape(), groove).Shape();
}

}  // namespace

class SectionViewTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpApplication();
    ThemeManager::instance().apply(ThemeChoice::Dark);
    box_ = sceneOf(box());
  }
  void init() {
    view_ = openView();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    QVERIFY2(view_->problem().isEmpty(), qPrintable(view_->problem()));
    view_->setItems({{"box", box_}});
    view_->lookFrom(QStringLiteral("iso"), false);
  }
  void cleanup() { view_.reset(); }

  void whatIsTakenAwayIsNotPicked() {
    const QPointF corner = at({10, -10, 20});
    QVERIFY(!view_->pickAt(corner, PickMode::Vertex).feature.empty());
    const QImage whole = view_->grabFramebuffer();
    view_->setSection(CutPlane{Vec3::UnitZ(), 12});
    QVERIFY(view_->pickAt(corner, PickMode::Vertex).feature.empty());
    const Pick cut = view_->pickAt(at({0, 0, 12}), PickMode::Feature);
    QCOMPARE(cut.feature, FeatureId("box"));
    COMPARE_NEAR(cut.part.point.z(), 12, 1e-9);
    const QImage sectioned = view_->grabFramebuffer();
    QVERIFY(sectioned != whole);
    if (qEnvironmentVariableIsSet("BLOSSOM_TEST_PICTURES")) sectioned.save(qEnvironmentVariable("BLOSSOM_TEST_PICTURES"));
    view_->setSection({});
    QVERIFY(!view_->pickAt(corner, PickMode::Vertex).feature.empty());
  }

  /// A groove from below, whose edges run close behind the cut.
  void whatLiesBehindACutIsHidden() {
    for (const bool parallel : {false, true}) {
      view_->setParallel(parallel);
      std::vector<QImage> pictures;
      for (const SceneData& scene : {box_, sceneOf(Brep(boxWithGroove()))}) {
        view_->setItems({{"box", scene}});
        view_->fitTo({{-10, -10, 0}, {10, 10, 20}}, false);
        view_->setSection(CutPlane{Vec3::UnitZ(), 12});
        pictures.push_back(view_->grabFramebuffer());
      }
      view_->setSection({});
      int different = 0;
      for (double x = -9; x <= 9; x += 0.25)
        for (double y = -9; y <= 9; y += 0.25)
          different += offBetween(colorAt(pictures[0], {x, y, 12}), colorAt(pictures[1], {x, y, 12})) > 40;
      QCOMPARE(different, 0);
    }
  }

  /// Faces that are left look as they did before the cut.
  void whatLiesBesideACutIsNotHatched() {
    for (const bool parallel : {false, true}) {
      view_->setParallel(parallel);
      view_->fitTo({{-16, -16, -6}, {16, 16, 26}}, false);
      const QImage whole = view_->grabFramebuffer();
      view_->setSection(CutPlane{-Vec3::UnitY(), 0});  // takes away what is nearer than the plane
      const QImage cut = view_->grabFramebuffer();
      view_->setSection({});
      const auto off = [&](const Vec3& p) { return offBetween(colorAt(whole, p), colorAt(cut, p)); };
      for (double x = -9; x <= 9; x += 0.5)
        for (double y = 1; y <= 9; y += 0.5) QVERIFY2(off({x, y, 20}) < 12, "a face that is left");
      int most = 0;
      for (double x = -9; x <= 9; x += 0.25) most = std::max(most, off({x, 0, 10}));
      QVERIFY2(most > 12, "the cut is hatched");
    }
  }

  /// A hollow body shows its hollow, and whoever looks from behind sees the body, not its cut.
  void hollowsStayOpenAndTheBackStaysWhole() {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 10), 7).Shape();
    view_->setItems({{"box", sceneOf(Brep(BRepAlgoAPI_Cut(box().shape(), ball).Shape()))}});
    view_->lookFrom(QStringLiteral("front"), false);
    view_->fitTo({{-10, -10, 0}, {10, 10, 20}}, false);
    view_->setSection(CutPlane{-Vec3::UnitY(), 0});
    const QImage front = view_->grabFramebuffer();
    // A cut has two colours; the inside of the ball is shaded.
    std::set<int> wall, hollow;
    for (double z = 1; z <= 19; z += 0.05) wall.insert(qGreen(front.pixel(pixelOf(front, {-8.5, 0, z}))));
    for (double z = 5; z <= 15; z += 0.05) hollow.insert(qGreen(front.pixel(pixelOf(front, {0, 0, z}))));
    QVERIFY2(*wall.rbegin() - *wall.begin() > 6, "hatched");
    QVERIFY(hollow.size() > 4);
    view_->lookFrom(QStringLiteral("back"), false);
    const QImage cut = view_->grabFramebuffer();
    view_->setSection({});
    const QImage whole = view_->grabFramebuffer();
    for (double x = -9; x <= 9; x += 0.5)
      for (double z = 1; z <= 19; z += 0.5) QVERIFY(offBetween(colorAt(cut, {x, 10, z}), colorAt(whole, {x, 10, z})) < 12);
  }

  /// What is replaced, hidden or shown as wires takes its section along.
  void theSectionGoesWithItsShape() {
    view_->setSection(CutPlane{Vec3::UnitZ(), 12});
    view_->setItems({});
    const QImage empty = view_->grabFramebuffer();
    view_->setSection({});
    QCOMPARE(view_->grabFramebuffer(), empty);
    view_->setSection(CutPlane{Vec3::UnitZ(), 12});
    view_->setItems({{"box", box_}});
    const QImage shaded = view_->grabFramebuffer();
    view_->setDisplayMode(DisplayMode::Wireframe);
    QVERIFY(view_->grabFramebuffer() != shaded);
    view_->setDisplayMode(DisplayMode::ShadedWithEdges);
    QCOMPARE(view_->grabFramebuffer(), shaded);
  }

 private:
  [[nodiscard]] QPointF at(const Vec3& p) const { return view_->camera().project(p); }
  [[nodiscard]] QPoint pixelOf(const QImage& picture, const Vec3& p) const {
    return (at(p) * picture.devicePixelRatio()).toPoint();
  }
  [[nodiscard]] QColor colorAt(const QImage& picture, const Vec3& p) const {
    return picture.pixelColor(pixelOf(picture, p));
  }

  SceneData box_;
  std::unique_ptr<ViewWidget> view_;
};

BLOSSOM_WIDGET_TEST(SectionViewTest)
#include "section_view_test.moc"
