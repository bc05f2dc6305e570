#include <QDir>
#include <QFile>
#include <QToolButton>
#include <algorithm>
#include <array>

#include "document/storage.h"
#include "exchange/format/format.h"
#include "geometry/planar/planar.h"
#include "support/true_distance.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// A free-form outline of cubic splines with a free-form island; 100 x 70 mm.
const char* const drawing =
    "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='70mm' viewBox='0 0 100 70'><path fill-rule='evenodd' "
    "d='M10 35C10 12 30 5 48 14S78 2 90 22 88 60 66 58 48 54 36 62 10 56 10 35Z"
    "M44 36C44 28 56 26 62 32S60 46 53 45 44 42 44 36Z'/></svg>";

std::vector<Path> pathsIn(const App& app, const QString& file) {
  const Imported read = readShape(*app.formats, file.toStdString());
  if (const auto* region = read.shape.get<Region>()) return region->loops;
  const auto* curves = read.shape.get<Curves>();
  return curves ? curves->paths : std::vector<Path>{};
}

}  // namespace

/// The medial axis and the offset loops of a spline outline with an island, from the file to the saved drawing.
class OffsetWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void ringsAndAxisOfAnOutlineGoToADrawing();
  void aTooLargeDistanceSaysWhatFits();
  void aFaceOfASolidIsPicked();

 private:
  [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  void importDrawing();
  void takePictures();
  FeatureId part_;
};

void OffsetWindowTest::init() {
  openWindow();
  run("file.new");
}

void OffsetWindowTest::importDrawing() {
  QFile file(path("outline.svg"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(drawing);
  file.close();
  QVERIFY(drop({path("outline.svg")}));
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{1});
  waitUntilComputed();
  part_ = last();
}

void OffsetWindowTest::takePictures() {
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  if (folder.isEmpty()) return;
  window_->resize(1280, 800);
  run("view.top");
  run("view.fit");
  for (const auto& [choice, name] : {std::pair{ThemeChoice::Dark, "dark"}, std::pair{ThemeChoice::Light, "light"}}) {
    ThemeManager::instance().apply(choice);
    (void)canvas();
    QVERIFY(window_->grab().save(QDir(folder).filePath(QStringLiteral("offset-window-%1.png").arg(QLatin1String(name)))));
  }
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void OffsetWindowTest::ringsAndAxisOfAnOutlineGoToADrawing() {
  importDrawing();
  window_->tree().select(part_);
  run("feature.pocket.medial-axis");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{2});
  const FeatureId axis = last();
  waitUntilComputed();
  // One island: one closed chain. All discs were checked.
  QCOMPARE(measureOf(axis, "edges") - measureOf(axis, "vertices") + 1, 1.0);
  QCOMPARE(measureOf(axis, "uncertified"), 0.0);

  window_->tree().select(part_);
  run("feature.pocket.offset");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{3});
  const FeatureId rings = last();
  QCOMPARE(window_->page().document().at(rings).inputs, std::vector<FeatureId>{part_});
  waitUntilComputed();
  const double area = measureOf(rings, "area");
  edit("distance", "2 mm");
  waitUntilComputed();
  QVERIFY(measureOf(rings, "area") < area);
  Session& session = window_->session();
  Feature several = session.document().at(rings);
  several.parameters["distance"] = {1.0, 2.0, 4.0, 6.0, 8.0};
  session.commit(session.document().with(several), QStringLiteral("Change distance"));
  waitUntilComputed();
  QVERIFY(measureOf(rings, "curves") >= 5);
  takePictures();

  // What is saved lies at the distances from the drawing that came in.
  window_->tree().select(rings);
  exportAs("dxf", path("rings.dxf"));
  const test::TrueDistance truth(pathsIn(session.app(), path("outline.svg")));
  const std::vector<Path> saved = pathsIn(session.app(), path("rings.dxf"));
  QCOMPARE(double(saved.size()), measureOf(rings, "curves"));
  for (const Path& ring : saved) {
    QVERIFY(ring.closed);
    const double distance = std::stod(ring.layer.substr(ring.layer.find(' ') + 1));
    for (const Segment& segment : ring.segments) COMPARE_NEAR(truth(startPoint(segment)), distance, 1e-3);
  }
  window_->tree().select(axis);
  exportAs("dxf", path("axis.dxf"));
  QVERIFY(!pathsIn(session.app(), path("axis.dxf")).empty());

  // The document is saved, opened, and the same.
  bool done = false;
  session.save(path("rings.blossom").toStdString(), [&] { done = true; });
  QTRY_VERIFY(done);
  const std::string written = toJson(session.document());
  session.clear();
  openAndWait(path("rings.blossom"));
  QCOMPARE(toJson(session.document()), written);
}

void OffsetWindowTest::aTooLargeDistanceSaysWhatFits() {
  importDrawing();
  window_->tree().select(part_);
  run("feature.pocket.offset");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{2});
  edit("distance", "60 mm");
  waitUntilComputed();
  const auto view = window_->session().view(last());
  QVERIFY(view->result->error);
  QVERIFY2(view->result->error->message().find("the distance must be below ") != std::string::npos,
           view->result->error->what());
  edit("distance", "3 mm");
  waitUntilComputed();
  QVERIFY(!window_->session().view(last())->result->error);
}

void OffsetWindowTest::aFaceOfASolidIsPicked() {
  run("feature.modeling.box");
  waitUntilComputed();
  const FeatureId box = last();
  window_->tree().select(box);
  run("feature.pocket.offset");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{2});
  const FeatureId inset = last();
  waitUntilComputed();
  QVERIFY(window_->session().view(inset)->result->error);  // which face?
  run("view.top");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  (void)canvas();
  auto* const field = window_->properties().field(QStringLiteral("face"));
  QVERIFY(field);
  for (auto* button : field->findChildren<QToolButton*>())
    if (button->isCheckable()) QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(window_->properties().wanted());
  const Bounds extent = window_->view().extent();
  Vec3 top = extent.center();
  top.z() = extent.high.z();
  clickAt(top);
  QTRY_VERIFY(!window_->properties().wanted());
  waitUntilComputed();
  const auto view = window_->session().view(inset);
  QVERIFY2(!view->result->error, view->result->error ? view->result->error->what() : "");
  const Vec3 size = extent.high - extent.low;
  COMPARE_NEAR(measureOf(inset, "area"), (size.x() - 2) * (size.y() - 2), 1e-6);
}

BLOSSOM_WINDOW_TEST(OffsetWindowTest)
#include "offset_window_test.moc"
