#include "geometry/measure/measure_between.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Eigen/Geometry>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <thread>

#include "geometry/mesh/triangle_distance.h"
#include "geometry/planar/planar.h"
#include "geometry/tessellate/tessellate.h"
#include "support/solids.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

std::optional<double> figure(const Measurement& m, const std::string& name) {
  for (const Measure& value : m.values)
    if (value.name == name) return std::get<double>(value.value);
  return std::nullopt;
}
double distance(const Shape& a, const Shape& b) { return *figure(measureBetween({a}, {b}), "distance"); }
Shape brep(const TopoDS_Shape& shape) { return Shape(Brep(shape)); }
Shape moved(const TopoDS_Shape& shape, const Vec3& by, const Vec3& axis = Vec3::UnitZ(), double angle = 0) {
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(axis.x(), axis.y(), axis.z())), angle);
  shift.SetTranslation(gp_Vec(by.x(), by.y(), by.z()));
  return brep(BRepBuilderAPI_Transform(shape, shift * turn, Standard_True).Shape());
}
Shape vertex(const Vec3& p) { return brep(BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Vertex()); }
Shape line(const Vec3& a, const Vec3& b) {
  return brep(BRepBuilderAPI_MakeEdge(gp_Pnt(a.x(), a.y(), a.z()), gp_Pnt(b.x(), b.y(), b.z())).Edge());
}
Shape square(const Vec3& centre, const Vec3& normal, double half) {
  const gp_Pln plane(gp_Pnt(centre.x(), centre.y(), centre.z()), gp_Dir(normal.x(), normal.y(), normal.z()));
  return brep(BRepBuilderAPI_MakeFace(plane, -half, half, -half, half).Face());
}
MeasuredPart face(const Shape& shape, int index = 0) { return {shape, SubShapeKind::Face, index}; }
MeasuredPart edge(const Shape& shape, int index = 0) { return {shape, SubShapeKind::Edge, index}; }

}  // namespace

class MeasureBetweenTest : public QObject {
  Q_OBJECT
 private slots:
  void figuresOfOnePart();
  void splinesAreKnownForCirclesAndPlanes();
  void partsOfDrawingsAndMeshes();
  void primitivesApart();
  void touchingAndInterpenetrating();
  void anglesAndParallels();
  void ellipsesAgainstClosedForm();
  void randomSegmentsAndTriangles();
  void randomPrimitivesAgainstThePeer();
  void ringsOfSplinesAgainstTheirCircles();
  void freeFormAgainstItsTriangles();
  void meshesAgainstExactShapes();
  void whatIsNotThereIsSaid();
  void itCanBeCancelled();

 private:
  std::mt19937_64 random_ = seededRandom();
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
};

void MeasureBetweenTest::figuresOfOnePart() {
  const Shape cylinder = brep(BRepPrimAPI_MakeCylinder(3, 10).Shape());
  const Measurement side = measureOne(face(cylinder));
  QCOMPARE(side.kind, std::string("diameter"));
  COMPARE_NEAR(*figure(side, "diameter"), 6, 1e-12);
  COMPARE_NEAR(*figure(side, "radius"), 3, 1e-12);
  COMPARE_NEAR(*figure(side, "area"), 60 * pi, 1e-9);
  COMPARE_NEAR(*figure(side, "perimeter"), 12 * pi, 1e-9);
  COMPARE_NEAR((side.lines[0][0] - side.lines[0][1]).norm(), 6, 1e-12);

  const Shape sphere = moved(BRepPrimAPI_MakeSphere(4).Shape(), {1, 2, 3});
  const Measurement ball = measureOne(face(sphere));
  COMPARE_NEAR(*figure(ball, "diameter"), 8, 1e-12);
  COMPARE_NEAR(*figure(ball, "center_y"), 2, 1e-12);
  COMPARE_NEAR(*figure(ball, "area"), 64 * pi, 1e-9);
  QVERIFY(!figure(ball, "perimeter"));
  const Measurement whole = measureOne({sphere});
  QCOMPARE(whole.kind, std::string("volume"));
  COMPARE_NEAR(*figure(whole, "size_x"), 8, 1e-6);

  const Measurement ring = measureOne(face(brep(BRepPrimAPI_MakeTorus(7, 2).Shape())));
  COMPARE_NEAR(*figure(ring, "major_radius"), 7, 1e-12);
  COMPARE_NEAR(*figure(ring, "area"), 4 * pi * pi * 14, 1e-8);
  COMPARE_NEAR(*figure(measureOne(face(brep(BRepPrimAPI_MakeCone(4, 1, 3).Shape()))), "half_angle"), 45, 1e-12);

  const Measurement arc =
      measureOne({brep(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(1, 0, 5), gp_Dir(0, 1, 0)), 6), 0.2, 1.7).Edge()),
                  SubShapeKind::Edge, 0});
  QCOMPARE(arc.kind, std::string("radius"));
  COMPARE_NEAR(*figure(arc, "radius"), 6, 1e-12);
  COMPARE_NEAR(*figure(arc, "length"), 9, 1e-10);
  COMPARE_NEAR(*figure(arc, "angle"), 1.5 * 180 / pi, 1e-10);
  COMPARE_NEAR(*figure(arc, "center_z"), 5, 1e-12);
  COMPARE_NEAR(*figure(measureOne({line({1, 2, 3}, {4, 6, 15}), SubShapeKind::Edge, 0}), "length"), 13, 1e-12);
  COMPARE_NEAR(*figure(measureOne({vertex({1, 2, 3}), SubShapeKind::Vertex, 0}), "z"), 3, 0);
}

void MeasureBetweenTest::splinesAreKnownForCirclesAndPlanes() {
  Curve circle{2, circleKnots, {}};
  for (const Vec3& pole : circlePoles(0, 5)) circle.poles.emplace_back(pole.x(), pole.y(), 2 * pole.z(), pole.z());
  const Measurement round = measureOne({Shape(circle), SubShapeKind::Edge, 0});
  QCOMPARE(round.kind, std::string("diameter"));
  COMPARE_NEAR(*figure(round, "diameter"), 10, 1e-9);
  COMPARE_NEAR(*figure(round, "center_z"), 2, 1e-9);
  COMPARE_NEAR(*figure(round, "length"), 10 * pi, 1e-9);
  const Surface flat{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0, 1}, {0, 4, 4, 1}, {3, 0, 0, 1}, {3, 4, 4, 1}}};
  const Measurement slope = measureBetween(face(Shape(flat)), face(square({0, 0, -10}, {0, 0, 1}, 1)));
  COMPARE_NEAR(*figure(slope, "angle"), 45, 1e-9);
}

void MeasureBetweenTest::partsOfDrawingsAndMeshes() {
  const Path outline{
      {Line2{{0, 0}, {8, 0}}, Arc2{{8, 3}, 3, -pi / 2, pi}, Line2{{8, 6}, {0, 6}}, Line2{{0, 6}, {0, 0}}}, true, {}, {}};
  const Shape region(Region{{outline}});
  COMPARE_NEAR(*figure(measureOne(edge(region, 1)), "radius"), 3, 1e-12);
  COMPARE_NEAR(*figure(measureOne(edge(region, 1)), "angle"), 180, 1e-9);
  COMPARE_NEAR(*figure(measureOne(face(region)), "area"), 48 + 4.5 * pi, 1e-9);
  COMPARE_NEAR(*figure(measureOne({region, SubShapeKind::Vertex, 2}), "y"), 6, 1e-12);
  COMPARE_NEAR(*figure(measureBetween(edge(region, 0), edge(region, 2)), "distance"), 6, 1e-12);
  const Measurement corner = measureBetween(edge(region, 0), edge(region, 3));
  QCOMPARE(corner.kind, std::string("angle"));
  COMPARE_NEAR(*figure(corner, "angle"), 90, 1e-12);
  const Shape drawing(Curves{{outline}, FillRule::EvenOdd});
  COMPARE_NEAR(*figure(measureBetween(edge(drawing, 1), edge(drawing, 3)), "distance"), 8, 1e-9);

  const Shape box(boxMesh({0, 0, 0}, {2, 3, 4}));
  COMPARE_NEAR(*figure(measureOne(face(box, 0)), "area"), 6, 1e-12);
  COMPARE_NEAR(*figure(measureOne(face(box, 0)), "perimeter"), 10, 1e-12);
  COMPARE_NEAR(*figure(measureOne({box, SubShapeKind::Vertex, 7}), "z"), 4, 0);
  const Measurement across = measureBetween(face(box, 0), face(box, 1));
  COMPARE_NEAR(*figure(across, "distance"), 4, 1e-12);
  COMPARE_NEAR(*figure(across, "plane_distance"), 4, 1e-12);
  COMPARE_NEAR(*figure(across, "angle"), 0, 1e-12);
}

void MeasureBetweenTest::primitivesApart() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), 2, 2, 2).Shape();
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(2).Shape();
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(6, 1).Shape();
  COMPARE_NEAR(distance(brep(box), moved(box, {5, 0, 0})), 3, 1e-12);
  COMPARE_NEAR(distance(brep(box), moved(box, {5, 6, 7})), std::sqrt(9.0 + 16 + 25), 1e-12);
  COMPARE_NEAR(distance(brep(box), moved(sphere, {3, 4, 12}, {1, 2, 3}, 0.7)), std::sqrt(4.0 + 9 + 121) - 2, 1e-10);
  COMPARE_NEAR(distance(brep(sphere), moved(sphere, {3, 4, 12}, {1, 2, 3}, 0.7)), 9, 1e-10);
  COMPARE_NEAR(distance(brep(torus), moved(sphere, {0.5, 0, 0}, {1, 0, 1}, 1)), 6 - 1 - 2.5, 1e-10);
  // A ball of radius 2 at (6, 0, 9): the nearest circle of the tube is around (6, 0, 0).
  COMPARE_NEAR(distance(brep(torus), moved(sphere, {6, 0, 9}, {1, 1, 1}, 2)), 6, 1e-10);
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1)), 1, 40).Shape();
  COMPARE_NEAR(distance(brep(rod), moved(rod, {0, 7, 0}, {0, 1, 0}, pi / 3)), 5, 1e-10);
  COMPARE_NEAR(distance(brep(rod), moved(rod, {3, 4, 0})), 3, 1e-10);
  COMPARE_NEAR(distance(brep(rod), brep(torus)), 4, 1e-10);
  const Measurement middle = measureBetween(face(square({0, 0, 0}, {0, 0, 1}, 5)), face(square({1, 0, 3}, {0, 0, 1}, 5)));
  COMPARE_NEAR(*figure(middle, "distance"), 3, 1e-12);
  // Of all equally near points those in the middle: at most one step of samples away.
  QVERIFY((middle.label - Vec3(0.5, 0, 1.5)).norm() < 1.3);
}

void MeasureBetweenTest::touchingAndInterpenetrating() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), 2, 2, 2).Shape();
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(2).Shape();
  COMPARE_NEAR(distance(brep(box), moved(box, {2, 0.3, 0.1})), 0, 0);                  // a common side
  COMPARE_NEAR(distance(brep(box), moved(box, {2, 2, 2})), 0, 0);                      // a common corner
  COMPARE_NEAR(distance(brep(box), moved(box, {1, 0.5, 0.5})), 0, 1e-7);               // crossing
  COMPARE_NEAR(distance(brep(box), moved(sphere, {3, 0, 0}, {1, 1, 0}, 1)), 0, 1e-7);  // tangent
  COMPARE_NEAR(distance(brep(sphere), moved(sphere, {4, 0, 0}, {0, 1, 0}, pi / 2)), 0, 1e-7);
  const TopoDS_Shape small = BRepPrimAPI_MakeSphere(0.2).Shape();
  COMPARE_NEAR(distance(brep(box), brep(small)), 0, 0);  // inside a solid
  // A face is no solid: from its inside there is a distance.
  COMPARE_NEAR(*figure(measureBetween(face(brep(sphere)), {brep(small)}), "distance"), 1.8, 1e-10);
  // A plate through a ball's bulge, far from its seam and poles.
  const Shape plate = square({0, -1.9, 0}, {0, 1, 0}, 9);
  COMPARE_NEAR(*figure(measureBetween(face(brep(sphere)), face(plate)), "distance"), 0, 1e-9);
  const Shape mesh(boxMesh({-1, -1, -1}, {2, 2, 2}));
  COMPARE_NEAR(distance(mesh, Shape(boxMesh({-0.1, -0.1, -0.1}, {0.2, 0.2, 0.2}))), 0, 0);
  COMPARE_NEAR(distance(mesh, brep(small)), 0, 0);
  COMPARE_NEAR(distance(mesh, Shape(boxMesh({0.5, 0.5, 0.5}, {2, 2, 2}))), 0, 1e-12);
  COMPARE_NEAR(distance(mesh, Shape(boxMesh({1, -3, -3}, {6, 6, 6}))), 0, 1e-12);
}

void MeasureBetweenTest::anglesAndParallels() {
  const Shape a = line({0, 0, 0}, {10, 0, 0});
  const Measurement corner = measureBetween(edge(a), edge(line({0, 0, 0}, {-3, 3, 0})));
  QCOMPARE(corner.kind, std::string("angle"));
  COMPARE_NEAR(*figure(corner, "angle"), 135, 1e-10);
  COMPARE_NEAR(*figure(corner, "distance"), 0, 0);
  QCOMPARE(corner.lines.size(), std::size_t{2});
  const Measurement skew = measureBetween(edge(a), edge(line({2, -5, 4}, {2, 5, 4})));
  QCOMPARE(skew.kind, std::string("distance"));
  COMPARE_NEAR(*figure(skew, "distance"), 4, 1e-12);
  COMPARE_NEAR(*figure(skew, "delta_z"), 4, 1e-12);
  COMPARE_NEAR(*figure(skew, "angle"), 90, 1e-12);
  const Measurement beside = measureBetween(edge(a), edge(line({20, 3, 4}, {50, 3, 4})));
  COMPARE_NEAR(*figure(beside, "axis_distance"), 5, 1e-12);
  COMPARE_NEAR(*figure(beside, "distance"), std::sqrt(125.0), 1e-12);
  COMPARE_NEAR(*figure(beside, "angle"), 0, 1e-12);
  for (const double t : {0.0, 20.0, 45.0, 90.0}) {
    const Vec3 tilted(0, std::sin(t * pi / 180), std::cos(t * pi / 180));
    const Measurement planes = measureBetween(face(square({0, 0, 0}, {0, 0, 1}, 1)), face(square({0, 0, 9}, tilted, 1)));
    COMPARE_NEAR(*figure(planes, "angle"), t, 1e-9);
    QCOMPARE(figure(planes, "plane_distance").has_value(), t == 0);
    const Measurement pierced =
        measureBetween(edge(line({0, 0, 9}, Vec3(0, 0, 9) + tilted)), face(square({}, {0, 0, 1}, 1)));
    COMPARE_NEAR(*figure(pierced, "angle"), 90 - t, 1e-9);
  }
  const Shape rod = brep(BRepPrimAPI_MakeCylinder(1, 10).Shape());
  const Shape other = moved(BRepPrimAPI_MakeCylinder(2, 4).Shape(), {6, 8, 30});
  const Measurement axes = measureBetween(face(rod), face(other));
  COMPARE_NEAR(*figure(axes, "axis_distance"), 10, 1e-12);
  COMPARE_NEAR(*figure(axes, "distance"), std::sqrt(49.0 + 400), 1e-10);
  const Measurement balls = measureBetween(face(brep(BRepPrimAPI_MakeSphere(1).Shape())),
                                           face(moved(BRepPrimAPI_MakeSphere(2).Shape(), {2, 3, 6})));
  COMPARE_NEAR(*figure(balls, "center_distance"), 7, 1e-12);
  COMPARE_NEAR(*figure(balls, "distance"), 4, 1e-10);
}

// The nearest point of an ellipse solves a quartic; here it is found by bisection of its monotone form (Eberly).
void MeasureBetweenTest::ellipsesAgainstClosedForm() {
  const double major = 9, minor = 2;
  const Shape ellipse = brep(BRepBuilderAPI_MakeEdge(gp_Elips(gp_Ax2(gp_Pnt(), gp_Dir(0, 0, 1)), major, minor)).Edge());
  COMPARE_NEAR(*figure(measureOne(edge(ellipse)), "major_radius"), major, 1e-12);
  for (int i = 0; i < 40; ++i) {
    const Vec2 p(uniform(-15, 15), uniform(-8, 8));
    const double y0 = std::abs(p.x()), y1 = std::abs(p.y());
    const auto outside = [&](double t) {
      const double x = major * y0 / (t + major * major), y = minor * y1 / (t + minor * minor);
      return x * x + y * y > 1;
    };
    double low = -minor * minor, high = low + major * std::hypot(y0, y1) + 100;
    for (int k = 0; k < 200; ++k) (outside((low + high) / 2) ? low : high) = (low + high) / 2;
    const Vec2 foot(major * major * y0 / (low + major * major), minor * minor * y1 / (low + minor * minor));
    COMPARE_NEAR(distance(ellipse, vertex({p.x(), p.y(), 0})), (foot - Vec2(y0, y1)).norm(), 1e-9);
  }
}

void MeasureBetweenTest::randomSegmentsAndTriangles() {
  for (int i = 0; i < 60; ++i) {
    const Vec3 a0 = vector(5), a1 = vector(5), b0 = vector(5), b1 = vector(5);
    double brute = 1e9;
    constexpr int steps = 400;
    for (int s = 0; s <= steps; ++s) {
      const Vec3 p = a0 + (a1 - a0) * s / steps, along = b1 - b0;
      const double t = std::clamp((p - b0).dot(along) / along.squaredNorm(), 0.0, 1.0);
      brute = std::min(brute, (p - b0 - t * along).norm());
    }
    const double exact = distance(line(a0, a1), line(b0, b1));
    COMPARE_NEAR(closestOnSegments(a0, a1, b0, b1).distance(), exact, 1e-10);
    QVERIFY(exact <= brute + 1e-12 && exact >= brute - (a1 - a0).norm() / steps);
  }
  for (int i = 0; i < 60; ++i) {
    const Triangle3 a{vector(3), vector(3), vector(3)}, b{vector(3), vector(3), vector(3)};
    const double exact = closestOnTriangles(a, b).distance();
    double brute = 1e9;
    for (int s = 0; s <= 30; ++s)
      for (int t = 0; s + t <= 30; ++t) {
        const Vec3 p = a[0] + (a[1] - a[0]) * s / 30 + (a[2] - a[0]) * t / 30;
        brute = std::min(brute, (p - closestOnTriangle(p, b)).norm());
      }
    const double step = ((a[1] - a[0]).norm() + (a[2] - a[0]).norm()) / 30;
    QVERIFY(exact <= brute + 1e-12 && exact >= brute - step);
  }
}

void MeasureBetweenTest::randomPrimitivesAgainstThePeer() {
  const std::vector<TopoDS_Shape> shapes{BRepPrimAPI_MakeBox(gp_Pnt(-1, -2, -3), 2, 4, 6).Shape(),
                                         BRepPrimAPI_MakeCylinder(2, 5).Shape(), BRepPrimAPI_MakeSphere(2).Shape(),
                                         BRepPrimAPI_MakeCone(3, 1, 4).Shape(), BRepPrimAPI_MakeTorus(4, 1).Shape()};
  for (const TopoDS_Shape& a : shapes)
    for (const TopoDS_Shape& b : shapes) {
      const Shape other = moved(b, vector(1).normalized() * uniform(3, 14), vector(1).normalized(), uniform(0, 6));
      const Measurement found = measureBetween({brep(a)}, {other});
      const double mine = *figure(found, "distance");
      const BRepExtrema_DistShapeShape peer(a, other.get<Brep>()->shape());
      QVERIFY(peer.IsDone());
      QVERIFY2(mine <= peer.Value() + 1e-7,
               qPrintable(QString("%1 > %2").arg(mine, 0, 'g', 17).arg(peer.Value(), 0, 'g', 17)));
      // The feet lie on both, so the distance is never too small.
      if (mine > 0)
        for (int end = 0; end < 2; ++end) {
          const Vec3& foot = end == 0 ? found.lines[0].front() : found.lines[0].back();
          const BRepExtrema_DistShapeShape on(BRepBuilderAPI_MakeVertex(gp_Pnt(foot.x(), foot.y(), foot.z())).Vertex(),
                                              end == 0 ? a : other.get<Brep>()->shape());
          COMPARE_NEAR(on.Value(), 0, 1e-7);
        }
    }
}

void MeasureBetweenTest::ringsOfSplinesAgainstTheirCircles() {
  // Two rings are as far apart as the circles in their middle, less both thicknesses; splines have seams where they close.
  constexpr double major = 5, minor = 2;
  const TopoDS_Shape ring = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(major, minor).Shape()).Shape();
  const auto onCircle = [&](double t) -> Vec3 { return {major * std::cos(t), major * std::sin(t), 0}; };
  for (int i = 0; i < 40; ++i) {
    const Vec3 axis = vector(1).normalized(), by(uniform(16, 20), uniform(0, 8), uniform(0, 8));
    const double angle = uniform(0, 2 * pi);
    const Eigen::AngleAxisd turn(angle, axis);
    const auto fromFirst = [&](double t) {
      const Vec3 p = turn * onCircle(t) + by;
      return std::hypot(p.head<2>().norm() - major, p.z());
    };
    constexpr int steps = 2000;
    int nearest = 0;
    for (int k = 1; k < steps; ++k)
      if (fromFirst(2 * pi * k / steps) < fromFirst(2 * pi * nearest / steps)) nearest = k;
    double low = 2 * pi * (nearest - 1) / steps, high = 2 * pi * (nearest + 1) / steps;
    for (int k = 0; k < 60; ++k) {
      const double third = (high - low) / 3;
      if (fromFirst(low + third) < fromFirst(high - third))
        high -= third;
      else
        low += third;
    }
    const double expected = fromFirst((low + high) / 2) - 2 * minor;
    COMPARE_NEAR(distance(brep(ring), moved(ring, by, axis, angle)), expected, 1e-9);
  }
}

void MeasureBetweenTest::freeFormAgainstItsTriangles() {
  const Surface torus = torusOfDegree9x12(8, 2);
  for (int i = 0; i < 4; ++i) {
    const Vec3 p = vector(12);
    const double exact = std::abs(std::hypot(std::hypot(p.x(), p.y()) - 8, p.z()) - 2);
    COMPARE_NEAR(distance(Shape(torus), vertex(p)), exact, 1e-9);
  }
  for (int i = 0; i < 6; ++i) {
    Surface wave{3, 3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {}}, other = wave;
    for (int u = 0; u < 5; ++u)
      for (int v = 0; v < 5; ++v) {
        const double w = uniform(0.6, 1.6);
        wave.poles.push_back(w * Vec4(u * 4.0, v * 4.0, uniform(-2, 2), 1));
        other.poles.emplace_back(u * 4.0, v * 4.0, uniform(6, 10), 1);
      }
    const Shape a(wave), b(other);
    TessellationOptions fine;
    fine.chord = 1e-3;
    const auto tree = [&](const Shape& shape) {
      const Tessellation t = tessellate(shape, fine);
      std::vector<Triangle3> triangles;
      for (const auto& [x, y, z] : t.triangles)
        triangles.push_back({t.points[std::size_t(x)], t.points[std::size_t(y)], t.points[std::size_t(z)]});
      return TriangleTree(triangles);
    };
    COMPARE_NEAR(distance(a, b), tree(a).closest(tree(b), Progress::none()).distance(), 2 * fine.chord);
  }
}

void MeasureBetweenTest::meshesAgainstExactShapes() {
  const Shape mesh(boxMesh({-1, -1, -1}, {2, 2, 2}));
  const Shape ball = moved(BRepPrimAPI_MakeSphere(2).Shape(), {3, 4, 12}, {1, 2, 3}, 0.7);
  COMPARE_NEAR(distance(mesh, ball), std::sqrt(4.0 + 9 + 121) - 2, 1e-9);
  COMPARE_NEAR(distance(ball, mesh), std::sqrt(4.0 + 9 + 121) - 2, 1e-9);
  const Mesh ring = torusMesh(8, 2, 200, 80);
  // The nearest triangle to the axis holds a vertex or an edge on the inner circle.
  COMPARE_NEAR(distance(Shape(ring), line({0, 0, -9}, {0, 0, 9})), 6 * std::cos(pi / 200), 1e-9);
  const Measurement feet = measureBetween({Shape(ring)}, {line({0, 0, -9}, {0, 0, 9})});
  COMPARE_NEAR(feet.lines[0].back().head<2>().norm(), 0, 1e-9);
}

void MeasureBetweenTest::whatIsNotThereIsSaid() {
  const Shape box = brep(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  VERIFY_ERROR(measureOne(edge(box, 12)), ErrorCode::NotFound);
  VERIFY_ERROR(measureOne(edge(Shape(Region{}), 0)), ErrorCode::NotFound);
  VERIFY_ERROR(measureOne({Shape()}), ErrorCode::InvalidInput);
  VERIFY_ERROR(measureOne({Shape(Sequence{})}), ErrorCode::InvalidInput);
  VERIFY_ERROR(measureOne({Shape(boxMesh({0, 0, 0}, {1, 1, 1})), SubShapeKind::Face, 6}), ErrorCode::NotFound);
  VERIFY_ERROR(measureBetween({box}, {Shape(Motion{})}), ErrorCode::InvalidInput);
}

void MeasureBetweenTest::itCanBeCancelled() {
  const CancelToken token;
  const Shape a(torusOfDegree9x12(8, 2)), b = moved(toFace(torusOfDegree9x12(8, 2)), {9, 3, 1}, {1, 1, 0}, 1);
  int reports = 0;
  const Progress progress(token, [&](double, const std::string&) {
    if (++reports == 2) token.cancel();
  });
  VERIFY_ERROR(measureBetween({a}, {b}, progress), ErrorCode::Cancelled);
  QVERIFY(reports >= 2);
}

BLOSSOM_TEST(MeasureBetweenTest)
#include "measure_between_test.moc"
