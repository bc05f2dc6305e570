#include <Eigen/Geometry>
#include <array>
#include <cstring>
#include <limits>

#include "geometry/mesh/mesh_topology.h"
#include "subdivision/kernel/deform.h"
#include "subdivision/kernel/limit_surface.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

using Triangle = std::array<Vec3, 3>;

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

double distanceToTriangle(const Vec3& p, const Triangle& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  bool inside = normal.norm() > 0;
  for (std::size_t k = 0; k < 3 && inside; ++k) inside = (t[(k + 1) % 3] - t[k]).cross(p - t[k]).dot(normal) >= 0;
  if (inside) return std::abs((p - t[0]).dot(normal.normalized()));
  return std::min({distanceToSegment(p, t[0], t[1]), distanceToSegment(p, t[1], t[2]), distanceToSegment(p, t[2], t[0])});
}

struct Measured {
  double rms = 0, largest = 0;
};

/// Distances of points from a fine mesh of the limit surface, every triangle tried: no feet, no patches, no rows.
Measured distancesTo(const Mesh& cage, Scheme scheme, const std::vector<Vec3>& samples) {
  const Mesh fine = triangulated(subdivide(cage, {.scheme = scheme, .levels = 4, .limit = true}).mesh).first;
  Measured result;
  double sum = 0;
  for (const Vec3& p : samples) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < fine.faceCount(); ++f) {
      const auto face = fine.face(f);
      const auto at = [&](std::size_t k) { return fine.points[static_cast<std::size_t>(face[k])]; };
      nearest = std::min(nearest, distanceToTriangle(p, {at(0), at(1), at(2)}));
    }
    sum += nearest * nearest;
    result.largest = std::max(result.largest, nearest);
  }
  result.rms = std::sqrt(sum / static_cast<double>(samples.size()));
  return result;
}

Mesh triangles(const Mesh& quads) {
  Mesh mesh;
  mesh.points = quads.points;
  for (std::size_t f = 0; f < quads.faceCount(); ++f) {
    const auto q = quads.face(f);
    addPolygon(mesh, {q[0], q[1], q[2]});
    addPolygon(mesh, {q[0], q[2], q[3]});
  }
  return mesh;
}

struct Case {
  Mesh cage;
  Scheme scheme = Scheme::CatmullClark;
  std::vector<Vec3> samples;
  DeformOptions options;
};

/// A random cage with extraordinary points or without, and a bump lifted off a part of its limit surface.
Case randomCase(std::mt19937_64& random, int k) {
  Case made;
  const Mesh plain = k % 4 == 0   ? gridCage(8, 7)
                     : k % 4 == 1 ? torusCage(9, 6)
                     : k % 4 == 2 ? subdivide(prism(5), {.levels = 2}).mesh
                                  : triangles(gridCage(8, 8));
  if (k % 4 == 3) made.scheme = Scheme::Loop;
  const double size = k % 4 == 2 ? 0.03 : 0.15;
  made.cage = jittered(plain, random, size);
  const LimitSurface surface(made.cage, made.scheme);
  std::uniform_int_distribution<int> patch(0, static_cast<int>(surface.patchCount()) - 1);
  std::uniform_real_distribution<double> height(1, 4);
  const Foot middle{patch(random), 0.4, 0.4};
  const Frame at = surface.frame(middle, made.cage.points);
  const Vec3 up = at.du.cross(at.dv).normalized();
  const double reach = 1.2 * at.du.norm(), lift = height(random) * size;
  for (const Vec3& p : subdivide(made.cage, {.scheme = made.scheme, .levels = 3, .limit = true}).mesh.points)
    if (const double r = (p - at.at).norm() / reach; r < 1 && made.samples.size() < 60)
      made.samples.emplace_back(p + lift * (1 - r * r) * up);
  made.options.lambda = k % 3 == 0 ? 1e-6 : 1e-3;
  made.options.free.rings = k % 5 == 4 ? 1 : 0;
  return made;
}

bool sameBits(const Vec3& a, const Vec3& b) { return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0; }

}  // namespace

/// What a deformation reports, against distances and positions found without its rows and feet.
class SubdivisionPullTest : public QObject {
  Q_OBJECT

 private slots:
  void distancesFallAsReported() {
    auto random = seededRandom();
    double error = 0, ratio = 0;
    constexpr int cases = 12;
    for (int k = 0; k < cases; ++k) {
      const Case given = randomCase(random, k);
      const LimitSurface surface(given.cage, given.scheme);
      const DeformResult result = deform(surface, given.cage.points, given.samples, given.options);
      Mesh moved = given.cage;
      moved.points = result.points;
      const Measured before = distancesTo(given.cage, given.scheme, given.samples),
                     after = distancesTo(moved, given.scheme, given.samples);
      for (const double off : {before.rms - result.before.rms, after.rms - result.after.rms,
                               before.largest - result.before.largest, after.largest - result.after.largest})
        error = std::max(error, std::abs(off));
      ratio = std::max(ratio, after.rms / before.rms);
      QVERIFY2(after.rms < before.rms, qPrintable(QString::number(k)));
    }
    qInfo("figure pulled_cases %d", cases);
    qInfo("figure rms_error_mm %.3g", error);
    qInfo("figure rms_ratio %.3g", ratio);
    QVERIFY2(error < 5e-3, qPrintable(QString::number(error)));  // what the chords of the fine mesh leave
    QVERIFY2(ratio < 0.5, qPrintable(QString::number(ratio)));
  }

  /// Vertices of the refined cages, level by level, that no free point reaches: found by refining marks in place of points.
  void outsideTheSupportEveryBitStays() {
    auto random = seededRandom();
    long checked = 0, changed = 0, reached = 0;
    for (int k = 0; k < 40; ++k) {
      const Case given = randomCase(random, k);
      const LimitSurface surface(given.cage, given.scheme);
      const DeformResult result = deform(surface, given.cage.points, given.samples, given.options);
      Mesh moved = given.cage, marks = given.cage;
      moved.points = result.points;
      std::fill(marks.points.begin(), marks.points.end(), Vec3(0, 0, 0));
      for (const int i : result.freePoints) marks.points[static_cast<std::size_t>(i)] = Vec3(1, 1, 1);
      for (const bool limit : {false, true}) {
        const SubdivideOptions options{.scheme = given.scheme, .levels = 3, .limit = limit};
        const Mesh before = subdivide(given.cage, options).mesh, after = subdivide(moved, options).mesh,
                   mark = subdivide(marks, options).mesh;
        for (std::size_t i = 0; i < before.points.size(); ++i) {
          if (mark.points[i] != Vec3(0, 0, 0)) {
            ++reached;
            continue;
          }
          ++checked;
          changed += sameBits(before.points[i], after.points[i]) ? 0 : 1;
        }
      }
      QCOMPARE(result.outsideChange, 0.0);
    }
    qInfo("figure outside_points %ld", checked);
    qInfo("figure inside_points %ld", reached);
    qInfo("figure outside_changed %ld", changed);
    QVERIFY(checked > 10000 && reached > 1000);
    QCOMPARE(changed, 0L);
  }
};

BLOSSOM_TEST(SubdivisionPullTest)
#include "subdivision_pull_test.moc"
