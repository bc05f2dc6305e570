#include "geometry/measure/measure.h"
#include <Eigen/Geometry>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <array>
#include <gp_Ax2.hxx>
#include <numbers>

#include "geometry/measure/volume_doubt.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "support/solids.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

struct Expected {
  double volume, area;
  std::int64_t faces, genus, components;
};

void compareSolid(const TopoDS_Shape& shape, const Expected& expected, double digits) {
  const Measures m = measure(Brep(shape));
  QCOMPARE(m.kind, std::string("solid"));
  COMPARE_NEAR(measured<double>(m, "volume") / expected.volume, 1, digits);
  COMPARE_NEAR(measured<double>(m, "area") / expected.area, 1, digits);
  QCOMPARE(measured<std::int64_t>(m, "faces"), expected.faces);
  QCOMPARE(measured<std::int64_t>(m, "genus"), expected.genus);
  QCOMPARE(measured<std::int64_t>(m, "components"), expected.components);
  QCOMPARE(measured<bool>(m, "closed"), true);
}

Path circleArc(const Vec2& center, double radius, double sweep) { return {{Arc2{center, radius, 0, sweep}}, true, {}, {}}; }

}  // namespace

/// Adds a box whose faces look outwards or inwards.
static void addBox(Mesh& mesh, const Vec3& low, const Vec3& high, bool outwards) {
  const int first = static_cast<int>(mesh.points.size());
  for (int k = 0; k < 8; ++k) mesh.points.push_back(low + (high - low).cwiseProduct(Vec3(k & 1, k >> 1 & 1, k >> 2 & 1)));
  for (std::array<int, 4> face : std::to_array<std::array<int, 4>>(
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})) {
    if (!outwards) std::reverse(face.begin(), face.end());
    for (int& v : face) v += first;
    mesh.addFace(face);
  }
}

class MeasureTest : public QObject {
  Q_OBJECT
 private slots:
  void primitivesHaveTheirClosedForms() {
    compareSolid(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 4.0, 5.0, 6.0).Shape(), {120, 148, 6, 0, 1}, 1e-13);
    compareSolid(BRepPrimAPI_MakeSphere(3).Shape(), {36 * pi, 36 * pi, 1, 0, 1}, 1e-12);
    compareSolid(BRepPrimAPI_MakeCylinder(2, 7).Shape(), {28 * pi, 36 * pi, 3, 0, 1}, 1e-12);
    compareSolid(BRepPrimAPI_MakeTorus(5, 2).Shape(), {2 * pi * pi * 5 * 4, 4 * pi * pi * 10, 1, 1, 1}, 1e-12);
    compareSolid(BRepPrimAPI_MakeCone(3, 1, 4).Shape(),
                 {pi * 4 / 3 * (9 + 3 + 1), pi * (9 + 1 + (3 + 1) * std::sqrt(20.0)), 3, 0, 1}, 1e-12);
  }
  void volumesThatCountSpaceTwiceAreTold() {
    const auto with = [](Mesh mesh, const Vec3& low, double size, bool outwards = true) {
      addBox(mesh, low, low + Vec3::Constant(size), outwards);
      return mesh;
    };
    // An octahedron with tips at 10, and a second pair of tips on the same four corners around its middle.
    const auto withInnerTips = [](double tip, bool outwards) {
      Mesh mesh;
      mesh.points = {{10, 0, 0}, {0, 10, 0}, {-10, 0, 0}, {0, -10, 0}, {0, 0, 10}, {0, 0, -10}, {0, 0, tip}, {0, 0, -tip}};
      for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        for (const auto& [top, bottom, turned] : {std::tuple(4, 5, false), std::tuple(6, 7, !outwards)}) {
          mesh.addFace(turned ? std::array{next, k, top} : std::array{k, next, top});
          mesh.addFace(turned ? std::array{k, next, bottom} : std::array{next, k, bottom});
        }
      }
      return mesh;
    };
    const Mesh one = with({}, {0, 0, 0}, 10);
    const Mesh hollow = with(one, {2, 2, 2}, 6, false);
    for (const Mesh& right : {one, with(one, {20, 0, 0}, 10), with(one, {10, 10, 10}, 10), hollow,
                              with(hollow, {4, 4, 4}, 2), with(with(hollow, {3, 3, 3}, 1), {5, 5, 5}, 2),
                              // Bodies that touch in a face, a part of one, an edge of one, or where a notch begins.
                              with(one, {10, 0, 0}, 10), with(one, {3, 4, 10}, 4), with(one, {10, 4, 10}, 3),
                              with(with(with(one, {10, 0, 0}, 10), {0, 0, 10}, 10), {10, 2, 10}, 5),
                              with(one, {0, 0, 0}, 5, false), with(hollow, {3, 3, 2}, 3), withInnerTips(5, false)})
      QVERIFY2(!volumeDoubt(right), (volumeDoubt(right).value_or("") + std::to_string(right.faceCount())).c_str());
    const auto tells = [](const Mesh& wrong, const char* what) {
      const auto told = volumeDoubt(wrong);
      return told && told->find(what) != std::string::npos;
    };
    QVERIFY(tells(with(one, {5, 5, 5}, 10), "intersect near"));  // 2000, and the union holds 1875
    QVERIFY(tells(with(one, {2, 2, 2}, 6), "lies within another"));
    QVERIFY(tells(with(with(hollow, {3, 3, 3}, 4), {4, 4, 4}, 1), "lies within another"));
    QVERIFY(tells(with(one, {0, 0, 0}, 5), "intersect near"));  // in one corner, so that walls lie on walls
    QVERIFY(tells(with(one, {-5, 0, 0}, 10), "intersect near"));
    QVERIFY(tells(with(one, {0, 0, 0}, 10), "intersect near"));
    QVERIFY(tells(with(one, {2, -5, 2}, 6), "intersect near"));
    QVERIFY(tells(with(hollow, {4, 4, 4}, 6), "intersect near"));
    QVERIFY(tells(withInnerTips(5, true), "lies within another"));
    QVERIFY(tells(with({}, {1, 1, 1}, 5, false), "is inside out"));
    QVERIFY(tells(with(one, {20, 0, 0}, 10, false), "is inside out"));
    QVERIFY(tells(with(with({}, {0, 0, 0}, 10, false), {2, 2, 2}, 6), "is inside out"));
    Mesh open = with(one, {5, 5, 5}, 10);
    open.faceStarts.pop_back();
    open.faceVertices.resize(open.faceVertices.size() - 4);
    QVERIFY(!volumeDoubt(open));
  }
  /// Boxes on a grid, which touch and overlap in all ways, each outwards or inwards: how often they count a cell is known.
  void volumesOfBoxesOnAGridAreDoubtedWhereACellCountsWrong() {
    std::mt19937_64 random = test::seededRandom();
    constexpr int cells = 4;
    const Eigen::Quaternion<double> turned = Eigen::Quaternion<double>(0.8, 0.3, -0.4, 0.33).normalized();
    int doubted = 0, trusted = 0;
    for (int round = 0; round < 400; ++round) {
      Mesh mesh;
      std::array<int, cells * cells * cells> counts{};
      const int boxes = 2 + static_cast<int>(random() % 3);
      for (int k = 0; k < boxes; ++k) {
        std::array<int, 3> low{}, high{};
        for (std::size_t a = 0; a < 3; ++a) {
          low[a] = static_cast<int>(random() % cells);
          high[a] = low[a] + 1 + static_cast<int>(random() % static_cast<unsigned>(cells - low[a]));
        }
        const bool outwards = k == 0 || random() % 2 == 0;
        addBox(mesh, Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2]), outwards);
        for (int cell = 0; cell < cells * cells * cells; ++cell) {
          const std::array<int, 3> at{cell % cells, cell / cells % cells, cell / cells / cells};
          bool inside = true;
          for (std::size_t a = 0; a < 3; ++a) inside = inside && low[a] <= at[a] && at[a] < high[a];
          if (inside) counts[static_cast<std::size_t>(cell)] += outwards ? 1 : -1;
        }
      }
      const bool right = std::all_of(counts.begin(), counts.end(), [](int n) { return n == 0 || n == 1; });
      if (round % 2 == 1)  // with coordinates that are rounded
        for (Vec3& p : mesh.points) p = turned * p + Vec3(100, -20, 3);
      const auto doubt = volumeDoubt(mesh);
      QVERIFY2(right == !doubt, (std::to_string(round) + ": " + doubt.value_or("nothing is said")).c_str());
      ++(right ? trusted : doubted);
    }
    QVERIFY(doubted > 40 && trusted > 40);
  }
  void trimmedFacesOfTheSteinmetzSolid() {
    const double r = 2;
    const TopoDS_Shape x = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-5, 0, 0), gp_Dir(1, 0, 0)), r, 10).Shape();
    const TopoDS_Shape z = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -5), gp_Dir(0, 0, 1)), r, 10).Shape();
    const Measures m = measure(Brep(BRepAlgoAPI_Common(x, z).Shape()));
    COMPARE_NEAR(measured<double>(m, "volume") / (16 * r * r * r / 3), 1, 1e-6);
    COMPARE_NEAR(measured<double>(m, "area") / (16 * r * r), 1, 1e-6);
  }
  void drilledBoxHasAHandle() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), 10.0, 10.0, 4.0).Shape();
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 0, -1), gp_Dir(0, 0, 1)), 2, 9).Shape();
    compareSolid(BRepAlgoAPI_Cut(box, drill).Shape(), {400 - 16 * pi, 2 * (100 - 4 * pi) + 160 + 16 * pi, 7, 1, 1}, 1e-9);
  }
  void hollowBallSubtractsItsHollow() {
    const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(3).Shape(), BRepPrimAPI_MakeSphere(1).Shape()).Shape();
    compareSolid(shape, {4 * pi / 3 * (27 - 1), 4 * pi * (9 + 1), 2, 0, 1}, 1e-10);
  }
  void instancesCountOnceEach() {
    auto part = std::make_shared<BrepPart>();
    part->shape = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    gp_Trsf aside, mirror;
    aside.SetTranslation(gp_Vec(5, 0, 0));
    mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, -3), gp_Dir(0, 0, 1)));
    const Brep assembly(
        std::vector<BrepInstance>{{"a", {}, gp_Trsf(), part}, {"b", {}, aside, part}, {"c", {}, mirror, part}});
    compareSolid(assembly.shape(), {3, 18, 18, 0, 3}, 1e-12);
  }
  void highDegreeRationalSolid() {
    const Surface torus = torusOfDegree9x12(5, 2);
    QCOMPARE(torus.degreeU, 9);
    QCOMPARE(torus.degreeV, 12);
    compareSolid(solidOf(toFace(torus)), {2 * pi * pi * 5 * 4, 4 * pi * pi * 10, 1, 1, 1}, 1e-10);
  }
  void surfaceAndItsFaceMeasureAlike() {
    const Surface torus = torusOfDegree9x12(5, 2);
    const Measures own = measure(torus);
    const Measures face = measure(Brep(toFace(torus)));
    QCOMPARE(own.kind, std::string("surface"));
    QCOMPARE(face.kind, std::string("surface"));
    for (const char* name : {"degree_u", "degree_v", "poles_u", "poles_v"})
      QCOMPARE(measured<std::int64_t>(own, name), measured<std::int64_t>(face, name));
    COMPARE_NEAR(measured<double>(own, "min_weight"), measured<double>(face, "min_weight"), 1e-15);
    COMPARE_NEAR(measured<double>(own, "area") / (4 * pi * pi * 10), 1, 1e-11);
    COMPARE_NEAR(measured<double>(face, "area") / (4 * pi * pi * 10), 1, 1e-11);
  }
  void sphereWithPolesIsStillExact() {
    Surface sphere{2, 2, circleKnots, {0, 0, 0, 1, 1, 2, 2, 2}, {}};
    const double h = std::numbers::sqrt2 / 2;
    const std::vector<Vec3> half{{0, -1, 1}, {h, -h, h}, {1, 0, 1}, {h, h, h}, {0, 1, 1}};
    for (const Vec3& around : circlePoles(0, 1))
      for (const Vec3& m : half)
        sphere.poles.emplace_back(around.x() * m.x(), around.y() * m.x(), around.z() * m.y(), around.z() * m.z());
    COMPARE_NEAR(measured<double>(measure(sphere), "area") / (4 * pi), 1, 1e-11);
  }
  /// A weight of its own only moves parameters along a ruling: most of the area comes to lie in a strip as thin as its
  /// share.
  void areaInAThinStrip() {
    for (const double weight : {1e3, 1e5, 1e7}) {
      Surface cylinder{2, 2, circleKnots, {0, 0, 0, 1, 1, 1}, {}};
      for (const Vec3& around : circlePoles(0, 1))
        for (const double z : {0.0, 2.0, 4.0}) {
          const double w = z == 2 ? weight : 1;
          cylinder.poles.emplace_back(w * around.x(), w * around.y(), w * around.z() * z, w * around.z());
        }
      COMPARE_NEAR(measured<double>(measure(cylinder), "area") / (8 * pi), 1, 1e-9);
    }
  }

  /// All that is left of x_v is rounding noise, which no quartering makes smaller: it took minutes.
  void surfaceThatCollapsesToACurveHasNoArea() {
    constexpr std::size_t spans = 24;
    Surface ring{2, 2, circleKnots, {0, 0}, {}};
    for (std::size_t j = 0; j <= spans; ++j) ring.knotsV.push_back(static_cast<double>(j) / spans);
    ring.knotsV.insert(ring.knotsV.end(), {1, 1});
    for (const Vec3& around : circlePoles(0, 10))
      for (std::size_t j = 0; j < spans + 2; ++j)
        ring.poles.emplace_back(around.x(), around.y(), 0.1 * around.z(), around.z());
    const double area = measured<double>(measure(ring), "area");
    QVERIFY2(area >= 0 && area < 1e-9, qPrintable(QString::number(area)));
  }
  void regionCountsItsParts() {
    const Path plate{
        {Line2{{0, 0}, {10, 0}}, Line2{{10, 0}, {10, 10}}, Line2{{10, 10}, {0, 10}}, Line2{{0, 10}, {0, 0}}}, true, {}, {}};
    const Measures m = measure(Region{{plate, circleArc({5, 5}, 2, -2 * pi), circleArc({20, 0}, 1, 2 * pi)}});
    QCOMPARE(m.kind, std::string("region"));
    COMPARE_NEAR(measured<double>(m, "area"), 100 - 4 * pi + pi, 1e-12);
    COMPARE_NEAR(measured<double>(m, "perimeter"), 40 + 4 * pi + 2 * pi, 1e-12);
    for (const auto& [name, value] : std::vector<std::pair<std::string, std::int64_t>>{
             {"loops", 3}, {"holes", 1}, {"components", 2}, {"vertices", 6}, {"lines", 4}, {"arcs", 2}, {"splines", 0}})
      QCOMPARE(measured<std::int64_t>(m, name), value);
  }
  void curvesAddTheirLengths() {
    const Curves curves{{circleArc({0, 0}, 1, 2 * pi), {{Line2{{0, 0}, {3, 4}}}, false, {}, {}}}, FillRule::EvenOdd};
    const Measures m = measure(curves);
    QCOMPARE(m.kind, std::string("curves"));
    QCOMPARE(measured<std::int64_t>(m, "curves"), std::int64_t{2});
    COMPARE_NEAR(measured<double>(m, "length"), 2 * pi + 5, 1e-12);
    const Measures wires = measure(Brep(toWires(curves)));
    QCOMPARE(wires.kind, std::string("curves"));
    QCOMPARE(measured<std::int64_t>(wires, "curves"), std::int64_t{2});
    COMPARE_NEAR(measured<double>(wires, "length"), 2 * pi + 5, 1e-11);
  }
  void facesWithoutASolid() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    const Measures m = measure(Brep(TopExp_Explorer(box, TopAbs_FACE).Current()));
    QCOMPARE(m.kind, std::string("faces"));
    QCOMPARE(measured<std::int64_t>(m, "faces"), std::int64_t{1});
    COMPARE_NEAR(measured<double>(m, "area"), 6, 1e-12);
  }
  void sequencesAndNothing() {
    QCOMPARE(measured<std::int64_t>(measure(Sequence{{Shape(), Shape()}, {0, 1}}), "frames"), std::int64_t{2});
    QCOMPARE(measure(Shape()).kind, std::string("nothing"));
  }
  void cancelledMeasuringStops() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(measure(torusOfDegree9x12(5, 2), Progress(token)), ErrorCode::Cancelled);
  }
  void boundsFitClosely() {
    const Bounds arc = bounds(Curves{{{{Arc2{{0, 0}, 2, -pi / 4, pi / 2}}, false, {}, {}}}, FillRule::EvenOdd});
    COMPARE_NEAR(arc.low.x(), std::sqrt(2.0), 1e-12);
    COMPARE_NEAR(arc.high.x(), 2, 1e-12);
    COMPARE_NEAR(arc.high.y(), std::sqrt(2.0), 1e-12);
    const Bounds box = bounds(Brep(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 4.0, 5.0, 6.0).Shape()));
    COMPARE_NEAR((box.low - Vec3(1, 2, 3)).norm() + (box.high - Vec3(5, 7, 9)).norm(), 0, 1e-6);
    QVERIFY(bounds(Shape()).empty);
    QVERIFY(bounds(torusSurface(5, 2)).high.x() >= 7);
  }
};

BLOSSOM_TEST(MeasureTest)
#include "measure_test.moc"
