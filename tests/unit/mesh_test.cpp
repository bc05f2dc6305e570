#include "geometry/mesh/mesh.h"

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/tessellate/tessellate.h"
#include "support/solids.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

void appendMesh(Mesh& mesh, const Mesh& other) {
  const int offset = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (std::size_t f = 0; f < other.faceCount(); ++f) {
    std::vector<int> face(other.face(f).begin(), other.face(f).end());
    for (int& v : face) v += offset;
    mesh.addFace(face);
  }
}

/// Columns of whole heights side by side, with a corner at every whole place of the outline.
std::vector<Vec2> columns(Random& random, int count) {
  std::vector<Vec2> outline;
  for (int x = 0; x < count; ++x) outline.emplace_back(x, 0);
  int height = 0;
  for (int x = count; x > 0; --x) {
    for (const int next = uniformInt(random, 1, 4); height != next; height += height < next ? 1 : -1)
      outline.emplace_back(x, height);
    outline.emplace_back(x, height);
  }
  for (; height > 0; --height) outline.emplace_back(0, height);
  return outline;
}

/// Star-shaped polygon in a tilted plane, counter-clockwise around `axis`.
std::vector<Vec3> starPolygon(Random& random, int corners, const Vec3& axis) {
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  std::vector<Vec3> points;
  for (int k = 0; k < corners; ++k) {
    const double r = uniform(random, 0.2, 5), angle = 2 * pi * k / corners;
    points.push_back(Vec3(1, 2, 3) + r * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return points;
}

}  // namespace

class MeshTest : public QObject {
  Q_OBJECT
 private slots:
  void boxIsClosedWithItsVolume() {
    const Measures m = measure(boxMesh({1, 2, 3}, {2, 3, 4}));
    COMPARE_NEAR(measured<double>(m, "volume"), 24, 1e-13);
    COMPARE_NEAR(measured<double>(m, "area"), 52, 1e-13);
    QCOMPARE(measured<std::int64_t>(m, "faces"), std::int64_t{6});
    QCOMPARE(measured<std::int64_t>(m, "vertices"), std::int64_t{8});
    QCOMPARE(measured<std::int64_t>(m, "edges"), std::int64_t{12});
    QCOMPARE(measured<std::int64_t>(m, "genus"), std::int64_t{0});
    QCOMPARE(measured<bool>(m, "closed"), true);
  }
  void openMeshHasNoVolume() {
    Mesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
    mesh.faceStarts.pop_back();
    mesh.faceVertices.resize(20);
    const Measures m = measure(mesh);
    QVERIFY(!hasMeasure(m, "volume"));
    QCOMPARE(measured<bool>(m, "closed"), false);
    COMPARE_NEAR(measured<double>(m, "area"), 5, 1e-13);
  }
  void torusHasOneHandle() {
    const int n = 40, k = 20;
    const Measures m = measure(torusMesh(5, 2, n, k));
    QCOMPARE(measured<std::int64_t>(m, "genus"), std::int64_t{1});
    QCOMPARE(measured<bool>(m, "closed"), true);
    // Sectors of the k-gon between n half-planes: its area times its centre's radius times n sin(2 pi / n).
    const double profile = k / 2.0 * 4 * std::sin(2 * pi / k);
    COMPARE_NEAR(measured<double>(m, "volume"), profile * 5 * n * std::sin(2 * pi / n), 1e-9);
  }
  void componentsAndGenusAddUp() {
    Mesh mesh = torusMesh(5, 1, 12, 8);
    appendMesh(mesh, torusMesh(20, 1, 12, 8));
    appendMesh(mesh, boxMesh({100, 0, 0}, {1, 1, 1}));
    const Measures m = measure(mesh);
    QCOMPARE(measured<std::int64_t>(m, "genus"), std::int64_t{2});
    QCOMPARE(measured<std::int64_t>(m, "components"), std::int64_t{3});
  }
  void wallsOfVoidsAreShellsButNoComponents() {
    const auto inwards = [](Mesh mesh) {
      for (std::size_t first = 0; first < mesh.faceVertices.size(); first += 4)
        std::reverse(mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(first),
                     mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(first + 4));
      return mesh;
    };
    Mesh mesh = boxMesh({1e6, 0, 0}, {3, 3, 3});
    appendMesh(mesh, inwards(boxMesh({1e6 + 1, 1, 1}, {1, 1, 1})));
    const Measures m = measure(mesh);
    QCOMPARE(measured<std::int64_t>(m, "components"), std::int64_t{1});
    QCOMPARE(measured<std::int64_t>(m, "shells"), std::int64_t{2});
    COMPARE_NEAR(measured<double>(m, "volume"), 26, 1e-9);
    Mesh apart = boxMesh({0, 0, 0}, {1, 1, 1});
    for (int k = 1; k < 40; ++k) appendMesh(apart, boxMesh({1e6 + 7.3 * k, 1.1e5 * k, 3e5}, {0.1, 0.1, 0.1}));
    QCOMPARE(measured<std::int64_t>(measure(apart), "components"), std::int64_t{40});
    const Measures insideOut = measure(inwards(boxMesh({0, 0, 0}, {1, 1, 1})));
    QCOMPARE(measured<std::int64_t>(insideOut, "components"), std::int64_t{1});
  }
  void boxesThatTouchInAnEdgeStayTwo() {
    Mesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
    appendMesh(mesh, boxMesh({1, 1, 0}, {1, 1, 1}));
    const Mesh merged = toMesh(tessellate(mesh));
    QCOMPARE(merged.points.size(), std::size_t{14});
    const Measures m = measure(merged);
    QCOMPARE(measured<bool>(m, "closed"), true);
    QCOMPARE(measured<std::int64_t>(m, "genus"), std::int64_t{0});
    QCOMPARE(measured<std::int64_t>(m, "components"), std::int64_t{2});
    COMPARE_NEAR(measured<double>(m, "volume"), 2, 1e-13);
  }
  void polygonsOfAnyFormAreCovered() {
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
      const Vec3 axis = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)).normalized();
      const std::vector<Vec3> polygon = starPolygon(random, uniformInt(random, 3, 40), axis);
      const double wanted = vectorArea(polygon).dot(axis);
      if (wanted < 1e-3) continue;
      const auto triangles = triangulate(polygon);
      QCOMPARE(triangles.size(), polygon.size() - 2);
      double signedSum = 0, sum = 0;
      for (const auto& t : triangles) {
        const std::vector<Vec3> corners{polygon[static_cast<std::size_t>(t[0])], polygon[static_cast<std::size_t>(t[1])],
                                        polygon[static_cast<std::size_t>(t[2])]};
        signedSum += vectorArea(corners).dot(axis);
        sum += vectorArea(corners).norm();
      }
      COMPARE_NEAR(signedSum, wanted, 1e-10);
      if (wanted > 1) COMPARE_NEAR(sum, wanted, 1e-9);  // no triangle is turned over
    }
  }
  /// Slots that are narrow, but wider than rounding, are no spikes.
  void narrowSlotsStay() {
    Random random = seededRandom();
    for (double width = 1e-10; width < 1e-5; width *= 3) {
      std::vector<Vec3> polygon{{-50, -1, 0}};
      polygon.emplace_back(50, -1, 0);
      for (int k = 49; k > -50; --k)
        for (const Vec2& p : {Vec2(k + width, 0), Vec2(k, -uniform(random, 0.1, 0.9)), Vec2(k - width, 0)})
          polygon.emplace_back(p.x(), p.y(), 0);
      const double wanted = vectorArea(polygon).norm();
      double sum = 0;
      for (const auto& [a, b, c] : triangulate(polygon)) {
        const auto at = [&](int k) { return polygon[static_cast<std::size_t>(k)]; };
        sum += vectorArea(std::vector<Vec3>{at(a), at(b), at(c)}).norm();
      }
      COMPARE_NEAR(sum, wanted, 1e-11);
    }
  }
  /// Sides that go on beyond their corner and come back, but for rounding: polygons that touch or cross themselves by that
  /// are covered once all the same.
  void spikesMakeNoFolds() {
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
      const Vec3 axis = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)).normalized();
      const std::vector<Vec3> star = starPolygon(random, i % 10 == 0 ? 300 : uniformInt(random, 3, 12), axis);
      if (vectorArea(star).dot(axis) < 1) continue;
      const std::size_t spiked = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(star.size()) - 1));
      const Vec3 &before = star[(spiked + star.size() - 1) % star.size()], &corner = star[spiked];
      std::vector<Vec3> polygon;
      for (std::size_t k = 0; k < star.size(); ++k) {
        if (k == spiked) polygon.push_back(corner + uniform(random, 0.01, 1) * (corner - before));
        polygon.push_back(star[k]);
      }
      const double rounding = std::pow(10, uniform(random, -16, -8));
      for (Vec3& p : polygon) p += rounding * Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      double sum = 0;
      for (const auto& [a, b, c] : triangulate(polygon)) {
        const auto at = [&](int k) { return polygon[static_cast<std::size_t>(k)]; };
        sum += vectorArea(std::vector<Vec3>{at(a), at(b), at(c)}).norm();
      }
      COMPARE_NEAR(sum, vectorArea(star).norm(), 1e-5);
    }
  }
  void cornersInLineMakeNoFlatTriangles() {
    Random random = seededRandom();
    // The diagonal between the second and the last corner would run through the third.
    std::vector<std::vector<Vec2>> outlines{{{-9, 9}, {-7, -7}, {8, 1}, {16, 1}, {16, 0}, {24, 0}, {23, 9}}};
    for (int k = 0; k < 100; ++k) outlines.push_back(columns(random, uniformInt(random, 1, 12)));
    for (const int many : {40, 60, 80, 100, 500}) outlines.push_back(columns(random, many));  // large ones go another way
    for (const std::vector<Vec2>& outline : outlines) {
      const Vec3 x = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)).normalized();
      const Vec3 y = x.unitOrthogonal(), far(100, -20, 3);
      std::vector<Vec3> polygon;
      for (const Vec2& p : outline) polygon.push_back(far + p.x() * x + p.y() * y);
      for (const auto& [a, b, c] : triangulate(polygon)) {
        const auto at = [&](int i) { return polygon[static_cast<std::size_t>(i)]; };
        // Triangles between whole places have at least half an area.
        QVERIFY(vectorArea(std::vector<Vec3>{at(a), at(b), at(c)}).dot(x.cross(y)) > 0.499);
      }
    }
  }
  void needlesAreCutAfterAllElse() {
    // A large polygon whose needles are thinner than rounding counts, behind corners that are cut off before them.
    std::vector<Vec3> polygon{{0, -10, 0}, {200, -10, 0}};
    for (int k = 200; k > 0; --k) {
      polygon.emplace_back(k - 0.5 + 1e-9, 0, 0);
      polygon.emplace_back(k - 0.5, 100, 0);
      polygon.emplace_back(k - 0.5 - 1e-9, 0, 0);
    }
    for (const Vec3& p : {Vec3(-50, 0, 0), Vec3(-60, -5, 0), Vec3(-50, -10, 0)}) polygon.push_back(p);
    const auto triangles = triangulate(polygon);
    QCOMPARE(triangles.size(), polygon.size() - 2);
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
      const auto at = [&](int i) { return polygon[static_cast<std::size_t>(i)]; };
      area += vectorArea(std::vector<Vec3>{at(a), at(b), at(c)}).z();
    }
    COMPARE_NEAR(area, vectorArea(polygon).z(), 1e-9);
  }
  void nonConvexFaceHasItsArea() {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 0.5, 0}, {0, 3, 0}};
    const int face[5] = {0, 1, 2, 3, 4};
    mesh.addFace(face);
    COMPARE_NEAR(measured<double>(measure(mesh), "area"), 12 - 0.5 * 4 * 2.5, 1e-13);
    Mesh arrow;  // a quad whose one diagonal runs outside
    arrow.points = {{0, 0, 0}, {3, 0, 0}, {1, 1, 0}, {0, 3, 0}};
    const int quad[4] = {0, 1, 2, 3};
    arrow.addFace(quad);
    COMPARE_NEAR(measured<double>(measure(arrow), "area"), 3, 1e-13);
  }
  void sharpEdgesSplitNormals() {
    const Tessellation box = tessellate(boxMesh({0, 0, 0}, {1, 1, 1}));
    QCOMPARE(box.points.size(), std::size_t{24});
    QCOMPARE(box.edges.size(), std::size_t{12});
    QCOMPARE(box.triangles.size(), std::size_t{12});
    const Tessellation torus = tessellate(torusMesh(5, 2, 60, 40));
    QCOMPARE(torus.points.size(), std::size_t{2400});
    QVERIFY(torus.edges.empty());
    for (std::size_t i = 0; i < torus.points.size(); ++i) {
      const Vec3& p = torus.points[i];
      const Vec3 center = Vec3(p.x(), p.y(), 0).normalized() * 5;
      QVERIFY(torus.normals[i].dot((p - center).normalized()) > 0.99);
    }
    Mesh creased = torusMesh(5, 2, 60, 40);
    creased.creases.push_back({1, 0, 2.5});
    QCOMPARE(tessellate(creased).edges.size(), std::size_t{1});
  }
  void facesOfUnknownVerticesAreRefused() {
    Mesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
    mesh.faceVertices[5] = 8;
    VERIFY_ERROR(measure(mesh), ErrorCode::InvalidInput);
    mesh.faceVertices[5] = -1;
    VERIFY_ERROR(tessellate(mesh), ErrorCode::InvalidInput);
  }
  void nearPointsMergeAcrossCells() {
    Random random = seededRandom();
    std::vector<Vec3> points;
    for (int i = 0; i < 500; ++i) {
      const Vec3 p(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -1e7, 1e7));
      points.push_back(p);
      points.push_back(p + Vec3(uniform(random, -5e-8, 5e-8), uniform(random, -5e-8, 5e-8), 0));
    }
    const std::vector<int> first = mergeClosePoints(points, 1e-7);
    for (std::size_t i = 0; i < points.size(); ++i) QCOMPARE(first[i], static_cast<int>(i / 2 * 2));
    const std::vector<Vec3> wild{{1e300, 0, 0}, {-1e300, 0, 0}, {1e300, 0, 0}};
    QCOMPARE(mergeClosePoints(wild, 1e-7), (std::vector<int>{0, 1, 0}));
  }
  void equalPointsAreOne() {
    const std::vector<Vec3> points{{0, 1, 2}, {-0.0, 1, 2}, {0, 1, std::nextafter(2, 3)},
                                   {1, 0, 2}, {0.0, 1, 2},  {1, -0.0, 2}};
    QCOMPARE(mergeEqualPoints(points), (std::vector<int>{0, 0, 2, 3, 0, 3}));
  }
  void cancelledWorkStops() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(measure(boxMesh({0, 0, 0}, {1, 1, 1}), Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(MeshTest)
#include "mesh_test.moc"
