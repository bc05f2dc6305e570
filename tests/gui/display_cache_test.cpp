#include "ui/session/display_cache.h"

#include <BRepPrimAPI_MakeSphere.hxx>
#include <array>
#include <thread>

#include "support/support.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

constexpr double radius = 10;

std::shared_ptr<FeatureResult> sphere() {
  auto result = std::make_shared<FeatureResult>();
  result->evaluated.shape = Brep(BRepPrimAPI_MakeSphere(radius).Shape());
  return result;
}

/// How far what is drawn lies from the sphere: vertices, and the triangles between them.
double farthest(vtkPolyData& faces) {
  const auto off = [](const Vec3& p) { return std::abs(p.norm() - radius); };
  double most = 0;
  for (vtkIdType cell = 0; cell < faces.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    faces.GetCellPoints(cell, count, corners);
    Vec3 middle = Vec3::Zero();
    for (vtkIdType i = 0; i < count; ++i) {
      const Vec3 corner(faces.GetPoint(corners[i]));
      most = std::max(most, off(corner));
      middle += corner / double(count);
    }
    most = std::max(most, off(middle));
  }
  return most;
}

}  // namespace

class DisplayCacheTest : public QObject {
  Q_OBJECT
 private slots:
  void whatCannotBeDrawnKeepsItsReason();
  void theSameShapeIsDrawnOnce();
  void threadsDrawTheSameShapeOnce();
  void aToleranceIsKept();
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

// Features that are shown side by side may share a shape, as one that is suppressed does with its input.
void DisplayCacheTest::threadsDrawTheSameShapeOnce() {
  const auto ball = sphere();
  DisplayCache cache;
  std::array<std::shared_ptr<const FeatureView>, 4> views;
  std::vector<std::thread> threads;
  for (auto& view : views) threads.emplace_back([&] { view = cache.view(ball, 0.01, Progress::none()); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& view : views) QVERIFY(view->scene.faces && view->scene.faces == views[0]->scene.faces);
}

void DisplayCacheTest::aToleranceIsKept() {
  const auto ball = sphere();
  DisplayCache cache;
  vtkIdType before = 0;
  for (const double tolerance : {1.0, 0.02, 0.005}) {
    const auto view = cache.view(ball, tolerance, Progress::none());
    QVERIFY(!view->result->error && view->scene.faces && view->scene.solid);
    const vtkIdType triangles = view->scene.faces->GetNumberOfCells();
    QVERIFY2(triangles > before, qPrintable(QStringLiteral("%1 triangles within %2").arg(triangles).arg(tolerance)));
    QVERIFY2(farthest(*view->scene.faces) <= tolerance, qPrintable(QString::number(farthest(*view->scene.faces))));
    before = triangles;
  }
  // Every tolerance has its own drawing; what was drawn before is shown again.
  const auto fine = cache.view(ball, 0.005, Progress::none()), usual = cache.view(ball, 0, Progress::none());
  QCOMPARE(fine->scene.faces->GetNumberOfCells(), before);
  QVERIFY(usual->scene.faces->GetNumberOfCells() < before);
  QVERIFY(farthest(*usual->scene.faces) <= 2 * radius * std::sqrt(3.0) * 1e-3);
  QVERIFY(usual->scene.faces == cache.view(ball, 0, Progress::none())->scene.faces);
}

BLOSSOM_TEST(DisplayCacheTest)
#include "display_cache_test.moc"
