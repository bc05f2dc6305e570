// Triangulated areas against a membership test of its own: the number of sides that a ray to the right crosses.
#include "geometry/planar/area_triangulation.h"

#include <numbers>

#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Polygon = std::vector<Vec2>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool isInside(const std::vector<Polygon>& polygons, const Vec2& p) {
  bool inside = false;
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if ((turn(a, b, p) > 0) == (b.y() > a.y())) inside = !inside;
    }
  return inside;
}

int trianglesAt(const AreaTriangles& t, const Vec2& p) {
  int count = 0;
  for (const auto& [a, b, c] : t.triangles) {
    const auto at = [&](int i) -> const Vec2& { return t.points[static_cast<std::size_t>(i)]; };
    count += turn(at(a), at(b), p) > 0 && turn(at(b), at(c), p) > 0 && turn(at(c), at(a), p) > 0;
  }
  return count;
}

double areaOf(const AreaTriangles& t) {
  double twice = 0;
  for (const auto& [a, b, c] : t.triangles)
    twice += turn(t.points[static_cast<std::size_t>(a)], t.points[static_cast<std::size_t>(b)],
                  t.points[static_cast<std::size_t>(c)]);
  return twice / 2;
}

AreaTriangles triangulated(const std::vector<Polygon>& polygons) { return triangulateArea(polygons, Progress::none()); }

Polygon regular(std::size_t corners, double radius) {
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

double areaOfRegular(double corners, double radius) {
  return corners / 2 * radius * radius * std::sin(2 * std::numbers::pi / corners);
}

}  // namespace

class AreaTriangulationTest : public QObject {
  Q_OBJECT
 private slots:
  void randomPolygonsAreFilledEvenOdd() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> place(-10, 10);
    std::uniform_int_distribution<std::size_t> corners(3, 9), count(1, 4);
    const auto anywhere = [&] { return Vec2(place(random), place(random)); };
    for (int round = 0; round < 200; ++round) {
      std::vector<Polygon> polygons(count(random));
      for (Polygon& polygon : polygons) {
        polygon.resize(corners(random));
        std::generate(polygon.begin(), polygon.end(), anywhere);
      }
      if (round % 3 == 0) polygons.push_back(polygons.front());  // covers it a second time
      const AreaTriangles triangles = triangulated(polygons);
      for (int k = 0; k < 100; ++k) {
        const Vec2 p = anywhere();
        QCOMPARE(trianglesAt(triangles, p), isInside(polygons, p) ? 1 : 0);
      }
    }
  }
  void aRingHasAHole() {
    for (const std::size_t corners : {3U, 4U, 1000U}) {
      const auto n = static_cast<double>(corners);
      const AreaTriangles ring = triangulated({regular(corners, 5), regular(corners, 2)});
      COMPARE_NEAR(areaOf(ring), areaOfRegular(n, 5) - areaOfRegular(n, 2), 1e-12 * 100);
      QCOMPARE(ring.triangles.size(), 2 * corners);  // Euler: corners of both, one hole
      for (const auto& [a, b, c] : ring.triangles)
        QVERIFY(turn(ring.points[static_cast<std::size_t>(a)], ring.points[static_cast<std::size_t>(b)],
                     ring.points[static_cast<std::size_t>(c)]) > 0);
    }
  }
  void sidesThatTouchBoundNothingTwice() {
    const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, beside{{1, 0.25}, {2, 0.25}, {2, 0.75}, {1, 0.75}};
    QCOMPARE(areaOf(triangulated({square, beside})), 1.5);
    QCOMPARE(areaOf(triangulated({square, square})), 0.0);
    QCOMPARE(areaOf(triangulated({square, square, square})), 1.0);
  }
  void nothingIsFilledByNothing() {
    QVERIFY(triangulated({}).triangles.empty());
    QVERIFY(triangulated({{}, {{1, 1}}, {{0, 0}, {3, 1}}}).triangles.empty());
    QVERIFY(triangulated({{{0, 0}, {1, 1}, {2, 2}, {1, 1}}}).triangles.empty());
  }
  void cancelledWorkStops() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(triangulateArea({regular(9, 1)}, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(AreaTriangulationTest)
#include "area_triangulation_test.moc"
