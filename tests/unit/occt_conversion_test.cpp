#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <numbers>

#include "geometry/planar/planar.h"
#include "support/solids.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

Vec3 toVec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

Path closedPolygon(const std::vector<Vec2>& points) {
  Path path;
  path.closed = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    path.segments.emplace_back(Line2{points[i], points[(i + 1) % points.size()]});
  return path;
}

/// Lines, arcs both ways and a spline around, with a round hole; and a disc beside it.
Region plateWithHole() {
  const Path outer{{Line2{{0, 0}, {10, 0}}, Arc2{{10, 3}, 3, -pi / 2, pi}, ellipticArc({5, 6}, {5, 0}, 0.4, 0, pi),
                    Arc2{{0, 3}, 3, pi / 2, -pi}},
                   true,
                   {},
                   {}};
  const Path hole{{Arc2{{6, 3}, 1.5, 1, -2 * pi}}, true, {}, {}};
  const Path disc{{Arc2{{30, 0}, 2, 0, 2 * pi}}, true, {}, {}};
  return {{outer, hole, disc}};
}

std::size_t countOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  std::size_t n = 0;
  for (TopExp_Explorer e(shape, kind); e.More(); e.Next()) ++n;
  return n;
}

bool isValid(const TopoDS_Shape& shape) { return BRepCheck_Analyzer(shape).IsValid(); }

}  // namespace

class OcctConversionTest : public QObject {
  Q_OBJECT
 private slots:
  void curvesEvaluateAlikeAndComeBack() {
    Random random = seededRandom();
    for (int i = 0; i < 60; ++i) {
      const Curve curve = randomCurve(random, uniformInt(random, 1, 12));
      const Handle(Geom_BSplineCurve) occt = toOcct(curve);
      for (int k = 0; k < 20; ++k) {
        const double t = randomParameter(random, curve.domain());
        COMPARE_NEAR((toVec(occt->Value(t)) - point(curve, t)).norm(), 0, 1e-10);
      }
      const Curve back = fromOcct(occt);
      const Curve expected = clamped(curve);
      QCOMPARE(back.degree, expected.degree);
      QCOMPARE(back.poles.size(), expected.poles.size());
      QVERIFY(back.knots == expected.knots);
    }
  }
  void aPeriodicSurfaceWithoutWeightsHasThemAllAtOne() {
    Random random = seededRandom();
    constexpr int around = 7, across = 4;
    TColgp_Array2OfPnt poles(1, around, 1, across);
    for (int i = 1; i <= around; ++i)
      for (int j = 1; j <= across; ++j) {
        const double angle = 2 * pi * i / around, radius = uniform(random, 5, 9);
        poles(i, j) = {radius * std::cos(angle), radius * std::sin(angle), 3.0 * j};
      }
    TColStd_Array1OfReal knotsU(1, around + 1), knotsV(1, 2);
    TColStd_Array1OfInteger onceU(1, around + 1), fullV(1, 2);
    for (int i = 1; i <= around + 1; ++i) knotsU(i) = i, onceU(i) = 1;
    knotsV(1) = 0, knotsV(2) = 1;
    fullV.Init(across);
    const Handle(Geom_BSplineSurface) closed =
        new Geom_BSplineSurface(poles, knotsU, knotsV, onceU, fullV, 3, across - 1, true, false);
    const Surface surface = fromOcct(closed);
    COMPARE_NEAR(smallestWeight(surface), 1, 0);
    for (int k = 0; k < 50; ++k) {
      const double u = randomParameter(random, surface.domainU()), v = randomParameter(random, surface.domainV());
      COMPARE_NEAR((toVec(closed->Value(u, v)) - point(surface, u, v)).norm(), 0, 1e-10);
    }
  }
  void surfacesEvaluateAlikeAndComeBack() {
    Random random = seededRandom();
    for (int i = 0; i < 30; ++i) {
      const Surface surface =
          randomSurface(random, uniformInt(random, 1, 9), uniformInt(random, 1, 12), {.spans = 3}, {.spans = 3});
      const Handle(Geom_BSplineSurface) occt = toOcct(surface);
      for (int k = 0; k < 20; ++k) {
        const double u = randomParameter(random, surface.domainU());
        const double v = randomParameter(random, surface.domainV());
        COMPARE_NEAR((toVec(occt->Value(u, v)) - point(surface, u, v)).norm(), 0, 1e-10);
      }
      const Surface back = fromOcct(occt);
      QVERIFY(back.knotsU == clamped(surface).knotsU);
      QVERIFY(back.knotsV == clamped(surface).knotsV);
      for (std::size_t k = 0; k < back.poles.size(); ++k)
        COMPARE_NEAR((back.poles[k] - clamped(surface).poles[k]).norm(), 0, 1e-11);
    }
  }
  void periodicSplinesAreUnwrapped() {
    const Handle(Geom_BSplineSurface) occt = toOcct(torusSurface(5, 2));
    occt->SetUPeriodic();
    occt->SetVPeriodic();
    const Surface back = fromOcct(occt);
    for (int i = 0; i <= 10; ++i)
      COMPARE_NEAR((point(back, 0.4 * i, 0.3 * i) - point(torusSurface(5, 2), 0.4 * i, 0.3 * i)).norm(), 0, 1e-12);
    QVERIFY(occt->IsUPeriodic());  // the given one stays as it was
  }
  void impossibleSplinesAreNamed() {
    Surface torus = torusSurface(5, 2);
    torus.poles[7].w() = 0;
    VERIFY_ERROR(toOcct(torus), ErrorCode::InvalidInput);
    torus.poles[7].w() = std::nan("");
    VERIFY_ERROR(toOcct(torus), ErrorCode::InvalidInput);
    VERIFY_ERROR(toOcct(elevateDegree(torusSurface(5, 2), 24, 0)), ErrorCode::InvalidInput);
    const Curve torn{1, {0, 0, 1, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {5, 0, 0, 1}, {6, 0, 0, 1}}};
    VERIFY_ERROR(toOcct(torn), ErrorCode::InvalidInput);
  }
  void facesOfClosedSurfacesHaveASeam() {
    for (const Surface& surface : {torusSurface(5, 2), torusOfDegree9x12(5, 2)}) {
      const TopoDS_Face face = toFace(surface);
      QVERIFY(isValid(face));
      QVERIFY(isValid(solidOf(face)));
      for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
        QVERIFY(BRep_Tool::IsClosed(TopoDS::Edge(edge.Current()), face));
    }
    Surface half = torusSurface(5, 2);  // open in v
    half.knotsV = {0, 0, 0, 1, 1, 2, 2, 2};
    std::vector<Vec4> poles;
    for (std::size_t i = 0; i < 9; ++i)
      poles.insert(poles.end(), half.poles.begin() + static_cast<std::ptrdiff_t>(i * 9),
                   half.poles.begin() + static_cast<std::ptrdiff_t>(i * 9 + 5));
    half.poles = poles;
    QVERIFY(isValid(toFace(half)));
    QCOMPARE(countOf(toFace(half), TopAbs_EDGE), std::size_t{4});
  }
  void regionBecomesExactFaces() {
    const Region region = plateWithHole();
    const TopoDS_Shape faces = toFaces(region);
    QVERIFY(isValid(faces));
    QCOMPARE(countOf(faces, TopAbs_FACE), std::size_t{2});
    QCOMPARE(countOf(faces, TopAbs_WIRE), std::size_t{3});
    QCOMPARE(countOf(faces, TopAbs_EDGE), std::size_t{6});
    const Measures m = measure(Brep(faces));
    COMPARE_NEAR(measured<double>(m, "area"), area(region), 1e-9);
    const double closedForm =
        60 + pi * 5 + pi * 4 - pi * 2.25;  // arcs in and out cancel; half ellipse pi 5 2 / 2; disc; hole
    COMPARE_NEAR(area(region), closedForm, 1e-9);
  }
  void wiresComeBackAsTheyWere() {
    const Curves given = toCurves(plateWithHole());
    const TopoDS_Shape wires = toWires(given);
    QVERIFY(isValid(wires));
    const Curves back = planarCurves(wires);
    QCOMPARE(back.paths.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY(back.paths[i].closed);
      COMPARE_NEAR(length(back.paths[i]), length(given.paths[i]), 1e-9);
      COMPARE_NEAR(signedArea(back.paths[i]), signedArea(given.paths[i]), 1e-9);
    }
    QCOMPARE(std::count_if(back.paths[0].segments.begin(), back.paths[0].segments.end(),
                           [](const Segment& s) { return std::holds_alternative<Arc2>(s); }),
             std::ptrdiff_t{2});
    QVERIFY(std::holds_alternative<Arc2>(back.paths[2].segments[0]));
  }
  void levelFacesOfASolid() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), 10.0, 10.0, 4.0).Shape();
    const TopoDS_Shape drilled =
        BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), 2, 9).Shape()).Shape();
    const Curves curves = planarCurves(drilled);
    QCOMPARE(curves.paths.size(), std::size_t{4});  // a square and a circle, above and below
    for (const Path& path : curves.paths) {
      QVERIFY(path.closed);
      const double size = std::abs(signedArea(path));
      QVERIFY(std::abs(size - 100) < 1e-9 || std::abs(size - 4 * pi) < 1e-9);
    }
  }
  void pathsOfNoLengthAreRefused() {
    const Path speck{{Line2{{1, 1}, {1, 1}}}, false, {}, {}};
    VERIFY_ERROR(toWires({{speck}, FillRule::EvenOdd}), ErrorCode::Degenerate);
  }
  void gapsAreBridgedByTolerantVertices() {
    Path loop = closedPolygon({{0, 0}, {1, 0}, {1, 1}});
    std::get<Line2>(loop.segments[1]).from.x() += 5e-5;
    QVERIFY(isValid(toFaces({{loop}})));
  }
  void closedMeshBecomesASolid() {
    const TopoDS_Shape box = toShape(boxMesh({1, 2, 3}, {2, 3, 4}));
    QCOMPARE(box.ShapeType(), TopAbs_SOLID);
    QVERIFY(isValid(box));
    const Measures m = measure(Brep(box));
    COMPARE_NEAR(measured<double>(m, "volume"), 24, 1e-11);
    QCOMPARE(measured<std::int64_t>(m, "edges"), std::int64_t{12});
    const Mesh torus = torusMesh(5, 2, 24, 12);
    const Measures t = measure(Brep(toShape(torus)));
    QCOMPARE(t.kind, std::string("solid"));
    QCOMPARE(measured<std::int64_t>(t, "genus"), std::int64_t{1});
    COMPARE_NEAR(measured<double>(t, "volume"), measured<double>(measure(torus), "volume"), 1e-9);
  }
  static Mesh inward(Mesh mesh) {
    for (std::size_t f = 0; f < mesh.faceCount(); ++f)
      std::reverse(mesh.faceVertices.begin() + mesh.faceStarts[f], mesh.faceVertices.begin() + mesh.faceStarts[f + 1]);
    return mesh;
  }
  static Mesh together(Mesh mesh, const Mesh& more) {
    for (std::size_t f = 0; f < more.faceCount(); ++f) {
      std::vector<int> face(more.face(f).begin(), more.face(f).end());
      for (int& v : face) v += static_cast<int>(mesh.points.size());
      mesh.addFace(face);
    }
    mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
    return mesh;
  }
  /// Hollows that touch their body in a corner, whichever corner their faces begin with.
  void hollowsThatTouchTheirBody() {
    for (int turn = 0; turn < 3; ++turn) {
      Mesh hollow;
      hollow.points = {{0, 0, 0}, {6, 2, 2}, {2, 6, 2}, {2, 2, 6}};
      const std::array<std::array<int, 3>, 4> faces{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
      for (std::array<int, 3> face : faces) {
        std::rotate(face.begin(), face.begin() + turn, face.end());
        hollow.addFace(face);
      }
      QVERIFY(signedVolume(hollow) < 0);
      const TopoDS_Shape solid = toShape(together(boxMesh({0, 0, 0}, {10, 10, 10}), hollow));
      QCOMPARE(countOf(solid, TopAbs_SOLID), std::size_t{1});
      COMPARE_NEAR(measured<double>(measure(Brep(solid)), "volume"), 1000 - 80. / 3, 1e-9);
    }
  }
  /// Shells in shells, as they are and all of them inside out.
  void bodiesInsideOutAreTurned() {
    const Mesh hollow = together(boxMesh({0, 0, 0}, {10, 10, 10}), inward(boxMesh({2, 2, 2}, {6, 6, 6})));
    const Mesh nested = together(together(hollow, boxMesh({3, 3, 3}, {4, 4, 4})), inward(boxMesh({4, 4, 4}, {1, 1, 1})));
    for (const auto& [mesh, volume, solids] :
         {std::tuple(hollow, 784., std::size_t{1}), std::tuple(nested, 784. + 63, std::size_t{2}),
          std::tuple(together(hollow, boxMesh({20, 0, 0}, {1, 1, 1})), 785., std::size_t{2})})
      for (const Mesh& given : {mesh, inward(mesh)}) {
        const TopoDS_Shape solid = toShape(given);
        QVERIFY(isValid(solid));
        QCOMPARE(countOf(solid, TopAbs_SOLID), solids);
        COMPARE_NEAR(measured<double>(measure(Brep(solid)), "volume"), volume, 1e-9);
      }
  }
  void hollowsAndOpenMeshes() {
    const TopoDS_Shape solid = toShape(together(boxMesh({0, 0, 0}, {10, 10, 10}), inward(boxMesh({3, 3, 3}, {2, 2, 2}))));
    QCOMPARE(countOf(solid, TopAbs_SOLID), std::size_t{1});
    QCOMPARE(countOf(solid, TopAbs_SHELL), std::size_t{2});
    QVERIFY(isValid(solid));
    COMPARE_NEAR(measured<double>(measure(Brep(solid)), "volume"), 992, 1e-9);
    const TopoDS_Shape turned = toShape(inward(boxMesh({0, 0, 0}, {1, 1, 1})));  // inside out: put right
    QCOMPARE(turned.ShapeType(), TopAbs_SOLID);
    Mesh open = boxMesh({0, 0, 0}, {1, 1, 1});
    open.faceStarts.pop_back();
    open.faceVertices.resize(20);
    QCOMPARE(toShape(open).ShapeType(), TopAbs_SHELL);
    VERIFY_ERROR(toShape(Mesh()), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(OcctConversionTest)
#include "occt_conversion_test.moc"
