#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "minkowski/kernel/compare/distance_field.h"
#include "minkowski/kernel/compare/matched_outlines.h"
#include "minkowski/kernel/compare/morph_comparison.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

/// Corners on a circle, in order: a convex polygon.
Region randomConvex(Random& random, const Vec2& about, double radius) {
  std::vector<double> angles;
  for (int k = uniformInt(random, 3, 12); k > 0; --k) angles.push_back(uniform(random, 0, 2 * pi));
  angles.insert(angles.end(), {0.1, 2.2, 4.3});  // the middle is inside
  std::sort(angles.begin(), angles.end());
  std::vector<Vec2> points;
  for (const double angle : angles) points.push_back(about + radius * Vec2(std::cos(angle), 0.6 * std::sin(angle)));
  return polygonRegion(points);
}

Loop squareLoop(double half) { return {{half, half}, {-half, half}, {-half, -half}, {half, -half}}; }

/// Distance from a square about the origin, negative inside.
double squareField(const Vec2& p, double half) {
  const Vec2 beyond = p.cwiseAbs() - Vec2(half, half);
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

double sideDistance(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  return (from + std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along - p).norm();
}

double loopsArea(const std::vector<Loop>& loops) {
  double sum = 0;
  for (const Loop& loop : loops) sum += planar::signedArea(loop);
  return sum;
}

void widen(double& least, double& most, double value) {
  least = std::min(least, value);
  most = std::max(most, value);
}

/// Pairs of edges without a common end that cross, by the signs of the four triangles.
std::size_t crossingsOneByOne(const Loop& loop) {
  const std::size_t n = loop.size();
  const auto side = [](const Vec2& a, const Vec2& b, const Vec2& p) { return blossom::cross(b - a, p - a) > 0; };
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Vec2 &a = loop[i], &b = loop[i + 1], &c = loop[j], &d = loop[(j + 1) % n];
      if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) ++count;
    }
  return count;
}

const std::vector<double> fiveTimes{0, 0.2, 0.5, 0.9, 1};

}  // namespace

/// The three ways of morphing that `morph-compare` sets beside each other.
class MinkowskiCompareTest : public QObject {
  Q_OBJECT

 private slots:
  /// Radii blend in every way, wherever the circles were drawn.
  void circlesStayCircles() {
    Random random = seededRandom();
    for (int round = 0; round < 5; ++round) {
      const double r0 = uniform(random, 2, 20), r1 = uniform(random, 2, 20);
      const MorphComparison result =
          compareMorphs(circleRegion(r0, {30, uniform(random, -9, 9)}), circleRegion(r1, {-50, 4}), {.times = fiveTimes});
      QVERIFY(result.whyNoVertices.empty());
      for (std::size_t k = 0; k < fiveTimes.size(); ++k) {
        const double radius = (1 - fiveTimes[k]) * r0 + fiveTimes[k] * r1, wanted = pi * radius * radius;
        const double cell = 2 * std::max(r0, r1) / 200;
        COMPARE_NEAR(result.sums.areas[k], wanted, 1e-9 * wanted);
        COMPARE_NEAR(result.vertices.areas[k], wanted, 4 * pi * radius * 0.01);
        COMPARE_NEAR(result.fields.areas[k], wanted, 2 * pi * cell * cell + 4 * pi * radius * 0.01);
        for (const MorphedWay* way : {&result.vertices, &result.fields}) {
          double least = HUGE_VAL, most = 0;
          QCOMPARE(way->outlines[k].size(), std::size_t{1});
          for (const Segment& side : way->outlines[k].front().segments) widen(least, most, startPoint(side).norm());
          COMPARE_NEAR(least, radius, 0.02 + cell * cell / radius);
          COMPARE_NEAR(most, radius, 0.02 + cell * cell / radius);
        }
        QCOMPARE(result.crossings[k], std::size_t{0});
      }
    }
  }

  /// Squares about one centre: sides blend; matched vertices and sums give the square, fields round its corners.
  void squaresAboutOneCentre() {
    const double a = 12, b = 5;
    const Vec2 corner(a, a), small(b, b);
    const MorphComparison result =
        compareMorphs(rectangleRegion(-corner, corner), rectangleRegion(-small, small), {.times = fiveTimes});
    const double step = 2 * a / 200;
    for (std::size_t k = 0; k < fiveTimes.size(); ++k) {
      const double t = fiveTimes[k], half = (1 - t) * a + t * b;
      COMPARE_NEAR(result.sums.areas[k], 4 * half * half, 1e-7);
      COMPARE_NEAR(result.vertices.areas[k], 4 * half * half, 1e-9);
      double least = HUGE_VAL, most = -HUGE_VAL;
      for (const Segment& side : result.fields.outlines[k].front().segments) {
        const Vec2 p = startPoint(side);
        widen(least, most, p.x());
        // The field that is blended, in closed form: it is linear but for its creases.
        QVERIFY(std::abs((1 - t) * squareField(p, a) + t * squareField(p, b)) <= 0.5 * step + 1e-9);
      }
      COMPARE_NEAR(least, -half, 1e-5 * step + 1e-9);
      COMPARE_NEAR(most, half, 1e-5 * step + 1e-9);
      QVERIFY(result.fields.areas[k] <= 4 * half * half + 1e-6);
    }
  }

  /// A(t) = (1-t)^2 |A| + 2 t (1-t) V(A, B) + t^2 |B|, with the mixed area V taken from A + B.
  void sumsOfConvexShapesHaveTheMixedArea() {
    Random random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      const Region a = randomConvex(random, {uniform(random, -9, 9), 3}, uniform(random, 2, 9)),
                   b = randomConvex(random, {4, uniform(random, -9, 9)}, uniform(random, 2, 9));
      const double areaA = area(a), areaB = area(b);
      const double mixed = (area(minkowskiSum(std::vector{a, b}).region) - areaA - areaB) / 2;
      const MorphComparison result = compareMorphs(a, b, {.times = fiveTimes, .resolution = 20});
      QCOMPARE(result.sumCount, std::size_t{3});
      for (std::size_t k = 0; k < fiveTimes.size(); ++k) {
        const double t = fiveTimes[k];
        const double wanted = (1 - t) * (1 - t) * areaA + 2 * t * (1 - t) * mixed + t * t * areaB;
        COMPARE_NEAR(result.sums.areas[k], wanted, 1e-7 * wanted);
        // Brunn and Minkowski: no less than the mean of the roots.
        QVERIFY(std::sqrt(result.sums.areas[k]) >= ((1 - t) * std::sqrt(areaA) + t * std::sqrt(areaB)) * (1 - 1e-7));
      }
    }
  }

  /// Matched vertices begin and end at the shapes, corner by corner, and match lengths.
  void verticesAreMatchedByLength() {
    Random random = seededRandom();
    for (int round = 0; round < 50; ++round) {
      const Loop a = spikyPoints(random, {0, 0}, 10, uniformInt(random, 3, 12)),
                 b = spikyPoints(random, {5, 2}, 6, uniformInt(random, 3, 12));
      const MatchedOutlines matched = matchedOutlines({{a, {}}}, {{b, {}}});
      const Loop &from = matched.first.front(), &to = matched.second.front();
      QCOMPARE(from.size(), to.size());
      for (const Vec2& corner : a) QVERIFY(std::find(from.begin(), from.end(), corner) != from.end());
      for (const Vec2& corner : b) QVERIFY(std::find(to.begin(), to.end(), corner) != to.end());
      COMPARE_NEAR(loopsArea(inBetween(matched, 0)), planar::signedArea(a), 1e-6);
      COMPARE_NEAR(loopsArea(inBetween(matched, 1)), planar::signedArea(b), 1e-6);
      const double lengthA = perimeter(a), lengthB = perimeter(b);
      for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t next = (i + 1) % from.size();
        COMPARE_NEAR((from[next] - from[i]).norm() / lengthA, (to[next] - to[i]).norm() / lengthB, 1e-8);
      }
    }
  }

  /// A shape and its own copy, begun elsewhere and moved: every point finds itself.
  void theStartIsFound() {
    Random random = seededRandom();
    for (int round = 0; round < 50; ++round) {
      const Loop a = spikyPoints(random, {0, 0}, 10, uniformInt(random, 5, 12));
      Loop b = a;
      std::rotate(b.begin(), b.begin() + uniformInt(random, 0, static_cast<int>(a.size()) - 1), b.end());
      const Vec2 by(uniform(random, -50, 50), uniform(random, -50, 50));
      for (Vec2& p : b) p += by;
      const MatchedOutlines matched = matchedOutlines({{a, {}}}, {{b, {}}});
      for (std::size_t i = 0; i < matched.first.front().size(); ++i)
        COMPARE_NEAR((matched.second.front()[i] - matched.first.front()[i] - by).norm(), 0, 1e-6);
    }
  }

  void partsFindTheNearestOne() {
    const auto at = [](const Vec2& by) {
      Loop loop = squareLoop(1);
      for (Vec2& p : loop) p += by;
      return Polygon{loop, {}};
    };
    const MatchedOutlines matched =
        matchedOutlines({at({0, 0}), at({10, 0}), at({0, 10})}, {at({9, 1}), at({0, 9}), at({1, 0})});
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t i = 0; i < matched.first[l].size(); ++i)
        QVERIFY((matched.first[l][i] - matched.second[l][i]).norm() < 2);
  }

  void whatCannotBeMatchedIsTold() {
    Region ring = circleRegion(9), two = circleRegion(3);
    ring.loops.push_back(reversed(circleRegion(4).loops.front()));
    two.loops.push_back(circleRegion(3, {8, 0}).loops.front());
    const Region disc = circleRegion(5);
    const std::vector<std::tuple<Region, Region, const char*>> cases{{ring, disc, "first shape has holes"},
                                                                     {disc, ring, "second shape has holes"},
                                                                     {disc, two, "one outline and the second 2"}};
    for (const auto& [a, b, says] : cases) {
      const MorphComparison result = compareMorphs(a, b, {.times = fiveTimes, .resolution = 60});
      QVERIFY2(result.whyNoVertices.find(says) != std::string::npos, result.whyNoVertices.c_str());
      QVERIFY(result.vertices.outlines.empty() && result.crossings.empty());
      QCOMPARE(result.sums.outlines.size(), fiveTimes.size());
      COMPARE_NEAR(result.fields.areas.front(), area(a), 0.02 * area(a));
      COMPARE_NEAR(result.fields.areas.back(), area(b), 0.02 * area(b));
    }
    QVERIFY(compareMorphs(two, two, {.times = {0.5}, .resolution = 60}).whyNoVertices.empty());
    VERIFY_ERROR(compareMorphs(disc, disc, {.times = {}}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(compareMorphs(disc, disc, {.resolution = 7}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(compareMorphs(disc, disc, {.resolution = 1001}), ErrorCode::LimitExceeded);
    VERIFY_ERROR(compareMorphs(disc, Region(), {}), ErrorCode::InvalidInput);
  }

  void crossingsAreCounted() {
    QCOMPARE(crossingsOf({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}), std::size_t{1});
    Loop pentagram;
    for (int k = 0; k < 5; ++k) pentagram.emplace_back(std::cos(0.3 + 4 * pi * k / 5), std::sin(0.3 + 4 * pi * k / 5));
    QCOMPARE(crossingsOf({pentagram}), std::size_t{5});
    QCOMPARE(crossingsOf({squareLoop(3), squareLoop(1)}), std::size_t{0});
    QCOMPARE(crossingsOf({squareLoop(3), {{2, 1}, {7, 1}, {7, 2}, {2, 2}}}), std::size_t{2});
    Random random = seededRandom();
    for (int round = 0; round < 50; ++round) {
      Loop loop;
      for (int k = uniformInt(random, 4, 30); k > 0; --k) loop.emplace_back(uniform(random, 0, 9), uniform(random, 0, 9));
      QCOMPARE(crossingsOf({loop}), crossingsOneByOne(loop));
    }
  }

  /// Distances of nodes from random regions, one by one; the sign by the winding number of the curves.
  void fieldsAreSignedDistances() {
    Random random = seededRandom();
    for (int round = 0; round < 8; ++round) {
      const Region region = randomRegion(random, 8);
      const Polygons polygons = flattened(region, {}, "shape");
      const FieldGrid grid = fieldGrid(boxOf(polygons), 31);
      const std::vector<double> field = signedDistances(polygons, grid);
      for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column) {
          const Vec2 p = grid.node(column, row);
          double nearest = HUGE_VAL;
          for (const Path& loop : region.loops)
            for (const Segment& side : loop.segments)
              nearest = std::min(nearest, sideDistance(p, startPoint(side), endPoint(side)));
          COMPARE_NEAR(std::abs(field[row * grid.columns + column]), nearest, 1e-9);
          if (nearest < 1e-6) continue;
          int winding = 0;
          for (const Path& loop : region.loops) winding += windingNumber(loop, p);
          QCOMPARE(field[row * grid.columns + column]<0, winding> 0);
        }
    }
  }

  /// Loops of random fields bound the negative nodes: every node is wound around once or not at all, and no two edges cross.
  void outlinesEncloseWhatIsNegative() {
    Random random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      FieldGrid grid{{-2, 3}, 0.5, static_cast<std::size_t>(uniformInt(random, 4, 14)), 9};
      std::vector<double> field(grid.nodes(), 1);
      for (std::size_t row = 1; row + 1 < grid.rows; ++row)
        for (std::size_t column = 1; column + 1 < grid.columns; ++column)
          field[row * grid.columns + column] = uniformInt(random, 0, 6) == 0 ? 0 : uniform(random, -1, 1);
      const std::vector<Loop> loops = negativeOutlines(field, grid);
      QCOMPARE(crossingsOf(loops), std::size_t{0});
      for (std::size_t node = 0; node < field.size(); ++node) {
        int winding = 0;
        for (const Loop& loop : loops)
          winding += windingNumber(polygonPath(loop), grid.node(node % grid.columns, node / grid.columns));
        QCOMPARE(winding, field[node] < 0 ? 1 : 0);
      }
    }
  }
};

BLOSSOM_TEST(MinkowskiCompareTest)
#include "minkowski_compare_test.moc"
