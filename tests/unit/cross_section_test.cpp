// Sections of drawn solids against generalised winding numbers: the solid angles of all triangles, seen from points of the
// plane.
#include "scene/section/cross_section.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/shape/brep.h"
#include "geometry/tessellate/tessellate.h"
#include "scene/section/deadline.h"
#include "support/polyhedra.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;

using test::Random;

namespace {

using Corners = std::array<Vec3, 3>;

Tessellation drawn(const TopoDS_Shape& shape) { return tessellate(Brep(shape), {.chord = 0.05, .angle = 0.3}); }

TopoDS_Shape boxAt(const gp_Pnt& low, double side) { return BRepPrimAPI_MakeBox(low, side, side, side).Shape(); }

Tessellation together(const Tessellation& a, const Tessellation& b) {
  Tessellation both = a;
  const int first = static_cast<int>(a.points.size());
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  both.normals.insert(both.normals.end(), b.normals.begin(), b.normals.end());
  for (const auto& [p, q, r] : b.triangles) both.triangles.push_back({first + p, first + q, first + r});
  return both;
}

std::vector<Corners> trianglesOf(vtkPolyData* data) {
  std::vector<Corners> all;
  for (vtkIdType i = 0; data && i < data->GetNumberOfPolys(); ++i) {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    data->GetPolys()->GetCellAtId(i, count, ids);
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) data->GetPoint(ids[k], corners[k].data());
    all.push_back(corners);
  }
  return all;
}

double areaOfTriangles(const std::vector<Corners>& all) {
  double area = 0;
  for (const auto& [a, b, c] : all) area += (b - a).cross(c - a).norm() / 2;
  return area;
}

/// A. van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983.
double windingOf(const std::vector<Corners>& all, const Vec3& p) {
  double angle = 0;
  for (const Corners& corners : all) {
    const Vec3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

double distanceToOutline(vtkPolyData* outline, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; outline && i < outline->GetNumberOfLines(); ++i) {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    outline->GetLines()->GetCellAtId(i, count, ids);
    for (vtkIdType k = 0; k + 1 < count; ++k) {
      Vec3 a, b;
      outline->GetPoint(ids[k], a.data());
      outline->GetPoint(ids[k + 1], b.data());
      const double along = (b - a).squaredNorm() > 0 ? std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) : 0;
      nearest = std::min(nearest, (a + along * (b - a) - p).norm());
    }
  }
  return nearest;
}

int coverOf(const std::vector<Corners>& section, const Vec3& p, const Vec3& normal) {
  int cover = 0;
  for (const auto& [a, b, c] : section) {
    const auto left = [&](const Vec3& from, const Vec3& to) { return (to - from).cross(p - from).dot(normal); };
    const double first = left(a, b), second = left(b, c), third = left(c, a);
    cover += (first > 0 && second > 0 && third > 0) || (first < 0 && second < 0 && third < 0);
  }
  return cover;
}

/// Whether a triangle in the plane covers a point of it: a face is seen there, whatever lies behind it.
bool isOnFace(const std::vector<Corners>& mesh, const Vec3& p, const CutPlane& cut) {
  std::vector<Corners> inPlane;
  for (const Corners& corners : mesh)
    if (std::all_of(corners.begin(), corners.end(), [&](const Vec3& q) { return std::abs(cut.height(q)) < 1e-6; }))
      inPlane.push_back(corners);
  return coverOf(inPlane, p, cut.normal) > 0;
}

struct Body {
  const char* name;
  Tessellation mesh;
};

const std::vector<Body>& bodies() {
  static const std::vector<Body> all = [] {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(10, 10, 10), 7).Shape();
    return std::vector<Body>{{"box", drawn(boxAt({0, 0, 0}, 20))},
                             {"torus", drawn(BRepPrimAPI_MakeTorus(9, 4).Shape())},
                             {"hollow box", drawn(BRepAlgoAPI_Cut(boxAt({0, 0, 0}, 20), ball).Shape())},
                             {"boxes that overlap", together(drawn(boxAt({0, 0, 0}, 20)), drawn(boxAt({5, 7, 9}, 20)))},
                             {"boxes side by side", together(drawn(boxAt({0, 0, 0}, 20)), drawn(boxAt({20, 0, 0}, 20)))},
                             {"far away", drawn(boxAt({1e6, -2e6, 3e6}, 20))}};
  }();
  return all;
}

Vec3 centreOf(const Tessellation& mesh) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : mesh.points) sum += p;
  return sum / static_cast<double>(mesh.points.size());
}

}  // namespace

class CrossSectionTest : public QObject {
  Q_OBJECT
 private slots:
  void pointsOfTheMaterialAreCoveredOnce() {
    Random random = test::seededRandom();
    std::normal_distribution<double> normal;
    std::uniform_int_distribution<int> kind(0, 2);
    for (const Body& body : bodies()) {
      const SceneData scene = toSceneData(body.mesh);
      const std::vector<Corners> mesh = trianglesOf(scene.faces);
      const Vec3 centre = centreOf(body.mesh);
      int inside = 0, outside = 0;
      for (int i = 0; i < 60; ++i) {
        Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
        if (kind(random) == 0) direction = Vec3::Unit(i % 3) * (i % 2 == 0 ? 1 : -1);
        Vec3 through = centre + 4 * Vec3(normal(random), normal(random), normal(random));
        if (kind(random) == 0) through = body.mesh.points[random() % body.mesh.points.size()];
        const CutPlane cut{direction, direction.dot(through)};
        const CrossSection section = crossSection(*scene.faces, cut);
        const std::vector<Corners> area = trianglesOf(section.area);
        for (int k = 0; k < 40; ++k) {
          Vec3 p = centre + 8 * Vec3(normal(random), normal(random), normal(random));
          p -= cut.height(p) * direction;
          if (distanceToOutline(section.outline, p) < 1e-4 || isOnFace(mesh, p, cut)) continue;
          const long winding = std::lround(windingOf(mesh, p - 1e-5 * direction));
          if (winding != std::lround(windingOf(mesh, p + 1e-5 * direction))) continue;  // on a face in the plane
          const bool isInside = winding != 0;
          const std::string where = fmt::format("{}: plane ({}, {}, {}) at {}, point ({}, {}, {})", body.name, direction.x(),
                                                direction.y(), direction.z(), cut.offset, p.x(), p.y(), p.z());
          QVERIFY2(coverOf(area, p, direction) == (isInside ? 1 : 0), where.c_str());
          ++(isInside ? inside : outside);
        }
      }
      QVERIFY2(inside > 100 && outside > 100, body.name);
    }
  }

  void areasAreThoseOfClosedForms() {
    const auto areaOfCut = [](const Tessellation& mesh, const CutPlane& cut) {
      return areaOfTriangles(trianglesOf(crossSection(*toSceneData(mesh).faces, cut).area));
    };
    COMPARE_NEAR(areaOfCut(bodies()[0].mesh, {Vec3::UnitZ(), 12}), 400, 1e-9);
    COMPARE_NEAR(areaOfCut(bodies()[0].mesh, {Vec3(1, 1, 0).normalized(), 20 / std::numbers::sqrt2}),
                 400 * std::numbers::sqrt2, 1e-9);
    COMPARE_NEAR(areaOfCut(bodies()[0].mesh, {Vec3(1, 1, 1).normalized(), 30 / std::numbers::sqrt3}),
                 600 * std::numbers::sqrt3 / 2, 1e-9);  // a regular hexagon
    COMPARE_NEAR(areaOfCut(bodies()[1].mesh, {Vec3::UnitZ(), 0}), std::numbers::pi * (13 * 13 - 5 * 5), 4);
    COMPARE_NEAR(areaOfCut(bodies()[2].mesh, {Vec3::UnitX(), 10}), 400 - std::numbers::pi * 49, 2);
    COMPARE_NEAR(areaOfCut(bodies()[3].mesh, {Vec3::UnitZ(), 12}), 400 + 400 - 15 * 13, 1e-9);
    COMPARE_NEAR(areaOfCut(bodies()[4].mesh, {Vec3::UnitZ(), 12}), 800, 1e-9);
    COMPARE_NEAR(areaOfCut(bodies()[5].mesh, {Vec3::UnitZ(), 3e6 + 12}), 400, 1e-6);
  }

  void whereThePlaneMissesThereIsNothing() {
    for (const double offset : {-1.0, 0.0, 1e-16, 20.0, 20 + 4e-15, 21.0}) {
      const CrossSection section = crossSection(*toSceneData(bodies()[0].mesh).faces, {Vec3::UnitZ(), offset});
      QVERIFY(!section.area && !section.outline);
    }
  }

  /// A step and an overhang in the plane: where a face lies there, nothing is cut.
  void facesInThePlaneAreNoSection() {
    const TopoDS_Shape stepped =
        BRepAlgoAPI_Cut(boxAt({0, 0, 0}, 20), BRepPrimAPI_MakeBox(gp_Pnt(10, -1, 10), 11, 22, 11).Shape()).Shape();
    for (const double side : {1.0, -1.0}) {  // seen from above it is a step, from below an overhang
      const CrossSection section = crossSection(*toSceneData(drawn(stepped)).faces, {side * Vec3::UnitZ(), side * 10});
      COMPARE_NEAR(areaOfTriangles(trianglesOf(section.area)), 200, 1e-9);
      QCOMPARE(section.outline->GetNumberOfLines(), vtkIdType{1});
    }
    // Turned, no corner lies in the plane but for rounding; nor in the single precision of files.
    Random random = test::seededRandom();
    for (int k = 0; k < 100; ++k) {
      const Eigen::Matrix3d turn = test::randomTurn(random);
      Tessellation turned = drawn(stepped);
      for (Vec3& p : turned.points) {
        p = turn * p;
        if (k % 2 == 0) p = p.cast<float>().cast<double>();
      }
      for (const double side : {1.0, -1.0})
        for (const double height : {0.0, 10.0, 20.0}) {
          const CutPlane cut{side * turn.col(2), side * height};
          const double area = areaOfTriangles(trianglesOf(crossSection(*toSceneData(turned).faces, cut).area));
          COMPARE_NEAR(area, height == 10 ? 200 : 0, 1e-3);
        }
    }
  }

  void deadlinesCancelWhatTakesLong() {
    { const Deadline unused(std::chrono::hours(1)); }  // is not waited for
    const Deadline later(std::chrono::hours(1)), soon(std::chrono::milliseconds(1));
    const Progress progress = soon.progress();
    QTRY_VERIFY(progress.cancelled());
    VERIFY_ERROR(progress.check(), ErrorCode::Cancelled);
    QVERIFY(!later.progress().cancelled());
  }

  void withoutTimeOnlyTheOutlineIsDrawn() {
    const CancelToken token;
    token.cancel();
    const CrossSection section = crossSection(*toSceneData(bodies()[0].mesh).faces, {Vec3::UnitZ(), 12}, Progress(token));
    QVERIFY(section.outline && !section.area);
  }

  /// Without one of its triangles the box is cut all the same, and the corner of it that is missing is cut off.
  void gapsAreClosedByStraightLines() {
    const Tessellation whole = bodies()[0].mesh;
    for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
      Tessellation torn = whole;
      torn.triangles.erase(torn.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      torn.faceOfTriangle.erase(torn.faceOfTriangle.begin() + static_cast<std::ptrdiff_t>(i));
      const CrossSection section = crossSection(*toSceneData(torn).faces, {Vec3::UnitZ(), 12});
      COMPARE_NEAR(areaOfTriangles(trianglesOf(section.area)), 400, 1e-9);
    }
  }
};

BLOSSOM_TEST(CrossSectionTest)
#include "cross_section_test.moc"
