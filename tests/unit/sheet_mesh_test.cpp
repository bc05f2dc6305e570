/// Triangles for the search of crossings: they must not overlap one another where the faces do not.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <gp_Vec.hxx>
#include <numbers>

#include "geometry/crossing/self_crossing.h"
#include "geometry/crossing/sheet_mesh.h"
#include "geometry/crossing/triangle_pairs.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/brep.h"
#include "support/crossing_shapes.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

class SheetMeshTest : public QObject {
  Q_OBJECT

  std::mt19937_64 random_;

  /// A straight wall of height 10 over a closed wavy curve in the plane z = 0, with two flat ends.
  TopoDS_Shape wavyPrism() {
    const int corners = 5 + static_cast<int>(uniform(random_, 0, 8));
    const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, corners);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * (k + uniform(random_, -0.2, 0.2)) / corners,
                   radius = uniform(random_, 6, 12);
      places->SetValue(k + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0));
    }
    GeomAPI_Interpolate curve(places, Standard_True, 1e-9);
    curve.Perform();
    BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(curve.Curve()).Edge());
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face(), gp_Vec(0, 0, 10)).Shape();
  }

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  /// A corner of an outline on the axis makes a pole, where the parameter around it means nothing.
  void trianglesAroundPolesDoNotFold() {
    double worst = -1;  // what folds covers more than the surface
    for (int round = 0; round < 60; ++round) {
      BRepBuilderAPI_MakePolygon outline;
      outline.Add(gp_Pnt(0, 0, uniform(random_, -8, -1)));
      outline.Add(gp_Pnt(uniform(random_, 2, 12), 0, uniform(random_, -1, 1)));
      if (round % 2 == 0) outline.Add(gp_Pnt(uniform(random_, 1, 9), 0, uniform(random_, 2, 5)));
      outline.Add(gp_Pnt(0, 0, uniform(random_, 6, 12)));
      outline.Close();
      const double turn = round % 3 == 0 ? 2 * std::numbers::pi : uniform(random_, 0.5, 5.5);
      const TopoDS_Shape turned =
          BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp::OZ(), turn).Shape();
      const double size = bounds(Shape(Brep(turned))).diagonal();
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(turned, properties);
      for (const double share : {4e-4, 1.5e-3}) {
        const SheetMesh mesh = sheetMesh(turned, share * size);
        double all = 0;
        for (const SheetTriangle& triangle : mesh.triangles) {
          const auto t = mesh.at(triangle);
          all += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
        }
        worst = std::max(worst, all / properties.Mass() - 1);
      }
      QVERIFY(!selfCrossing(turned, Progress::none()));
    }
    std::printf("figure triangles_beyond_the_area %.3g\n", worst);
    QVERIFY2(worst < 1e-4, qPrintable(QString::number(worst)));
  }

  void trianglesOfFlatEndsDoNotOverlap() {
    for (int round = 0; round < 40; ++round) {
      const TopoDS_Shape prism = wavyPrism();
      const double size = bounds(Shape(Brep(prism))).diagonal();
      for (const double share : {4e-4, 1.5e-3, 6e-3}) {
        const SheetMesh mesh = sheetMesh(prism, share * size);
        for (const double end : {0.0, 10.0}) {
          double up = 0, down = 0;
          for (const SheetTriangle& triangle : mesh.triangles) {
            const auto t = mesh.at(triangle);
            if (std::any_of(t.begin(), t.end(), [&](const Vec3& p) { return std::abs(p.z() - end) > 1e-9; })) continue;
            const double area = (t[1] - t[0]).cross(t[2] - t[0]).z() / 2;
            (area > 0 ? up : down) += std::abs(area);
          }
          const double turned = end > 0 ? down : up, all = up + down;
          QVERIFY2(turned <= 1e-9 * all,
                   qPrintable(QStringLiteral("%1 of %2 mm2 at z = %3 are turned over, chord %4 of the size")
                                  .arg(turned)
                                  .arg(all)
                                  .arg(end)
                                  .arg(share)));
        }
        const MeetingTriangles found = meetingTriangles(mesh, 1000, Progress::none());
        QCOMPARE(found.pairs.size() + found.lying.size(), std::size_t{0});
      }
      QVERIFY(!selfCrossing(prism, Progress::none()));
    }
  }
};

BLOSSOM_TEST(SheetMeshTest)
#include "sheet_mesh_test.moc"
