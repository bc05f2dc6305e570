#include "geometry/planar/planar.h"
#include "minkowski/kernel/morph/blossom_path.h"
#include "minkowski/kernel/morph/morph.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

/// Interpolated by hand: u tells the way in whole numbers, and the part of it that is left.
Arguments interpolated(const std::vector<Arguments>& points, double u) {
  const double along = u * static_cast<double>(points.size() - 1), whole = std::floor(along);
  const auto from = static_cast<std::size_t>(whole), to = std::min(from + 1, points.size() - 1);
  Arguments t;
  for (std::size_t i = 0; i < points[from].size(); ++i)
    t.push_back(points[from][i] * (1 - (along - whole)) + points[to][i] * (along - whole));
  return t;
}

}  // namespace

/// Paths through the arguments of a blossom.
class MinkowskiPathTest : public QObject {
  Q_OBJECT

 private slots:
  void itIsStraightFromPointToPoint() {
    auto random = seededRandom();
    for (int round = 0; round < 200; ++round) {
      std::vector<Arguments> points(static_cast<std::size_t>(uniformInt(random, 1, 6)));
      const auto count = static_cast<std::size_t>(uniformInt(random, 1, 5));
      for (Arguments& point : points)
        while (point.size() < count) point.push_back(uniform(random, 0, 1));
      checkPath(points, count + 1);
      for (std::size_t k = 0; k < points.size() && points.size() > 1; ++k) {
        // Where u is told by a quotient that rounding has not moved to the way before.
        const double u = static_cast<double>(k) / static_cast<double>(points.size() - 1);
        if (u * static_cast<double>(points.size() - 1) == static_cast<double>(k))
          QCOMPARE(pointOfPath(points, u), points[k]);
      }
      const double u = uniform(random, 0, 1);
      const Arguments at = pointOfPath(points, u), wanted = interpolated(points, u);
      for (std::size_t i = 0; i < count; ++i) {
        COMPARE_NEAR(at[i], wanted[i], 1e-14);
        QVERIFY(at[i] >= 0 && at[i] <= 1);
      }
    }
  }

  /// Equal numbers stay equal to the last bit, so that the sums of the ordinary morph are enough.
  void theDiagonalIsTheOrdinaryMorph() {
    auto random = seededRandom();
    std::vector<Arguments> points;
    for (const double t : {0.0, 0.3, 0.1, 1.0}) points.push_back(diagonal(3, t));
    for (int round = 0; round < 100; ++round) {
      const Arguments at = pointOfPath(points, uniform(random, 0, 1));
      QCOMPARE(at, diagonal(3, at.front()));
    }
    std::vector<Region> shapes;
    for (int k = 0; k < 4; ++k) shapes.push_back(polygonRegion(spikyPoints(random, Vec2(20 * k, 0), 8, 5)));
    const double u = 0.41;
    const std::vector<Arguments> straight{diagonal(3, 0), diagonal(3, 1)};
    const std::vector<Arguments> onPath{pointOfPath(straight, u)}, onDiagonal{diagonal(3, u)};
    const MorphResult here = morph(shapes, onPath), there = morph(shapes, onDiagonal);
    QCOMPARE(here.sums, there.sums);
    COMPARE_NEAR(area(here.regions.front()), area(there.regions.front()), 1e-12 * area(there.regions.front()));
  }

  /// A blossom does not ask for the order of its arguments: paths that are mirrored in the diagonal give the same shapes.
  void mirroredPathsGiveTheSameShapes() {
    auto random = seededRandom();
    std::vector<Region> shapes;
    for (int k = 0; k < 3; ++k) shapes.push_back(polygonRegion(spikyPoints(random, Vec2(20 * k, 0), 8, 5)));
    const std::vector<Arguments> path{{0, 0}, {0.2, 0.9}, {1, 1}}, mirrored{{0, 0}, {0.9, 0.2}, {1, 1}};
    std::vector<Arguments> one, other;
    for (const double u : {0.1, 0.35, 0.5, 0.8}) {
      one.push_back(pointOfPath(path, u));
      other.push_back(pointOfPath(mirrored, u));
    }
    const MorphResult a = morph(shapes, one), b = morph(shapes, other);
    for (std::size_t k = 0; k < one.size(); ++k)
      COMPARE_NEAR(area(a.regions[k]), area(b.regions[k]), 1e-7 * area(a.regions[k]));
  }

  void rubbishIsRefused() {
    VERIFY_ERROR(checkPath(std::vector<Arguments>{{0, 0}, {1}}, 3), ErrorCode::InvalidParameter);
    VERIFY_ERROR(checkPath(std::vector<Arguments>{{0, 0}, {1, 1.1}}, 3), ErrorCode::InvalidParameter);
    VERIFY_ERROR(checkPath(std::vector<Arguments>{{0, std::nan("")}}, 3), ErrorCode::InvalidParameter);
    checkPath(std::vector<Arguments>{}, 3);  // none is none
  }
};

BLOSSOM_TEST(MinkowskiPathTest)
#include "minkowski_path_test.moc"
