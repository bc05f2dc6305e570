#include <BRepCheck_Analyzer.hxx>
#include <Eigen/Geometry>
#include <fstream>
#include <numbers>

#include "core/file.h"
#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure.h"
#include "support/motion_integrals.h"
#include "support/motion_samples.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/cubic_approximation.h"
#include "sweep/kernel/edit/direct_manipulation.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"
#include "sweep/kernel/vanishing.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

/// A helix whose quaternions stand at the half-angles given, in degrees, one span between each two.
Value turning(const std::vector<double>& halfAngles) {
  Value row = Value::array(), scales = Value::array(), knots = Value::array({0.0});
  for (std::size_t j = 0; j < halfAngles.size(); ++j) {
    const double half = halfAngles[j] * pi / 180;
    row.push_back({std::cos(half), 0.0, 0.0, std::sin(half)});
    scales.push_back({1.0, 1.0, 1.0, 1.0});
    knots.push_back(static_cast<double>(j));
  }
  knots.push_back(knots.back());
  const Value both = Value::array({Value::array({0, 0, 1, 1}), knots});
  const double end = knots.back().get<double>();
  return {{"trajectory", {{"degree", 1}, {"knots", {0.0, 0.0, end, end}}, {"poles", {{0, 0, 0}, {0, 0, 30}}}}},
          {"orientation", {{"degree", {1, 1}}, {"knots", both}, {"poles", {row, row}}}},
          {"scaling", {{"degree", {1, 1}}, {"knots", both}, {"poles", {scales, scales}}}},
          {"point", {10, 0, 0}}};
}

/// Degrees that the swept point turns about z from one end in v to the other, counted in small steps.
double totalTurn(const Motion& motion) {
  const auto [first, last] = motion.domainV();
  constexpr int steps = 3000;
  double turn = 0;
  Vec3 before = evaluate(motion, 0.5, first).point;
  for (int k = 1; k <= steps; ++k) {
    const Vec3 now = evaluate(motion, 0.5, first + (last - first) * k / steps).point;
    turn += std::atan2(before.x() * now.y() - before.y() * now.x(), before.x() * now.x() + before.y() * now.y());
    before = now;
  }
  return turn * 180 / pi;
}

/// Bilinear in u and v, everything constant but the quaternions: rows of u, entries of v.
Motion soundMotion(int degreeV, const std::vector<std::vector<Vec4>>& quaternions) {
  std::vector<double> knots(static_cast<std::size_t>(degreeV) + 1, 0.0);
  knots.insert(knots.end(), static_cast<std::size_t>(degreeV) + 1, 1.0);
  Motion motion;
  motion.point = Vec3(1, 0, 0);
  motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 1, 1)}};
  motion.scaling = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4::Ones())};
  motion.orientation = {1, degreeV, {0, 0, 1, 1}, knots, {}};
  for (const auto& row : quaternions)
    motion.orientation.poles.insert(motion.orientation.poles.end(), row.begin(), row.end());
  return motion;
}

/// A motion that closes in u with so few rows that its basis functions overlap more often than there are rows.
Motion fewRows(Random& random, ClosedU closed, std::size_t rows) {
  Motion motion = randomMotion(random, ClosedU::No, true);
  std::vector<double> period;
  for (std::size_t i = 0; i <= rows; ++i) period.push_back(static_cast<double>(i) / static_cast<double>(rows));
  const auto surface = [&](const Surface& like, double sign, auto pole) {
    std::vector<Vec4> poles;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < like.countV(); ++j)
        poles.push_back(pole(static_cast<double>(i) / static_cast<double>(rows)));
    return unwrapped(3, like.degreeV, period, like.knotsV, poles, sign);
  };
  motion.closedU = closed;
  const double turn = closed == ClosedU::AntiPeriodic ? pi : 0;
  motion.orientation = surface(motion.orientation, closed == ClosedU::AntiPeriodic ? -1 : 1,
                               [&](double at) { return randomQuaternion(random, turn * at); });
  motion.scaling = surface(motion.scaling, 1, [&](double) { return randomScale(random); });
  validate(motion);
  return motion;
}

double solidVolume(const SolidResult& result) {
  for (const Measure& value : measure(Brep(result.solid)).values)
    if (value.name == "volume") return std::get<double>(value.value);
  return 0;
}

}  // namespace

class SweepSoundTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

  Imported read(const Value& json) const {
    const auto path = folder_.path() / "motion.json";
    std::ofstream(path, std::ios::binary) << json.dump();
    return motionFormat().read(path, Value::object(), Progress::none());
  }

 private slots:
  void theMotionTurnsTheWayItsSignsSay() {
    // 200 degrees from pole to pole, 600 in all; with other signs it would be -160 each.
    const Imported imported = read(turning({0, 100, 200, 300}));
    const Motion& motion = *imported.shape.get<Motion>();
    COMPARE_NEAR(totalTurn(motion), 600, 1e-9);
    // Half-way between two poles of the same length the half-angle is half-way, too: 50 degrees.
    const Vec3 middle = evaluate(motion, 0.5, 0.5).point;
    const double angle = 100 * pi / 180;
    QVERIFY((middle - Vec3(10 * std::cos(angle), 10 * std::sin(angle), 5)).norm() < 1e-12);
    QCOMPARE(imported.warnings.size(), std::size_t(1));
    QVERIFY(imported.warnings[0].find("more than half a turn") != std::string::npos);
    QVERIFY(imported.warnings[0].find("same") == std::string::npos);
    std::printf("figure kept_turn_degrees %.9g\n", totalTurn(motion));
  }
  void theOtherSenseIsKeptAsWell() {
    COMPARE_NEAR(totalTurn(*read(turning({0, -100, -200, -300})).shape.get<Motion>()), -600, 1e-9);
  }
  void lostSignsAreStillFound() {
    // 120 degrees from pole to pole; programs that keep w >= 0 have lost the signs.
    const Imported imported = read(turning({0, 60, 120 - 180, 0}));
    COMPARE_NEAR(totalTurn(*imported.shape.get<Motion>()), 360, 1e-9);
    QCOMPARE(imported.warnings.size(), std::size_t(1));
    QVERIFY(imported.warnings[0].find("the shorter way") != std::string::npos);
    // 10 degrees from pole to pole with every second sign turned round.
    COMPARE_NEAR(totalTurn(*read(turning({0, 185, 10, 195})).shape.get<Motion>()), 30, 1e-9);
  }

  void aTubeThatCrossesItselfIsRefusedWithItsPlace() {
    Motion motion = readMotionOf("twisted-tube.json");
    (void)makeSolid(productSurface(motion).surface);
    for (Vec4& pole : motion.scaling.poles) pole.head<3>() *= 6;
    Vec3 place = Vec3::Zero();
    bool refused = false;
    try {
      (void)makeSolid(productSurface(motion).surface);
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::Degenerate);
      const auto at = error.message().find('(');
      QVERIFY2(at != std::string::npos, error.what());
      QCOMPARE(std::sscanf(error.message().c_str() + at, "(%lf, %lf, %lf)", &place.x(), &place.y(), &place.z()), 3);
      refused = true;
    }
    QVERIFY(refused);
    // At that place two parts of the surface meet that lie far from each other along the motion: seen on the motion itself.
    std::vector<double> us, vs;
    for (int k = 0; k <= 800; ++k) us.push_back(k / 800.0), vs.push_back(k / 800.0);
    MotionGrid grid;
    evaluateGrid(motion, us, vs, grid, GridDerivatives::No);
    double low = 1, high = 0, largest = 0;
    for (std::size_t k = 0; k < us.size(); ++k)
      for (std::size_t l = 0; l < vs.size(); ++l) {
        largest = std::max(largest, grid.pointAt(k, l).norm());
        if ((grid.pointAt(k, l) - place).norm() < 1.0) low = std::min(low, vs[l]), high = std::max(high, vs[l]);
      }
    QVERIFY2(high - low > 0.05, qPrintable(QString("%1 .. %2").arg(low).arg(high)));
    std::printf("figure crossing_spans_v %.3g\n", high - low);
  }

  void straightSidesAndFlatEndsAreNoCrossing() {
    // A star with straight edges: rims whose points lie on lines, rounded.
    auto random = seededRandom();
    for (int k = 0; k < 5; ++k) {
      constexpr int rows = 12;
      std::vector<double> period;
      std::vector<Vec4> quaternions, scales;
      const Vec4 leaning = randomQuaternion(random, 0.4);
      for (int i = 0; i < rows; ++i) {
        period.push_back(i / static_cast<double>(rows));
        const double angle = 2 * pi * i / rows, radius = i % 2 == 0 ? 10 : uniform(random, 4, 9);
        for (int j = 0; j < 2; ++j) {
          quaternions.push_back(leaning);
          scales.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1, 1);
        }
      }
      period.push_back(1);
      Motion motion;
      motion.closedU = ClosedU::Periodic;
      motion.point = Vec3(1, 1, 0);
      motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(3, 2, 40, 1)}};
      motion.orientation = unwrapped(1, 1, period, {0, 0, 1, 1}, quaternions, 1);
      motion.scaling = unwrapped(1, 1, period, {0, 0, 1, 1}, scales, 1);
      const SolidResult solid = makeSolid(productSurface(motion).surface);
      // A prism: the area of the section times the way along its normal.
      double area = 0;
      for (int i = 0; i < rows; ++i) {
        const Vec4 &a = scales[static_cast<std::size_t>(2 * i)], &b = scales[static_cast<std::size_t>(2 * ((i + 1) % rows))];
        area += (a.x() * b.y() - a.y() * b.x()) / 2;
      }
      const Vec3 normal = Eigen::Quaterniond(leaning[0], leaning[1], leaning[2], leaning[3]).normalized() * Vec3::UnitZ();
      const double wanted = std::abs(area * normal.dot(Vec3(3, 2, 40)));
      COMPARE_NEAR(solidVolume(solid), wanted, 1e-6 * wanted);
    }
  }

  void dragsArriveWithFewRows() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
      const std::size_t rows = 1 + static_cast<std::size_t>(k % 4);
      // One row that comes back negated is no orientation.
      const ClosedU closed = rows > 1 && k % 8 < 4 ? ClosedU::AntiPeriodic : ClosedU::Periodic;
      Motion motion = fewRows(random, closed, rows);
      const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
      if (evaluate(motion.orientation, u, v).norm() < 0.1) continue;
      const Vec3 target(uniform(random, -20, 20), uniform(random, -20, 20), uniform(random, -20, 20));
      dragScaling(motion, u, v, target);
      worst = std::max(worst, (evaluate(motion, u, v).point - target).norm());
      const Vec3 centre = point(motion.trajectory, v), arm = target - centre, axis(0.3, 0.2, 1);
      twistOrientation(motion, u, v, axis, 35);
      const Vec3 wanted = Eigen::AngleAxisd(35 * pi / 180, axis.normalized()) * arm;
      worst = std::max(worst, (evaluate(motion, u, v).point - centre - wanted).norm());
      validate(motion);
    }
    QVERIFY2(worst < 1e-10, qPrintable(QString::number(worst)));
    std::printf("figure few_rows_miss_mm %.3g\n", worst);
  }

  void degreesAbove25AreRefused() {
    const auto ofDegree = [](int degree) {
      std::vector<Vec4> row;
      for (int j = 0; j <= degree; ++j) {
        const double half = 0.3 * j / degree;
        row.emplace_back(std::cos(half), 0, 0, std::sin(half));
      }
      return soundMotion(degree, {row, row});
    };
    Motion motion = ofDegree(11);  // 1 + 2 * 11 + 1 = 24
    QCOMPARE(productSurface(motion).surface.degreeV, 24);
    motion.trajectory = elevateDegree(motion.trajectory, 1);
    QCOMPARE(productSurface(motion).surface.degreeV, 25);
    motion.trajectory = elevateDegree(motion.trajectory, 1);
    VERIFY_ERROR(productSurface(motion), ErrorCode::LimitExceeded);
    // What the error offers instead works.
    QVERIFY(approximateCubic(motion, {.tolerance = 1e-4}).deviation <= 1e-4);
  }

  void nearlyOppositeQuaternionsAreSettled() {
    // Along the line v = 1/2 the length is 1.5e-6 for every u; split evenly, 2^40 patches would lie along it.
    const Vec4 ahead(1, 0, 0, 0), back(-1, 0, 0, 3e-6);
    requireNonVanishing(soundMotion(1, {{ahead, back}, {ahead, back}}).orientation);
    // The line of near misses bends.
    const Vec4 bent(-0.5, 0, 0, 1e-5), far(-1.5, 0, 0, 1e-5);
    requireNonVanishing(soundMotion(1, {{ahead, bent}, {ahead, far}}).orientation);
    requireNonVanishing(
        soundMotion(3, {{ahead, Vec4(0.4, 0, 1e-6, 4e-6), bent, far}, {far, bent, ahead, ahead + 1e-5 * Vec4::UnitW()}})
            .orientation);
  }
  void quaternionsThatVanishAreFoundWithTheirPlace() {
    auto random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const double u = uniform(random, 0.1, 0.9), v = uniform(random, 0.1, 0.9);
      // w = v - v0, x = u - u0.
      const Motion motion =
          soundMotion(1, {{Vec4(-v, -u, 0, 0), Vec4(1 - v, -u, 0, 0)}, {Vec4(-v, 1 - u, 0, 0), Vec4(1 - v, 1 - u, 0, 0)}});
      try {
        requireNonVanishing(motion.orientation);
        QFAIL("accepted");
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::Degenerate);
        double foundU = -1, foundV = -1;
        const auto at = error.message().find("u = ");
        QCOMPARE(std::sscanf(error.message().c_str() + at, "u = %lf, v = %lf", &foundU, &foundV), 2);
        COMPARE_NEAR(foundU, u, 1e-3);
        COMPARE_NEAR(foundV, v, 1e-3);
      }
    }
    // A whole line of zeros ends as well.
    VERIFY_ERROR(
        requireNonVanishing(
            soundMotion(1, {{Vec4(1, 0, 0, 0), Vec4(-1, 0, 0, 0)}, {Vec4(2, 0, 0, 0), Vec4(-1, 0, 0, 0)}}).orientation),
        ErrorCode::Degenerate);
  }

  void aRingClosesWhateverTheLengthsOfItsQuaternions() {
    for (const double length : {1.0, 2.0, 0.5, 7.0}) {
      Motion motion = readMotionOf("torus.json");
      Surface& r = motion.orientation;
      for (std::size_t i = 0; i < r.countU(); ++i) r.pole(i, r.countV() - 1) *= length;
      // The last sections are turned between other neighbours, so that only the plain torus has the volume of one.
      const double wanted = std::abs(volumeEnclosed(motion, 128));
      if (length == 1) COMPARE_NEAR(wanted, 2 * pi * pi * 30 * 100, 1e-8 * wanted);
      const SolidResult solid = makeSolid(productSurface(motion).surface);
      QCOMPARE(solid.start, EndCap::None);
      QCOMPARE(solid.end, EndCap::None);
      QVERIFY(BRepCheck_Analyzer(solid.solid).IsValid());
      COMPARE_NEAR(solidVolume(solid), wanted, 1e-6 * wanted);
      std::printf("figure ring_volume_share %.9g\n", solidVolume(solid) / wanted);
    }
  }
};

BLOSSOM_TEST(SweepSoundTest)
#include "sweep_sound_test.moc"
