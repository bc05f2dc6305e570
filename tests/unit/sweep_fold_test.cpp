/// Where a swept surface runs back over itself.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "geometry/crossing/surface_crossing.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/grid/span_parameters.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/validity.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// A part of a cylinder about z: the quaternions of a spline in u stand at these angles, in degrees.
Motion aroundAxis(int degree, const std::vector<double>& degrees, double radius) {
  Motion motion;
  motion.point = Vec3(radius, 0, 0);
  motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 20, 1)}};
  motion.scaling = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4::Ones())};
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  const int spans = static_cast<int>(degrees.size()) - degree;
  for (int k = 0; k <= spans; ++k) knots.push_back(static_cast<double>(k) / spans);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), 1.0);
  motion.orientation = {degree, 1, knots, {0, 0, 1, 1}, {}};
  for (const double angle : degrees) {
    const double half = angle * std::numbers::pi / 360;
    motion.orientation.poles.insert(motion.orientation.poles.end(), 2, Vec4(std::cos(half), 0, 0, std::sin(half)));
  }
  return motion;
}

/// Triangles around all meetings of a folded surface. Each ball used to have some 20,000, and there were about 20 of them.
constexpr std::size_t workOfAFold = 60000;

/// A torus about z with a ring of radius 30; its section may be wider than that.
Motion ringOf(double section) {
  constexpr double before = 10;
  Motion motion =
      primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = before, .rows = 7, .columns = 7}).motion;
  for (Vec4& pole : motion.scaling.poles) pole.head<3>() *= section / before;
  return motion;
}

/// The same with sections that swell and shrink, so that its tips are no points.
Motion unevenRing(double section, double by) {
  Motion motion = ringOf(section);
  Surface& s = motion.scaling;
  for (std::size_t k = 0; k < s.poles.size(); ++k) {
    const std::size_t column = k % s.countV();
    if (column > 1 && column + 2 < s.countV()) s.poles[k].head<3>() *= 1 + by * std::sin(3.0 * static_cast<double>(column));
  }
  return motion;
}

/// A sheet or a tube along z, straight but for these curves of (x, y), all of one degree over the same knots in u.
Motion ruled(int degree, const std::vector<double>& knots, const std::vector<std::vector<Vec2>>& curves) {
  Motion motion;
  motion.point = Vec3(1, 1, 1);
  motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 40, 1)}};
  motion.orientation = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 0, 0, 0))};
  motion.scaling = {degree, 1, knots, {0, 0, 1, 1}, {}};
  for (std::size_t i = 0; i < curves[0].size(); ++i)
    for (const std::vector<Vec2>& curve : curves) motion.scaling.poles.emplace_back(curve[i].x(), curve[i].y(), 0, 1);
  return motion;
}

double foldNormal(const Motion& motion, double u, double v) {
  const MotionPoint p = evaluate(motion, u, v);
  return p.du.cross(p.dv).norm();
}

}  // namespace

class SweepFoldTest : public QObject {
  Q_OBJECT

  std::mt19937_64 random_;

  double drawn(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  /// What rounding leaves of the normals at a pole points anywhere.
  void aSphereDoesNotFold() {
    for (const double radius : {10.0, 17.3, 20.0, drawn(1, 100)})
      for (const std::size_t rows : {4, 7, 8, 12, 16, 20, 24, 31, 32})
        for (const std::size_t columns : {4, 8, 16}) {
          const Motion sphere =
              primitiveMotion({.kind = PrimitiveKind::Sphere, .radius = radius, .rows = rows, .columns = columns}).motion;
          QVERIFY2(!examine(sphere).fold, qPrintable(QStringLiteral("%1 %2 %3").arg(radius).arg(rows).arg(columns)));
        }
  }

  /// x = 10 (2 u - 1)^2 runs back over itself at u = 1/2, where a sample lies.
  void aFoldOnASampleIsFound() {
    Motion motion;
    motion.point = Vec3(1, 1, 1);
    motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 20, 1)}};
    motion.orientation = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 0, 0, 0))};
    motion.scaling = {2, 1, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, {}};
    for (const double x : {10.0, -10.0, 10.0}) motion.scaling.poles.insert(motion.scaling.poles.end(), 2, Vec4(x, 1, 0, 1));
    const auto fold = examine(motion).fold;
    QVERIFY(fold && std::abs(fold->u - 0.5) < 0.1);
  }

  void aSideThatTurnsBackFolds() {
    for (int round = 0; round < 20; ++round) {
      const double back = drawn(5, 40), radius = drawn(5, 20);
      for (const int degree : {1, 2, 3}) {
        const Motion motion =
            aroundAxis(degree, {0, 40, 80, 120, 120 - back, 80 - back, 120 - back, 160 - back, 200}, radius);
        const auto fold = examine(motion).fold;
        QVERIFY2(fold, qPrintable(QStringLiteral("degree %1, back by %2").arg(degree).arg(back)));
        COMPARE_NEAR(std::hypot(fold->place.x(), fold->place.y()), radius, 1e-9 * radius);
        QVERIFY((evaluate(motion, fold->u, fold->v).point - fold->place).norm() < 1e-9 * radius);
        if (degree > 1) QVERIFY(foldNormal(motion, fold->u, fold->v) < 1e-4 * foldNormal(motion, 0, 0.5));
      }
    }
  }

  void aSideThatGoesOnDoesNot() {
    for (int round = 0; round < 20; ++round) {
      std::vector<double> degrees{0};
      for (int k = 0; k < 9; ++k) degrees.push_back(degrees.back() + drawn(1, 70));
      for (const int degree : {1, 2, 3}) QVERIFY(!examine(aroundAxis(degree, degrees, drawn(5, 20))).fold);
    }
  }

  /// However many samples there are along the edge.
  void aSharpEdgeHidesNoFold() {
    constexpr double turn = 130 * std::numbers::pi / 180;
    const Vec2 along(10 * std::cos(turn), 10 * std::sin(turn)), at = Vec2(10, 0) + along;
    for (const int spans : {1, 2, 4, 8, 9, 16}) {
      std::vector<double> knots{0};
      for (int k = 0; k <= spans; ++k) knots.push_back(static_cast<double>(k) / spans);
      knots.push_back(1);
      Motion motion;
      motion.point = Vec3(1, 1, 1);
      motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 40, 0, 1)}};
      motion.orientation = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 0, 0, 0))};
      motion.scaling = {1, 1, {0, 0, 0.25, 0.5, 0.75, 1, 1}, knots, {}};
      for (const Vec2& p : {Vec2(0, 0), Vec2(10, 0), at, Vec2(at + Vec2(10, 0)), Vec2(at + Vec2(5, 0))})
        motion.scaling.poles.insert(motion.scaling.poles.end(), static_cast<std::size_t>(spans) + 1,
                                    Vec4(p.x(), 0, p.y(), 1));
      const auto fold = examine(motion).fold;
      QVERIFY2(fold && std::abs(fold->u - 0.75) < 0.01, qPrintable(QString::number(spans)));
    }
  }

  /// Two parts of a thin blade meet in an edge of a few degrees: no fold.
  void aSharpEdgeIsNoFold() {
    for (const double degrees : {1.0, 5.0, 20.0}) {
      const double thin = std::tan(degrees * std::numbers::pi / 360);
      Motion motion;
      motion.point = Vec3(1, 1, 1);
      motion.trajectory = {1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 20, 1)}};
      motion.orientation = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Vec4>(4, Vec4(1, 0, 0, 0))};
      motion.scaling = {1, 1, {0, 0, 0.5, 1, 1}, {0, 0, 1, 1}, {}};
      for (const Vec3& p : {Vec3(10, -10 * thin, 0), Vec3(0, 0, 0), Vec3(10, 10 * thin, 0)})
        motion.scaling.poles.insert(motion.scaling.poles.end(), 2, Vec4(p.x(), p.y(), p.z(), 1));
      QVERIFY(!examine(motion).fold);
    }
  }

  /// A cylinder pulled along its axis until it runs back: all of it lies on the cylinder still, and what goes on beyond the
  /// fold passes through nothing.
  void sheetsThatLieOnEachOtherDoNotCross() {
    const Motion cylinder =
        primitiveMotion({.kind = PrimitiveKind::Cylinder, .radius = 10, .height = 40, .rows = 16, .columns = 16}).motion;
    const MotionPlace at{0.25, 0.5};
    const Vec3 from = evaluate(cylinder, at.u, at.v).point;
    for (const double by : {12.0, drawn(10, 16), -12.0}) {
      const Motion motion = pull(cylinder, {{at}, {from + Vec3(0, 0, by)}, {1, 0, 0}}).motion;
      QVERIFY(examine(motion).fold);
      for (int k = 0; k < 100; ++k) {
        const Vec3 p = evaluate(motion, drawn(0, 1), drawn(0, 1)).point;
        COMPARE_NEAR(std::hypot(p.x(), p.y()), 10, 1e-9);
      }
      const CrossingResult result = findCrossing(productSurface(motion).surface);
      const auto& found = result.deepest;
      QVERIFY2(!found, qPrintable(QStringLiteral("%1 mm deep, pulled by %2").arg(found ? found->depth : 0).arg(by)));
      QVERIFY2(result.divided < workOfAFold, qPrintable(QString::number(result.divided)));
    }
  }

  /// A torus whose section is wider than its ring passes through its axis: all meetings are at the tips, on both sides of
  /// the seam, where one sheet hangs together.
  void tipsOfAWideTorusTakeLittleWork() {
    Motion motion =
        primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 20, .profile = 6, .rows = 16, .columns = 16}).motion;
    for (const double by : {3.34, 3.6, drawn(3.4, 4)}) {
      Motion wide = motion;
      for (Vec4& pole : wide.scaling.poles) pole.head<3>() *= by;
      const CrossingResult result = findCrossing(productSurface(wide).surface);
      QVERIFY(result.pairs > 0);
      QVERIFY2(result.divided < workOfAFold,
               qPrintable(QStringLiteral("%1 triangles, times %2").arg(result.divided).arg(by)));
    }
  }

  /// What is sampled has a limit, and a fold among very many spans is found within it.
  void manySpansAreSampledLess() {
    QCOMPARE(partsWithin(12, 8, 8, 4'000'000), std::size_t{8});
    QCOMPARE(partsWithin(600, 600, 8, 4'000'000), std::size_t{3});
    QCOMPARE(partsWithin(5000, 5000, 8, 4'000'000), std::size_t{1});
    Motion motion = aroundAxis(2, {0, 40, 80, 120, 100, 60, 100, 140, 200}, 10);
    for (Surface* factor : {&motion.orientation, &motion.scaling}) {
      std::vector<double> u, v;
      for (int k = 1; k < 400; ++k) u.push_back(k / 400.0 + 1e-4), v.push_back(k / 400.0);
      *factor = insertKnotsV(insertKnotsU(*factor, u), v);
    }
    QVERIFY(examine(motion).fold);
  }

  /// The inner side of a section that is wider than its ring goes back, however little of it that is.
  void aRingWiderThanItsBendGoesBack() {
    for (const double times : {1.00001, 1.0001, 1.001, 1.01, 1.1, 1.5, 2.5, drawn(1.001, 3)}) {
      const auto fold = examine(ringOf(30 * times)).fold;
      QVERIFY2(fold && fold->backwards, qPrintable(QString::number(times)));
      COMPARE_NEAR(std::abs(fold->place.z()), 30 * std::sqrt(times * times - 1), 1e-3);
    }
    for (const double times : {0.5, 0.999, 0.99999, 1.0, drawn(0.1, 1)})
      QVERIFY2(!examine(ringOf(30 * times)).fold, qPrintable(QString::number(times)));
  }

  /// Where the normal turns half round while it is short, but nowhere vanishes, a search that goes on finds a smooth turn.
  void aRingWithoutSharpTipsGoesBack() {
    for (const double times : {1.2, 1.5, drawn(1.1, 2)})
      for (const double by : {1e-6, 3e-5, 1e-3}) {
        const auto fold = examine(unevenRing(30 * times, by)).fold;
        QVERIFY2(fold && fold->backwards, qPrintable(QStringLiteral("%1 %2").arg(times).arg(by)));
      }
    for (const double by : {1e-3, 1e-2}) QVERIFY(!examine(unevenRing(25, by)).fold);
  }

  /// A section that almost has a cusp turns sharply, and goes on.
  void aNarrowBendIsNoFold() {
    for (const double width : {1e-2, 1e-4, 1e-6}) {
      const std::vector<Vec2> bend{{10, width}, {0, width}, {0, -width}, {10, -width}};
      QVERIFY2(!examine(ruled(3, {0, 0, 0, 0, 1, 1, 1, 1}, {bend, bend})).fold, qPrintable(QString::number(width)));
    }
  }

  /// The last section of a chisel runs forth and back along its edge; those before it do not.
  void aSharpEndIsNoFold() {
    for (const int corners : {12, 24}) {
      std::vector<Vec2> round, flat;
      std::vector<double> knots;
      for (int i = 0; i <= corners + 2; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        round.emplace_back(20 * std::cos(angle), 8 * std::sin(angle));
        flat.emplace_back(0, 8 * std::sin(angle));
      }
      for (int k = -2; k <= corners + 3; ++k) knots.push_back(k);
      knots.resize(round.size() + 3);
      QVERIFY(!examine(ruled(2, knots, {round, flat})).fold);
      QVERIFY(!examine(ruled(2, knots, {flat, round})).fold);
      for (Vec2& p : flat) p.x() = -5 * p.y();
      QVERIFY(!examine(ruled(2, knots, {round, flat})).fold);
    }
  }

  void samplesDoNotFold() {
    for (const char* name : {"cylinder.json", "helicoid.json", "horn.json", "propeller.json"}) {
      const auto motion = motionFormat().read(sample(name), Value::object(), Progress::none()).shape;
      QVERIFY2(!examine(*motion.get<Motion>()).fold, name);
    }
  }
};

BLOSSOM_TEST(SweepFoldTest)
#include "sweep_fold_test.moc"
