#include <QtTest>
#include <algorithm>
#include <set>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/planar/area_triangulation.h"
#include "kernel/convex/hull.h"
#include "kernel/plane_triangles.h"
#include "support/support.h"
#include "support/test_main.h"

using namespace blossom;
using namespace blossom::morphology;
using namespace blossom::test;

namespace {

/// On a circle exactly: any of its triangulations is a Delaunay triangulation.
const std::vector<Vec2> twelve{{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                               {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};

using Corners = std::vector<std::vector<std::array<double, 3>>>;

Corners cornersOf(const Mesh& mesh) {
  Corners faces;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    faces.emplace_back();
    for (const Vec3& p : facePoints(mesh, f)) faces.back().push_back({p.x(), p.y(), p.z()});
  }
  return faces;
}

}  // namespace

/// Where several results are right, the same one is made whatever the order of what is given: CGAL's own choice is made by
/// addresses of memory, so by what ran before in the same process.
class MorphologyOrderTest : public QObject {
  Q_OBJECT
 private slots:
  void hullsDoNotTellTheOrderOfTheirPoints() {
    std::mt19937_64 random = seededRandom();
    std::vector<Vec3> points;
    for (const Vec2& p : twelve)
      for (const double z : {-2.0, 0.0, 3.0}) points.emplace_back(p.x(), p.y(), z);  // the middle ones lie within edges
    points.emplace_back(1, 1, 3);                                                    // within a facet
    points.emplace_back(0, 0, 0);
    const Mesh first = hullTriangles(points);
    QCOMPARE(first.points.size(), 2 * twelve.size());
    QCOMPARE(first.faceCount(), 2 * (twelve.size() - 2) + 2 * twelve.size());
    QVERIFY(meshTopology(first).closed());
    const double area = 5 * 5 / 2.0 * 4 * (std::sin(std::atan2(3, 4)) * 2 + std::sin(std::atan2(4, 3) - std::atan2(3, 4)));
    COMPARE_NEAR(signedVolume(first), 5 * area, 1e-11);
    for (int k = 0; k < 40; ++k) {
      std::shuffle(points.begin(), points.end(), random);
      const Mesh again = hullTriangles(points);
      QCOMPARE(cornersOf(again), cornersOf(first));
      QCOMPARE(again.faceVertices, first.faceVertices);
    }
  }

  void shrunkHullsDoNotEither() {
    std::mt19937_64 random = seededRandom();
    std::vector<Vec3> points, mover{{0.5, 0.25, 0}, {-0.5, 0, 0.25}, {0, -0.5, -0.25}};
    for (const Vec2& p : twelve)
      for (const double z : {-2.0, 3.0}) points.emplace_back(p.x(), p.y(), z);
    const Mesh hull = hullTriangles(points), first = shrunk(hull, mover);
    QVERIFY(first.faceCount() > 20 && meshTopology(first).closed());
    for (int k = 0; k < 10; ++k) {
      std::shuffle(mover.begin(), mover.end(), random);
      QCOMPARE(cornersOf(shrunk(hull, mover)), cornersOf(first));
    }
  }

  void trianglesOfAPlaneDoNotTellWhereItsLoopsBegin() {
    std::vector<Vec3> points;
    for (const Vec2& p : twelve) points.emplace_back(p.x(), p.y(), 0);
    std::vector<int> loop(points.size());
    std::iota(loop.begin(), loop.end(), 0);
    const auto first = trianglesBetween(points, {loop}, Vec3::UnitZ());
    QCOMPARE(first.size(), points.size() - 2);
    for (std::size_t k = 1; k < loop.size(); ++k) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      QCOMPARE(trianglesBetween(points, {loop}, Vec3::UnitZ()), first);
    }
  }

  void trianglesOfAnAreaDoNotEither() {
    const auto triangles = [](const std::vector<Vec2>& polygon) {
      const AreaTriangles made = triangulateArea({polygon}, Progress::none());
      std::set<std::set<std::pair<double, double>>> all;
      for (const auto& t : made.triangles) {
        std::set<std::pair<double, double>> corners;
        for (const int c : t) {
          const Vec2& p = made.points[static_cast<std::size_t>(c)];
          corners.emplace(p.x(), p.y());
        }
        all.insert(corners);
      }
      return all;
    };
    std::vector<Vec2> polygon = twelve;
    const auto first = triangles(polygon);
    QCOMPARE(first.size(), twelve.size() - 2);
    for (std::size_t k = 1; k < polygon.size(); ++k) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      QCOMPARE(triangles(polygon), first);
    }
  }
};

BLOSSOM_TEST(MorphologyOrderTest)
#include "morphology_order_test.moc"
