// The solid between two regions: its sections are their morphs, decided by the planar kernel, and its surface closes.
#include <BRepCheck_Analyzer.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/measure/measure.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "minkowski/kernel/solid/loft.h"
#include "minkowski/kernel/solid/loft_brep.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

constexpr double height = 10;

Region polygonAround(int sides, double radius) {
  std::vector<Vec2> points;
  for (int k = 0; k < sides; ++k)
    points.push_back(radius * Vec2(std::cos(2 * pi * k / sides), std::sin(2 * pi * k / sides)));
  return polygonRegion(points);
}

Region evenStar(int spikes, double outer, double inner) {
  std::vector<Vec2> points;
  for (int k = 0; k < 2 * spikes; ++k)
    points.push_back((k % 2 == 0 ? outer : inner) * Vec2(std::cos(pi * k / spikes), std::sin(pi * k / spikes)));
  return polygonRegion(points);
}

Region withLoopsOf(const Region& a, const Region& b) {
  Region both = a;
  both.loops.insert(both.loops.end(), b.loops.begin(), b.loops.end());
  return both;
}

/// A square frame about the origin.
Region squareFrame(double outer, double inner) {
  return withLoopsOf(rectangleRegion({-outer, -outer}, {outer, outer}),
                     polygonRegion({{-inner, -inner}, {-inner, inner}, {inner, inner}, {inner, -inner}}));
}

Polygons polygonsOf(const Region& region) { return flattened(region, {}, "shape"); }

double morphArea(const Polygons& a, const Polygons& b, double t) {
  return planar::area(sum(scaled(a, 1 - t), scaled(b, t)));
}

/// Area of the section of closed triangles, by Green's formula over the pieces that they leave in the plane.
double sectionArea(const Mesh& triangles, double z) {
  double sum = 0;
  std::optional<Vec2> near;  // so that places far away cost no digits
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const std::vector<Vec3> corners = facePoints(triangles, f);
    Vec2 up = Vec2::Zero(), down = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &from = corners[k], &to = corners[(k + 1) % 3];
      if ((from.z() > z) == (to.z() > z)) continue;
      const Vec2 at = (from + (z - from.z()) / (to.z() - from.z()) * (to - from)).head<2>();
      if (!near) near = at;
      (to.z() > z ? up : down) = at - *near;
    }
    sum += cross(down, up) / 2;
  }
  return sum;
}

int genus(const Mesh& mesh) {
  const MeshTopology topology = meshTopology(mesh);
  return topology.components.size() == 1 ? topology.components.front().genus() : -1;
}

/// Closed, without crossings, and with the sections of the morph.
void checkLoft(const Region& lower, const Region& upper, LoftResult* kept = nullptr) {
  const Polygons a = polygonsOf(lower), b = polygonsOf(upper);
  const LoftResult result = loft(lower, upper, {.height = height});
  QVERIFY(meshTopology(result.mesh).closed());
  QVERIFY(!firstCrossing(result.mesh, Progress::none()));
  QVERIFY(BRepCheck_Analyzer(loftBrep(result.mesh).shape()).IsValid());
  const Mesh triangles = triangulated(result.mesh).first;
  const double size = std::max(boxOf(a).sizes().maxCoeff(), boxOf(b).sizes().maxCoeff());
  for (const double t : {0.01, 0.127, 0.25, 0.3301, 0.449, 0.5003, 0.617, 0.75, 0.883, 0.99})
    COMPARE_NEAR(sectionArea(triangles, t * height), morphArea(a, b, t), 1e-9 * size * size);
  if (kept) *kept = result;
}

double volumeOf(const LoftResult& result) { return signedVolume(triangulated(result.mesh).first); }

double measured(const Brep& solid, const std::string& name) {
  for (const Measure& each : measure(Shape(solid)).values)
    if (each.name == name) {
      if (const auto* number = std::get_if<double>(&each.value)) return *number;
      if (const auto* count = std::get_if<std::int64_t>(&each.value)) return static_cast<double>(*count);
      if (const auto* flag = std::get_if<bool>(&each.value)) return *flag ? 1 : 0;
    }
  return -1;
}

}  // namespace

class MinkowskiSolidTest : public QObject {
  Q_OBJECT
 private slots:
  void equalSquaresMakeABox() {
    const Region square = rectangleRegion({1, 2}, {3, 5});
    LoftResult box;
    checkLoft(square, square, &box);
    QCOMPARE(box.mesh.faceCount(), std::size_t(6));
    QCOMPARE(box.mesh.points.size(), std::size_t(8));
    COMPARE_NEAR(volumeOf(box), 60, 1e-9);
    QCOMPARE(measured(loftBrep(box.mesh), "faces"), 6.0);
    COMPARE_NEAR(measured(loftBrep(box.mesh), "volume"), 60, 1e-9);
  }

  /// h (|A| + V(A, B) + |B|) / 3, where 2 V is what the sum has more than both areas.
  void convexPairsHaveTheVolumeOfTheMixedArea() {
    for (const auto& [a, b] :
         {std::pair(polygonAround(3, 10), rectangleRegion({-5, -5}, {5, 5})),
          std::pair(polygonAround(6, 10), polygonAround(5, 7)), std::pair(circleRegion(5), circleRegion(10, {3, 4})),
          std::pair(rectangleRegion({0, 0}, {2, 2}), rectangleRegion({50, 10}, {51, 14}))}) {
      LoftResult result;
      checkLoft(a, b, &result);
      const Polygons lower = polygonsOf(a), upper = polygonsOf(b);
      const double ofA = planar::area(lower), ofB = planar::area(upper);
      const double mixed = (planar::area(sum(lower, upper)) - ofA - ofB) / 2;
      const double volume = height * (ofA + mixed + ofB) / 3;
      COMPARE_NEAR(volumeOf(result), volume, 1e-9 * volume);
      QCOMPARE(genus(result.mesh), 0);
    }
  }

  void spikyPairs() {
    checkLoft(evenStar(5, 20, 8), rectangleRegion({-5, -5}, {5, 5}));
    checkLoft(evenStar(5, 20, 8), evenStar(7, 15, 5));
    checkLoft(evenStar(5, 20, 8), evenStar(5, 20, 8));
    checkLoft(evenStar(5, 20, 8), circleRegion(15));
    checkLoft(polygonRegion({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}),
              polygonRegion({{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}));
  }

  /// The hole of a frame with half-width 6 closes over a square of 4 where 6 (1 - t) = 4 t: a pyramid of height 0.6 h.
  void aHoleClosesWhereTheOtherFillsIt() {
    LoftResult result;
    checkLoft(squareFrame(10, 6), rectangleRegion({-4, -4}, {4, 4}), &result);
    QCOMPARE(genus(result.mesh), 0);
    const double whole = height * (20 * 20 + 20 * 8 + 8 * 8) / 3, pyramid = 12 * 12 * 0.6 * height / 3;
    COMPARE_NEAR(volumeOf(result), whole - pyramid, 1e-8);
    const Brep solid = loftBrep(result.mesh);
    QCOMPARE(measured(solid, "faces"), 10.0);  // bottom and top, four sides, four of the pyramid
    COMPARE_NEAR(measured(solid, "volume"), whole - pyramid, 1e-7);
    // A hole that closes along a ridge, and the same upside down.
    checkLoft(squareFrame(10, 6), rectangleRegion({-4, -1}, {4, 1}));
    checkLoft(rectangleRegion({-4, -1}, {4, 1}), squareFrame(10, 6));
  }
  void holesAtBothEndsCloseApart() {
    LoftResult result;
    checkLoft(squareFrame(10, 6), squareFrame(10, 6), &result);
    QCOMPARE(genus(result.mesh), 0);
    checkLoft(withLoopsOf(squareFrame(10, 6), rectangleRegion({20, -1}, {22, 1})), squareFrame(8, 3));
  }
  /// The hole is as large as the other shape.
  void aTightHoleClosesHalfway() {
    LoftResult result;
    checkLoft(withLoopsOf(rectangleRegion({-2, -2}, {3, 3}), polygonRegion({{0, 0}, {0, 1}, {1, 1}, {1, 0}})),
              rectangleRegion({0, 0}, {1, 1}), &result);
    COMPARE_NEAR(volumeOf(result), height * (25 + 5 + 1) / 3 - 0.5 * height / 3, 1e-9);
  }
  void partsJoinOnTheirWay() {
    const Region two = withLoopsOf(rectangleRegion({-10, -2}, {-6, 2}), rectangleRegion({6, -2}, {10, 2}));
    const Region across = withLoopsOf(rectangleRegion({-2, -10}, {2, -6}), rectangleRegion({-2, 6}, {2, 10}));
    LoftResult joined, ring;
    checkLoft(two, rectangleRegion({-3, -3}, {3, 3}), &joined);
    QCOMPARE(genus(joined.mesh), 0);
    checkLoft(two, across, &ring);
    QCOMPARE(genus(ring.mesh), 1);  // four columns, each from one of the parts below to one of those above
  }

  /// Squares that touch in corners, holes as large as what is put into them, parallel edges everywhere.
  void latticeSquares() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 25; ++round) {
      const int width = 2 + round % 4;
      checkLoft(cellRegion(randomCells(random, width, width, 0.6)), cellRegion(randomCells(random, 1 + round % 3, 3, 0.6)));
      if (QTest::currentTestFailed()) return;
    }
  }
  void randomParts() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 12; ++round) {
      checkLoft(randomRegion(random, 5), randomRegion(random, 3));
      if (QTest::currentTestFailed()) return;
    }
  }
  void manyCorners() {
    std::mt19937_64 random = seededRandom();
    checkLoft(polygonRegion(spikyPoints(random, {0, 0}, 10, 24)), polygonRegion(spikyPoints(random, {0, 0}, 10, 24)));
  }
  /// Far from the origin and of sizes far apart.
  void placesAndSizes() {
    checkLoft(rectangleRegion({1e6, 1e6}, {1e6 + 4, 1e6 + 4}), evenStar(3, 5, 2));
    checkLoft(evenStar(4, 1000, 300), evenStar(3, 0.5, 0.2));
  }

  void theEndsAreTheShapes() {
    const LoftResult result = loft(squareFrame(10, 6), evenStar(5, 20, 8), {.height = 3});
    const Mesh triangles = triangulated(result.mesh).first;
    double bottom = 0, top = 0;
    for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
      const auto corners = facePoints(triangles, f);
      const auto all = [&](double z) {
        return std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) { return p.z() == z; });
      };
      if (all(0)) bottom += vectorArea(corners).z();
      if (all(3)) top += vectorArea(corners).z();
    }
    COMPARE_NEAR(bottom, -(400 - 144), 1e-9);
    COMPARE_NEAR(top, area(evenStar(5, 20, 8)), 1e-9);
  }

  void badInputIsRefused() {
    const Region square = rectangleRegion({0, 0}, {1, 1});
    VERIFY_ERROR(loft(square, square, {.height = 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(loft(square, square, {.height = -1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(loft(square, square, {.height = NAN}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(loft(square, Region{}, {}), ErrorCode::InvalidInput);
    const Region crossed = polygonRegion({{0, 0}, {2, 2}, {2, 0}, {0, 3}});
    try {
      (void)loft(square, crossed, {});
      QFAIL("it crosses itself");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::InvalidInput);
      QVERIFY2(error.message().find("hape 2") != std::string::npos, error.message().c_str());
    }
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(loft(square, square, {}, Progress(token)), ErrorCode::Cancelled);
  }
  void longOnesAreLeftToTheCaller() {
    std::mt19937_64 random = seededRandom();
    const Region a = polygonRegion(spikyPoints(random, {0, 0}, 10, 40));
    QVERIFY_THROWS_EXCEPTION(TooMuchWork, (void)loft(a, a, {.maximumWork = 1000}));
  }
};

BLOSSOM_TEST(MinkowskiSolidTest)
#include "minkowski_solid_test.moc"
