// Faces that are rectangles of B-spline surfaces: structured grids, and how they meet the faces around them.
#include "geometry/tessellate/grid_mesher.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <numbers>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/grid_face.h"
#include "support/exchange.h"
#include "support/motion_samples.h"
#include "support/solids.h"
#include "support/support.h"
#include "sweep/kernel/cubic_approximation.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

TopoDS_Shape exactSolid(const std::string& name) {
  return sweep::makeSolid(sweep::productSurface(readMotionOf(name + ".json")).surface).solid;
}

/// A ball as one face with two poles and a seam.
Surface ballSurface(double radius) {
  Surface surface{2, 2, circleKnots, {0, 0, 0, 1, 1, 2, 2, 2}, {}};
  const std::vector<Vec3> circle = circlePoles(0, radius);
  const std::vector<Vec3> profile{circle[6], circle[7], circle[0], circle[1], circle[2]};  // from pole to pole
  for (const Vec3& around : circlePoles(0, 1))
    for (const Vec3& p : profile)
      surface.poles.emplace_back(around.x() * p.x(), around.y() * p.x(), around.z() * p.y(), around.z() * p.z());
  return surface;
}

struct GridMeshes {
  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape faces;
  GridNormalsOf normals;
};

GridMeshes gridMeshes(const TopoDS_Shape& shape, double chord) {
  GridMeshes result{BRepBuilderAPI_Copy(shape).Shape(), {}, {}};
  TopExp::MapShapes(result.shape, TopAbs_FACE, result.faces);
  result.normals = meshGridFaces(result.faces, {chord, 0.5}, Progress::none());
  return result;
}

/// Distance from p to the surface, by Newton's steps along the tangent plane from nearby parameters.
double distanceToSurface(const Surface& surface, Vec2 uv, const Vec3& p) {
  const auto [u0, u1] = surface.domainU();
  const auto [v0, v1] = surface.domainV();
  double minimum = 1e300;
  for (int i = 0; i < 4; ++i) {
    const SurfaceFrame at = frame(surface, std::clamp(uv.x(), u0, u1), std::clamp(uv.y(), v0, v1));
    minimum = std::min(minimum, (at.point - p).norm());
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << at.du, at.dv;
    uv += (tangents.transpose() * tangents).inverse() * (tangents.transpose() * (p - at.point));
  }
  return minimum;
}

/// Largest distance from the triangles of the grids to their surfaces, looked for at some 12000 places.
double largestError(const GridMeshes& meshes) {
  double worst = 0;
  for (int f = 1; f <= meshes.faces.Extent(); ++f) {
    const auto face = gridFace(TopoDS::Face(meshes.faces(f)));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(meshes.faces(f)), location);
    if (!face || mesh.IsNull()) continue;
    for (int t = 1; t <= mesh->NbTriangles(); t += 1 + mesh->NbTriangles() / 2000) {
      int n[3];
      mesh->Triangle(t).Get(n[0], n[1], n[2]);
      for (const Vec3& weights :
           {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(0, 1, 1), Vec3(1, 0, 1), Vec3(2, 1, 1), Vec3(1, 4, 1)}) {
        Vec3 p(0, 0, 0);
        Vec2 uv = -face->shift;
        for (int k = 0; k < 3; ++k) {
          const double w = weights[k] / weights.sum();
          p += w * Vec3(mesh->Node(n[k]).X(), mesh->Node(n[k]).Y(), mesh->Node(n[k]).Z());
          uv += w * Vec2(mesh->UVNode(n[k]).X(), mesh->UVNode(n[k]).Y());
        }
        worst = std::max(worst, distanceToSurface(face->surface, uv, p));
      }
    }
  }
  return worst;
}

/// Every directed edge has its opposite, the Euler characteristic is 2 - 2 genus, the volume that of the exact solid, and
/// the triangles look the way of their normals.
void verifyBody(const TopoDS_Shape& shape, double chord, int genus, int components = 1) {
  const Measures exact = measure(Brep(shape));
  const Tessellation t = tessellate(Brep(shape), {chord, 0.5});
  const Mesh mesh = toMesh(t);
  const MeshTopology topology = meshTopology(mesh);
  for (const MeshEdge& edge : topology.edges) QVERIFY(edge.manifold());
  QCOMPARE(topology.components.size(), static_cast<std::size_t>(components));
  const auto euler =
      static_cast<int>(mesh.points.size()) - static_cast<int>(topology.edges.size()) + static_cast<int>(mesh.faceCount());
  QCOMPARE(euler, 2 * components - 2 * genus);
  COMPARE_NEAR(signedVolume(mesh), measured<double>(exact, "volume"), measured<double>(exact, "area") * chord);
  QCOMPARE(t.normals.size(), t.points.size());
  for (const auto& [a, b, c] : t.triangles) {
    const auto at = [&](int i) { return t.points[static_cast<std::size_t>(i)]; };
    const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    Vec3 sum(0, 0, 0);
    for (const int i : {a, b, c}) sum += t.normals[static_cast<std::size_t>(i)];
    QVERIFY(normal.norm() < 1e-9 || normal.dot(sum) > 0);
  }
  for (const Vec3& n : t.normals) COMPARE_NEAR(n.norm(), 1, 1e-12);
}

}  // namespace

class TessellateGridTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str()); }
  void sweptSolids_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("cubic");
    QTest::addColumn<int>("genus");
    for (const bool cubic : {false, true}) {
      for (const char* name : {"propeller", "twisted-tube", "cylinder", "torus"}) {
        const QString way = cubic ? "cubic" : "exact";
        QTest::newRow(qPrintable(QString("%1 %2").arg(name, way))) << name << cubic << (QString(name) == "torus" ? 1 : 0);
      }
    }
  }
  void sweptSolids() {
    QFETCH(QString, name);
    QFETCH(bool, cubic);
    QFETCH(int, genus);
    const Motion motion = readMotionOf(name.toStdString() + ".json");
    const Surface surface = cubic ? sweep::approximateCubic(motion).surface : sweep::productSurface(motion).surface;
    const TopoDS_Shape solid = sweep::makeSolid(surface).solid;
    for (const double chord : {0.2, 0.05}) {
      verifyBody(solid, chord, genus);
      const GridMeshes meshes = gridMeshes(solid, chord);
      QVERIFY(!meshes.normals.empty());
      const double error = largestError(meshes);
      QVERIFY2(error <= chord, qPrintable(QString("error %1").arg(error)));
      qInfo("largest error %.3g of chord %.3g", error, chord);
    }
  }

  void facesWithPoles() {
    const TopoDS_Shape ball = solidOf(toFace(ballSurface(10)));
    QCOMPARE(gridMeshes(ball, 0.1).normals.size(), std::size_t{1});
    for (const double chord : {0.5, 0.02}) verifyBody(ball, chord, 0);
  }

  /// Two halves of a torus, one with many more knots than the other: the shared edges have the points of both.
  void neighborsAgreeOnTheirEdges() {
    const Surface whole = torusSurface(5, 2);
    const std::vector<double> torn{2};
    const Surface cut = insertKnotsU(whole, torn);
    const auto half = [&](std::size_t first, std::vector<double> knots) {
      Surface result{2, 2, std::move(knots), cut.knotsV, {}};
      result.poles.assign(cut.poles.begin() + static_cast<std::ptrdiff_t>(first * cut.countV()),
                          cut.poles.begin() + static_cast<std::ptrdiff_t>((first + 5) * cut.countV()));
      return result;
    };
    const Surface left = half(0, {0, 0, 0, 1, 1, 2, 2, 2});
    const Surface right = insertKnotsV(half(5, {2, 2, 2, 3, 3, 4, 4, 4}), std::vector<double>{0.3, 0.7, 1.1, 1.9, 2.5, 3.3});
    BRepBuilderAPI_Sewing sewing(1e-6);
    sewing.Add(toFace(left));
    sewing.Add(toFace(right));
    sewing.Perform();
    const TopoDS_Shape shell = sewing.SewedShape();
    QCOMPARE(shell.ShapeType(), TopAbs_SHELL);
    QCOMPARE(gridMeshes(shell, 0.1).normals.size(), std::size_t{2});
    BRepBuilderAPI_MakeSolid solid(TopoDS::Shell(shell));
    for (const double chord : {0.3, 0.01}) verifyBody(solid.Solid(), chord, 1);
  }

  void partsOfSurfaces() {
    const Handle(Geom_BSplineSurface) torus = toOcct(torusSurface(5, 2));
    const auto verifyFace = [](const TopoDS_Face& face) {
      const GridMeshes meshes = gridMeshes(face, 0.01);
      QCOMPARE(meshes.normals.size(), std::size_t{1});
      QVERIFY(largestError(meshes) <= 0.01);
      const double exact = measured<double>(measure(Brep(face)), "area");
      COMPARE_NEAR(area(meshOf(Brep(face), {0.01, 0.5})), exact, 0.01 * exact);
    };
    verifyFace(BRepBuilderAPI_MakeFace(torus, 0.3, 2.6, 1.2, 3.9, 1e-7));
    const Handle(Geom_BSplineSurface) periodic = toOcct(torusSurface(5, 2));
    periodic->SetUPeriodic();
    periodic->SetVPeriodic();
    verifyFace(BRepBuilderAPI_MakeFace(periodic, 2.6, 5.3, 3.5, 4.5, 1e-7));  // over the seam
  }

  void facesCutByOtherCurvesBesideThem() {
    const auto drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(70, 10, -5), gp_Dir(0, 0, 1)), 4, 40).Shape();
    const auto drilled = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), 40, 20, 30).Shape(), drill).Shape();
    const BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, drilled);
    builder.Add(both, exactSolid("cylinder"));
    verifyBody(both, 0.02, 1, 2);
    // A B-spline face with a hole in it is no rectangle.
    const auto needle = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-20, 0, 20), gp_Dir(1, 0, 0)), 3, 50).Shape();
    verifyBody(BRepAlgoAPI_Cut(exactSolid("cylinder"), needle).Shape(), 0.02, 1);
  }

  /// Readers make closed surfaces periodic.
  void solidsReadFromStep() {
    for (const auto& [name, genus] : {std::pair("torus", 1), {"cylinder", 0}, {"propeller", 0}}) {
      const Shape read = roundTrip(Brep(exactSolid(name)), "step").shape;
      const TopoDS_Shape& solid = read.get<Brep>()->shape();
      verifyBody(solid, 0.1, genus);
      const GridMeshes meshes = gridMeshes(solid, 0.1);
      QVERIFY(!meshes.normals.empty());
      QVERIFY(largestError(meshes) <= 0.1);
    }
  }
};

BLOSSOM_TEST(TessellateGridTest)
#include "tessellate_grid_test.moc"
