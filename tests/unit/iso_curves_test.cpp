#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Eigen/Geometry>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/tessellate/iso_curves.h"
#include "support/solids.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

double lengthOf(const IsoCurve& curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) length += (curve.points[i] - curve.points[i - 1]).norm();
  return length;
}

double lengthOf(const std::vector<IsoCurve>& curves, int face) {
  double length = 0;
  for (const IsoCurve& curve : curves)
    if (curve.face == face) length += lengthOf(curve);
  return length;
}

}  // namespace

class IsoCurvesTest : public QObject {
  Q_OBJECT
 private slots:
  void spheresHaveCirclesOnThem() {
    const double radius = 5;
    const auto curves = isoCurves(Brep(BRepPrimAPI_MakeSphere(radius).Shape()), {.count = 6, .chord = 1e-3});
    QCOMPARE(curves.size(), std::size_t{12});
    for (const IsoCurve& curve : curves) {
      for (const Vec3& p : curve.points) COMPARE_NEAR(p.norm(), radius, 1e-12);
      // Meridians from pole to pole, parallels round at their latitude.
      const double wanted =
          curve.constantU ? std::numbers::pi * radius : 2 * std::numbers::pi * radius * std::cos(curve.parameter);
      QVERIFY(lengthOf(curve) <= wanted + 1e-9 && lengthOf(curve) > wanted * (1 - 1e-3));
      for (std::size_t i = 1; i < curve.points.size(); ++i) {  // a chord of length c stands c^2 / 8 r high
        const double chord = (curve.points[i] - curve.points[i - 1]).norm();
        QVERIFY(chord * chord / (8 * radius * std::max(0.05, curve.constantU ? 1 : std::cos(curve.parameter))) < 1.01e-3);
      }
    }
  }

  /// A hole through a plate cuts its lines: their length is that of the plate less what lies within the circle.
  void facesAreCutAtTheirEdges() {
    const double a = 20, r = 6;
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-a, -a, 0), gp_Pnt(a, a, 3)).Shape();
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), r, 9).Shape();
    const Brep brep(BRepAlgoAPI_Cut(plate, drill).Shape());
    const int count = 7;
    const auto curves = isoCurves(brep, {.count = count, .chord = 1e-4});
    double wanted = 0;
    for (int k = 1; k <= count; ++k) {
      const double at = -a + 2 * a * k / (count + 1);
      wanted += 2 * (2 * a - 2 * std::sqrt(std::max(0.0, r * r - at * at)));  // lines in both directions
    }
    int pierced = 0;
    for (int face = 0; face < 7; ++face) {
      bool flat = true, level = false;
      for (const IsoCurve& curve : curves) {
        if (curve.face != face) continue;
        for (const Vec3& p : curve.points) {
          const double z = curve.points.front().z();
          flat = flat && std::abs(p.z() - z) < 1e-12;
          level = std::abs(z) < 1e-9 || std::abs(z - 3) < 1e-9;
          if (level) QVERIFY(std::hypot(p.x(), p.y()) > r - 1e-9);
        }
      }
      if (!flat || !level) continue;
      ++pierced;
      COMPARE_NEAR(lengthOf(curves, face), wanted, 1e-6);
    }
    QCOMPARE(pierced, 2);
  }

  void everyPointLiesOnItsFace() {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(9, 4).Shape();
    const TopoDS_Shape half = BRepPrimAPI_MakeBox(gp_Pnt(-2, -20, -20), gp_Pnt(20, 20, 1)).Shape();
    const Brep brep(BRepAlgoAPI_Cut(torus, half).Shape());
    const auto curves = isoCurves(brep, {.count = 5, .chord = 0.05});
    QVERIFY(curves.size() > 20);
    for (const IsoCurve& curve : curves)
      for (const Vec3& p : {curve.points.front(), curve.points[curve.points.size() / 2], curve.points.back()}) {
        const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Shape();
        QVERIFY(BRepExtrema_DistShapeShape(faceOf(brep, curve.face), vertex).Value() < 1e-6);
      }
  }

  void patchesHaveTheirOwnCurves() {
    auto random = seededRandom();
    for (int k = 0; k < 10; ++k) {
      Surface surface{3,
                      2,
                      randomKnots(random, 3, {.clamped = true, .highest = 1}),
                      randomKnots(random, 2, {.clamped = true, .highest = 1}),
                      {}};
      for (std::size_t i = 0; i < surface.countU() * surface.countV(); ++i) surface.poles.push_back(randomPole(random, 10));
      const auto curves = isoCurves(surface, {.count = 4, .chord = 0.01});
      QCOMPARE(curves.size(), std::size_t{8});
      for (const IsoCurve& curve : curves) {
        const auto [from, to] = curve.constantU ? surface.domainV() : surface.domainU();
        const auto at = [&](double t) {
          return curve.constantU ? point(surface, curve.parameter, t) : point(surface, t, curve.parameter);
        };
        COMPARE_NEAR((curve.points.front() - at(from)).norm(), 0, 1e-10);
        COMPARE_NEAR((curve.points.back() - at(to)).norm(), 0, 1e-10);
        for (int i = 0; i <= 200; ++i) {  // the polyline misses no place of the curve by more than the chord
          const Vec3 p = at(from + (to - from) * i / 200);
          double nearest = 1e9;
          for (std::size_t j = 1; j < curve.points.size(); ++j) {
            const Vec3 a = curve.points[j - 1], along = curve.points[j] - a;
            const double t = std::clamp((p - a).dot(along) / std::max(1e-300, along.squaredNorm()), 0.0, 1.0);
            nearest = std::min(nearest, (p - a - t * along).norm());
          }
          QVERIFY2(nearest < 0.0101, qPrintable(QString::number(nearest)));
        }
      }
    }
  }

  /// Where a face closes onto itself, the curves are evenly spread and none lies on the seam.
  void closedPatchesSpreadThemEvenly() {
    const auto curves = isoCurves(torusSurface(7, 2), {.count = 8, .chord = 0.01});
    for (const IsoCurve& curve : curves) {
      COMPARE_NEAR(curve.parameter - std::floor(curve.parameter * 2) / 2, 0.25, 1e-12);
      COMPARE_NEAR((curve.points.front() - curve.points.back()).norm(), 0, 1e-10);
    }
  }

  void shapesWithoutParametersHaveNone() {
    QVERIFY(isoCurves(boxMesh({0, 0, 0}, {1, 1, 1})).empty());
    QVERIFY(isoCurves(Brep(BRepPrimAPI_MakeSphere(5).Shape()), {.count = 0}).empty());
    VERIFY_ERROR(isoCurves(boxMesh({0, 0, 0}, {1, 1, 1}), {.count = -1}), ErrorCode::InvalidParameter);
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(isoCurves(torusSurface(7, 2), {}, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(IsoCurvesTest)
#include "iso_curves_test.moc"
