/// Outlines and paths that come as loose edges and wires, as STEP, IGES and BREP files give them.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include "geometry/shape/brep.h"
#include "support/command_line.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& part : parts) builder.Add(all, part);
  return all;
}

/// Edges without common vertices, every second one drawn backwards.
TopoDS_Shape looseEdges(const std::vector<gp_Pnt>& corners, bool closed = true) {
  std::vector<TopoDS_Shape> edges;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
    const gp_Pnt &from = corners[i], &to = corners[(i + 1) % corners.size()];
    edges.push_back(i % 2 == 0 ? BRepBuilderAPI_MakeEdge(from, to).Edge() : BRepBuilderAPI_MakeEdge(to, from).Edge());
  }
  return compound(edges);
}

TopoDS_Shape circleEdge(const gp_Pnt& center, double radius) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(center, gp_Dir(0, 0, 1)), radius)).Edge();
}

TopoDS_Shape squareWire(double from, double to, double z) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const auto& [x, y] : {std::pair(from, from), {to, from}, {to, to}, {from, to}}) polygon.Add(gp_Pnt(x, y, z));
  polygon.Close();
  return polygon.Wire();
}

const std::vector<gp_Pnt> triangle{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};

}  // namespace

class ModelingWireTest : public QObject {
  Q_OBJECT

 private slots:
  void looseEdgesThatCloseMakeSolids() {
    const Shape edges = Brep(looseEdges(triangle));
    const Evaluated prism = made("extrude", {{"height", 6}}, {edges});
    QVERIFY(isSound(prism));
    COMPARE_NEAR(volume(prism), 300, 1e-9);
    const Evaluated cone = made("revolve", {}, {edges});
    QVERIFY(isSound(cone));
    COMPARE_NEAR(volume(cone), 2000 * pi / 3, 1e-8);
    const Evaluated leaning = made("extrude", {{"height", 1}, {"taper", 45}}, {Brep(squareWire(0, 10, 0))});
    COMPARE_NEAR(volume(leaning), (1000 - 512) / 6.0, 1e-7);
  }

  void aCircleAloneMakesACylinder() {
    const Evaluated cylinder = made("extrude", {{"height", 3}}, {Brep(circleEdge({20, 0, 7}, 5))});
    QVERIFY(isSound(cylinder));
    COMPARE_NEAR(volume(cylinder), 75 * pi, 1e-8);
    COMPARE_NEAR(bounds(cylinder.shape).low.z(), 7, 1e-6);
    COMPARE_NEAR(volume(made("revolve", {{"point", {0, 0, 7}}}, {Brep(circleEdge({20, 0, 7}, 5))})), 1000 * pi * pi, 1e-6);
  }

  void whatLiesInsideIsAHoleAndWhatLiesInThatIsNot() {
    const Shape nested = Brep(compound(
        {squareWire(0, 20, 4), looseEdges({{2, 2, 4}, {18, 2, 4}, {18, 18, 4}, {2, 18, 4}}), circleEdge({10, 10, 4}, 3)}));
    const Evaluated solids = made("extrude", {{"height", 2}}, {nested});
    QVERIFY(isSound(solids));
    COMPARE_NEAR(volume(solids), 2 * (400 - 256 + 9 * pi), 1e-8);
    COMPARE_NEAR(figure(solids.shape, "components"), 2, 0);
  }

  void outlinesStandInAnyPlane() {
    const Vec3 axis = Vec3(1, 2, -0.5).normalized();
    gp_Trsf tilt, shift;
    tilt.SetRotation(gp_Ax1(gp_Pnt(3, 1, 2), gp_Dir(axis.x(), axis.y(), axis.z())), 1.1);
    shift.SetTranslation(gp_Vec(0, 0, 5));
    const TopoDS_Shape ring = compound({looseEdges({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}), circleEdge({4, 4, 0}, 2)});
    const Evaluated tilted = made("extrude", {{"height", 3}}, {Brep(ring.Moved(TopLoc_Location(tilt)))});
    QVERIFY(isSound(tilted));
    COMPARE_NEAR(volume(tilted), 3 * (64 - 4 * pi), 1e-7);
    // one above the other: two outlines, not an outline with a hole
    const TopoDS_Shape two = compound({squareWire(0, 8, 0), squareWire(2, 6, 5)});
    COMPARE_NEAR(volume(made("extrude", {{"height", 3}}, {Brep(two)})), 3 * (64 + 16), 1e-8);
    const Evaluated loft = made("loft", {{"ruled", true}}, {Brep(squareWire(0, 8, 0)), Brep(squareWire(2, 6, 6))});
    COMPARE_NEAR(volume(loft), 2 * (64 + 16 + 32), 1e-7);
  }

  void openChainsStaySheetsAndSolidOffDoesToo() {
    const Evaluated sheet = made("extrude", {{"height", 4}}, {Brep(looseEdges(triangle, false))});
    QVERIFY(measure(sheet.shape).kind != "solid");
    COMPARE_NEAR(figure(sheet.shape, "area"), 80, 1e-8);
    const Evaluated off = made("extrude", {{"height", 4}, {"solid", false}}, {Brep(looseEdges(triangle))});
    QVERIFY(measure(off.shape).kind != "solid");
    COMPARE_NEAR(figure(off.shape, "area"), 4 * (20 + 10 * std::sqrt(2.0)), 1e-8);
  }

  void crossingOutlinesAreRefusedWithTheirPlaceInSpace() {
    const auto bowtie = looseEdges({{0, 0, 3}, {10, 10, 3}, {10, 0, 3}, {0, 8, 3}});
    VERIFY_REFUSED(refusal("extrude", {}, {Brep(bowtie)}), ErrorCode::InvalidInput,
                   "crosses itself near (4.44444, 4.44444, 3)");
  }

  void edgesServeAsThePathOfAPipe() {
    const Region disc{{circle({0, 0}, 1)}};
    const auto corner = looseEdges({{0, 0, 0}, {20, 0, 0}, {20, 0, 30}}, false);  // a mitre keeps the middle line's length
    const Evaluated bent = made("pipe", {}, {disc, Brep(corner)});
    QVERIFY(isSound(bent));
    COMPARE_NEAR(volume(bent), 50 * pi, 1e-4);
    const Evaluated ring = made("pipe", {}, {disc, Brep(circleEdge({0, 0, 0}, 10))});
    QVERIFY(isSound(ring));
    COMPARE_NEAR(volume(ring), 20 * pi * pi, 1e-4);
  }

  void filesOfEveryKind() {
    COMPARE_NEAR(areaOf({"circle", "--radius", "5", "--centre", "20,0,0", "-o", "c.svg"}), 25 * pi, 1e-9);
    for (const char* file : {"c.step", "c.igs", "c.brep"}) {
      QCOMPARE(blossom({"convert", "c.svg", file}).code, 0);
      COMPARE_NEAR(volumeOf({"extrude", file, "--height", "3", "-o", "e.step"}), 75 * pi, 1e-6);
      COMPARE_NEAR(volumeOf({"revolve", file, "-o", "r.step"}), 1000 * pi * pi, 1e-5);
      COMPARE_NEAR(volumeOf({"pipe", "circle:1", file, "-o", "p.step"}), 10 * pi * pi, 1e-3);
    }
  }

 private:
  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }
  double resultOf(const QStringList& arguments, const char* name) const {
    const Answer ran = blossom(arguments);
    return ran.code == 0 ? ran.result(name) : std::nan("");
  }
  double volumeOf(const QStringList& arguments) const { return resultOf(arguments, "volume"); }
  double areaOf(const QStringList& arguments) const { return resultOf(arguments, "area"); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(ModelingWireTest)
#include "modeling_wire_test.moc"
