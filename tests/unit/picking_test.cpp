#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <numbers>

#include "geometry/occt/sub_shape.h"
#include "geometry/shape/brep.h"
#include "geometry/tessellate/tessellate.h"
#include "scene/picking.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;

using test::Random;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 randomIn(Random& random, double reach) {
  std::uniform_real_distribution<double> range(-reach, reach);
  return {range(random), range(random), range(random)};
}

/// Triangles anywhere, each a face of its own.
Tessellation soup(Random& random, int count) {
  Tessellation t;
  for (int i = 0; i < count; ++i) {
    const Vec3 middle = randomIn(random, 10);
    for (int k = 0; k < 3; ++k) t.points.push_back(middle + randomIn(random, 1));
    t.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    t.faceOfTriangle.push_back(i);
  }
  return t;
}

/// First triangle in front of the ray by solving for barycentric coordinates with a general solver.
std::pair<double, int> firstByHand(const Tessellation& t, const Ray& ray, const std::optional<CutPlane>& cut) {
  std::pair<double, int> best{infinity, -1};
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    const auto at = [&](std::size_t k) { return t.points[static_cast<std::size_t>(t.triangles[i][k])]; };
    Eigen::Matrix3d m;
    m << at(1) - at(0), at(2) - at(0), -ray.direction;
    const Vec3 solution = m.inverse() * (ray.origin - at(0));
    if (solution.x() < 0 || solution.y() < 0 || solution.x() + solution.y() > 1 || solution.z() < 0) continue;
    if (cut && cut->height(ray.origin + solution.z() * ray.direction) > 0) continue;
    if (solution.z() < best.first) best = {solution.z(), static_cast<int>(i)};
  }
  return best;
}

/// A block with two rounded edges and a hole.
TopoDS_Shape filleted() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(4.0, TopoDS::Edge(edges(2)));
  fillet.Add(3.0, TopoDS::Edge(edges(7)));
  const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, -5), gp_Dir(0, 0, 1)), 5.0, 40.0).Shape();
  return BRepAlgoAPI_Cut(fillet.Shape(), tool).Shape();
}

double distanceTo(const TopoDS_Shape& shape, const Vec3& p) {
  const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z()));
  return BRepExtrema_DistShapeShape(shape, vertex).Value();
}

PickIndex indexOf(const Shape& shape, bool solid = false, double chord = 0.01) {
  SceneData scene = toSceneData(tessellate(shape, {.chord = chord, .angle = 0.1}));
  scene.solid = solid;
  return PickIndex(scene);
}

Ray towards(const Vec3& from, const Vec3& to) { return {from, (to - from).normalized()}; }

}  // namespace

class PickingTest : public QObject {
  Q_OBJECT
 private slots:
  void raysMeetWhatBruteForceMeets() {
    Random random = test::seededRandom();
    const Tessellation t = soup(random, 1500);
    const PickIndex index(toSceneData(t));
    const PickOptions faces{.edges = false, .vertices = false};
    int met = 0;
    for (int i = 0; i < 600; ++i) {
      const Ray ray = towards(randomIn(random, 25), randomIn(random, 8));
      PickOptions options = faces;
      if (i % 2 == 1) options.cut = CutPlane{randomIn(random, 1).normalized(), randomIn(random, 4).x()};
      const auto [distance, face] = firstByHand(t, ray, options.cut);
      const auto pick = index.pick(ray, options);
      QCOMPARE(pick.has_value(), face >= 0);
      if (!pick) continue;
      ++met;
      QCOMPARE(pick->index, face);
      QVERIFY(pick->kind == SubShapeKind::Face);
      COMPARE_NEAR(pick->distance, distance, 1e-9 * (1 + distance));
      COMPARE_NEAR((ray.origin + distance * ray.direction - pick->point).norm(), 0, 1e-9 * (1 + distance));
    }
    QVERIFY(met > 100);
  }

  void edgesAndVerticesMeetWhatBruteForceMeets() {
    Random random = test::seededRandom();
    Tessellation t;
    for (int i = 0; i < 400; ++i) {
      const Vec3 a = randomIn(random, 10);
      t.edges.push_back({a, a + randomIn(random, 2)});
      t.edgeIndices.push_back(i);
      t.vertices.push_back(randomIn(random, 10));
    }
    const PickIndex index(toSceneData(t));
    int edges = 0, vertices = 0;
    for (int i = 0; i < 500; ++i) {
      const Ray ray = towards(randomIn(random, 25), randomIn(random, 8));
      const double reach = 0.05, growth = i % 2 == 0 ? 0.0 : 0.01;
      // The line and the segment by sampling, which is slow but simple.
      double nearestEdge = infinity, nearestVertex = infinity;
      const auto off = [&](const Vec3& p) {
        const double distance = (p - ray.origin).dot(ray.direction);
        return distance < 0 ? infinity : (p - ray.origin).cross(ray.direction).norm() / (reach + growth * distance);
      };
      for (const auto& edge : t.edges) {
        const Eigen::ParametrizedLine<double, 3> line(edge[0], (edge[1] - edge[0]).normalized());
        const double length = (edge[1] - edge[0]).norm();
        const Vec3 normal = line.direction().cross(ray.direction);
        const double s = (ray.origin - edge[0]).cross(ray.direction).dot(normal) / normal.squaredNorm();
        nearestEdge = std::min(nearestEdge, off(line.pointAt(std::clamp(s, 0.0, length))));
      }
      for (const Vec3& vertex : t.vertices) nearestVertex = std::min(nearestVertex, off(vertex));
      const auto pick = index.pick(ray, {.tolerance = reach, .tolerancePerMm = growth});
      if (nearestVertex <= 1) {
        QVERIFY(pick && pick->kind == SubShapeKind::Vertex);
        QVERIFY(off(pick->point) <= std::floor(nearestVertex / 0.2) * 0.2 + 0.2 + 1e-9);
        ++vertices;
      } else if (nearestEdge <= 1) {
        QVERIFY(pick && pick->kind == SubShapeKind::Edge);
        ++edges;
      } else {
        QVERIFY(!pick);
      }
    }
    QVERIFY(edges > 30 && vertices > 5);
  }

  void numbersAreThoseOfTheShape() {
    const Brep brep(filleted());
    const Tessellation t = tessellate(brep, {.chord = 0.01, .angle = 0.1});
    TopTools_IndexedMapOfShape faces, edges, vertices;
    TopExp::MapShapes(brep.shape(), TopAbs_FACE, faces);
    TopExp::MapShapes(brep.shape(), TopAbs_EDGE, edges);
    TopExp::MapShapes(brep.shape(), TopAbs_VERTEX, vertices);
    QVERIFY(faces.Extent() >= 9);
    for (std::size_t i = 0; i < t.triangles.size(); i += 7) {
      Vec3 middle = Vec3::Zero();
      for (const int k : t.triangles[i]) middle += t.points[static_cast<std::size_t>(k)] / 3;
      QVERIFY(distanceTo(faceOf(brep, t.faceOfTriangle[i]), middle) < 0.011);
    }
    QCOMPARE(t.edgeIndices.size(), t.edges.size());
    QVERIFY(t.edges.size() + 3 >= static_cast<std::size_t>(edges.Extent()));  // seams are not drawn
    for (std::size_t i = 0; i < t.edges.size(); ++i)
      for (const Vec3& p : {t.edges[i].front(), t.edges[i][t.edges[i].size() / 2], t.edges[i].back()})
        QVERIFY(distanceTo(edgeOf(brep, t.edgeIndices[i]), p) < 1e-6);
    QCOMPARE(t.vertices.size(), static_cast<std::size_t>(vertices.Extent()));
    for (std::size_t i = 0; i < t.vertices.size(); ++i)
      QVERIFY(distanceTo(vertexOf(brep, static_cast<int>(i)), t.vertices[i]) < 1e-7);
  }

  void picksNameTheFaceThatIsThere() {
    Random random = test::seededRandom();
    const Brep brep(filleted());
    const PickIndex index = indexOf(brep);
    int met = 0;
    for (int i = 0; i < 60; ++i) {
      const Vec3 middle(20, 15, 10);
      const Ray ray = towards(middle + randomIn(random, 1).normalized() * 200, middle + randomIn(random, 10));
      const auto pick = index.pick(ray, {.edges = false, .vertices = false});
      if (!pick) continue;
      ++met;
      const TopoDS_Face face = faceOf(brep, pick->index);
      QVERIFY(distanceTo(face, pick->point) < 0.011);
      QVERIFY(pick->normal.dot(ray.direction) < 0.05);  // seen from outside
    }
    QVERIFY(met > 40);
  }

  void assembliesCountTheirInstancesOneAfterAnother() {
    auto block = std::make_shared<BrepPart>();
    block->shape = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    auto other = std::make_shared<BrepPart>();
    other->shape = filleted();
    gp_Trsf aside, turned;
    aside.SetTranslation(gp_Vec(0, 0, 50));
    turned.SetRotation(gp_Ax1(gp_Pnt(-30, 0, 0), gp_Dir(1, 1, 0)), 0.7);
    // The last one is the first again, in the same place: it counts once.
    const Brep brep(std::vector<BrepInstance>{
        {"a", {}, gp_Trsf(), block}, {"b", {}, aside, other}, {"c", {}, turned, block}, {"d", {}, gp_Trsf(), block}});
    const Tessellation t = tessellate(brep, {.chord = 0.01, .angle = 0.1});
    for (std::size_t i = 0; i < t.triangles.size(); i += 11)
      QVERIFY(distanceTo(faceOf(brep, t.faceOfTriangle[i]), t.points[static_cast<std::size_t>(t.triangles[i][0])]) < 0.011);
    for (std::size_t i = 0; i < t.edges.size(); ++i)
      QVERIFY(distanceTo(edgeOf(brep, t.edgeIndices[i]), t.edges[i][t.edges[i].size() / 2]) < 1e-6);
    for (std::size_t i = 0; i < t.vertices.size(); ++i)
      QVERIFY(distanceTo(vertexOf(brep, static_cast<int>(i)), t.vertices[i]) < 1e-7);
  }

  void nearerPartsWinAndFacesHide() {
    const Brep box(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
    const PickIndex index = indexOf(box);
    const auto kindAt = [&](const Vec3& target, PickOptions options = {}) {
      options.tolerance = 0.2;
      const auto pick = index.pick({target + Vec3(0, 0, 50), -Vec3::UnitZ()}, options);
      return pick ? static_cast<int>(pick->kind) : -1;
    };
    QCOMPARE(kindAt({5, 5, 10}), static_cast<int>(SubShapeKind::Face));
    QCOMPARE(kindAt({5, 0.1, 10}), static_cast<int>(SubShapeKind::Edge));
    QCOMPARE(kindAt({5, -0.1, 10}), static_cast<int>(SubShapeKind::Edge));  // beside the shape
    QCOMPARE(kindAt({0.1, 0.1, 10}), static_cast<int>(SubShapeKind::Vertex));
    QCOMPARE(kindAt({0.1, 0.1, 10}, {.vertices = false}), static_cast<int>(SubShapeKind::Edge));
    QCOMPARE(kindAt({0.1, 0.1, 10}, {.edges = false, .vertices = false}), static_cast<int>(SubShapeKind::Face));
    QCOMPARE(kindAt({5, -0.3, 10}), -1);
    // From above every edge that is met is one of the four on top, though those below lie in the same direction.
    for (const Vec3& target : {Vec3(5, 0, 10), Vec3(5, 10, 10), Vec3(0, 5, 10), Vec3(10, 5, 10)}) {
      const auto pick = index.pick({target + Vec3(0, 0, 50), -Vec3::UnitZ()}, {.tolerance = 0.2});
      QVERIFY(pick);
      COMPARE_NEAR(pick->point.z(), 10, 1e-9);
      QVERIFY(distanceTo(edgeOf(box, pick->index), target) < 1e-9);
    }
    // The edge along x at y = 10, z = 0 is behind the block; a wireframe shows it.
    const Ray slanted = towards({5, -30, 60}, {5, 10, 0});
    const auto front = index.pick(slanted, {.tolerance = 0.1});
    QVERIFY(front && front->kind == SubShapeKind::Face && front->distance < 65);
    const auto through = index.pick(slanted, {.tolerance = 0.1, .faces = false, .facesHide = false});
    QVERIFY(through && through->kind == SubShapeKind::Edge);
    COMPARE_NEAR((through->point - Vec3(5, 10, 0)).norm(), 0, 1e-9);
    QVERIFY(!index.pick(slanted, {.tolerance = 0.1, .faces = false}));
  }

  void whatIsCutAwayIsNotMet() {
    const Brep box(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
    const PickIndex open = indexOf(box, false), solid = indexOf(box, true);
    const CutPlane cut{Vec3::UnitZ(), 4};
    const Ray down{{3, 3, 50}, -Vec3::UnitZ()};
    const auto floor = open.pick(down, {.cut = cut});
    QVERIFY(floor && floor->kind == SubShapeKind::Face);
    COMPARE_NEAR(floor->point.z(), 0, 1e-12);
    const auto filled = solid.pick(down, {.cut = cut});
    QVERIFY(filled && filled->kind == SubShapeKind::Whole);
    COMPARE_NEAR((filled->point - Vec3(3, 3, 4)).norm(), 0, 1e-12);
    // An upright edge is met below the cut only, and the filled cut hides the edges on the floor.
    const auto edgeAt = [&](double z) {
      return solid.pick(towards({-40, -40, z}, {0, 0, z}), {.tolerance = 0.1, .cut = cut});
    };
    QVERIFY(edgeAt(2) && edgeAt(2)->kind == SubShapeKind::Edge);
    QVERIFY(!edgeAt(6));
    QVERIFY(!solid.pick(towards({3, 5, 60}, {3, 10, 0}), {.tolerance = 0.1, .faces = false, .cut = cut}));
    QVERIFY(open.pick(towards({3, 5, 60}, {3, 10, 0}), {.tolerance = 0.1, .faces = false, .cut = cut}));
    QVERIFY(!solid.pick({{-5, 3, 7}, Vec3::UnitX()}, {.cut = cut}));
  }

  void partsOfDrawingsAreTheirSegments() {
    const Path plate{
        {Line2{{0, 0}, {10, 0}}, Line2{{10, 0}, {10, 10}}, Line2{{10, 10}, {0, 10}}, Line2{{0, 10}, {0, 0}}}, true, {}, {}};
    const Path hole{{Arc2{{5, 5}, 2, 0, -2 * std::numbers::pi}}, true, {}, {}};
    const PickIndex index = indexOf(Region{{plate, hole}});
    const auto at = [&](double x, double y) {
      return index.pick({{x, y, 100}, -Vec3::UnitZ()}, {.tolerance = 0.2}).value_or(SubPick{SubShapeKind::Whole, -7});
    };
    QVERIFY(at(1, 5).kind == SubShapeKind::Face && at(1, 5).index == 0);
    QVERIFY(at(10, 4).kind == SubShapeKind::Edge && at(10, 4).index == 1);
    QVERIFY(at(5, 3.1).kind == SubShapeKind::Edge && at(5, 3.1).index == 4);
    QVERIFY(at(10, 10).kind == SubShapeKind::Vertex && at(10, 10).index == 2);
    QCOMPARE(at(5, 5).index, -7);
  }

  void boxesGatherWhatLiesInThem() {
    const Brep box(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
    const PickIndex index = indexOf(box);
    // x <= 6 and z <= 11
    const std::vector<CutPlane> bounds{{Vec3::UnitX(), 6}, {Vec3::UnitZ(), 11}};
    QVERIFY(index.within(bounds, SubShapeKind::Whole, false).empty());
    QCOMPARE(index.within(bounds, SubShapeKind::Whole, true), std::vector<int>{0});
    QCOMPARE(index.within(bounds, SubShapeKind::Face, false).size(), std::size_t{1});
    QCOMPARE(index.within(bounds, SubShapeKind::Face, true).size(), std::size_t{5});
    QCOMPARE(index.within(bounds, SubShapeKind::Edge, false).size(), std::size_t{4});
    QCOMPARE(index.within(bounds, SubShapeKind::Edge, true).size(), std::size_t{8});
    QCOMPARE(index.within(bounds, SubShapeKind::Vertex, true).size(), std::size_t{4});
    // A narrow window in the middle of a side holds no corner of it, yet crosses it.
    const std::vector<CutPlane> narrow{
        {Vec3::UnitX(), 5.5}, {-Vec3::UnitX(), -4.5}, {Vec3::UnitY(), 5.5}, {-Vec3::UnitY(), -4.5}};
    QCOMPARE(index.within(narrow, SubShapeKind::Face, true).size(), std::size_t{2});
  }
};

BLOSSOM_TEST(PickingTest)
#include "picking_test.moc"
