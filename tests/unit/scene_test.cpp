#include <Eigen/Geometry>
#include <QImage>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "app/picture_format.h"
#include "core/file.h"
#include "exchange/format/format.h"
#include "scene/camera.h"
#include "scene/scene.h"
#include "support/support.h"

using namespace blossom;

namespace {

/// Sphere about the origin of n x 2n quads, with exact normals and two colours: red above z = 0, blue below.
Tessellation sphere(double radius, int n) {
  Tessellation t;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= 2 * n; ++j) {
      const double a = std::numbers::pi * i / n, b = std::numbers::pi * j / n;
      const Vec3 normal(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      t.normals.push_back(normal);
      t.points.push_back(radius * normal);
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const int k = i * (2 * n + 1) + j, below = k + 2 * n + 1;
      t.triangles.push_back({k, below, k + 1});
      t.triangles.push_back({k + 1, below, below + 1});
      t.faceOfTriangle.insert(t.faceOfTriangle.end(), 2, i < n / 2 ? 0 : 1);
    }
  t.faceColors = {Color{0.9, 0.1, 0.1}, Color{0.1, 0.1, 0.9}};
  return t;
}

Mesh toQuads(const Tessellation& t) {
  Mesh mesh;
  mesh.points = t.points;
  for (const auto& triangle : t.triangles) mesh.addFace(triangle);
  return mesh;
}

Shape ball(double radius) { return toQuads(sphere(radius, 24)); }

int distance(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

}  // namespace

class SceneTest : public QObject {
  Q_OBJECT
 private slots:
  void polyDataHoldsWhatTheTessellationHolds();
  void piecesOfALargeShapeAreItsFaces();
  void edgesHaveColoursOfTheirOwn();
  void aFramedSphereTouchesTheMarginExactly();
  void aPointAloneIsFramed();
  void namedViewsAreRightHandedFrames();
  void pictureShowsTheShapeInTheMiddleAndCanvasAtTheCorners();
  void pictureLargerThanATileHasNoSeams();
  void transparentPictureHasNoCanvas();
  void badOptionsAreRefused();
  void pngIsARegisteredFormat();
};

void SceneTest::polyDataHoldsWhatTheTessellationHolds() {
  Tessellation t = sphere(3, 12);
  t.edges = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}};
  t.markers = {Vec3(0, 0, 9)};
  const SceneData data = toSceneData(t);
  QCOMPARE(data.faces->GetNumberOfPolys(), vtkIdType(t.triangles.size()));
  QCOMPARE(data.edges->GetNumberOfPoints(), vtkIdType(3));
  QCOMPARE(data.points->GetNumberOfVerts(), vtkIdType(1));
  QVERIFY(!data.planar);
  vtkDataArray* normals = data.faces->GetPointData()->GetNormals();
  QVERIFY(normals);
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i) {
    const double* n = normals->GetTuple3(i);
    COMPARE_NEAR(Vec3(n[0], n[1], n[2]).norm(), 1.0, 1e-6);
  }
  QCOMPARE(int(data.faces->GetCellData()->GetScalars()->GetTuple3(0)[0]), 230);
  QCOMPARE(data.faces->GetCellData()->GetArray("face")->GetTuple1(vtkIdType(t.triangles.size()) - 1), 1.0);
  QVERIFY(toSceneData(Tessellation{}).empty());
}

// The cone of sight through the margin touches a sphere of radius r at distance r / sin(angle).
void SceneTest::piecesOfALargeShapeAreItsFaces() {
  QVERIFY(toSceneData(sphere(2, 24)).pieces.empty());
  const Tessellation t = sphere(2, 200);
  const SceneData data = toSceneData(t);
  QVERIFY(data.pieces.size() > 1);
  std::size_t next = 0;
  for (const auto& piece : data.pieces) {
    QVERIFY(piece->GetNumberOfPolys() <= 40'000);
    auto* faces = piece->GetCellData()->GetArray("face");
    for (vtkIdType cell = 0; cell < piece->GetNumberOfPolys(); ++cell, ++next) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      piece->GetPolys()->GetCellAtId(cell, count, ids);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto k = static_cast<std::size_t>(t.triangles[next][corner]);
        Vec3 p, normal;
        piece->GetPoint(ids[corner], p.data());
        piece->GetPointData()->GetNormals()->GetTuple(ids[corner], normal.data());
        QVERIFY(p == t.points[k]);
        QVERIFY((normal - t.normals[k]).norm() < 1e-6);
      }
      QCOMPARE(static_cast<int>(faces->GetTuple1(cell)), t.faceOfTriangle[next]);
    }
  }
  QCOMPARE(next, t.triangles.size());
}

void SceneTest::edgesHaveColoursOfTheirOwn() {
  Tessellation t;
  t.edges = {{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(2, 1, 0)}};
  QVERIFY(!toSceneData(t).edges->GetCellData()->GetScalars());
  t.edgeColors = {Color{1, 0, 0}, Color{0, 0, 1}};
  const SceneData data = toSceneData(t);
  auto* colors = data.edges->GetCellData()->GetScalars();
  QVERIFY(colors);
  QCOMPARE(colors->GetNumberOfTuples(), vtkIdType{2});
  QCOMPARE(colors->GetComponent(0, 0), 255.0);
  QCOMPARE(colors->GetComponent(1, 2), 255.0);
  QCOMPARE(colors->GetComponent(1, 0), 0.0);
}

void SceneTest::aFramedSphereTouchesTheMarginExactly() {
  const double radius = 7, viewAngle = 30, margin = 0.1;
  const Turn turn{20, 40};
  const Framing framing = frameAll(sphere(radius, 200).points, turn, 1.5, viewAngle, margin);
  const double tangent = std::tan(viewAngle / 2 * std::numbers::pi / 180) * (1 - 2 * margin);
  COMPARE_NEAR(framing.distance, radius / std::sin(std::atan(tangent)), 1e-2);
  COMPARE_NEAR(framing.target.norm(), 0, 1e-2);
  COMPARE_NEAR(framing.parallelScale, radius / (1 - 2 * margin), 1e-2);
}

void SceneTest::aPointAloneIsFramed() {
  const Vec3 point(3, 4, 5);
  const Framing framing = frameAll({point}, turnOf("top"), 1.5, 30);
  COMPARE_NEAR((framing.target - point).norm(), 0, 1e-12);
  QVERIFY2(framing.parallelScale > 1, "a view of no size shows nothing");
  QVERIFY(framing.distance > 1);
}

void SceneTest::namedViewsAreRightHandedFrames() {
  for (const std::string& name : viewNames()) {
    if (name == "auto") continue;
    const Turn turn = turnOf(name);
    COMPARE_NEAR((turn.right().cross(turn.up()) - turn.toCamera()).norm(), 0, 1e-12);
  }
  QVERIFY((turnOf("right").toCamera() - Vec3(1, 0, 0)).norm() < 1e-12);
  QVERIFY((turnOf("top").up() - Vec3(0, 1, 0)).norm() < 1e-12);
  VERIFY_ERROR(turnOf("sideways"), ErrorCode::InvalidParameter);
}

void SceneTest::pictureShowsTheShapeInTheMiddleAndCanvasAtTheCorners() {
  const TemporaryFolder folder;
  const auto png = folder.path() / "ball.png";
  renderPicture({ball(5)}, png, {.width = 300, .height = 200});
  const QImage image(QString::fromStdString(png.string()));
  QCOMPARE(image.size(), QSize(300, 200));
  const Color top = Look::dark().backgroundTop, bottom = Look::dark().backgroundBottom;
  const auto rgb = [](const Color& c) { return qRgb(int(c.red * 255), int(c.green * 255), int(c.blue * 255)); };
  QVERIFY(distance(image.pixel(1, 1), rgb(top)) < 12);
  QVERIFY(distance(image.pixel(298, 198), rgb(bottom)) < 12);
  QVERIFY(distance(image.pixel(150, 100), rgb(top)) > 120);
  // The ball fills the height but for a margin of 8 % on each side.
  QVERIFY(distance(image.pixel(150, 22), image.pixel(1, 22)) > 60);
  QVERIFY(distance(image.pixel(150, 8), image.pixel(1, 8)) < 12);
}

// A ball seen from above is symmetric: its left and right silhouettes agree in every row although they are in different
// tiles.
void SceneTest::pictureLargerThanATileHasNoSeams() {
  const TemporaryFolder folder;
  const auto png = folder.path() / "large.png";
  renderPicture({ball(5)}, png, {.width = 1800, .height = 1500, .view = "top", .transparent = true});
  const QImage image(QString::fromStdString(png.string()));
  QCOMPARE(image.size(), QSize(1800, 1500));
  double area = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) area += qAlpha(image.pixel(x, y)) / 255.0;
  const double radius = 0.42 * 1500;  // half of the height without the margins
  COMPARE_NEAR(area / (std::numbers::pi * radius * radius), 1.0, 0.02);
  for (int y = 150; y < 1350; y += 50) {
    int left = 0, right = image.width() - 1;
    while (qAlpha(image.pixel(left, y)) < 128 && left < 900) ++left;
    while (qAlpha(image.pixel(right, y)) < 128 && right > 900) --right;
    QVERIFY2(std::abs((left + right) - (image.width() - 1)) <= 4, qPrintable(QString::number(y)));
  }
}

void SceneTest::transparentPictureHasNoCanvas() {
  const TemporaryFolder folder;
  const auto png = folder.path() / "clear.png";
  renderPicture({ball(5)}, png, {.width = 120, .height = 120, .transparent = true});
  const QImage image(QString::fromStdString(png.string()));
  QCOMPARE(qAlpha(image.pixel(1, 1)), 0);
  QCOMPARE(qAlpha(image.pixel(60, 60)), 255);
}

void SceneTest::badOptionsAreRefused() {
  const TemporaryFolder folder;
  const auto png = folder.path() / "x.png";
  VERIFY_ERROR(renderPicture({ball(5)}, png, {.width = 0}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(renderPicture({}, png, {}), ErrorCode::InvalidInput);
  VERIFY_ERROR(renderPicture({ball(5)}, png, {.view = "sideways"}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(renderPicture({ball(5)}, folder.path() / "no" / "x.png", {.width = 60, .height = 40}),
               ErrorCode::FileUnwritable);
  QVERIFY(!std::filesystem::exists(png));
}

void SceneTest::pngIsARegisteredFormat() {
  FormatRegistry formats;
  formats.add(pngFormat());
  const TemporaryFolder folder;
  const auto png = folder.path() / "ball.png";
  writeShape(formats, ball(5), png, Value{{"size", "64x48"}, {"theme", "light"}});
  QCOMPARE(QImage(QString::fromStdString(png.string())).size(), QSize(64, 48));
  VERIFY_ERROR(writeShape(formats, ball(5), png, Value{{"size", "64 by 48"}}), ErrorCode::InvalidParameter);
}

BLOSSOM_TEST(SceneTest)
#include "scene_test.moc"
