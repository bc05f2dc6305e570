// The place of a swept surface under the mouse, against a search through all cells of a dense grid.
#include <Eigen/Geometry>
#include <limits>
#include <optional>

#include "support/motion_samples.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/grid/motion_grid.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/manipulators/place_under_mouse.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

constexpr std::size_t cells = 300;

LiveGrid gridOf(const Motion& motion, std::size_t count) {
  return {motion, evenParameters(motion.domainU(), count), evenParameters(motion.domainV(), count)};
}

/// Distance along the ray to a triangle.
double meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  Eigen::Matrix3d sides;
  sides << b - a, c - a, -ray.direction;
  const Vec3 solution = sides.inverse() * (ray.origin - a);
  const bool inside = solution[0] >= 0 && solution[1] >= 0 && solution[0] + solution[1] <= 1 && solution[2] > 0;
  return inside ? solution[2] : std::numeric_limits<double>::infinity();
}

struct DenseHit {
  double u = 0, v = 0, distance = std::numeric_limits<double>::infinity();
};

/// Cells whose sphere the ray misses are left out; nothing else is clever here.
DenseHit denseSearch(const LiveGrid& dense, const Ray& ray) {
  DenseHit best;
  const MotionGrid& grid = dense.grid();
  for (std::size_t k = 0; k + 1 < grid.countU; ++k)
    for (std::size_t l = 0; l + 1 < grid.countV; ++l) {
      const Vec3 a = grid.pointAt(k, l), b = grid.pointAt(k + 1, l), c = grid.pointAt(k + 1, l + 1),
                 d = grid.pointAt(k, l + 1);
      const double radius = std::max({(b - a).norm(), (c - a).norm(), (d - a).norm()});
      if (ray.direction.cross(a - ray.origin).norm() > radius) continue;
      const double distance = std::min(meet(ray, a, b, c), meet(ray, a, c, d));
      if (distance < best.distance)
        best = {(dense.us()[k] + dense.us()[k + 1]) / 2, (dense.vs()[l] + dense.vs()[l + 1]) / 2, distance};
    }
  return best;
}

Vec3 normalAt(const Motion& motion, double u, double v) {
  const MotionPoint x = evaluate(motion, u, v);
  return x.du.cross(x.dv).normalized();
}

}  // namespace

class SweepPlaceTest : public QObject {
  Q_OBJECT
 private:
  struct Compared {
    int rays = 0, off = 0;
  };
  /// Rays from outside at places of the surface.
  static Compared compare(const Motion& motion, Random& random, int rays) {
    const LiveGrid coarse = gridOf(motion, 96), dense = gridOf(motion, cells);
    const PlaceFinder finder(coarse);
    double size = 0;
    for (std::size_t k = 0; k < cells; k += 10)
      for (std::size_t l = 0; l < cells; l += 10)
        size = std::max(size, (dense.grid().pointAt(k, l) - dense.grid().pointAt(0, 0)).norm());
    Compared compared;
    for (int i = 0; i < rays; ++i) {
      const Vec3 aim = evaluate(motion, randomIn(random, motion.domainU()), randomIn(random, motion.domainV())).point;
      const Vec3 from = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)).normalized();
      const Ray ray{aim + 3 * size * from, -from};
      const auto found = finder.find(ray);
      const DenseHit wanted = denseSearch(dense, ray);
      if (!found || wanted.distance == std::numeric_limits<double>::infinity()) continue;  // past a silhouette
      if ((found->point - evaluate(motion, found->at.u, found->at.v).point).norm() > 0) ++compared.off;
      // Where the nearer of the two is seen edge on, one grid may be hit and the other missed.
      const bool finderNearer = found->distance < wanted.distance;
      const double facing = std::abs(
          from.dot(finderNearer ? normalAt(motion, found->at.u, found->at.v) : normalAt(motion, wanted.u, wanted.v)));
      if (!(facing > 0.3)) continue;
      const Vec3 off = found->point - ray.origin;
      const double beside = (off - off.dot(ray.direction) * ray.direction).norm();
      ++compared.rays;
      if (beside <= 1e-9 * size && std::abs(found->distance - wanted.distance) <= 0.01 * size) continue;
      ++compared.off;
      qInfo("ray %d: %.3g beside, %.6g instead of %.6g along, size %.3g", i, beside, found->distance, wanted.distance, size);
    }
    return compared;
  }

 private slots:
  void samplesAgreeWithADenseSearch() {
    auto random = seededRandom();
    for (const char* name : {"cylinder.json", "torus.json", "helicoid.json", "twisted-tube.json", "propeller.json"}) {
      const Compared compared = compare(readMotionOf(name), random, 24);
      QVERIFY2(compared.rays >= 6, name);
      QVERIFY2(compared.off == 0, name);
    }
  }

  /// They fold and bend within single cells, where the coarse grid meets another sheet first now and then.
  void randomMotionsAgreeWithADenseSearch() {
    auto random = seededRandom();
    Compared all;
    for (int k = 0; k < 12; ++k) {
      const Compared now = compare(randomMotion(random, static_cast<ClosedU>(k % 3), true), random, 24);
      all.rays += now.rays;
      all.off += now.off;
    }
    QVERIFY(all.rays >= 60);
    QVERIFY2(10 * all.off <= all.rays, qPrintable(QStringLiteral("%1 of %2").arg(all.off).arg(all.rays)));
  }

  /// Rays that meet the grid in corners of its cells, and run within their sides.
  void aRayThroughACornerOfCellsHits() {
    const Motion motion = readMotionOf("cylinder.json");
    const LiveGrid grid = gridOf(motion, 64);
    const PlaceFinder finder(grid);
    for (const double u : grid.us())
      for (const double v : grid.vs()) {
        const Vec3 x = evaluate(motion, u, v).point, out = Vec3(x.x(), x.y(), 0).normalized();
        const auto found = finder.find({x + 50 * out, -out});
        QVERIFY2(found && std::abs(found->distance - 50) < 1e-6, qPrintable(QStringLiteral("%1 %2").arg(u).arg(v)));
      }
  }

  /// The same with rays that miss the corner by what rounding may move them.
  void aRayBesideACornerByRoundingHits() {
    const Motion motion = readMotionOf("cylinder.json");
    const LiveGrid grid = gridOf(motion, 64);
    const PlaceFinder finder(grid);
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double u : grid.us())
      for (int k = 0; k < 40; ++k) {
        const Vec3 x = evaluate(motion, u, grid.vs()[20]).point, out = Vec3(x.x(), x.y(), 0).normalized();
        const Vec3 off = 2e-14 * Vec3(unit(random), unit(random), unit(random));
        const Vec3 turn = 2e-16 * Vec3(unit(random), unit(random), unit(random));
        const auto found = finder.find({x + 50 * out + off, turn - out});
        QVERIFY2(found && std::abs(found->distance - 50) < 1e-6, qPrintable(QStringLiteral("%1 %2").arg(u).arg(k)));
      }
  }

  /// The parameters themselves, on a cylinder of radius 10 about z where they are known by the angle.
  void aPlaceAcrossTheSeamIsFound() {
    const Motion motion = readMotionOf("cylinder.json");
    const LiveGrid grid = gridOf(motion, 128);
    const PlaceFinder finder(grid);
    for (int k = 0; k <= 40; ++k) {
      const double u = 0.9 + 0.005 * k, inside = u > 1 ? u - 1 : u;
      const Vec3 x = evaluate(motion, inside, 0.4).point, out = Vec3(x.x(), x.y(), 0).normalized();
      const auto found = finder.find({x + 50 * out, -out});
      QVERIFY(found);
      const double apart = std::abs(found->at.u - inside);
      QVERIFY2(std::min(apart, 1 - apart) < 1e-12, qPrintable(QString::number(apart)));
      COMPARE_NEAR(found->at.v, 0.4, 1e-12);
      COMPARE_NEAR(found->distance, 50, 1e-9);
      QVERIFY(std::abs(std::abs(found->normal.dot(out)) - 1) < 1e-9);
    }
  }

  void aRayPastTheSurfaceFindsNothing() {
    const Motion motion = readMotionOf("cylinder.json");
    const LiveGrid grid = gridOf(motion, 64);
    const PlaceFinder finder(grid);
    QVERIFY(!finder.find({Vec3(50, 0, 60), Vec3(-1, 0, 0)}));
    QVERIFY(!finder.find({Vec3(50, 0, 20), Vec3(1, 0, 0)}));
    QVERIFY(!finder.find({Vec3(0, 0, 100), Vec3(0, 0, -1)}));  // through the open ends
  }
};

BLOSSOM_TEST(SweepPlaceTest)
#include "sweep_place_test.moc"
