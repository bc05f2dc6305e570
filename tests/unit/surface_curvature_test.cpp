#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Eigen/Geometry>
#include <gp_Ax2.hxx>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "geometry/mesh/discrete_curvature.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt.h"
#include "geometry/tessellate/grid_curvature.h"
#include "geometry/tessellate/tessellate.h"
#include "support/solids.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr TessellationOptions curved{.chord = 0.02, .angle = 0.15, .curvature = true};

/// The greatest distance of what is found from what is wanted, each in units of 1/size.
struct Worst {
  double size = 1, gaussian = 0, mean = 0, spread = 0;

  void add(const SurfaceCurvature& found, double wantedGaussian, double wantedMean) {
    const double wantedSpread = std::sqrt(std::max(0.0, wantedMean * wantedMean - wantedGaussian));
    gaussian = std::max(gaussian, std::abs(found.gaussian - wantedGaussian) * size * size);
    mean = std::max(mean, std::abs(found.mean - wantedMean) * size);
    spread = std::max(spread, std::abs(found.spread - wantedSpread) * size);
  }
  [[nodiscard]] double all() const { return std::max({gaussian, mean, spread}); }
  [[nodiscard]] QByteArray text() const {
    return QStringLiteral("gaussian %1, mean %2, spread %3").arg(gaussian).arg(mean).arg(spread).toUtf8();
  }
};

/// Gaussian and mean curvature of a torus around z at one of its points, seen from outside.
std::pair<double, double> ofTorus(double major, double minor, const Vec3& p) {
  const double away = std::hypot(p.x(), p.y()), cosine = (away - major) / minor;
  return {cosine / (minor * away), (major + 2 * minor * cosine) / (2 * minor * away)};
}

/// A surface of revolution around z whose meridian is the parabola r = a + b z + c z^2, z from 0 to 1: u turns, v climbs.
Surface turnedParabola(double a, double b, double c) {
  Surface surface{2, 2, circleKnots, {0, 0, 0, 1, 1, 1}, {}};
  const Vec2 meridian[] = {{a, 0}, {a + b / 2, 0.5}, {a + b + c, 1}};
  for (const Vec3& around : circlePoles(0, 1))
    for (const Vec2& at : meridian)
      surface.poles.emplace_back(around.x() * at.x(), around.y() * at.x(), around.z() * at.y(), around.z());
  return surface;
}

Mesh triangulatedTorus(double major, double minor, int around, int tube) {
  return triangulated(torusMesh(major, minor, around, tube)).first;
}

}  // namespace

class SurfaceCurvatureTest : public QObject {
  Q_OBJECT
 private slots:
  void spheresOfOcct() {
    const Tessellation t = tessellate(Brep(BRepPrimAPI_MakeSphere(gp_Pnt(3, -2, 7), 5).Shape()), curved);
    QVERIFY(!t.points.empty());
    QCOMPARE(t.curvatures.size(), t.points.size());
    Worst worst{.size = 5};
    for (const SurfaceCurvature& c : t.curvatures) worst.add(c, 1.0 / 25, 1.0 / 5);
    // At the poles a place a little inside counts; a sphere is the same there.
    QVERIFY2(worst.all() < 1e-6, worst.text());
  }

  /// A hole turns the cylinder round: seen from the free side it is hollow.
  void cylindersAndHoles() {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), gp_Pnt(10, 10, 8)).Shape();
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), 4, 20).Shape();
    for (const bool hole : {false, true}) {
      const Tessellation t = tessellate(Brep(hole ? BRepAlgoAPI_Cut(block, drill).Shape() : drill), curved);
      Worst onWall{.size = 4}, flat;
      int wall = 0;
      for (std::size_t i = 0; i < t.points.size(); ++i) {
        const bool upright =
            std::abs(t.normals[i].z()) < 0.5 && std::abs(std::hypot(t.points[i].x(), t.points[i].y()) - 4) < 0.1;
        (upright ? onWall : flat).add(t.curvatures[i], 0, upright ? (hole ? -1.0 : 1.0) / 8 : 0);
        wall += upright;
      }
      QVERIFY(wall > 20);
      QVERIFY2(onWall.all() < 1e-12, onWall.text());
      QVERIFY2(flat.all() < 1e-12, flat.text());
    }
  }

  void conesOfOcct() {
    const Tessellation t = tessellate(Brep(BRepPrimAPI_MakeCone(6, 2, 8).Shape()), curved);
    const double slant = std::hypot(1, 0.5);  // r = 6 - z / 2
    Worst worst;
    for (std::size_t i = 0; i < t.points.size(); ++i) {
      if (std::abs(t.normals[i].z()) > 0.9) continue;
      worst.add(t.curvatures[i], 0, 1 / (2 * std::hypot(t.points[i].x(), t.points[i].y()) * slant));
    }
    QVERIFY2(worst.all() < 1e-12, worst.text());
  }

  void toriOfOcctAndOfOurs() {
    const double major = 7, minor = 2.5;
    const Shape shapes[] = {Brep(BRepPrimAPI_MakeTorus(major, minor).Shape()), torusSurface(major, minor),
                            torusOfDegree9x12(major, minor), Brep(solidOf(toFace(torusSurface(major, minor))))};
    for (const Shape& shape : shapes) {
      const Tessellation t = tessellate(shape, curved);
      QCOMPARE(t.curvatures.size(), t.points.size());
      Worst worst{.size = minor};
      for (std::size_t i = 0; i < t.points.size(); ++i) {
        const auto [gaussian, mean] = ofTorus(major, minor, t.points[i]);
        worst.add(t.curvatures[i], gaussian, mean);
      }
      QVERIFY2(worst.all() < 1e-9, worst.text());
    }
  }

  /// K = -r'' / (r s^4), H = (1 / (r s) - r'' / s^3) / 2 with s^2 = 1 + r'^2, seen from outside.
  void rationalSurfacesOfRevolution() {
    auto random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const double a = uniform(random, 1.5, 3), b = uniform(random, -1, 1), c = uniform(random, -0.5, 0.5);
      const Tessellation t = tessellate(turnedParabola(a, b, c), curved);
      Worst worst;
      for (std::size_t i = 0; i < t.points.size(); ++i) {
        const double z = t.points[i].z(), r = a + b * z + c * z * z, slope = b + 2 * c * z, s = std::hypot(1, slope);
        const double outwards = t.normals[i].x() * t.points[i].x() + t.normals[i].y() * t.points[i].y() > 0 ? 1 : -1;
        worst.add(t.curvatures[i], -2 * c / (r * std::pow(s, 4)), outwards * (1 / (r * s) - 2 * c / std::pow(s, 3)) / 2);
      }
      QVERIFY2(worst.all() < 1e-10, worst.text());
    }
  }

  /// r = cosh z up to the second order at z = 1/2: minimal on that circle.
  void catenoidOnItsCircle() {
    const double c = std::cosh(0.5), s = std::sinh(0.5);
    const Surface surface = turnedParabola(c - s / 2 + c / 8, s - c / 2, c / 2);
    for (const double u : {0.0, 0.7, 2.3, 3.9}) {
      const auto found = curvatureOf(jetOf(surface, u, 0.5));
      QVERIFY(found.has_value());
      COMPARE_NEAR(found->mean, 0, 1e-13);
      COMPARE_NEAR(found->gaussian, -1 / std::pow(c, 4), 1e-13);
      COMPARE_NEAR(found->spread, 1 / (c * c), 1e-13);
    }
  }

  /// Neither another parametrisation nor a motion in space changes what a surface is.
  void curvatureBelongsToTheSurfaceAlone() {
    auto random = seededRandom();
    const auto vec = [&] { return Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)); };
    for (int k = 0; k < 500; ++k) {
      const SurfaceJet jet{vec(), vec(), vec(), vec(), vec()};
      const auto found = curvatureOf(jet);
      if (!found || jet.u.cross(jet.v).norm() < 0.05) continue;
      // u = a s + b t, v = c s + d t, seen in another frame of space.
      const double a = uniform(random, 0.5, 2), b = uniform(random, -1, 1), c = uniform(random, -1, 1),
                   d = uniform(random, 0.5, 2);
      if (a * d - b * c < 0.2) continue;
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(uniform(random, -3, 3), vec().normalized()).toRotationMatrix();
      const auto second = [&](double p, double q, double r, double s) {
        return Vec3(turn * (p * r * jet.uu + (p * s + q * r) * jet.uv + q * s * jet.vv));
      };
      const auto again = curvatureOf({turn * (a * jet.u + c * jet.v), turn * (b * jet.u + d * jet.v), second(a, c, a, c),
                                      second(a, c, b, d), second(b, d, b, d)});
      QVERIFY(again.has_value());
      const double scale = 1 + found->largest();
      COMPARE_NEAR(again->gaussian, found->gaussian, 1e-10 * scale * scale);
      COMPARE_NEAR(again->mean, found->mean, 1e-10 * scale);
      COMPARE_NEAR(again->spread, found->spread, 1e-10 * scale);
      COMPARE_NEAR(found->mean * found->mean - found->spread * found->spread, found->gaussian, 1e-10 * scale * scale);
    }
  }

  void instancesAreScaledAndMirrored() {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(5).Shape();
    auto part = std::make_shared<BrepPart>();
    part->shape = ball;
    gp_Trsf aside, mirrored;
    aside.SetTranslation(gp_Vec(40, 0, 0));
    mirrored.SetMirror(gp_Ax2(gp_Pnt(-40, 0, 0), gp_Dir(1, 0, 0)));
    const Brep assembly(std::vector<BrepInstance>{{"a", {}, aside, part}, {"b", {}, mirrored, part}});
    const Tessellation t = tessellate(assembly, curved);
    Worst worst{.size = 5};
    for (const SurfaceCurvature& c : t.curvatures) worst.add(c, 1.0 / 25, 1.0 / 5);
    QVERIFY2(worst.all() < 1e-6, worst.text());
  }

  void onlyWhereItIsAskedFor() {
    const Shape ball = Brep(BRepPrimAPI_MakeSphere(5).Shape());
    const Tessellation plain = tessellate(ball, {.chord = 0.02, .angle = 0.15}), more = tessellate(ball, curved);
    QVERIFY(plain.curvatures.empty());
    QVERIFY(plain.points == more.points && plain.normals == more.normals && plain.triangles == more.triangles);
  }

  /// Gauss and Bonnet: what is missing to full turns adds up to 2 pi times the Euler characteristic, whatever the mesh.
  void missingAnglesOfClosedMeshes() {
    auto random = seededRandom();
    for (int k = 0; k < 10; ++k) {
      Mesh mesh = k % 2 == 0 ? triangulatedTorus(6, 2, 20, 12) : triangulated(boxMesh({0, 0, 0}, {3, 4, 5})).first;
      for (Vec3& p : mesh.points)
        p += Vec3(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
      std::vector<std::array<int, 3>> triangles;
      for (std::size_t f = 0; f < mesh.faceCount(); ++f)
        triangles.push_back({mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]});
      const std::vector<Vec3> normals(mesh.points.size(), Vec3::UnitZ());
      const std::vector<SurfaceCurvature> c = discreteCurvature(mesh.points, normals, triangles);
      const std::vector<double> areas = mixedAreas(mesh.points, triangles);
      double total = 0, whole = 0;
      for (std::size_t i = 0; i < c.size(); ++i) total += c[i].gaussian * areas[i], whole += areas[i];
      COMPARE_NEAR(total, k % 2 == 0 ? 0 : 4 * std::numbers::pi, 1e-10);
      COMPARE_NEAR(whole, area(mesh), 1e-10);
    }
  }

  /// The finer the mesh, the nearer its curvatures are to those of the torus.
  void meshesComeNearTheSurface() {
    const double major = 7, minor = 2.5;
    double before = 0;
    for (const int fine : {1, 2, 4}) {
      const Tessellation t = tessellate(torusMesh(major, minor, 40 * fine, 24 * fine), curved);
      QCOMPARE(t.curvatures.size(), t.points.size());
      Worst worst{.size = minor};
      for (std::size_t i = 0; i < t.points.size(); ++i) {
        const auto [gaussian, mean] = ofTorus(major, minor, t.points[i]);
        worst.add(t.curvatures[i], gaussian, mean);
      }
      if (fine > 1) QVERIFY2(std::max(worst.gaussian, worst.mean) < 0.6 * before, worst.text());
      before = std::max(worst.gaussian, worst.mean);
    }
    QVERIFY(before < 0.02);
  }

  /// The sharp edges of a box part its points: every face of it is flat by itself.
  void sharpEdgesAreNoCurvature() {
    const Tessellation t = tessellate(boxMesh({0, 0, 0}, {3, 4, 5}), curved);
    for (const SurfaceCurvature& c : t.curvatures) COMPARE_NEAR(c.largest(), 0, 0);
  }
};

BLOSSOM_TEST(SurfaceCurvatureTest)
#include "surface_curvature_test.moc"
