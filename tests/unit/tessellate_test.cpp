#include "geometry/tessellate/tessellate.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax2.hxx>
#include <map>
#include <numbers>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "geometry/tessellate/face_mesh.h"
#include "support/solids.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

double torusDistance(const Vec3& p, double major, double minor) {
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) - minor);
}

/// Points of the triangles: corners, middles of the sides, centre.
template <class Visit>
void visitSamples(const Tessellation& t, const Visit& visit) {
  for (const auto& [a, b, c] : t.triangles) {
    const auto at = [&](int i) -> const Vec3& { return t.points[static_cast<std::size_t>(i)]; };
    visit((at(a) + at(b)) / 2);
    visit((at(b) + at(c)) / 2);
    visit((at(c) + at(a)) / 2);
    visit((at(a) + at(b) + at(c)) / 3);
  }
}

Vec3 triangleNormal(const Tessellation& t, std::size_t i) {
  const auto at = [&](int k) -> const Vec3& {
    return t.points[static_cast<std::size_t>(t.triangles[i][static_cast<std::size_t>(k)])];
  };
  return (at(1) - at(0)).cross(at(2) - at(0));
}

/// Triangles and normals look the same way, and normals have length one.
bool normalsAgree(const Tessellation& t) {
  for (const Vec3& n : t.normals)
    if (std::abs(n.norm() - 1) > 1e-12) return false;
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    const Vec3 normal = triangleNormal(t, i);
    for (const int p : t.triangles[i])
      if (normal.norm() > 1e-9 && normal.dot(t.normals[static_cast<std::size_t>(p)]) < 0.5 * normal.norm()) return false;
  }
  return true;
}

Path roundPath(const Vec2& center, double radius, double sweep) { return {{Arc2{center, radius, 0, sweep}}, true, {}, {}}; }

}  // namespace

class TessellateTest : public QObject {
  Q_OBJECT
 private slots:
  void closedSolidsGiveClosedMeshesOfTheirVolume() {
    const auto tool = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -9), gp_Dir(0, 0, 1)), 1, 18).Shape();
    struct Case {
      TopoDS_Shape shape;
      double volume, area;
      int genus;
    };
    const std::vector<Case> cases{
        {BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), 6, 22, 0},
        {BRepPrimAPI_MakeSphere(3).Shape(), 36 * pi, 36 * pi, 0},
        {BRepPrimAPI_MakeCylinder(2, 7).Shape(), 28 * pi, 36 * pi, 0},
        {BRepPrimAPI_MakeTorus(5, 2).Shape(), 40 * pi * pi, 40 * pi * pi, 1},
        {BRepPrimAPI_MakeCone(3, 0, 4).Shape(), 12 * pi, 24 * pi, 0},
        {solidOf(toFace(torusOfDegree9x12(5, 2))), 40 * pi * pi, 40 * pi * pi, 1},
        // a ball with a hole drilled through its centre
        {BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(3).Shape(), tool).Shape(), 4 * pi / 3 * std::pow(8, 1.5),
         4 * pi * 3 * std::sqrt(8.0) + 2 * pi * 2 * std::sqrt(8.0), 1}};
    for (const double chord : {0.1, 0.01}) {
      for (const Case& c : cases) {
        const Mesh mesh = meshOf(Brep(c.shape), {chord, 0.5});
        const Measures m = measure(mesh);
        QCOMPARE(measured<bool>(m, "closed"), true);
        QCOMPARE(measured<std::int64_t>(m, "genus"), std::int64_t{c.genus});
        QCOMPARE(measured<std::int64_t>(m, "components"), std::int64_t{1});
        // Nothing of the mesh is farther than the chord from the solid's skin.
        COMPARE_NEAR(measured<double>(m, "volume"), c.volume, chord * c.area);
      }
    }
  }
  /// At the tip the angle about the axis means nothing, so it must not count against the triangles there.
  void aConeWithItsTipNeedsNoMoreTrianglesThanOneWithoutIt() {
    const auto slopes = [](double tip) {
      return Brep(BRepPrimAPI_MakeCone(10, tip, 10 - tip).Shape());  // one slope, as far up as the radius `tip`
    };
    for (const double chord : {0.05, 0.01, 0.002}) {
      const Mesh whole = meshOf(slopes(0), {chord, 0.5}), cut = meshOf(slopes(0.1), {chord, 0.5});
      QVERIFY2(whole.faceCount() <= cut.faceCount() + cut.faceCount() / 10,
               qPrintable(QString("%1, %2").arg(whole.faceCount()).arg(cut.faceCount())));
      COMPARE_NEAR(signedVolume(whole), 1000 * pi / 3, chord * 100 * pi * (1 + std::sqrt(2.0)));
    }
  }
  /// Both have nodes at which a derivative is 0.
  void onlyATipCollapsesAParameter() {
    const auto collapsed = [](const TopoDS_Shape& shape) {
      const BRepMesh_IncrementalMesh mesher(shape, 0.01);
      std::map<Collapsed, int> counts;
      for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(face.Current()), location);
        const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()), Standard_False);
        for (const Collapsed each : collapsedParameters(*mesh, surface)) ++counts[each];
      }
      return counts;
    };
    auto cone = collapsed(BRepPrimAPI_MakeCone(10, 0, 10).Shape());
    QVERIFY(cone[Collapsed::U] > 0);
    QCOMPARE(cone[Collapsed::V], 0);
    Surface doubled{2, 1, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, {}};  // its first two rows of poles lie on one another
    for (const Vec2& p : {Vec2(0, 0), Vec2(0, 0), Vec2(4, 3)})
      for (const double y : {0.0, 5.0}) doubled.poles.emplace_back(p.x(), y, p.y(), 1);
    auto sheet = collapsed(toFace(doubled));
    QVERIFY(sheet[Collapsed::No] > 0);
    QCOMPARE(sheet[Collapsed::U] + sheet[Collapsed::V], 0);
  }
  void volumesConverge() {
    const Brep sphere(BRepPrimAPI_MakeSphere(3).Shape());
    const auto error = [&](double chord) { return std::abs(signedVolume(meshOf(sphere, {chord, 1})) / (36 * pi) - 1); };
    QVERIFY(error(0.001) < error(0.01) / 4);
    QVERIFY(error(0.001) < 1e-3);
  }
  void trianglesKeepTheChord() {
    for (const double chord : {0.2, 0.02, 0.002}) {
      const TessellationOptions options{chord, 1};
      for (const Shape& shape :
           {Shape(torusSurface(5, 2)), Shape(torusOfDegree9x12(5, 2)), Shape(Brep(BRepPrimAPI_MakeTorus(5, 2).Shape()))}) {
        const Tessellation t = tessellate(shape, options);
        double worst = 0;
        visitSamples(t, [&](const Vec3& p) { worst = std::max(worst, torusDistance(p, 5, 2)); });
        QVERIFY2(worst <= chord, qPrintable(QString("chord %1, error %2").arg(chord).arg(worst)));
        QVERIFY(normalsAgree(t));
        QCOMPARE(t.normals.size(), t.points.size());
      }
    }
  }
  void randomSurfacesKeepTheChord() {
    Random random = seededRandom();
    for (int i = 0; i < 6; ++i) {
      const Surface surface =
          randomSurface(random, uniformInt(random, 1, 5), uniformInt(random, 1, 5), {.spans = 3}, {.spans = 3}, 5);
      constexpr double chord = 0.05;
      const Tessellation t = tessellate(surface, {chord, 3});
      // From the other side: every point of the surface has a triangle nearby.
      const auto [u0, u1] = surface.domainU();
      const auto [v0, v1] = surface.domainV();
      for (int k = 0; k < 20; ++k) {
        const Vec3 p = point(surface, uniform(random, u0, u1), uniform(random, v0, v1));
        double minimum = 1e300;
        for (const auto& [a, b, c] : t.triangles) {
          const Vec3 &pa = t.points[static_cast<std::size_t>(a)], &pb = t.points[static_cast<std::size_t>(b)],
                     &pc = t.points[static_cast<std::size_t>(c)];
          minimum = std::min(minimum, distanceToTriangle(p, pa, pb, pc));
        }
        QVERIFY2(minimum <= chord, qPrintable(QString("distance %1").arg(minimum)));
      }
    }
  }
  /// z = x y: straight along x and along y, and yet its normal turns.
  void twistedSurfacesKeepTheAngle() {
    constexpr double half = 2;
    Surface saddle{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {}};
    for (const double x : {-half, half})
      for (const double y : {-half, half}) saddle.poles.emplace_back(x, y, x * y, 1);
    constexpr int count = 400;
    double expected = 0;  // of sqrt(1 + x^2 + y^2), by the midpoint rule
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < count; ++k)
        expected += std::hypot(1, 2 * half * (i + 0.5) / count - half, 2 * half * (k + 0.5) / count - half);
    expected *= 4 * half * half / count / count;
    for (const double chord : {1.0, 0.05}) {
      const Tessellation t = tessellate(saddle, {chord, 0.3});
      double area = 0, turn = 0;
      for (std::size_t i = 0; i < t.triangles.size(); ++i) {
        const Vec3 normal = triangleNormal(t, i);
        area += normal.norm() / 2;
        for (const int corner : t.triangles[i]) {
          const Vec3& exact = t.normals[static_cast<std::size_t>(corner)];
          turn = std::max(turn, std::atan2(normal.cross(exact).norm(), std::abs(normal.dot(exact))));
        }
      }
      QVERIFY2(std::abs(area - expected) < 0.02 * expected, qPrintable(QString("%1, not %2").arg(area).arg(expected)));
      QVERIFY2(turn < 0.5, qPrintable(QString::number(turn)));
    }
  }
  void closedSurfaceMeshesClose() {
    const Mesh mesh = meshOf(torusOfDegree9x12(5, 2), {0.01, 0.5});
    const Measures m = measure(mesh);
    QCOMPARE(measured<bool>(m, "closed"), true);
    QCOMPARE(measured<std::int64_t>(m, "genus"), std::int64_t{1});
    COMPARE_NEAR(measured<double>(m, "volume") / (40 * pi * pi), 1, 0.005);
    QVERIFY(tessellate(torusSurface(5, 2)).edges.empty());  // no seam is drawn
  }
  void kinksStaySharp() {
    // A roof of degree 1: two planes that meet at u = 1.
    Surface roof{1, 1, {0, 0, 1, 2, 2}, {0, 0, 1, 1}, {}};
    for (const Vec2& p : {Vec2(0, 0), Vec2(1, 1), Vec2(2, 0)})
      for (const double y : {0.0, 5.0}) roof.poles.emplace_back(p.x(), y, p.y(), 1);
    const Tessellation t = tessellate(roof);
    for (const Vec3& n : t.normals) COMPARE_NEAR(std::abs(n.x()), std::sqrt(0.5), 1e-12);
    QCOMPARE(t.edges.size(), std::size_t{4});
  }
  void facesOfASolidAreDrawnFlat() {
    Mesh bend;  // two triangles that turn by far less than 30 degrees
    bend.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, -0.1}};
    bend.addFace(std::vector<int>{0, 1, 2});
    bend.addFace(std::vector<int>{1, 3, 2});
    QCOMPARE(tessellate(bend).points.size(), std::size_t{4});
    bend.flatFaces = true;
    const Tessellation t = tessellate(bend);
    QCOMPARE(t.points.size(), std::size_t{6});
    for (const auto& triangle : t.triangles) {
      const auto at = [&](int k) { return t.points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])]; };
      const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
      for (const int corner : triangle)
        COMPARE_NEAR((t.normals[static_cast<std::size_t>(corner)] - normal).norm(), 0, 1e-15);
    }
  }
  void facesKeepTheirIndexAndColor() {
    auto part = std::make_shared<BrepPart>();
    part->shape = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    part->color = Color{0, 0, 1};
    TopExp_Explorer face(part->shape, TopAbs_FACE);
    part->subShapeColors.emplace_back(face.Current(), Color{1, 0, 0});
    gp_Trsf aside, mirror;
    aside.SetTranslation(gp_Vec(5, 0, 0));
    mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, -3), gp_Dir(0, 0, 1)));
    const Brep assembly(
        std::vector<BrepInstance>{{"a", {}, gp_Trsf(), part}, {"b", Color{0, 1, 0}, aside, part}, {"c", {}, mirror, part}});
    const Tessellation t = tessellate(assembly);
    QCOMPARE(t.faceColors.size(), std::size_t{18});
    QVERIFY(t.faceColors[0] == (Color{1, 0, 0}));
    QVERIFY(t.faceColors[1] == (Color{0, 0, 1}));
    QVERIFY(t.faceColors[7] == (Color{0, 1, 0}));
    QCOMPARE(t.triangles.size(), std::size_t{36});
    QCOMPARE(*std::max_element(t.faceOfTriangle.begin(), t.faceOfTriangle.end()), 17);
    QCOMPARE(t.edges.size(), std::size_t{36});
    QVERIFY(normalsAgree(t));
    COMPARE_NEAR(measured<double>(measure(toMesh(t)), "volume"), 3, 1e-12);  // the mirrored one is not inside out
  }
  void theShapeItselfStaysUntouched() {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(3).Shape();
    tessellate(Brep(sphere));
    TopLoc_Location location;
    QVERIFY(BRep_Tool::Triangulation(TopoDS::Face(TopExp_Explorer(sphere, TopAbs_FACE).Current()), location).IsNull());
  }
  void regionsAreTriangulatedFlat() {
    const Path plate{
        {Line2{{0, 0}, {10, 0}}, Line2{{10, 0}, {10, 10}}, Line2{{10, 10}, {0, 10}}, Line2{{0, 10}, {0, 0}}}, true, {}, {}};
    const Region region{{plate, roundPath({5, 5}, 2, -2 * pi), roundPath({20, 0}, 1, 2 * pi)}};
    const Tessellation t = tessellate(region, {0.001, 0.5});
    QVERIFY(t.normals.empty());
    QCOMPARE(t.edges.size(), std::size_t{6});  // the segments
    QCOMPARE(t.edgeIndices, (std::vector<int>{0, 1, 2, 3, 4, 5}));
    QVERIFY(t.vertices[2] == Vec3(10, 10, 0) && t.edges[2].front() == t.vertices[2]);
    QCOMPARE(*std::max_element(t.faceOfTriangle.begin(), t.faceOfTriangle.end()), 0);
    double total = 0;
    for (std::size_t i = 0; i < t.triangles.size(); ++i) {
      QVERIFY(triangleNormal(t, i).z() > 0);
      total += triangleNormal(t, i).z() / 2;
    }
    COMPARE_NEAR(total, area(region), 0.001 * 6 * pi);
  }
  void overlappingPartsOfARegionAreFilledEach() {
    // What a drawing filled by the non-zero rule becomes.
    const auto filled = [](const Region& region) {
      const Tessellation t = tessellate(region, {0.001, 0.5});
      double total = 0;
      for (std::size_t i = 0; i < t.triangles.size(); ++i) total += triangleNormal(t, i).z() / 2;
      return total;
    };
    const Region discs{{roundPath({0, 0}, 2, 2 * pi), roundPath({1, 0}, 2, 2 * pi), roundPath({1, 0}, 0.5, -2 * pi)}};
    COMPARE_NEAR(filled(discs), (4 + 4 - 0.25) * pi, 0.001 * 9 * pi);
  }
  void drawingsBecomePolylines() {
    const Tessellation t = tessellate(Curves{{roundPath({0, 0}, 2, 2 * pi)}, FillRule::EvenOdd}, {0.01, 0.5});
    QCOMPARE(t.edges.size(), std::size_t{1});
    QVERIFY(t.edges[0].front() == t.edges[0].back());
    const Curve ring = toCurve(ellipticArc({0, 0}, {2, 0}, 1, 0, 2 * pi));
    const Tessellation line = tessellate(ring, {0.01, 0.5});
    for (std::size_t i = 0; i + 1 < line.edges[0].size(); ++i)
      QVERIFY(((line.edges[0][i] + line.edges[0][i + 1]) / 2).norm() >= 2 - 0.01);
    VERIFY_ERROR(meshOf(ring), ErrorCode::InvalidInput);
  }
  void drawingsKeepTheColoursOfTheirOutlines() {
    const auto ring = [](std::optional<Color> color) {
      Path path = roundPath({0, 0}, 2, pi);
      path.segments.emplace_back(Line2{endPoint(path), startPoint(path)});
      path.color = color;
      return path;
    };
    const auto colorsOf = [](const std::vector<Path>& paths) {
      return tessellate(Curves{paths, FillRule::EvenOdd}).edgeColors;
    };
    const Color red{1, 0, 0}, blue{0, 0, 1}, black{0, 0, 0}, white{1, 1, 1};
    const std::vector<Color> colors = colorsOf({ring(red), ring(std::nullopt), ring(blue)});
    QCOMPARE(colors.size(), std::size_t{6});  // one for each segment
    QVERIFY(colors[0] == red && colors[1] == red && colors[4] == blue && colors[5] == blue);
    QVERIFY(colors[2].red == colors[3].red && colors[2].red > 0.3 && colors[2].red < 0.7);  // grey, seen on either canvas
    // Black and white are the ink of a paper, which is here the canvas's own.
    QVERIFY(colorsOf({ring(black), ring(white), ring(std::nullopt)}).empty());
    const std::vector<Color> beside = colorsOf({ring(black), ring(red)});
    QVERIFY(beside.size() == 4 && beside[0].red > 0.3);
  }
  void drawingsAreFinerThanSurfacesByThemselves() {
    const auto worst = [](const Tessellation& t) {
      double depth = 0;
      for (const auto& line : t.edges)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
          depth = std::max(depth, 2 - ((line[i] + line[i + 1]) / 2).head<2>().norm());
      return depth;
    };
    const Path ring = roundPath({0, 0}, 2, 2 * pi);
    const double size = 4 * std::sqrt(2.0);
    const TessellationOptions byItself{0, 0.5};
    const Region disc{{ring}};
    for (const Shape& shape :
         {Shape(disc), Shape(Curves{{ring}, FillRule::EvenOdd}), Shape(toCurve(ellipticArc({0, 0}, {2, 0}, 1, 0, 2 * pi))),
          Shape(Sequence{{disc, disc}, {0, 1}})}) {
      const Tessellation t = tessellate(shape, byItself);
      QVERIFY(!t.edges.empty() && worst(t) > 0 && worst(t) <= size / 8000);
      if (t.triangles.empty()) continue;
      // The fill has the corners of its outline.
      double filled = 0;
      for (std::size_t i = 0; i < t.triangles.size(); ++i) filled += triangleNormal(t, i).z() / 2;
      COMPARE_NEAR(filled, 4 * pi, 4 * pi * size / 8000);
    }
    const Tessellation cylinder = tessellate(Brep(BRepPrimAPI_MakeCylinder(2, 1).Shape()), {0, 3});
    QVERIFY(worst(cylinder) > size / 8000);
  }
  void cancelledWorkStops() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(tessellate(torusSurface(5, 2), {}, Progress(token)), ErrorCode::Cancelled);
    VERIFY_ERROR(tessellate(Brep(BRepPrimAPI_MakeSphere(3).Shape()), {}, Progress(token)), ErrorCode::Cancelled);
  }
  void badOptionsAreRefused() {
    VERIFY_ERROR(tessellate(torusSurface(5, 2), {-1, 0.5}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(tessellate(torusSurface(5, 2), {0.1, 0}), ErrorCode::InvalidParameter);
  }

 private:
  /// Ericson, Real-Time Collision Detection, 5.1.5, by way of projections on plane and sides.
  static double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto toSegment = [&](const Vec3& from, const Vec3& to) {
      const Vec3 along = to - from;
      const double t = along.squaredNorm() > 0 ? std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
      return (p - from - t * along).norm();
    };
    const double sides = std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
    const Vec3 normal = (b - a).cross(c - a);
    if (!(normal.norm() > 0)) return sides;
    const bool inside = normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                        normal.dot((a - c).cross(p - c)) >= 0;
    return inside ? std::abs((p - a).dot(normal.normalized())) : sides;
  }
};

BLOSSOM_TEST(TessellateTest)
#include "tessellate_test.moc"
