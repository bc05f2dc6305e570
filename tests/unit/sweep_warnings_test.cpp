/// What the warnings of a sweep say, and in what order.
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <cmath>
#include <numbers>

#include "exchange/cad/brep_export.h"
#include "exchange/cad/brep_import.h"
#include "geometry/occt/occt.h"
#include "geometry/shape/motion.h"
#include "support/modeling.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/crossing_cause.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// A coil about z whose layers pass through each other on their way to the middle, and all of which end in one point of the
/// axis, at the end of v.
Motion pointedCoil(double end) {
  constexpr int rows = 9;
  std::vector<double> knots{0};
  for (int i = 0; i < rows; ++i) knots.push_back(i);
  knots.push_back(rows - 1);
  Motion motion;
  motion.point = Vec3(1, 0, 0);
  motion.trajectory = {1, {0, 0, end, end}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 20, 1)}};
  motion.orientation = {1, 1, knots, {0, 0, end, end}, {}};
  motion.scaling = {1, 1, knots, {0, 0, end / 2, end, end}, {}};
  for (int i = 0; i < rows; ++i) {
    const double half = i * std::numbers::pi / 6;
    motion.orientation.poles.insert(motion.orientation.poles.end(), 2, Vec4(std::cos(half), 0, 0, std::sin(half)));
    for (const double factor : {10 + i / 6.0, 10 - i / 6.0, 0.0})
      motion.scaling.poles.emplace_back(factor, factor, factor, 1);
  }
  validate(motion);
  return motion;
}

}  // namespace

class SweepWarningsTest : public QObject {
  Q_OBJECT
 private slots:
  void theWorstIsToldFirst() {
    const Evaluated swept = made("sweep", {}, {pointedCoil(1)});
    QCOMPARE(swept.warnings.size(), std::size_t{2});
    QVERIFY2(swept.warnings[0].starts_with("The surface crosses itself near ("), swept.warnings[0].c_str());
    QVERIFY2(swept.warnings[1].starts_with("The surface has no normal near u = "), swept.warnings[1].c_str());
  }

  void placesAreToldInFourDigits() {
    constexpr double end = 0.6175850365689627;
    const Evaluated swept = made("sweep", {}, {pointedCoil(end)});
    QVERIFY2(swept.warnings.back().find(", v = 0.6176: it runs into a point") != std::string::npos,
             swept.warnings.back().c_str());

    // One trajectory cannot leave the plane of the sections by scaling alone.
    const Value pull{
        {"pulls", {{{"u", 1.2367299199104309}, {"v", end / 3}, {"to", {3, 4, 19}}}}}, {"rotate", 0.0}, {"scale", 1.0}};
    const Evaluated pulled = made("sweep-pull", pull, {pointedCoil(end)});
    QCOMPARE(pulled.warnings.size(), std::size_t{1});
    QVERIFY2(pulled.warnings[0].starts_with("At u = 1.237, v = 0.2059, "), pulled.warnings[0].c_str());
  }

  /// Neither a crossing nor none: 1 1/3 turns of one cylinder.
  void aSurfaceThatLiesOnItselfIsTold() {
    Motion motion = pointedCoil(1);
    for (Vec4& pole : motion.scaling.poles) pole = Vec4(10, 10, 10, 1);
    const Evaluated coil = made("sweep", {}, {motion});
    QVERIFY2(coil.warnings.at(0).starts_with("The surface lies on itself near ("), coil.warnings.at(0).c_str());
    QVERIFY(!std::any_of(coil.figures.begin(), coil.figures.end(),
                         [](const Measure& each) { return each.name == "crosses_itself"; }));
  }

  /// A thin tube along a loop crosses where the path does, and not because it bends.
  void whyItCrosses() {
    const Shape loop = polynomial({{0, 0, 0}, {160, 400, 0}, {-160, 400, 0}, {0, 0, 0.001}});
    QVERIFY(has(swept({loop}, 0.5), "two parts of the motion pass through each other"));
    // Turns of a wide coil that come too near each other, however many there are.
    for (const double turns : {10.0, 60.0}) {
      Motion coil;
      coil.trajectory = {1, {}, {}};
      constexpr int perTurn = 16;
      const int count = static_cast<int>(turns) * perTurn;
      for (int k = 0; k <= count; ++k) {
        const double angle = 2 * std::numbers::pi * k / perTurn;
        coil.trajectory.poles.emplace_back(100 * std::cos(angle), 100 * std::sin(angle), 15.0 * k / perTurn, 1);
        coil.trajectory.knots.push_back(k);
      }
      coil.trajectory.knots.insert(coil.trajectory.knots.begin(), 0);
      coil.trajectory.knots.push_back(count);
      const Motion tube = primitiveMotion({.radius = 20, .height = 10}).motion;
      coil.point = tube.point;
      coil.closedU = tube.closedU;
      coil.orientation = tube.orientation;
      coil.scaling = tube.scaling;
      for (Surface* factor : {&coil.orientation, &coil.scaling})
        for (double& knot : factor->knotsV) knot *= count;
      const double v = 4.4 * perTurn;
      const std::string cause = causeOfCrossing(coil, {0.25, v}, {0.75, v + perTurn}).cause;
      QVERIFY2(cause.starts_with("two parts of the motion pass through each other"), cause.c_str());
    }
    // A bend of radius 10 in a tube of radius 12.
    const Evaluated wide = swept({polynomial({{0, -30, 0}, {40, -10, 0}, {40, 10, 0}, {0, 30, 0}})}, 18);
    QVERIFY2(has(wide, "bends or turns more tightly than its sections are wide"), all(wide).c_str());
  }

  void aRingWithACornerIsTold() {
    const Evaluated tube =
        made("sweep-along", {{"radius", 0.5}}, {polynomial({{0, 0, 0}, {40, 0, 0}, {0, 40, 0}, {0, 0, 0}})});
    QVERIFY(has(tube, "with a corner of 90 degrees"));
    QVERIFY(!has(made("sweep-along", {{"radius", 0.5}}, {circle(10)}), "corner"));
  }

  void theFactorWithSmallWeightsIsNamed() {
    Motion motion = *made("sweep-along", {{"radius", 2.0}}, {polynomial({{0, 0, 0}, {0, 0, 5}, {0, 0, 10}, {0, 0, 15}})})
                         .shape.get<Motion>();
    for (Vec4& pole : motion.trajectory.poles) pole *= &pole == motion.trajectory.poles.data() ? 1 : 1e-8;
    const Evaluated surface = made("sweep", {}, {motion});
    QVERIFY2(has(surface, "weights of the trajectory differ much") && !has(surface, "quaternions"), all(surface).c_str());
  }

  /// The ends are one circle, which begins elsewhere.
  void aRingTurnedInItselfHasNoWall() {
    Motion ring = *made("sweep-along", {{"radius", 2.0}}, {circle(10)}).shape.get<Motion>();
    QVERIFY(isSound(made("sweep", {{"solid", true}}, {ring})));
    Surface& r = ring.orientation;
    for (std::size_t k = 0; k < r.poles.size(); ++k) {
      const double half = std::numbers::pi / 4 * static_cast<double>(k % r.countV()) / static_cast<double>(r.countV() - 1);
      r.poles[k] = times(r.poles[k], Vec4(std::cos(half), 0, 0, std::sin(half)));
    }
    const Error error = refusal("sweep", {{"solid", true}}, {ring});
    QVERIFY2(error.message().find("turned by 0.25 of") != std::string::npos, error.message().c_str());
  }

  /// A ring whose ends are only almost in one place is told to be closed, not turned.
  void aRingThatIsAlmostClosedIsToldToBe() {
    Motion ring = *made("sweep-along", {{"radius", 2.0}}, {circle(10)}).shape.get<Motion>();
    ring.trajectory.poles.back().z() += 5e-4;
    const Error error = refusal("sweep", {{"solid", true}}, {ring});
    QVERIFY2(error.message().find("but for 0.0005 mm") != std::string::npos, error.message().c_str());
  }

  /// Two places on both sides of the seam of a ring are near each other.
  void aSectionThatCrossesItselfAtTheSeamIsNamed() {
    const Motion ring = *made("sweep-along", {{"radius", 2.0}}, {circle(10)}).shape.get<Motion>();
    const auto [low, high] = ring.domainV();
    const double aside = 0.003 * (high - low);
    const CrossingCause cause = causeOfCrossing(ring, {0.2, high - aside}, {0.7, low + aside / 2});
    QVERIFY2(cause.cause.find("crosses itself") != std::string::npos, cause.cause.c_str());
  }

  /// What the inner side of its sections takes away is a void, which neither volume nor crossings tell.
  void aRingWiderThanItsBendIsNoSolid() {
    for (const double radius : {5.5, 8.0}) {
      const Shape ring = made("sweep-along", {{"radius", radius}}, {circle(5)}).shape;
      const Error error = refusal("sweep", {{"solid", true}}, {ring});
      QVERIFY2(error.message().starts_with("The ring turns inside out near ("), error.message().c_str());
      QVERIFY2(error.hint().starts_with("Make the sections smaller there"), error.hint().c_str());
      VERIFY_REFUSED(refusal("sweep-growth", {{"as", "solid"}}, {ring, ring}), ErrorCode::Degenerate, "turns inside out");
      QVERIFY(has(made("sweep", {}, {ring}), "folds over itself"));
    }
    QVERIFY(isSound(made("sweep", {{"solid", true}}, {made("sweep-along", {{"radius", 4.9}}, {circle(5)}).shape})));
  }

  /// A cylinder remains one, however its parameters run along it.
  void unevenParametersAreNoFold() {
    Motion cylinder = primitiveMotion({.rows = 8, .columns = 8}).motion;
    std::vector<Vec4>& poles = cylinder.trajectory.poles;
    const std::vector<double> weights{1, 1e-6, 1, 1e6, 1, 1, 1e3, 1, 1e-4, 1, 1};
    for (std::size_t k = 0; k < poles.size(); ++k) poles[k] *= weights.at(k);
    const Evaluated surface = made("sweep", {}, {cylinder});
    QVERIFY2(has(surface, "parameters run very unevenly") && !has(surface, "no normal"), all(surface).c_str());
  }

  void aDoubleConeDoesNotFold() {
    Motion cone = *made("sweep-along", {{"radius", 5.0}}, {polynomial({{0, 0, 0}, {0, 0, 5}, {0, 0, 10}, {0, 0, 15}})})
                       .shape.get<Motion>();
    Surface& s = cone.scaling;
    for (std::size_t k = 0; k < s.poles.size(); ++k)
      s.poles[k][0] *= 1 - 1.9 * static_cast<double>(k % s.countV()) / static_cast<double>(s.countV() - 1);
    const Evaluated surface = made("sweep", {}, {cone});
    QVERIFY(!has(surface, "folds over itself"));
    QVERIFY(std::any_of(surface.figures.begin(), surface.figures.end(),
                        [](const Measure& each) { return each.name == "crosses_itself"; }));
  }

  /// Files have ranges that pass the ends of their curves by a rounding.
  void anEdgeMayPassItsCurve() {
    const Handle(Geom_BSplineCurve) curve = toOcct(*polynomial({{0, 0, 0}, {0, 0, 5}, {3, 0, 10}, {0, 0, 15}}).get<Curve>());
    TopoDS_Edge edge;
    BRep_Builder().MakeEdge(edge, curve, 1e-7);
    BRep_Builder().Range(edge, curve->FirstParameter(), curve->LastParameter() + 2e-8);
    const Evaluated tube = made("sweep-along", {{"radius", 1.0}}, {Brep(edge)});
    QVERIFY(tube.shape.get<Motion>());
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "edge.brep").string();
    writeBrep(Brep(edge), path, Value::object(), Progress::none());
    const TopoDS_Shape again = readBrep(path, Progress::none()).brep.shape();
    double first = 0, last = 0;
    QVERIFY(!BRep_Tool::Curve(TopoDS::Edge(again), first, last).IsNull());
    QVERIFY(last == curve->LastParameter());
    QCOMPARE(planarCurves(edge).paths.size(), std::size_t{0});
  }

 private:
  static std::string all(const Evaluated& result) { return fmt::format("{}", fmt::join(result.warnings, "\n")); }
  static bool has(const Evaluated& result, const std::string& part) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
  }
  static Shape polynomial(const std::vector<Vec3>& poles) {
    Curve curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {}};
    for (const Vec3& p : poles) curve.poles.emplace_back(p.x(), p.y(), p.z(), 1);
    return curve;
  }
  static Shape circle(double radius) { return toCurve(ellipticArc({0, 0}, {radius, 0}, 1, 0, 2 * std::numbers::pi)); }
  static Evaluated swept(const std::vector<Shape>& path, double radius) {
    return made("sweep", {}, {made("sweep-along", {{"radius", radius}}, path).shape});
  }
};

BLOSSOM_TEST(SweepWarningsTest)
#include "sweep_warnings_test.moc"
