#include <Eigen/Dense>
#include <limits>
#include <numeric>

#include "geometry/bspline/bspline.h"
#include "geometry/mesh/mesh_topology.h"
#include "subdivision/kernel/cage.h"
#include "subdivision/kernel/curve_through.h"
#include "subdivision/kernel/deform.h"
#include "subdivision/kernel/foot_points.h"
#include "subdivision/kernel/least_squares.h"
#include "subdivision/kernel/limit_curve.h"
#include "subdivision/kernel/limit_surface.h"
#include "subdivision/kernel/live_pull.h"
#include "subdivision/kernel/near_places.h"
#include "subdivision/kernel/quad_layout.h"
#include "subdivision/kernel/rims.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "support/dense.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

/// The control polygon of the sample pulled-curve.
ControlPolygon samplePolygon() {
  ControlPolygon polygon;
  for (int i = 0; i <= 14; ++i) polygon.points.emplace_back(10.0 * i, 12 * std::sin(i * 0.9) + 0.02 * (i - 7) * (i - 7), 0);
  return polygon;
}

/// Places along a smooth stroke through the points clicked.
std::vector<Vec3> clicked(const std::vector<Vec3>& points) {
  const Curve curve = splineThrough(points);
  const auto [from, to] = curve.domain();
  std::vector<Vec3> samples;
  for (int k = 0; k < 50; ++k) samples.push_back(point(curve, from + (to - from) * k / 49));
  return samples;
}

double uniformIn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Mesh movedMesh(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.points) p += by;
  return mesh;
}

/// Both in one mesh, their vertices apart.
Mesh beside(Mesh mesh, const Mesh& other) {
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (std::size_t f = 0; f < other.faceCount(); ++f) {
    std::vector<int> face(other.face(f).begin(), other.face(f).end());
    for (int& v : face) v += first;
    mesh.addFace(face);
  }
  return mesh;
}

/// The faces whose corners all lie on one side of the plane x = 0, and nothing else.
Mesh halfOf(const Mesh& mesh) {
  Mesh half;
  std::vector<int> number(mesh.points.size(), -1);
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    if (std::any_of(face.begin(), face.end(), [&](int v) { return mesh.points[static_cast<std::size_t>(v)].x() < 0; }))
      continue;
    std::vector<int> kept;
    for (const int v : face) {
      int& to = number[static_cast<std::size_t>(v)];
      if (to < 0) {
        to = static_cast<int>(half.points.size());
        half.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
      }
      kept.push_back(to);
    }
    half.addFace(kept);
  }
  return half;
}

Mesh mirrored(const Mesh& mesh) {
  Mesh result;
  for (const Vec3& p : mesh.points) result.points.emplace_back(-p.x(), p.y(), p.z());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face(mesh.face(f).rbegin(), mesh.face(f).rend());
    result.addFace(face);
  }
  return result;
}

/// Vertices exactly on x = 0, and the same on both sides.
Mesh symmetricTorus() {
  Mesh mesh = torusCage(12, 6);
  for (Vec3& p : mesh.points) {
    if (std::abs(p.x()) < 1e-9) p.x() = 0;
    p = Vec3(p.x(), p.y(), p.z());
  }
  return mesh;
}

double nearestTo(const Vec3& p, const std::vector<Vec3>& points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& q : points) nearest = std::min(nearest, (p - q).norm());
  return nearest;
}

}  // namespace

class SubdivisionSoundTest : public QObject {
  Q_OBJECT

 private slots:
  /// Strokes of five clicks over a curve: no control point moves much farther than the stroke lies off.
  void pointsThatActLittleStayCalm() {
    auto random = seededRandom();
    const ControlPolygon polygon = samplePolygon();
    const LimitCurve curve(polygon);
    double worst = 0, left = 0;
    for (int k = 0; k < 60; ++k) {
      std::vector<Vec3> clicks;
      for (int i = 0; i < 5; ++i)
        clicks.emplace_back(45 + 15 * i + uniformIn(random, -4, 4),
                            (i % 4 == 0 ? -5
                             : i == 2   ? 23
                                        : 15) +
                                uniformIn(random, -4, 4),
                            0);
      const DeformResult result = deform(curve, polygon.points, clicked(clicks), {});
      worst = std::max(worst, result.farthestMove / result.before.largest);
      left = std::max(left, result.after.rms / result.before.rms);
      double farthest = 0;
      for (std::size_t i = 0; i < polygon.points.size(); ++i)
        farthest = std::max(farthest, (result.points[i] - polygon.points[i]).norm());
      COMPARE_NEAR(result.farthestMove, farthest, 0);
      QVERIFY((result.points[static_cast<std::size_t>(result.farthestPoint)] -
               polygon.points[static_cast<std::size_t>(result.farthestPoint)])
                  .norm() == farthest);
    }
    std::printf("figure stroke_fling %.3g\nfigure stroke_left %.3g\n", worst, left);
    QVERIFY2(worst < 3, qPrintable(QString::number(worst)));
    QVERIFY2(left < 0.5, qPrintable(QString::number(left)));
  }

  /// Nearly planar clouds, and the paper's rule, which frees points that hardly act on them.
  void thePapersRuleFlingsNothing() {
    auto random = seededRandom();
    double worst = 0;
    int done = 0;
    for (int k = 0; k < 30; ++k) {
      const Mesh cage = jittered(gridCage(10, 10), random, 0.1);
      const LimitSurface surface(cage, Scheme::CatmullClark);
      std::vector<Vec3> samples;
      const double lift = uniformIn(random, -0.5, -0.1), lean = uniformIn(random, -0.02, 0.02);
      for (int i = 0; i < 40; ++i)
        samples.emplace_back(3 + i * 0.1, 4 + std::sin(i * 0.2), lift + lean * i + 1e-3 * std::sin(i * 0.7));
      DeformResult result;
      try {
        result = deform(surface, cage.points, samples, {.free = {.paper = true}});
      } catch (const Error& error) {  // on some of these cages no point is on the side that the cloud bulges to
        QCOMPARE(error.code(), ErrorCode::InvalidInput);
        continue;
      }
      ++done;
      worst = std::max(worst, result.farthestMove / result.before.largest);
      QVERIFY(result.after.rms <= result.before.rms);
    }
    QVERIFY(done > 5);
    std::printf("figure paper_fling %.3g\n", worst);
    QVERIFY2(worst < 9, qPrintable(QString::number(worst)));
  }

  /// A drawn target and pulls beside it: the rule looks at the target, as if the pulls were not there.
  void thePapersRuleLooksAtTheTargetAlone() {
    ControlPolygon polygon;
    for (int i = 0; i <= 20; ++i) polygon.points.emplace_back(i, 0.3 * std::sin(i), 0);
    std::vector<Vec3> target;
    for (int i = 0; i <= 20; ++i) target.emplace_back(4 + i / 5.0, -0.6 + 1.5 * std::sin(std::numbers::pi * i / 20), 0);
    const LimitCurve curve(polygon);
    const FreeRule paper{.paper = true};
    const std::vector<int> alone = deform(curve, polygon.points, target, {.free = paper}).freePoints;
    const Pull pull{Vec3(16, 0, 0), Vec3(16, 1, 0)};
    const DeformResult both = deform(curve, polygon.points, target, {.free = paper, .pulls = {pull}});
    std::vector<int> wanted = alone;
    for (const int i : deform(curve, polygon.points, {}, {.pulls = {pull}}).freePoints) wanted.push_back(i);
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    QCOMPARE(both.freePoints, wanted);
  }

  /// What is seen while dragging is what comes out, by every rule.
  void thePreviewFollowsTheRule() {
    auto random = seededRandom();
    const Mesh cage = jittered(gridCage(10, 10), random, 0.1);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const FootFinder finder(surface, {});
    for (const FreeRule rule : {FreeRule{.paper = true}, FreeRule{}, FreeRule{.rings = 1}}) {
      std::vector<Pull> pulls;
      std::vector<LivePull::Handle> handles;
      std::vector<Vec3> places{{3, 3, 0}, {7, 3, 0}, {5, 7, 0}, {5, 5, 0}};
      const std::vector<Foot> feet = finder.feet(places, cage.points, {}, {});
      for (std::size_t k = 0; k < places.size(); ++k) {
        const Vec3 at = combined(surface.row(feet[k]), cage.points);
        pulls.push_back({at, at + Vec3(0, 0, k == 3 ? 0.1 : -0.5)});
        handles.push_back({feet[k], pulls.back().to});
      }
      const DeformOptions options{.free = rule, .iterations = 1, .pulls = pulls};
      LivePull live(surface, cage.points, handles, options);
      DeformOptions after = options;
      for (const Vec3& to : {Vec3(5, 5, 0.4), Vec3(5, 6, 1.0), Vec3(9, 9, 0.7)}) {  // the box of the paper's rule grows
        after.pulls[3].to = to;
        live.drag(3, after.pulls[3].to);
        const DeformResult wanted = deform(surface, cage.points, {}, after);
        QCOMPARE(live.freePoints(), wanted.freePoints);
        double apart = 0;
        for (std::size_t i = 0; i < cage.points.size(); ++i)
          apart = std::max(apart, (live.points()[i] - wanted.points[i]).norm());
        QVERIFY2(apart < 1e-9, qPrintable(QString::number(apart)));
      }
    }
  }

  /// Directions that act a millionth of the strongest count, too: the result is that of the pseudo-inverse.
  void withoutLambdaNothingIsCutOff() {
    auto random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      constexpr int rows = 5, columns = 8;
      const Eigen::MatrixXd left = orthogonalFactor(Eigen::MatrixXd::Random(rows, rows)),
                            right = orthogonalFactor(Eigen::MatrixXd::Random(columns, columns));
      Eigen::MatrixXd scales = Eigen::MatrixXd::Zero(rows, columns);
      for (int i = 0; i < rows; ++i) scales(i, i) = std::pow(10, -1.5 * i);  // down to 1e-6
      const Eigen::MatrixXd matrix = left * scales * right.transpose();
      std::vector<Row> list(rows);
      std::vector<Vec3> residuals;
      for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
          list[static_cast<std::size_t>(r)].indices.push_back(c);
          list[static_cast<std::size_t>(r)].weights.push_back(matrix(r, c));
        }
        residuals.emplace_back(uniformIn(random, -1, 1), uniformIn(random, -1, 1), 0);
      }
      std::vector<int> free(columns);
      std::iota(free.begin(), free.end(), 0);
      const std::vector<double> even(columns, 1.0);
      const std::vector<Vec3> found = LeastSquares(list, free, even, {}, 0, {}).solve(residuals);
      Eigen::MatrixXd wantedRight(rows, 3);
      for (int r = 0; r < rows; ++r) wantedRight.row(r) = residuals[static_cast<std::size_t>(r)].transpose();
      // The pseudo-inverse from the factors that the matrix was made of.
      Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(columns, rows);
      for (int i = 0; i < rows; ++i) inverse(i, i) = 1 / scales(i, i);
      const Eigen::MatrixXd wanted = right * inverse * left.transpose() * wantedRight;
      double apart = 0;
      for (int c = 0; c < columns; ++c)
        apart = std::max(apart, (found[static_cast<std::size_t>(c)].transpose() - wanted.row(c)).norm());
      QVERIFY2(apart < 1e-7 * wanted.norm(), qPrintable(QString::number(apart / wanted.norm())));
    }
  }

  void nearestPlacesAreThoseOfASearchThroughAll() {
    auto random = seededRandom();
    std::vector<Vec3> places;
    for (int i = 0; i < 60000; ++i) {  // on a wavy sheet, some twice
      const double x = uniformIn(random, 0, 100), y = uniformIn(random, 0, 100);
      places.emplace_back(x, y, 5 * std::sin(x / 9) * std::cos(y / 7));
      if (i % 10 == 0) places.push_back(places.back());
    }
    const NearPlaces tree(places);
    std::size_t looked = 0, queries = 0;
    std::vector<NearPlaces::Near> found;
    for (int k = 0; k < 60; ++k) {
      const Vec3 to(uniformIn(random, -10, 110), uniformIn(random, -10, 110), uniformIn(random, -8, 8));
      tree.nearest(to, 24, found, &looked);
      ++queries;
      std::vector<NearPlaces::Near> all;
      for (std::size_t i = 0; i < places.size(); ++i) all.emplace_back((places[i] - to).squaredNorm(), i);
      std::partial_sort(all.begin(), all.begin() + 24, all.end());
      all.resize(24);
      QCOMPARE(found, all);
    }
    const double share = static_cast<double>(looked) / static_cast<double>(queries * places.size());
    std::printf("figure places_looked_at_share %.3g\n", share);
    QVERIFY2(share < 0.02, qPrintable(QString::number(share)));
    tree.nearest(places[0], 100000, found);
    QCOMPARE(found.size(), places.size());
    NearPlaces({}).nearest(places[0], 3, found);
    QVERIFY(found.empty());
  }

  void fewUnsettledVerticesNeedFewLimitSurfaces() {
    auto random = seededRandom();
    Mesh cage = jittered(gridCage(12, 12), random, 0.2);
    cage.corners = {{70, 4.5}, {100, 3.5}};
    cage.creases = {{30, 31, 3.25}};
    const SubdivideResult result = subdivide(cage, {.levels = 3, .limit = true});
    QCOMPARE(result.mesh.faceCount(), std::size_t(144 * 64));
    std::printf("figure limit_surfaces %zu\n", result.limitSurfaces);
    QVERIFY(result.limitSurfaces > 0 && result.limitSurfaces < 40);
    // Against the limit surface of the whole refined cage.
    const Mesh refined = subdivide(cage, {.levels = 3}).mesh;
    const LimitSurface whole(refined, Scheme::CatmullClark);
    double apart = 0;
    for (std::size_t f = 0; f < refined.faceCount(); ++f)
      for (std::size_t k = 0; k < 4; ++k)
        apart = std::max(apart, (combined(whole.cornerRow(f, k), refined.points) -
                                 result.mesh.points[static_cast<std::size_t>(refined.face(f)[k])])
                                    .norm());
    QVERIFY2(apart < 1e-9, qPrintable(QString::number(apart)));
  }

  void manyRingsAreCutOneByOne() {
    constexpr int rings = 60;
    Mesh mesh = torusCage(7, 5);
    const std::size_t faces = mesh.faceCount();
    for (int k = 1; k < rings; ++k) mesh = beside(mesh, movedMesh(torusCage(7, 5), Vec3(10.0 * k, 0, 0)));
    std::size_t looked = 0, alone = 0;
    const std::vector<LayoutCell> cells = quadLayout(mesh, {}, &looked), one = quadLayout(torusCage(7, 5), {}, &alone);
    QCOMPARE(cells.size(), rings * one.size());
    QCOMPARE(looked, rings * alone);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const LayoutCell& wanted = one[c % one.size()];
      QCOMPARE(cells[c].columns, wanted.columns);
      QCOMPARE(cells[c].rows, wanted.rows);
      for (std::size_t i = 0; i < wanted.faces.size(); ++i) {
        QCOMPARE(cells[c].faces[i].face, wanted.faces[i].face + static_cast<int>(c / one.size() * faces));
        QCOMPARE(cells[c].faces[i].turn, wanted.faces[i].turn);
      }
    }
    std::printf("figure faces_placed_per_face %.3g\n", static_cast<double>(looked) / static_cast<double>(mesh.faceCount()));
  }

  void aMirroredHalfCloses() {
    const Mesh whole = symmetricTorus(), half = halfOf(whole);
    Mesh both = beside(half, mirrored(half));
    QVERIFY(!meshTopology(both).closed());
    const JoinedRims joined = joinRims(both);
    QVERIFY(meshTopology(joined.mesh).closed());
    checkCage(joined.mesh, Scheme::CatmullClark);
    QCOMPARE(joined.mesh.points.size(), whole.points.size());
    QCOMPARE(joined.joined, both.points.size() - whole.points.size());
    // The limit surface is that of the cage that was never cut.
    const Mesh found = subdivide(joined.mesh, {.levels = 2, .limit = true}).mesh,
               wanted = subdivide(whole, {.levels = 2, .limit = true}).mesh;
    double apart = 0;
    for (const Vec3& p : wanted.points) apart = std::max(apart, nearestTo(p, found.points));
    QVERIFY2(apart < 1e-9, qPrintable(QString::number(apart)));
    std::printf("figure mirrored_apart_mm %.3g\n", apart);
    // A second join finds nothing, and neither does one of halves that stand apart.
    QCOMPARE(joinRims(joined.mesh).joined, std::size_t(0));
    QCOMPARE(joinRims(beside(half, movedMesh(mirrored(half), Vec3(-0.01, 0, 0)))).joined, std::size_t(0));
  }
  void rimsThatMakeNoCageStay() {
    // Three sheets at one edge: none is joined to another.
    Mesh fan;
    for (int k = 0; k < 3; ++k) {
      Mesh sheet;
      sheet.points = {
          {0, 0, 0}, {0, 0, 1}, {std::cos(2.0 * k), std::sin(2.0 * k), 1}, {std::cos(2.0 * k), std::sin(2.0 * k), 0}};
      addPolygon(sheet, {0, 1, 2, 3});
      fan = beside(fan, sheet);
    }
    QCOMPARE(joinRims(fan).joined, std::size_t(0));
    // Creases of both halves become one.
    Mesh half = halfOf(symmetricTorus());
    int a = -1, b = -1;
    for (const MeshEdge& edge : meshTopology(half).edges)
      if (edge.forward + edge.backward == 1) a = edge.low, b = edge.high;
    half.creases = {{a, b, 2.5}};
    Mesh other = mirrored(half);
    Mesh both = beside(half, other);
    const int first = static_cast<int>(half.points.size());
    both.creases = {{a, b, 2.5}, {a + first, b + first, 3.5}};
    const JoinedRims joined = joinRims(both);
    QCOMPARE(joined.mesh.creases.size(), std::size_t(1));
    QCOMPARE(joined.mesh.creases[0].sharpness, 3.5);
    checkCage(joined.mesh, Scheme::CatmullClark);
  }
};

BLOSSOM_TEST(SubdivisionSoundTest)
#include "subdivision_sound_test.moc"
