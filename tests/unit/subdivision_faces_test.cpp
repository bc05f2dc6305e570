#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Eigen/Dense>
#include <array>
#include <map>
#include <numbers>
#include <set>

#include "geometry/bspline/bspline.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt.h"
#include "subdivision/kernel/bspline_faces.h"
#include "subdivision/kernel/quad_layout.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

/// Distance from p to the nearest of many points of the faces, refined by a few steps of Newton's method.
double distanceTo(const std::vector<Surface>& faces, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Surface& face : faces) {
    const auto [u0, u1] = face.domainU();
    const auto [v0, v1] = face.domainV();
    double nearest = std::numeric_limits<double>::infinity();
    Vec2 at(u0, v0);
    const int columns = static_cast<int>(8 * (u1 - u0)), rows = static_cast<int>(8 * (v1 - v0));
    for (int i = 0; i <= columns; ++i)
      for (int j = 0; j <= rows; ++j) {
        const Vec2 uv(u0 + (u1 - u0) * i / columns, v0 + (v1 - v0) * j / rows);
        if (const double d = (point(face, uv.x(), uv.y()) - p).norm(); d < nearest) nearest = d, at = uv;
      }
    for (int step = 0; step < 20; ++step) {
      const SurfaceFrame f = frame(face, at.x(), at.y());
      Eigen::Matrix2d normal;
      normal << f.du.squaredNorm(), f.du.dot(f.dv), f.du.dot(f.dv), f.dv.squaredNorm();
      const Vec2 right(f.du.dot(p - f.point), f.dv.dot(p - f.point));
      at += Vec2(normal.inverse() * right);
      at = at.cwiseMax(Vec2(u0, v0)).cwiseMin(Vec2(u1, v1));
      nearest = std::min(nearest, (point(face, at.x(), at.y()) - p).norm());
    }
    best = std::min(best, nearest);
  }
  return best;
}

/// Largest distance from limit points, found by the masks, to the faces.
double offLimit(const Mesh& cage, const FacesResult& made) {
  double worst = 0;
  for (const Vec3& p : subdivide(cage, {.levels = 3, .limit = true}).mesh.points)
    worst = std::max(worst, distanceTo(made.faces, p));
  return worst;
}

bool closesTight(const std::vector<Surface>& faces) {
  BRepBuilderAPI_Sewing sewing(1e-9);
  for (const Surface& face : faces) sewing.Add(toFace(face));
  sewing.Perform();
  return sewing.NbFreeEdges() == 0 && BRepCheck_Analyzer(sewing.SewedShape()).IsValid();
}

}  // namespace

class SubdivisionFacesTest : public QObject {
  Q_OBJECT

 private slots:
  void aRegularGridIsOneExactFace() {
    auto random = seededRandom();
    const Mesh cage = jittered(gridCage(7, 4), random, 0.3);
    const FacesResult made = bsplineFaces(cage);
    QCOMPARE(made.faces.size(), std::size_t(1));
    QCOMPARE(made.exactFaces, std::size_t(1));
    QCOMPARE(made.faces[0].poles.size(), std::size_t(10 * 7));
    QVERIFY(made.deviation < 1e-13);
    QVERIFY(offLimit(cage, made) < 1e-12);
  }

  void aTorusClosesExactly() {
    auto random = seededRandom();
    const Mesh cage = jittered(torusCage(7, 5), random, 0.3);
    const FacesResult made = bsplineFaces(cage);
    QVERIFY(made.faces.size() <= 4);
    QCOMPARE(made.exactFaces, made.faces.size());
    QVERIFY(made.deviation < 1e-12);
    QVERIFY(closesTight(made.faces));
    QVERIFY(offLimit(cage, made) < 1e-12);
  }

  void extraordinaryPointsAreApproximatedWithinTheTolerance() {
    auto random = seededRandom();
    for (const int n : {3, 4, 5, 8}) {
      const Mesh cage = jittered(prism(n), random, 0.15);
      double last = 1;
      for (const double tolerance : {1e-2, n == 8 ? 1e-3 : 1e-4}) {
        const FacesResult made = bsplineFaces(cage, {.tolerance = tolerance});
        QVERIFY2(made.deviation <= tolerance, qPrintable(QString::number(made.deviation)));
        QVERIFY(made.deviation <= last);
        last = made.deviation;
        const double off = offLimit(cage, made);
        qInfo("%d sides: %zu faces, %.2g mm and %.2g degrees off, limit points %.2g", n, made.faces.size(), made.deviation,
              made.normalDeviation * 180 / std::numbers::pi, off);
        QVERIFY(off <= tolerance);
        QVERIFY(closesTight(made.faces));
      }
    }
  }

  void creasesAndRimsAreKept() {
    Mesh cage = cubeCage();
    for (int i = 0; i < 4; ++i) {
      cage.creases.push_back({i, (i + 1) % 4, 10});
      cage.creases.push_back({4 + i, 4 + (i + 1) % 4, 10});
      cage.creases.push_back({i, 4 + i, 10});
    }
    const FacesResult cube = bsplineFaces(cage);
    QCOMPARE(cube.faces.size(), std::size_t(6));
    QVERIFY(cube.deviation < 1e-12);
    QVERIFY(closesTight(cube.faces));
    cage.creases.resize(1);  // one sharp edge ends in the open
    const FacesResult dart = bsplineFaces(cage, {.tolerance = 1e-3});
    QVERIFY(dart.deviation <= 1e-3);
    QVERIFY(closesTight(dart.faces));
    const Mesh open = withoutFace(cubeCage(), 1);
    const FacesResult made = bsplineFaces(open, {.tolerance = 1e-3});
    QVERIFY(made.deviation <= 1e-3);
    QVERIFY(offLimit(open, made) <= 1e-3);
  }

  /// A crease of sharpness s is rounded by about a 2^s-th of a face: sharp faces are near it, and few.
  void semiSharpEdgesBecomeSharpWithinTheTolerance() {
    Mesh cage = cubeCage();
    for (const double sharpness : {0.5, 1.5, 3.0, 7.8}) {
      cage.creases = {{0, 1, sharpness}, {1, 2, sharpness}, {2, 3, sharpness}, {0, 3, sharpness}};
      cage.corners.clear();
      if (sharpness < 7) cage.corners = {{5, sharpness}};
      const FacesResult made = bsplineFaces(cage, {.tolerance = 5e-3});
      qInfo("sharpness %g: %zu faces, %.2g mm off, %.2g of it made sharp", sharpness, made.faces.size(), made.deviation,
            made.sharpened);
      QVERIFY(made.deviation <= 5e-3 && made.sharpened <= made.deviation);
      QVERIFY(offLimit(cage, made) <= 5e-3);
      QVERIFY(closesTight(made.faces));
      if (sharpness > 7) QVERIFY(made.faces.size() <= 6 && made.sharpened > 0);
    }
  }

  /// Cells cover every face once, their sides are whole sides of their neighbours, irregular vertices are corners only.
  void layoutsAreConforming() {
    for (const Mesh& cage : {subdivide(prism(5), {.levels = 3}).mesh, subdivide(octahedron(), {.levels = 2}).mesh,
                             torusCage(6, 9), gridCage(4, 3), subdivide(withoutFace(prism(6), 2), {.levels = 2}).mesh}) {
      const std::vector<LayoutCell> layout = quadLayout(cage);
      std::vector<int> used(cage.faceCount());
      std::map<std::set<int>, int> sides;
      for (const LayoutCell& cell : layout) {
        for (const PlacedFace& face : cell.faces) ++used[static_cast<std::size_t>(face.face)];
        const auto corner = [&](int column, int row, int k) {
          const PlacedFace& face = cell.at(column, row);
          return cage.face(static_cast<std::size_t>(face.face))[static_cast<std::size_t>((face.turn + k) % 4)];
        };
        std::array<std::set<int>, 4> around;
        for (int i = 0; i < cell.columns; ++i) {
          around[0].insert({corner(i, 0, 0), corner(i, 0, 1)});
          around[2].insert({corner(i, cell.rows - 1, 2), corner(i, cell.rows - 1, 3)});
        }
        for (int j = 0; j < cell.rows; ++j) {
          around[1].insert({corner(cell.columns - 1, j, 1), corner(cell.columns - 1, j, 2)});
          around[3].insert({corner(0, j, 3), corner(0, j, 0)});
        }
        for (const auto& side : around) ++sides[side];
        for (int i = 0; i + 1 < cell.columns; ++i)
          for (int j = 0; j < cell.rows; ++j) QCOMPARE(corner(i, j, 1), corner(i + 1, j, 0));
      }
      QVERIFY(std::all_of(used.begin(), used.end(), [](int times) { return times == 1; }));
      if (meshTopology(cage).closed())
        for (const auto& [side, times] : sides) QVERIFY(times == 2 || times == 4);
    }
    QCOMPARE(quadLayout(gridCage(4, 3)).size(), std::size_t(1));
    QCOMPARE(quadLayout(subdivide(cubeCage(), {.levels = 4}).mesh).size(), std::size_t(6));
  }

  void rubbishIsRefused() {
    VERIFY_ERROR(bsplineFaces({}), ErrorCode::InvalidInput);
    VERIFY_ERROR(bsplineFaces(cubeCage(), {.tolerance = 0}), ErrorCode::InvalidParameter);
    Mesh cage = torusCage(60, 60);
    cage.creases = {{0, 1, 7}};
    VERIFY_ERROR(bsplineFaces(cage, {.tolerance = 1e-9}), ErrorCode::LimitExceeded);
    const CancelToken token;
    const Progress progress(token, [&](double fraction, const std::string&) {
      if (fraction > 0.5) token.cancel();
    });
    VERIFY_ERROR(bsplineFaces(prism(5), {.tolerance = 1e-9}, progress), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(SubdivisionFacesTest)
#include "subdivision_faces_test.moc"
