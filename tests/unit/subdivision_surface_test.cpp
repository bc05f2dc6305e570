#include <Eigen/Geometry>
#include <limits>

#include "subdivision/kernel/limit_curve.h"
#include "subdivision/kernel/limit_surface.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

double largestGap(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double worst = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) worst = std::max(worst, (a[i] - b[i]).norm());
  return worst;
}

double distanceToPoints(const Mesh& mesh, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& q : mesh.points) nearest = std::min(nearest, (p - q).norm());
  return nearest;
}

}  // namespace

class SubdivisionSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  void aRegularVertexHasTheClosedForm() {
    auto random = seededRandom();
    const Mesh cage = jittered(gridCage(4, 4), random, 0.3);
    const Mesh limit = subdivide(cage, {.levels = 0, .limit = true}).mesh;
    const auto at = [&](int i, int j) { return cage.points[static_cast<std::size_t>(5 * j + i)]; };
    for (const auto& [i, j] : {std::pair(1, 1), std::pair(2, 2), std::pair(3, 1)}) {
      const Vec3 wanted = (16 * at(i, j) + 4 * (at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1)) +
                           at(i - 1, j - 1) + at(i + 1, j - 1) + at(i - 1, j + 1) + at(i + 1, j + 1)) /
                          36;
      QVERIFY((limit.points[static_cast<std::size_t>(5 * j + i)] - wanted).norm() < 1e-14);
    }
  }

  void limitPointsDoNotDependOnTheLevel() {
    auto random = seededRandom();
    for (const auto& [cage, scheme] : {std::pair(prism(5), Scheme::CatmullClark), std::pair(octahedron(), Scheme::Loop)}) {
      Mesh jitteredCage = jittered(cage, random, 0.3);
      jitteredCage.creases = {{0, 1, 1.5}};
      if (scheme == Scheme::Loop) jitteredCage.creases = {{0, 2, 1.5}};
      // Each level keeps the vertices of the last one, as its last points.
      const Mesh coarse = subdivide(jitteredCage, {.scheme = scheme, .levels = 3, .limit = true}).mesh;
      const Mesh fine = subdivide(jitteredCage, {.scheme = scheme, .levels = 5, .limit = true}).mesh;
      double worst = 0;
      for (const Vec3& p : coarse.points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& q : fine.points) nearest = std::min(nearest, (p - q).norm());
        worst = std::max(worst, nearest);
      }
      QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
    }
  }

  void limitRowsMeetTheMasks() {
    auto random = seededRandom();
    double worst = 0, worstInside = 0;
    for (const int n : {3, 5, 6, 8}) {
      const Mesh cage = jittered(prism(n), random, 0.2);
      const LimitSurface surface(cage, Scheme::CatmullClark);
      const Mesh masks = subdivide(cage, {.levels = 1, .limit = true}).mesh;
      for (std::size_t f = 0; f < cage.faceCount(); ++f)
        for (std::size_t k = 0; k < cage.face(f).size(); ++k)
          worst = std::max(worst, distanceToPoints(masks, combined(surface.cornerRow(f, k), cage.points)));
      // Points inside of patches against the masks four levels down.
      const Mesh fine = subdivide(cage, {.levels = 4, .limit = true}).mesh;
      for (const double u : {0.0625, 0.25, 0.5, 0.8125}) {
        const Vec3 p = combined(surface.row({0, u, 0.125}), cage.points);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& q : fine.points) nearest = std::min(nearest, (p - q).norm());
        worstInside = std::max(worstInside, nearest);
      }
    }
    qInfo("at vertices %.2g, inside %.2g", worst, worstInside);
    QVERIFY(worst < 1e-12);
    QVERIFY(worstInside < 1e-7);
  }

  void rowsAreAffineInvariant() {
    auto random = seededRandom();
    const Eigen::Affine3d map =
        Eigen::Translation3d(3, -2, 7) * Eigen::AngleAxisd(0.8, Vec3(1, 2, 3).normalized()) * Eigen::Scaling(2.0, 0.5, 3.0);
    for (const auto& [plain, scheme] : {std::pair(prism(5), Scheme::CatmullClark), std::pair(octahedron(), Scheme::Loop)}) {
      Mesh cage = jittered(plain, random, 0.3), moved = cage;
      for (Vec3& p : moved.points) p = map * p;
      std::vector<Vec3> wanted = subdivide(cage, {.scheme = scheme, .levels = 2, .limit = true}).mesh.points;
      for (Vec3& p : wanted) p = map * p;
      QVERIFY(largestGap(subdivide(moved, {.scheme = scheme, .levels = 2, .limit = true}).mesh.points, wanted) < 1e-12);
    }
  }

  /// Sharpness travels with the mesh, so that one level after another is the same as both at once.
  void levelsCompose() {
    auto random = seededRandom();
    Mesh cage = jittered(cubeCage(), random, 0.2);
    cage.creases = {{0, 1, 2.5}, {1, 2, 0.75}, {4, 5, 10}};
    cage.corners = {{7, 1.5}};
    const Mesh once = subdivide(subdivide(cage, {.levels = 1}).mesh, {.levels = 2}).mesh;
    const Mesh both = subdivide(cage, {.levels = 3}).mesh;
    for (const Vec3& p : once.points) QVERIFY(distanceToPoints(both, p) < 1e-13);  // vertices are numbered differently
  }

  void aSharpCubeStaysACube() {
    Mesh cage = cubeCage();
    for (int i = 0; i < 4; ++i) {
      cage.creases.push_back({i, (i + 1) % 4, 10});
      cage.creases.push_back({4 + i, 4 + (i + 1) % 4, 10});
      cage.creases.push_back({i, 4 + i, 10});
    }
    for (const Vec3& p : subdivide(cage, {.levels = 3, .limit = true}).mesh.points)
      COMPARE_NEAR(p.cwiseAbs().maxCoeff(), 1, 1e-12);
  }

  void polygonsBecomeCubicSplines() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> coordinate(-5, 5);
    for (const bool closed : {false, true}) {
      ControlPolygon polygon{{}, closed};
      for (int i = 0; i < 7; ++i) polygon.points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
      const LimitCurve curve(polygon);
      ControlPolygon fine = polygon;
      for (int level = 0; level < 3; ++level) fine = refined(fine);
      fine = onLimit(fine);
      // Limit points lie at equal parameters; those of the closed curve begin one point later.
      const int count = static_cast<int>(fine.points.size());
      for (int i = 0; i < count; ++i) {
        const double u =
            closed ? static_cast<double>((i + count - 8) % count) / count : static_cast<double>(i) / (count - 1);
        const Foot foot{0, u, 0};
        QVERIFY((combined(curve.row(foot), polygon.points) - fine.points[static_cast<std::size_t>(i)]).norm() < 1e-12);
      }
    }
  }

  void rubbishIsRefused() {
    const auto refused = [](const Mesh& cage, const char* place, Scheme scheme = Scheme::CatmullClark) {
      try {
        (void)subdivide(cage, {.scheme = scheme});
      } catch (const Error& error) {
        return error.code() == ErrorCode::InvalidInput && error.message().find(place) != std::string::npos &&
               !error.hint().empty();
      }
      return false;
    };
    QVERIFY(refused({}, "no face"));
    Mesh cage = cubeCage();
    cage.points[3].y() = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(refused(cage, "Vertex 4"));
    QVERIFY(refused(cubeCage(), "triangles only", Scheme::Loop));
    cage = cubeCage();
    addPolygon(cage, {0, 1, 6});
    QVERIFY(refused(cage, "meet at the edge from vertex 1 to vertex 2"));
    cage = gridCage(1, 1);
    cage.points.insert(cage.points.end(), {{3, 3, 0}, {4, 3, 0}});
    addPolygon(cage, {3, 5, 4});
    QVERIFY(refused(cage, "touch at vertex 4"));
    cage = gridCage(1, 1);
    cage.points.emplace_back(0, 0, 1);
    QVERIFY(refused(cage, "Vertex 5"));
    cage = gridCage(2, 1);
    cage.creases = {{0, 5, 1}};
    QVERIFY(refused(cage, "vertex 1 to vertex 6"));
    cage = Mesh();
    cage.points = gridCage(1, 1).points;
    addPolygon(cage, {0, 1, 1, 3});
    QVERIFY(refused(cage, "vertex 2 twice"));
    VERIFY_ERROR(subdivide(torusCage(30, 30), {.levels = 10}), ErrorCode::LimitExceeded);
    VERIFY_ERROR(refined(ControlPolygon{{{0, 0, 0}}, false}), ErrorCode::InvalidInput);
  }

  void cancelEndsIt() {
    const CancelToken token;
    const Progress progress(token, [&](double fraction, const std::string&) {
      if (fraction > 0.5) token.cancel();
    });
    VERIFY_ERROR(subdivide(torusCage(20, 20), {.levels = 4, .limit = true}, progress), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(SubdivisionSurfaceTest)
#include "subdivision_surface_test.moc"
