#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QPointer>
#include <algorithm>
#include <cmath>
#include <limits>

#include "exchange/formats.h"
#include "geometry/measure/measure.h"
#include "geometry/planar/planar.h"
#include "subdivision/kernel/limit_surface.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "ui/plugin/tool.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

namespace {

/// A box of 40 mm, refined often enough to be pulled in one place: 96 faces, smooth like a pebble.
Mesh pebble() {
  Mesh cage = cubeCage();
  for (Vec3& p : cage.points) p *= 20;
  return subdivision::subdivide(cage, {.levels = 2}).mesh;
}

/// A ring of 5,000 faces.
Mesh ring() {
  Mesh cage = torusCage(100, 50);
  for (Vec3& p : cage.points) p *= 10;
  return cage;
}

double volumeOf(const Shape& shape) {
  for (const Measure& each : measure(shape).values)
    if (const auto* number = std::get_if<double>(&each.value); number && each.name == "volume") return *number;
  return std::numeric_limits<double>::quiet_NaN();
}

std::size_t differing(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
  return count;
}

}  // namespace

/// A cage is imported, its smooth surface pulled to a stroke and by its points, and saved: the way of a user through the
/// real window.
class SubdivisionWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void aSurfaceIsPulledToAStrokeAndSaved();
  void aPointIsDraggedAndPutBack();
  void anImportedTargetIsFollowed();
  void aDrawnOutlineIsPulledInItsPlane();
  void theCurveOfAClosedOutlineIsDragged();
  void theCurveOfAnOpenPolygonIsDragged();
  void aBrokenCageIsRefusedAndTheDocumentLivesOn();
  void aCageOf5000FacesIsDraggedLive();

 private:
  [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  void openCage(const Mesh& cage, const char* name);
  void choose(const char* parameter, const char* value);
  void drawStroke();
  [[nodiscard]] Shape saved(const QString& file) const {
    return readShape(*window_->session().app().formats, file.toStdString()).shape;
  }
  void keepPictures(const char* name);
  void mouse(QEvent::Type, const QPoint& at);
  /// Waits until the point can be taken hold of.
  void hover(const Vec3& p);
  void drag(const Vec3& from, const Vec3& to);
  [[nodiscard]] Value pulls() const;
  [[nodiscard]] Vec3 limitPoint(const FeatureId& of, std::size_t vertex) const;
  void dragCurve(const FeatureId& polygon, const FeatureId& smooth, std::size_t vertex, const Vec3& by);
  [[nodiscard]] std::vector<Vec3> polygonOf(const FeatureId&) const;
  [[nodiscard]] const Feature* find(const char* type) const;
  [[nodiscard]] const Mesh& meshOf(const FeatureId& id) const {
    return *window_->session().view(id)->result->evaluated.shape.get<Mesh>();
  }
  /// Turns the event loop and nothing else.
  template <class Done>
  bool wait(const Done& done);
  FeatureId cage_, smooth_;
  bool held_ = false;
};

const Feature* SubdivisionWindowTest::find(const char* type) const {
  for (const auto& feature : window_->page().document().features())
    if (feature->type == type) return feature.get();
  return nullptr;
}

/// From the file to its smooth surface, which is selected.
void SubdivisionWindowTest::openCage(const Mesh& cage, const char* name) {
  writeShape(standardFormats(), cage, path(name).toStdString());
  openAndWait(path(name));
  cage_ = last();
  QCOMPARE(meshOf(cage_).points, cage.points);
  window_->tree().select(cage_);
  run("feature.subdivision.subdivide");
  waitUntilComputed();
  smooth_ = last();
  choose("as", "limit");
  waitUntilComputed();
  QVERIFY(!window_->session().view(smooth_)->result->error);
  if (window_->page().document().at(cage_).visible) window_->tree().toggleVisible(cage_);
  window_->tree().select(smooth_);
}

void SubdivisionWindowTest::choose(const char* parameter, const char* value) {
  ParameterField* const field = window_->properties().field(QLatin1String(parameter));
  QVERIFY2(field, parameter);
  auto* const box = field->findChild<QComboBox*>();
  box->setFocus();
  for (int k = 0; k < box->count() && field->value() != value; ++k) {
    box->setCurrentIndex(k);
    emit box->activated(k);
  }
  QCOMPARE(QString::fromStdString(field->value().get<std::string>()), QLatin1String(value));
}

/// Over the top of the pebble, seen from the front: three clicks and Enter.
void SubdivisionWindowTest::drawStroke() {
  run("view.front");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch) < 1e-9);
  run("feature.subdivision.stroke");
  QVERIFY(window_->page().toolStarted());
  const QPoint start = screenOf({-9, -10, 12});
  const Pick under = window_->view().pickAt(start, PickMode::Any);
  QCOMPARE(under.feature, smooth_);
  const Vec3 first = under.part.point;
  for (const Vec3& p : {first, Vec3(0, first.y(), first.z() + 14), Vec3(-first.x(), first.y(), first.z())}) clickAt(p);
  QTest::keyClick(&window_->view(), Qt::Key_Return);
  QTRY_VERIFY(!window_->page().toolStarted());
  waitUntilComputed();
}

/// Kept where BLOSSOM_PICTURES says, to be looked at.
void SubdivisionWindowTest::keepPictures(const char* name) {
  window_->resize(1280, 800);
  window_->view().lookFrom(QStringLiteral("iso"), false);
  window_->view().fit(false);
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    QVERIFY(!canvas().isNull());
    const QPixmap picture = window_->grab();
    QVERIFY(!picture.isNull());
    const QString file =
        QStringLiteral("%1-%2.png")
            .arg(QLatin1String(name), choice == ThemeChoice::Light ? QStringLiteral("light") : QStringLiteral("dark"));
    if (!folder.isEmpty()) QVERIFY(picture.save(QDir(folder).filePath(file)));
  }
}

void SubdivisionWindowTest::aSurfaceIsPulledToAStrokeAndSaved() {
  const Mesh cage = pebble();
  openCage(cage, "pebble.obj");
  drawStroke();
  const Feature *stroke = find("subdivision.stroke"), *deform = find("subdivision.deform");
  QVERIFY(stroke && deform);
  QCOMPARE(deform->inputs, (std::vector<FeatureId>{cage_, stroke->id}));
  QCOMPARE(window_->page().document().at(smooth_).inputs, std::vector<FeatureId>{deform->id});
  const double before = measureOf(deform->id, "rms_before"), after = measureOf(deform->id, "rms_after");
  qInfo("rms %.3g to %.3g", before, after);
  QVERIFY(before > 2 && after < 0.1 * before);
  QCOMPARE(measureOf(deform->id, "outside_change"), 0.0);
  const std::size_t changed = differing(meshOf(deform->id).points, cage.points);
  QVERIFY(changed > 0 && changed <= static_cast<std::size_t>(measureOf(deform->id, "free_points")));
  QVERIFY(changed < cage.points.size());
  // The surface that is shown comes to the middle of the stroke, as near as its vertices lie.
  const Value& middle = stroke->parameters["points"][1];
  const Vec3 wanted(middle[0].get<double>(), middle[1].get<double>(), middle[2].get<double>());
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : meshOf(smooth_).points) nearest = std::min(nearest, (p - wanted).norm());
  QVERIFY2(nearest < 2, qPrintable(QString::number(nearest)));
  window_->tree().select(smooth_);
  keepPictures("pulled");

  const double volume = measureOf(smooth_, "volume");
  exportAs("stl", path("pulled.stl"));
  exportAs("obj", path("pulled.obj"));
  for (const char* name : {"pulled.stl", "pulled.obj"}) COMPARE_NEAR(volumeOf(saved(path(name))), volume, 1e-4 * volume);
  choose("as", "faces");
  waitUntilComputed();
  QVERIFY(!window_->session().view(smooth_)->result->error);
  exportAs("step", path("pulled.step"));
  COMPARE_NEAR(volumeOf(saved(path("pulled.step"))), volume, 0.01 * volume);

  bool kept = false;
  window_->session().save(path("pulled.blossom").toStdString(), [&] { kept = true; });
  QTRY_VERIFY(kept);
  const std::vector<Vec3> points = meshOf(deform->id).points;
  const FeatureId pulled = deform->id;
  window_->closePage(0);
  openAndWait(path("pulled.blossom"));
  QCOMPARE(meshOf(pulled).points, points);
}

/// Straight to the view: moves by way of the display arrive in their own time.
void SubdivisionWindowTest::mouse(QEvent::Type type, const QPoint& at) {
  const bool moves = type == QEvent::MouseMove;
  held_ = type == QEvent::MouseButtonPress || (held_ && moves);
  ViewWidget& view = window_->view();
  QMouseEvent event(type, at, view.mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                    held_ ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&view, &event);
}

void SubdivisionWindowTest::hover(const Vec3& p) {
  const auto over = [&] {
    mouse(QEvent::MouseMove, screenOf(p));
    const Tool* handles = window_->page().tool();
    return handles && handles->hint().startsWith(QStringLiteral("Drag to pull"));
  };
  QTRY_VERIFY2_WITH_TIMEOUT(over(), "the point cannot be taken hold of", 60000);
}

void SubdivisionWindowTest::drag(const Vec3& from, const Vec3& to) {
  hover(from);
  const QPoint start = screenOf(from), end = screenOf(to);
  mouse(QEvent::MouseButtonPress, start);
  for (int k = 1; k <= 6; ++k) mouse(QEvent::MouseMove, start + (end - start) * k / 6);
  mouse(QEvent::MouseButtonRelease, end);
  waitUntilComputed();
}

Value SubdivisionWindowTest::pulls() const {
  const Feature* deform = find("subdivision.deform");
  return deform ? deform->parameters.value("pulls", Value::array()) : Value::array();
}

Vec3 SubdivisionWindowTest::limitPoint(const FeatureId& of, std::size_t vertex) const {
  return subdivision::subdivide(meshOf(of), {.levels = 0, .limit = true}).mesh.points[vertex];
}

void SubdivisionWindowTest::aPointIsDraggedAndPutBack() {
  const Mesh cage = pebble();
  openCage(cage, "dragged.obj");
  window_->view().lookFrom(QStringLiteral("iso"), false);
  const auto top = static_cast<std::size_t>(
      std::max_element(cage.points.begin(), cage.points.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) -
      cage.points.begin());
  const Vec3 at = limitPoint(cage_, top), wanted = at + Vec3(0, 0, 8);
  drag(at, wanted);
  const Feature* deform = find("subdivision.deform");
  QVERIFY(deform);
  const FeatureId pulled = deform->id;
  QCOMPARE(pulls().size(), std::size_t(1));
  const auto place = [](const Value& p) { return Vec3(p[0].get<double>(), p[1].get<double>(), p[2].get<double>()); };
  const Vec3 to = place(pulls()[0]["to"]);
  QVERIFY((place(pulls()[0]["at"]) - at).norm() < 1e-12);
  // It was drawn on the screen where the mouse let go.
  QVERIFY((screenOf(to) - screenOf(wanted)).manhattanLength() <= 2);
  const Vec3 first = limitPoint(pulled, top);
  QVERIFY2((first - to).norm() < 0.01 * (to - at).norm(), qPrintable(QString::number((first - to).norm())));
  QCOMPARE(measureOf(pulled, "outside_change"), 0.0);
  QCOMPARE(window_->page().document().at(smooth_).inputs, std::vector<FeatureId>{pulled});

  // The same point again is the same pull; Esc in the middle changes nothing.
  window_->tree().select(smooth_);
  drag(to, to + Vec3(0, 0, -3));
  QCOMPARE(pulls().size(), std::size_t(1));
  const Value twice = pulls();
  const Vec3 now = place(twice[0]["to"]);
  QVERIFY((now - to).norm() > 0.5);
  hover(now);
  mouse(QEvent::MouseButtonPress, screenOf(now));
  mouse(QEvent::MouseMove, screenOf(now) + QPoint(25, -10));
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, screenOf(now) + QPoint(25, -10));
  waitUntilComputed();
  QCOMPARE(pulls(), twice);

  keepPictures("dragged");
  window_->session().undo();
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(!find("subdivision.deform"));
  QCOMPARE(meshOf(cage_).points, cage.points);
}

/// Both imported and selected: the feature of the menu takes them.
void SubdivisionWindowTest::anImportedTargetIsFollowed() {
  const Mesh cage = pebble();
  openCage(cage, "followed.obj");
  QFile cloud(path("target.xyz"));
  QVERIFY(cloud.open(QIODevice::WriteOnly));
  for (int k = 0; k <= 20; ++k) {
    const double x = -8 + 0.8 * k;
    cloud.write(QStringLiteral("%1 0 %2\n").arg(x).arg(18 + 4 * std::cos(x * M_PI / 16)).toLatin1());
  }
  cloud.close();
  window_->session().import({path("target.xyz").toStdString()});
  waitUntilComputed();
  const FeatureId target = last();
  window_->tree().selectThese({cage_, target});
  run("feature.subdivision.deform");
  waitUntilComputed();
  const FeatureId deform = last();
  QCOMPARE(window_->page().document().at(deform).inputs, (std::vector<FeatureId>{cage_, target}));
  QVERIFY(measureOf(deform, "rms_after") < 0.2 * measureOf(deform, "rms_before"));
  const double free = measureOf(deform, "free_points");
  edit("free", "rings:1");
  waitUntilComputed();
  QVERIFY(measureOf(deform, "free_points") > free);
  edit("free", "rings:many");
  waitUntilComputed();
  const auto view = window_->session().view(deform);
  QVERIFY(view->result->error);
  QVERIFY(view->result->error->message().find("rings:N") != std::string::npos);
  edit("free", "paper");
  waitUntilComputed();
  QVERIFY(!window_->session().view(deform)->result->error);
}

/// A closed outline is a cage like any other, and a stroke over it stays in its plane, seen from wherever.
void SubdivisionWindowTest::aDrawnOutlineIsPulledInItsPlane() {
  run("feature.modeling.rectangle");
  waitUntilComputed();
  const FeatureId outline = last();
  QCOMPARE(window_->session().view(outline)->result->evaluated.shape.kind(), ShapeKind::Region);
  const double width = std::sqrt(measureOf(outline, "area"));
  window_->view().lookFrom(QStringLiteral("iso"), false);
  window_->view().fit(false);
  window_->tree().select(outline);
  run("feature.subdivision.stroke");
  QVERIFY(window_->page().toolStarted());
  for (const double x : {-0.3, 0.0, 0.3}) clickAt(Vec3(x * width, 0.4 * width + 0.1 * width * std::cos(5 * x), 0));
  QTest::keyClick(&window_->view(), Qt::Key_Return);
  QTRY_VERIFY(!window_->page().toolStarted());
  waitUntilComputed();
  const Feature *stroke = find("subdivision.stroke"), *deform = find("subdivision.deform");
  QVERIFY(stroke && deform);
  QCOMPARE(deform->inputs, (std::vector<FeatureId>{outline, stroke->id}));
  for (const Value& p : stroke->parameters["points"]) QCOMPARE(p[2].get<double>(), 0.0);
  const auto view = window_->session().view(deform->id);
  QVERIFY2(!view->result->error, view->result->error ? view->result->error->what() : "");
  QCOMPARE(view->result->evaluated.shape.kind(), ShapeKind::Curves);
  QVERIFY(measureOf(deform->id, "rms_after") < 0.5 * measureOf(deform->id, "rms_before"));
}

/// The corners of drawn lines or of a curve of degree 1; the first is not repeated at the end.
std::vector<Vec3> SubdivisionWindowTest::polygonOf(const FeatureId& id) const {
  const Shape& shape = window_->session().view(id)->result->evaluated.shape;
  std::vector<Vec3> points;
  if (const auto* curve = shape.get<Curve>())
    for (const Vec4& pole : curve->poles) points.emplace_back(pole.head<3>());
  const auto drawing = drawingOf(shape);
  if (drawing)
    for (const Segment& segment : drawing->paths.at(0).segments) {
      const Vec2 from = startPoint(segment), to = endPoint(segment);
      if (points.empty()) points.emplace_back(from.x(), from.y(), 0);
      points.emplace_back(to.x(), to.y(), 0);
    }
  if (points.size() > 2 && (points.front() - points.back()).norm() < 1e-9) points.pop_back();
  return points;
}

/// A vertex between its neighbours has its limit point at (1, 4, 1)/6 of the three.
void SubdivisionWindowTest::dragCurve(const FeatureId& polygon, const FeatureId& smooth, std::size_t vertex,
                                      const Vec3& by) {
  const auto limit = [&](const std::vector<Vec3>& p) {
    const std::size_t n = p.size();
    return Vec3((p[(vertex + n - 1) % n] + 4 * p[vertex] + p[(vertex + 1) % n]) / 6);
  };
  const std::vector<Vec3> before = polygonOf(polygon);
  const Vec3 at = limit(before);
  window_->tree().select(smooth);
  window_->view().lookFrom(QStringLiteral("top"), false);
  window_->view().fit(false);
  drag(at, at + by);
  QCOMPARE(pulls().size(), std::size_t(1));
  const auto place = [](const Value& p) { return Vec3(p[0].get<double>(), p[1].get<double>(), p[2].get<double>()); };
  const Vec3 to = place(pulls()[0]["to"]);
  QVERIFY((place(pulls()[0]["at"]) - at).norm() < 1e-9);
  QCOMPARE(to.z(), 0.0);
  QVERIFY((screenOf(to) - screenOf(at + by)).manhattanLength() <= 2);
  const FeatureId pulled =
      find("subdivision.deform")->inputs == std::vector<FeatureId>{polygon} ? find("subdivision.deform")->id : FeatureId();
  QVERIFY(!pulled.empty());
  QVERIFY(!window_->session().view(pulled)->result->error);
  const std::vector<Vec3> after = polygonOf(pulled);
  QCOMPARE(after.size(), before.size());
  QVERIFY2((limit(after) - to).norm() < 0.01 * (to - at).norm(), qPrintable(QString::number((limit(after) - to).norm())));
  // Only what acts there has moved: the vertex and its two neighbours.
  QVERIFY(differing(after, before) > 0 && differing(after, before) <= 3);
  QCOMPARE(window_->page().document().at(smooth).inputs, std::vector<FeatureId>{pulled});

  // The same place again is the same pull.
  window_->tree().select(smooth);
  drag(limit(after), limit(after) - by / 2);
  QCOMPARE(pulls().size(), std::size_t(1));
  QVERIFY((place(pulls()[0]["to"]) - to).norm() > 0.2 * by.norm());
  window_->session().undo();
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(polygonOf(polygon), before);
}

void SubdivisionWindowTest::theCurveOfAClosedOutlineIsDragged() {
  run("feature.modeling.rectangle");
  waitUntilComputed();
  const FeatureId outline = last();
  QCOMPARE(window_->session().view(outline)->result->evaluated.shape.kind(), ShapeKind::Region);
  window_->tree().select(outline);
  run("feature.subdivision.subdivide");
  waitUntilComputed();
  const FeatureId smooth = last();
  for (const char* scheme : {"catmull-clark", "cubic"}) {
    window_->tree().select(smooth);
    choose("scheme", scheme);
    waitUntilComputed();
    if (window_->page().document().at(outline).visible) window_->tree().toggleVisible(outline);
    const double size = std::sqrt(measureOf(outline, "area"));
    dragCurve(outline, smooth, 2, Vec3(0.2 * size, 0.1 * size, 0));
  }
}

void SubdivisionWindowTest::theCurveOfAnOpenPolygonIsDragged() {
  openAndWait(QString::fromStdString(sample("pulled-curve.blossom").string()));
  FeatureId smooth;
  for (const auto& feature : window_->page().document().features())
    if (feature->name == "Before") smooth = feature->id;
  QVERIFY(!smooth.empty());
  const FeatureId polygon = window_->page().document().at(smooth).inputs.front();
  Document alone = window_->page().document();
  for (const auto& feature : window_->page().document().features())
    if (feature->type == "subdivision.deform") alone = alone.without(feature->id);
  window_->session().commit(alone, QStringLiteral("Leave the polygon"));
  waitUntilComputed();
  dragCurve(polygon, smooth, 6, Vec3(2, 9, 0));
}

void SubdivisionWindowTest::aBrokenCageIsRefusedAndTheDocumentLivesOn() {
  Mesh fin = pebble();
  addPolygon(fin, {fin.faceVertices[0], fin.faceVertices[1], fin.faceVertices[60]});
  writeShape(standardFormats(), fin, path("fin.obj").toStdString());
  openAndWait(path("fin.obj"));
  window_->tree().select(last());
  run("feature.subdivision.subdivide");
  waitUntilComputed();
  const auto view = window_->session().view(last());
  QVERIFY(view->result->error);
  QVERIFY(view->result->error->message().find("vertex") != std::string::npos);
  QVERIFY(!view->result->error->hint().empty());
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(window_->page().document().features().size(), std::size_t(1));
}

template <class Done>
bool SubdivisionWindowTest::wait(const Done& done) {
  QEventLoop loop;
  QTimer poll;
  connect(&poll, &QTimer::timeout, &loop, [&] {
    if (done()) loop.quit();
  });
  poll.start(8);
  QTimer::singleShot(60000, &loop, [&] { loop.exit(1); });
  return loop.exec() == 0;
}

/// Prints what a user feels; what is checked is that the surface follows the mouse.
void SubdivisionWindowTest::aCageOf5000FacesIsDraggedLive() {
  const Mesh cage = ring();
  QCOMPARE(cage.faceCount(), std::size_t(5000));
  openCage(cage, "ring.obj");
  edit("levels", "1");
  waitUntilComputed();
  window_->view().lookFrom(QStringLiteral("iso"), false);
  window_->view().fit(false);
  const auto top = static_cast<std::size_t>(25 * 50 + 12);  // a quarter of the way round, on top
  const Vec3 at = limitPoint(cage_, top);
  StallWatch watch;
  window_->tree().select(cage_);
  window_->tree().select(smooth_);
  hover(at);
  qInfo("figure drag_select_stall_ms %.1f", watch.overall().wall);
  qInfo("figure drag_select_stall_computing_ms %.1f", watch.overall().busy);
  watch.reset();

  const QPoint start = screenOf(at);
  mouse(QEvent::MouseButtonPress, start);
  QElapsedTimer grabbed;
  grabbed.start();
  const Tool* const handles = window_->page().tool();
  QVERIFY(wait([&] { return handles->props().size() > 2; }));  // the surface within reach is drawn as it would become
  qInfo("figure drag_grab_ms %lld", static_cast<long long>(grabbed.elapsed()));
  const int before = window_->view().framesDrawn();
  int moves = 0;
  double slowest = 0;
  QElapsedTimer dragging;
  dragging.start();
  constexpr int wantedMoves = 120;
  QVERIFY(wait([&] {
    slowest = std::max(slowest, window_->view().lastFrameMs());
    if (moves >= wantedMoves) return true;
    ++moves;
    mouse(QEvent::MouseMove, start + QPoint(0, -moves / 2));
    return false;
  }));
  const double seconds = static_cast<double>(dragging.elapsed()) / 1000;
  qInfo("figure drag_frames_per_s %.1f", (window_->view().framesDrawn() - before) / seconds);
  qInfo("figure drag_slowest_frame_ms %.1f", slowest);
  qInfo("figure drag_stall_ms %.1f", watch.overall().wall);
  qInfo("figure drag_stall_computing_ms %.1f", watch.overall().busy);
  watch.reset();
  mouse(QEvent::MouseButtonRelease, start + QPoint(0, -moves / 2));
  QVERIFY(wait([&] { return find("subdivision.deform") && !window_->session().evaluating(); }));
  qInfo("figure drag_drop_stall_ms %.1f", watch.overall().wall);
  qInfo("figure drag_drop_stall_computing_ms %.1f", watch.overall().busy);
  const FeatureId pulled = find("subdivision.deform")->id;
  QVERIFY(!window_->session().view(pulled)->result->error);
  QVERIFY((screenOf(limitPoint(pulled, top)) - (start + QPoint(0, -moves / 2))).manhattanLength() <= 2);
  QCOMPARE(measureOf(pulled, "outside_change"), 0.0);
  QVERIFY(differing(meshOf(pulled).points, cage.points) <= static_cast<std::size_t>(measureOf(pulled, "free_points")));
}

BLOSSOM_WINDOW_TEST(SubdivisionWindowTest)
#include "subdivision_window_test.moc"
