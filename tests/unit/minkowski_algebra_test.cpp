#include <Eigen/LU>

#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "minkowski/kernel/morph/repetition.h"
#include "support/boundary_distance.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

Polygons setOf(const Region& region) { return flattened(region, {}, "shape"); }
/// Up to three parts, some with a hole.
Polygons anySet(Random& random, double reach) { return setOf(randomRegion(random, reach)); }

Polygons less(const Polygons& a, const Polygons& b) {
  Effort unlimited;
  return difference(a, b, Progress::none(), unlimited);
}

template <class Map>
Polygons image(Polygons polygons, bool mirrors, Map map) {
  const auto turn = [&](Loop& loop) {
    for (Vec2& p : loop) p = map(p);
    if (mirrors) std::reverse(loop.begin(), loop.end());
  };
  for (Polygon& polygon : polygons) {
    turn(polygon.outer);
    for (Loop& hole : polygon.holes) turn(hole);
  }
  return polygons;
}

/// Distance of the boundaries and difference of the areas, as shares of the size and its square.
double apart(const Polygons& a, const Polygons& b) {
  double size = 1e-300;
  for (const auto& [from, to] : sidesOf(a)) size = std::max(size, from.norm());
  const double areas = std::abs(planar::area(a) - planar::area(b)) / (size * size);
  return std::max(areas, distanceBetween(sidesOf(a), sidesOf(b)) / size);
}

Loop hullOf(const Polygons& polygons) {
  std::vector<Vec2> points;
  for (const auto& [from, to] : sidesOf(polygons)) points.push_back(from);
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  Loop hull;
  for (int chain = 0; chain < 2; ++chain) {  // the lower one, then back along the upper one
    const std::size_t begin = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= begin + 2 && cross(Vec2(hull.back() - hull[hull.size() - 2]), Vec2(p - hull.back())) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

constexpr double rounding = 1e-10;

}  // namespace

/// What holds of Minkowski sums and differences of any sets (Lee, Lee, Kim & Kim 2002, section 3).
class MinkowskiAlgebraTest : public QObject {
  Q_OBJECT

 private slots:
  void sumsCommuteAndAssociate() {
    Random random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const Polygons a = anySet(random, 10), b = anySet(random, uniform(random, 1, 8)),
                     c = anySet(random, uniform(random, 1, 4));
      QVERIFY(apart(sum(a, b), sum(b, a)) < rounding);
      const double off = apart(sum(sum(a, b), c), sum(a, sum(b, c)));
      QVERIFY2(off < rounding, qPrintable(QString::number(off)));
    }
  }

  void linearMapsAndShiftsPassThrough() {
    Random random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const Polygons a = anySet(random, 10), b = anySet(random, uniform(random, 1, 8));
      Eigen::Matrix2d m;
      do m << uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2);
      while (std::abs(m.determinant()) < 0.3);
      const bool mirrors = m.determinant() < 0;
      const auto linear = [&](const Vec2& p) { return Vec2(m * p); };
      const double off = apart(image(sum(a, b), mirrors, linear), sum(image(a, mirrors, linear), image(b, mirrors, linear)));
      QVERIFY2(off < rounding, qPrintable(QString::number(off)));
      const Vec2 p(uniform(random, -50, 50), uniform(random, -50, 50)),
          q(uniform(random, -50, 50), uniform(random, -50, 50));
      QVERIFY(apart(translated(sum(a, b), p + q), sum(translated(a, p), translated(b, q))) < rounding);
    }
  }

  /// {0} changes nothing: within its size, for the smallest part that there is.
  void aPointIsTheIdentity() {
    Random random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const Polygons a = anySet(random, 10), point{{{{0, 0}, {1e-13, 0}, {0, 1e-13}}, {}}};
      QVERIFY(apart(sum(a, point), a) < 1e-9);
      QVERIFY(apart(less(a, point), a) < 1e-9);
    }
  }

  /// A + A = 2 A for convex sets; otherwise it is larger. (1/k) [k]A lies between A and its hull, at most sqrt(2) R / k from
  /// it.
  void copiesFillTheHull() {
    Random random = seededRandom();
    for (int k = 0; k < 30; ++k) {
      const Polygons a = setOf(polygonRegion(spikyPoints(random, {0, 0}, 10, uniformInt(random, 5, 12))));
      const Polygons hull{{hullOf(a), {}}};
      QVERIFY(apart(sum(hull, hull), scaled(hull, 2)) < rounding);
      double before = planar::area(a);
      for (int copies = 2; copies <= 6; ++copies) {
        Adder adder;
        const SoundRegion all = repeated({planar::toRegion(a), 0}, static_cast<std::size_t>(copies), adder);
        const Polygons shrunk = scaled(toPolygons(all), 1.0 / copies);
        const double covered = planar::area(shrunk);
        QVERIFY(covered <= planar::area(hull) * (1 + rounding));
        if (copies == 2 || copies == 4) {  // twice as many copies hold at least as much
          QVERIFY(covered >= before * (1 - rounding));
          before = covered;
        }
        double farthest = 0;
        for (const auto& [from, to] : sidesOf(hull))
          farthest = std::max(farthest, distanceFrom(sidesOf(shrunk), (from + to) / 2));
        QVERIFY2(farthest <= std::sqrt(2) * 10 / copies, qPrintable(QString::number(farthest)));
      }
    }
  }

  /// A - (B + C) = (A - B) - C; what was taken off and put on again stays when that is done once more, both ways round.
  void differencesAreAdjointToSums() {
    Random random = seededRandom();
    int left = 0;
    for (int k = 0; k < 60; ++k) {
      const Polygons a = anySet(random, 10),
                     b = setOf(polygonRegion(spikyPoints(random, {0, 0}, uniform(random, 0.3, 2), 7))),
                     c = setOf(polygonRegion(spikyPoints(random, {0, 0}, uniform(random, 0.3, 1), 5)));
      const Polygons once = less(a, sum(b, c)), twice = less(less(a, b), c);
      if (!once.empty()) ++left;
      QVERIFY2(apart(once, twice) < 1e-9, qPrintable(QString::number(apart(once, twice))));
      const Polygons opened = sum(less(a, b), b), closed = less(sum(a, b), b);
      QVERIFY(planar::area(opened) <= planar::area(a) * (1 + rounding));
      QVERIFY(planar::area(closed) >= planar::area(a) * (1 - rounding));
      if (!opened.empty()) QVERIFY(std::abs(planar::area(sum(less(opened, b), b)) - planar::area(opened)) < 1e-6);
      QVERIFY(std::abs(planar::area(less(sum(closed, b), b)) - planar::area(closed)) < 1e-6);
    }
    QVERIFY(left > 20);
  }
};

BLOSSOM_TEST(MinkowskiAlgebraTest)
#include "minkowski_algebra_test.moc"
