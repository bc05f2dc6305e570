#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <numbers>

#include <Eigen/Geometry>

#include "geometry/measure/measure.h"
#include "support/crossing_shapes.h"
#include "support/motion_integrals.h"
#include "support/motion_samples.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/begin/turning_spline.h"
#include "sweep/kernel/cubic_approximation.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

/// A tube that closes in u: circles whose radius is the spline `radii` over v, along z.
Motion tube(const std::vector<double>& radii, double lean) {
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  Motion motion;
  motion.closedU = ClosedU::AntiPeriodic;
  motion.point = Vec3::UnitX();
  motion.trajectory = {3, knots, {}};
  for (int j = 0; j < 4; ++j) motion.trajectory.poles.emplace_back(0, 0, 20.0 * j / 3, 1);
  std::vector<double> period;
  std::vector<Vec4> quaternions, scales;
  for (int i = 0; i < 8; ++i) {
    period.push_back(i / 8.0);
    const double half = pi * (i - 1) / 8;
    for (int j = 0; j < 4; ++j) {
      quaternions.emplace_back(std::cos(half), 0, lean * std::sin(2 * half) * std::sin(half), std::sin(half));
      const double r = radii[static_cast<std::size_t>(j)];
      scales.emplace_back(r, r, r, 1);
    }
  }
  period.push_back(1);
  motion.orientation = unwrapped(3, 3, period, knots, quaternions, -1);
  motion.scaling = unwrapped(3, 3, period, knots, scales, 1);
  return motion;
}

/// A straight tube of height 40 whose section is round at the start. On the way along it becomes the edge that `thin` leaves
/// of it; with both ends, it begins as that edge, too.
Motion chisel(const Vec2& thin, bool bothEnds) {
  constexpr int rows = 16;
  constexpr double radius = 10, seam = 0.3;
  // The share of the round section: 1 - t, or 4 t (1 - t), a parabola of the coefficients 0, 2, 0.
  const std::vector<double> shares = bothEnds ? std::vector<double>{0, 2, 0} : std::vector<double>{1, 0.5, 0};
  std::vector<double> period;
  std::vector<Vec4> scales;
  for (int i = 0; i < rows; ++i) {
    period.push_back(i / static_cast<double>(rows));
    const double angle = seam + 2 * pi * i / rows;
    const Vec2 round = radius * Vec2(std::cos(angle), std::sin(angle));
    for (const double share : shares) {
      const Vec2 p = share * round + (1 - share) * round.dot(thin) * thin;
      scales.emplace_back(p.x(), p.y(), 0, 1);
    }
  }
  period.push_back(1);
  Motion motion;
  motion.closedU = ClosedU::Periodic;
  motion.point = Vec3::Ones();
  motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 40, 1)}};
  motion.orientation = unwrapped(1, 1, period, {0, 0, 1, 1}, std::vector<Vec4>(2 * rows, Vec4(1, 0, 0, 0)), 1);
  motion.scaling = unwrapped(3, 2, period, {0, 0, 0, 1, 1, 1}, scales, 1);
  return motion;
}

/// Of the section at v, in the plane of x and y.
double areaOfSection(const Motion& motion, double v) {
  constexpr int corners = 20000;
  double area = 0;
  Vec3 last = evaluate(motion, 0, v).point;
  for (int k = 1; k <= corners; ++k) {
    const Vec3 next = evaluate(motion, static_cast<double>(k) / corners, v).point;
    area += (last.x() * next.y() - last.y() * next.x()) / 2;
    last = next;
  }
  return area;
}

std::string refusalOf(const Motion& motion) {
  try {
    makeSolid(productSurface(motion).surface);
  } catch (const Error& error) {
    return error.message();
  }
  return "It was not refused.";
}

double volumeOf(const SolidResult& result) {
  for (const Measure& value : measure(Brep(result.solid)).values)
    if (value.name == "volume") return std::get<double>(value.value);
  return 0;
}

void verifySolid(const SolidResult& result) {
  QVERIFY(BRepCheck_Analyzer(result.solid).IsValid());
  for (TopExp_Explorer shells(result.solid, TopAbs_SHELL); shells.More(); shells.Next())
    QVERIFY(BRep_Tool::IsClosed(shells.Current()));
  QVERIFY(volumeOf(result) > 0);
}

}  // namespace

class SweepSolidTest : public QObject {
  Q_OBJECT
 private slots:
  /// A small body far from the origin ends as it does beside it: in points, planes or itself.
  void whereABodyLiesDoesNotChangeItsEnds() {
    for (const PrimitiveKind kind : {PrimitiveKind::Sphere, PrimitiveKind::Cylinder, PrimitiveKind::Torus}) {
      const Motion plain = primitiveMotion({.kind = kind, .radius = 0.01, .profile = 0.004, .height = 0.02}).motion;
      const SolidResult here = makeSolid(productSurface(plain).surface);
      for (const double far : {1e5, 1e6}) {
        Motion moved = plain;
        for (Vec4& pole : moved.trajectory.poles) pole.head<3>() += pole[3] * Vec3(far, far / 3, -far);
        const SolidResult there = makeSolid(productSurface(moved).surface);
        QVERIFY(there.start == here.start && there.end == here.end);
      }
    }
  }

  /// What is the same point is told by the size of the surface: a gap stays one however far poles of small weights lie.
  void gapsAreFoundBesidePolesFarAway() {
    const std::vector<Vec3> straight{{0, 0, 0}, {0, 0, 40}};
    const double weight = 1e-6, gap = 1e-4;  // poles at 1e7
    const SolidResult closed = makeSolid(circleMoved(circleWithFarPoles(10, weight), straight));
    verifySolid(closed);
    COMPARE_NEAR(volumeOf(closed), pi * 100 * 40, 1e-5 * pi * 100 * 40);
    VERIFY_ERROR(makeSolid(circleMoved(circleWithFarPoles(10, weight, gap), straight)), ErrorCode::InvalidInput);
  }

  void cylinderHasItsVolume() {
    const Motion motion = readMotionOf("cylinder.json");
    const double wanted = pi * 100 * 40;
    // Divergence theorem with the field (x, y, 0) / 2, to which the planar caps add nothing.
    const double volume =
        integrate(motion, 32, [](const Vec3& p, const Vec3& n) { return (p.x() * n.x() + p.y() * n.y()) / 2; });
    COMPARE_NEAR(std::abs(volume), wanted, 1e-9 * wanted);
    const SolidResult solid = makeSolid(productSurface(motion).surface);
    verifySolid(solid);
    QCOMPARE(solid.start, EndCap::Planar);
    QCOMPARE(solid.end, EndCap::Planar);
    COMPARE_NEAR(volumeOf(solid), wanted, 1e-6 * wanted);
  }

  void torusHasItsVolume() {
    const Motion motion = readMotionOf("torus.json");
    const double wanted = 2 * pi * pi * 30 * 100;
    const double volume = volumeEnclosed(motion, 32);
    COMPARE_NEAR(std::abs(volume), wanted, 1e-9 * wanted);
    const SolidResult solid = makeSolid(productSurface(motion).surface);
    verifySolid(solid);
    QCOMPARE(solid.start, EndCap::None);
    COMPARE_NEAR(volumeOf(solid), wanted, 1e-6 * wanted);
  }

  void helicoidHasItsArea() {
    // Two turns of pitch 20: sqrt(rho^2 + c^2) integrated over rho from 0 to 25 and the angle, c = 20 / 2 pi.
    const double c = 20 / (2 * pi), r = 25;
    const double wanted = 4 * pi * (r * std::hypot(r, c) + c * c * std::asinh(r / c)) / 2;
    const double area = integrate(readMotionOf("helicoid.json"), 64, [](const Vec3&, const Vec3& n) { return n.norm(); });
    COMPARE_NEAR(area, wanted, 1e-8 * wanted);
  }

  void samplesAreValidSolids_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"propeller.json", "twisted-tube.json", "torus.json", "cylinder.json"})
      QTest::newRow(name) << name;
  }
  void samplesAreValidSolids() {
    QFETCH(QString, name);
    const Motion motion = readMotionOf(qPrintable(name));
    const SolidResult exact = makeSolid(productSurface(motion).surface);
    verifySolid(exact);
    const SolidResult cubic = makeSolid(approximateCubic(motion, {.tolerance = 1e-3}).surface);
    verifySolid(cubic);
    COMPARE_NEAR(volumeOf(cubic), volumeOf(exact), 1e-4 * volumeOf(exact));
  }

  void endsThatRunIntoAPointNeedNoCap() {
    const SolidResult lens = makeSolid(productSurface(tube({0, 10, 10, 0}, 0)).surface);
    verifySolid(lens);
    QCOMPARE(lens.start, EndCap::Point);
    QCOMPARE(lens.end, EndCap::Point);
    // Radius 30 t (1 - t), height 20: pi * 900 * 20 * integral of t^2 (1 - t)^2 = pi * 18000 / 30.
    COMPARE_NEAR(volumeOf(lens), pi * 600, 1e-5 * pi * 600);
    const SolidResult drop = makeSolid(productSurface(tube({0, 8, 9, 5}, 0)).surface);
    verifySolid(drop);
    QCOMPARE(drop.end, EndCap::Planar);
  }

  /// What is a point beside the size of the body becomes one, though OCCT could tell its poles apart.
  void endsThatAreNearlyPointsBecomePoints() {
    for (const double top : {1e-7, 1e-6, 2e-6, 5e-6}) {
      Motion cone = primitiveMotion({.kind = PrimitiveKind::Cylinder, .radius = 1000, .height = 10000}).motion;
      const auto greville = grevilleAbscissae(cone.scaling.degreeV, cone.scaling.knotsV);
      for (std::size_t i = 0; i < cone.scaling.countU(); ++i)
        for (std::size_t j = 0; j < cone.scaling.countV(); ++j)
          cone.scaling.pole(i, j).head<3>() *= (1000 * (1 - greville[j]) + top * greville[j]) / 1000;
      const SolidResult solid = makeSolid(productSurface(cone).surface);
      verifySolid(solid);
      QCOMPARE(solid.end, EndCap::Point);
      const double wanted = pi * 1e6 * 1e4 / 3;
      COMPARE_NEAR(volumeOf(solid), wanted, 1e-6 * wanted);
    }
  }

  /// The ends of a body are told apart however short the domain of its parameters is.
  void shortDomainsHaveTheirEnds() {
    for (const auto& [from, length] : std::vector<std::pair<double, double>>{
             {0, 1e-6}, {0, 1e-9}, {0, 5e-10}, {0, 1e-12}, {0, 1e6}, {1, 1e-5}, {1, 1e-6}, {1, 3e-7}, {-1e3, 1e-5}}) {
      Motion motion = readMotionOf("cylinder.json");
      for (std::vector<double>* knots : {&motion.trajectory.knots, &motion.orientation.knotsV, &motion.scaling.knotsV})
        for (double& knot : *knots) knot = from + knot * length;
      for (std::vector<double>* knots : {&motion.orientation.knotsU, &motion.scaling.knotsU})
        for (double& knot : *knots) knot = from + knot * std::min(length, 1e-3);
      const SolidResult solid = makeSolid(productSurface(motion).surface);
      verifySolid(solid);
      COMPARE_NEAR(volumeOf(solid), pi * 100 * 40, 1e-6 * pi * 100 * 40);
    }
  }

  /// A tube that ends in a straight edge, whose ends lie at the seam or elsewhere: no cap, and the side meets itself along
  /// the edge.
  void endsThatAreEdgesNeedNoCap() {
    for (const bool bothEnds : {false, true})
      for (const Vec2& thin : {Vec2(0, 1), Vec2(1, 0), Vec2(0.6, 0.8), Vec2(std::cos(0.3), std::sin(0.3))}) {
        const Motion motion = chisel(thin, bothEnds);
        const SolidResult solid = makeSolid(productSurface(motion).surface);
        verifySolid(solid);
        QCOMPARE(solid.end, EndCap::Edge);
        QCOMPARE(solid.start, bothEnds ? EndCap::Edge : EndCap::Planar);
        // Sections are as large as the share of the round one, whose mean is 1/2 or 2/3.
        const double wanted = bothEnds ? areaOfSection(motion, 0.5) * 40 * 2 / 3 : areaOfSection(motion, 0) * 40 / 2;
        COMPARE_NEAR(volumeOf(solid), wanted, 1e-6 * wanted);
        for (TopExp_Explorer faces(solid.solid, TopAbs_FACE); faces.More(); faces.Next()) {
          const Brep face(faces.Current());
          for (const Measure& each : measure(face).values)
            if (each.name == "area") QVERIFY(std::get<double>(each.value) > 1);
        }
        for (TopExp_Explorer edges(solid.solid, TopAbs_EDGE); edges.More(); edges.Next())
          QVERIFY(BRep_Tool::Tolerance(TopoDS::Edge(edges.Current())) < 1e-4);
      }
  }

  /// What both ends share may be one point: nothing there is a wall.
  void aRingThatIsPinchedIsToldSo() {
    Motion ring = readMotionOf("torus.json");
    Surface& s = ring.scaling;
    for (std::size_t k = 0; k < s.poles.size(); ++k)
      if (k % s.countV() == 0 || k % s.countV() + 1 == s.countV()) s.poles[k].head<3>().setZero();
    const std::string message = refusalOf(ring);
    QVERIFY2(message.find("pinched") != std::string::npos, message.c_str());
  }

  void whatIsTooLargeIsToldSo() {
    const std::string message = refusalOf(primitiveMotion({.kind = PrimitiveKind::Sphere, .radius = 5e8}).motion);
    QVERIFY2(message.starts_with("The sweep is too large for a solid"), message.c_str());
    verifySolid(makeSolid(productSurface(primitiveMotion({.kind = PrimitiveKind::Sphere, .radius = 2e7}).motion).surface));
  }

  void bentEndsAreClosedByCones() {
    const SolidResult result = makeSolid(productSurface(tube({10, 8, 9, 10}, 0.3)).surface);
    verifySolid(result);
    QCOMPARE(result.start, EndCap::Cone);
    QCOMPARE(result.end, EndCap::Cone);
  }

  /// Radius 10 cos(theta): the circle through the origin, run through twice. OCCT never ends on a cap with such an outline.
  void sectionsThatCoverThemselvesAreRefusedWithTheirPlace() {
    const auto refusedWith = [](int waves) {
      Motion motion = tube({10, 10, 10, 10}, 0);
      const std::size_t columns = motion.scaling.countV();
      for (std::size_t k = 0; k < motion.scaling.poles.size(); ++k) {
        const double at = pi * waves * (static_cast<double>(k / columns) - 1) / 4;
        motion.scaling.poles[k].head<3>() *= std::cos(at);
      }
      try {
        makeSolid(productSurface(motion).surface);
      } catch (const Error& error) {
        return std::pair(error.code(), error.message());
      }
      return std::pair(ErrorCode::Cancelled, std::string("It is no solid, but was not refused."));
    };
    for (const int waves : {1, 2}) {  // a circle twice, and a rose of four leaves
      const auto [code, message] = refusedWith(waves);
      QVERIFY2(code == ErrorCode::Degenerate, message.c_str());
      QVERIFY2(message.find("crosses itself near (") != std::string::npos, message.c_str());
      QVERIFY2(message.find("at the start, v = 0") != std::string::npos, message.c_str());
    }
  }

  void openSurfaceIsNoBody() {
    VERIFY_ERROR(makeSolid(productSurface(readMotionOf("helicoid.json")).surface), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(SweepSolidTest)
#include "sweep_solid_test.moc"
