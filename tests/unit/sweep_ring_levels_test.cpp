// Coarse and fine edits of motions that close in v.
#include "geometry/bspline/bspline.h"
#include "support/motion_rings.h"
#include "support/motions.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/begin/motion_from_curve.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/begin/turning_spline.h"
#include "sweep/kernel/edit/edit_level.h"
#include "sweep/kernel/edit/place_row.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// At the seam, near it, beside the functions that reach it, anywhere.
double placeInRing(Random& random, int k) {
  switch (k % 6) {
    case 0:
      return 0;
    case 1:
      return 1;
    case 2:
      return uniform(random, 0, 0.03);
    case 3:
      return uniform(random, 0.97, 1);
    case 4:
      return uniform(random, 0.05, 0.3);
    default:
      return uniform(random, 0, 1);
  }
}

/// Along v all of one degree, continuity and ratio, but any knots; positive weights.
RingLine weightedRing(Random& random, const RingLine& like) {
  RingLine ring = like;
  for (Vec4& row : ring.rows) {
    const double weight = uniform(random, 0.7, 1.4);
    row = Vec4(uniform(random, 4, 7), uniform(random, 4, 7), uniform(random, 4, 7), weight);
  }
  return ring;
}

/// A torus whose trajectory and scaling are random rational splines that end as `ratio` times what they begin with.
Motion rationalRing(Random& random, int k) {
  const double ratio = k % 2 == 0 ? 1.5 : 1;
  Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6}).motion;
  const auto line = [&](int lowest) {
    const int degree = uniformInt(random, lowest, 5);
    return randomRing(random, uniformInt(random, 0, degree - 1), degree, ratio);
  };
  RingLine path = weightedRing(random, line(2));
  for (Vec4& row : path.rows) row.head<3>() = row[3] * anyVector(random, 20);
  ring.trajectory = path.clampedCurve();
  const RingLine form = line(1);
  const std::size_t rows = 8;
  std::vector<Vec4> poles;
  std::vector<double> knots;
  for (std::size_t i = 0; i < rows; ++i) {
    const Curve curve = weightedRing(random, form).clampedCurve();
    knots = curve.knots;
    poles.insert(poles.end(), curve.poles.begin(), curve.poles.end());
  }
  ring.scaling = unwrapped(3, form.degree, evenBreaks(rows), knots, std::move(poles), 1);
  return ring;
}

/// v's distance from the range, round the ring of length 1.
bool outsideOnRing(double v, double first, double last) {
  for (const double turns : {-1.0, 0.0, 1.0})
    if (v + turns >= first && v + turns <= last) return false;
  return true;
}

/// The reach along v of an edit in a cubic ring with even spans.
std::pair<double, double> reachInRing(double v, std::size_t spans, int level) {
  const double length = std::ldexp(1.0 / static_cast<double>(spans), -level), span = std::floor(v / length);
  return {(span - 3) * length, (span + 4) * length};
}

/// Values of the functions of a space at x, each times its value at y, summed.
double kernelOf(const SplineSpace& space, double x, double y) {
  double sum = 0;
  for (const FunctionValue& a : functionsAt(space, x))
    for (const FunctionValue& b : functionsAt(space, y))
      if (a.function == b.function) sum += a.value * b.value;
  return sum;
}

struct Worst {
  double open = 0, gap = 0, missed = 0;
};

/// One edit, and what it leaves: the ends joined as before.
Motion closedAfter(Random& random, const Motion& motion, const RingEdit& edit, Worst& worst) {
  const auto before = joinedInV(motion);
  const EditResult result = editRing(motion, edit);
  const double size = sizeOfPoles(result.motion, edit.at.u, edit.at.v);
  if (!before || !result.obstacles.empty()) {
    worst.missed = INFINITY;
    return motion;
  }
  validate(result.motion);
  worst.missed = std::max(worst.missed, result.remainder / (edit.way == EditWay::Twist ? 180 : size));
  worst.open = std::max(worst.open, openness(result.motion, *before));
  const auto after = joinedInV(result.motion);
  const bool joined = after && after->trajectory.continuity >= before->trajectory.continuity &&
                      after->orientation.continuity >= before->orientation.continuity &&
                      after->scaling.continuity >= before->scaling.continuity;
  if (!joined || !repeatsItsRows(result.motion)) worst.open = INFINITY;
  for (int i = 0; i < 10; ++i) {
    const double u = uniform(random, 0, 1);
    const Vec3 start = evaluate(result.motion, u, 0).point, end = evaluate(result.motion, u, 1).point;
    worst.gap = std::max(worst.gap, (start - end).norm() / size);
  }
  return result.motion;
}

void report(const char* name, const Worst& worst) {
  std::printf("figure %s_derivatives %.3g\nfigure %s_gap %.3g\nfigure %s_missed %.3g\n", name, worst.open, name, worst.gap,
              name, worst.missed);
  QVERIFY2(worst.open <= 1e-12, qPrintable(QString::number(worst.open)));
  QVERIFY2(worst.gap <= 1e-12, qPrintable(QString::number(worst.gap)));
  QVERIFY2(worst.missed <= 1e-12, qPrintable(QString::number(worst.missed)));
}

}  // namespace

class SweepRingLevelsTest : public QObject {
  Q_OBJECT

 private slots:
  void aTorusStaysClosedAtEveryLevel() {
    auto random = seededRandom();
    Worst worst;
    for (int k = 0; k < 60; ++k) {
      const Motion ring = primitiveMotion(ringOptions(random)).motion;
      for (const EditWay way : allEditWays) {
        const int fold = way != EditWay::Translate && k % 3 == 0 ? 4 : 1;
        const RingEdit first{{uniform(random, 0, 1), placeInRing(random, k)}, way, fold, k % 5 - 2},
            second{{uniform(random, 0, 1), placeInRing(random, k / 6)}, way, 1, uniformInt(random, -2, 2)};
        closedAfter(random, closedAfter(random, ring, first, worst), second, worst);
      }
    }
    report("ring_level", worst);
  }

  void aClosedTubeStaysClosedAtEveryLevel() {
    auto random = seededRandom();
    const Motion tube = motionFromCurve(closedOval(), {.radius = 4}).motion;
    QVERIFY(joinedInV(tube));
    Worst worst;
    for (int k = 0; k < 60; ++k) {
      const EditWay way = allEditWays[static_cast<std::size_t>(k % 5)];
      const RingEdit edit{{uniform(random, 0, 1), placeInRing(random, k)}, way, 1, uniformInt(random, -2, 2)};
      closedAfter(random, tube, edit, worst);
    }
    report("tube_level", worst);
  }

  /// Degrees, continuities at the seam and weights of all kinds, which may go on in any ratio.
  void rationalRingsStayClosedAtEveryLevel() {
    auto random = seededRandom();
    Worst worst;
    int edits = 0;
    for (int k = 0; k < 200; ++k) {
      const Motion ring = rationalRing(random, k);
      const EditWay way = k % 3 == 0 ? EditWay::Translate : k % 3 == 1 ? EditWay::Scale : EditWay::Together;
      const RingEdit edit{{uniform(random, 0, 1), placeInRing(random, k)}, way, 1, uniformInt(random, -2, 3)};
      if (!joinedInV(ring)) continue;  // a single pole: nothing changes along v
      closedAfter(random, ring, edit, worst);
      ++edits;
    }
    QVERIFY(edits > 150);
    report("rational_ring_level", worst);
  }

  /// The same edit half a ring farther gives the same ring, turned.
  void aRingHasNoBeginningAtAnyLevel() {
    auto random = seededRandom();
    const Eigen::Matrix3d half = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()).toRotationMatrix();
    double worst = 0;
    for (int k = 0; k < 40; ++k) {
      PrimitiveOptions options = ringOptions(random);
      options.columns = options.columns / 2 * 4;  // an even number after half of them are left out
      const Motion ring = primitiveMotion(options).motion;
      const double u = uniform(random, 0, 1), v = k % 4 == 0 ? 0 : uniform(random, 0, 0.1);
      const int level = k % 4 - 1;
      for (const EditWay way : allEditWays) {
        const Motion here = editRing(ring, {{u, v}, way, 1, level}).motion,
                     there = editRing(ring, {{u, v + 0.5}, way, 1, level, half}).motion;
        for (int i = 0; i < 40; ++i) {
          const double s = uniform(random, 0, 1), t = uniform(random, 0, 1);
          const Vec3 turned = half * evaluate(here, s, t).point,
                     same = evaluate(there, s, t < 0.5 ? t + 0.5 : t - 0.5).point;
          worst = std::max(worst, (turned - same).norm() / 60);
        }
      }
    }
    std::printf("figure ring_level_turned %.3g\n", worst);
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  /// The change of the quaternions is that of an anti-periodic spline with even knots, which is made here by its own.
  void theChangeIsTheShortestOfThePeriodicSpace() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 80; ++k) {
      PrimitiveOptions options = ringOptions(random);
      options.columns = options.columns / 2 * 4;
      const Motion ring = primitiveMotion(options).motion;
      const int level = k % 5 - 1;
      const MotionPlace at{uniform(random, 0, 1), placeInRing(random, k)};
      const Motion after = editRing(ring, {at, EditWay::Twist, 1, level}).motion;
      const std::size_t spans = level < 0 ? options.columns / 2 : options.columns << level;
      const SplineSpace v{3, unwrappedKnots(3, evenBreaks(spans)), -1},
          u = levelSpace(spaceInU(ring.orientation, closureOfOrientation(ring)), level, 1);
      const double square = kernelOf(u, at.u, at.u) * kernelOf(v, at.v, at.v);
      const Vec4 delta = evaluate(after.orientation, at.u, at.v) - evaluate(ring.orientation, at.u, at.v);
      for (int i = 0; i < 40; ++i) {
        const double x = uniform(random, 0, 1), y = i < 2 ? i : uniform(random, 0, 1);
        const Vec4 change = evaluate(after.orientation, x, y) - evaluate(ring.orientation, x, y);
        const Vec4 wanted = kernelOf(u, x, at.u) * kernelOf(v, y, at.v) / square * delta;
        worst = std::max(worst, (change - wanted).norm() / magnitude(ring.orientation.poles));
      }
    }
    std::printf("figure ring_level_change_apart %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void outsideItsReachNothingChanges() {
    auto random = seededRandom();
    const std::size_t spans = 16;
    const Motion ring =
        primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6, .rows = 8, .columns = spans}).motion;
    double worst = 0;
    int outside = 0;
    for (int k = 0; k < 90; ++k) {
      const int level = k % 3;
      const MotionPlace at{uniform(random, 0, 1), placeInRing(random, k / 3)};
      const Motion after = editRing(ring, {at, EditWay::Together, 1, level}).motion;
      const auto [first, last] = reachInRing(at.v, spans, level);
      // Knots of the level inside the reach and at its ends, those at the seam and of the motion left out. At the seam,
      // where a function ends, the reach is a span shorter on one side.
      if (at.v > 0 && at.v < 1) {
        std::size_t added = 0;
        const long pieces = 1L << level, begin = std::lround(first * 16 * static_cast<double>(pieces));
        for (long knot = begin; knot <= begin + 7; ++knot) added += knot % pieces != 0 ? 1 : 0;
        QCOMPARE(after.scaling.countV() - ring.scaling.countV(), added);
        QCOMPARE(after.orientation.countV() - ring.orientation.countV(), added);
      }
      for (int i = 0; i < 100; ++i) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        if (!outsideOnRing(v, first, last)) continue;
        ++outside;
        worst = std::max(worst, (evaluate(after, u, v).point - evaluate(ring, u, v).point).norm() / 36);
      }
    }
    QVERIFY(outside > 3000);
    std::printf("figure ring_level_outside %.3g\n", worst);
    QVERIFY2(worst <= 4e-15, qPrintable(QString::number(worst)));
  }

  void awayFromTheSeamNothingIsOther() {
    auto random = seededRandom();
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .columns = 16}).motion;
    Motion open = ring;
    open.scaling.pole(5, 0)[0] += 1e-3;
    QVERIFY(!joinedInV(open));
    for (const EditWay way : allEditWays)
      for (int level = 1; level <= 3; ++level) {
        const RingEdit edit{{0.6, 0.53}, way, 1, level};
        const Motion a = editRing(ring, edit).motion, b = editRing(open, edit).motion;
        QVERIFY(a.trajectory.knots == b.trajectory.knots && a.orientation.knotsV == b.orientation.knotsV &&
                a.scaling.knotsV == b.scaling.knotsV);
        for (int i = 0; i < 40; ++i) {
          const double u = uniform(random, 0, 1), v = uniform(random, 0.2, 0.9);
          QVERIFY((evaluate(a, u, v).point - evaluate(b, u, v).point).norm() < 1e-13 * 30);
        }
      }
  }

  void thereAndBackIsTheStart() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 90; ++k) {
      const Motion ring = k % 3 == 2 ? rationalRing(random, k) : primitiveMotion(ringOptions(random)).motion;
      if (!joinedInV(ring)) continue;
      const MotionPlace at{uniform(random, 0, 1), placeInRing(random, k)};
      const Vec3 start = evaluate(ring, at.u, at.v).point;
      MotionPull there{{at}, {start + anyVector(random, 4)}, k % 2 == 0 ? PullWeights{1, 0, 0} : PullWeights{0, 0, 1}};
      there.level = uniformInt(random, -2, 3);
      MotionPull back = there;
      back.to = {start};
      const Motion dragged = pull(ring, there).motion, again = pull(dragged, back).motion;
      QVERIFY(dragged.base == again.base && dragged.scaling.knotsV == again.scaling.knotsV);
      for (int i = 0; i < 20; ++i) {
        const double u = uniform(random, 0, 1), v = i < 2 ? i : uniform(random, 0, 1);
        const double size = std::max(sizeOfPoles(ring, u, v), sizeOfPoles(dragged, u, v));
        worst = std::max(worst, (evaluate(again, u, v).point - evaluate(ring, u, v).point).norm() / size);
      }
    }
    std::printf("figure ring_level_there_and_back %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void copiesAroundTheSectionStayCopies() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 40; ++k) {
      const int fold = uniformInt(random, 2, 5);
      PrimitiveOptions options = ringOptions(random);
      options.rows = static_cast<std::size_t>(fold * uniformInt(random, 2, 4));
      const Motion ring = primitiveMotion(options).motion;
      const MotionPlace at{uniform(random, 0, 1), placeInRing(random, k)};
      const EditResult result = editRing(ring, {at, EditWay::Scale, fold, uniformInt(random, -2, 2)});
      QVERIFY(result.obstacles.empty() && repeatsItsRows(result.motion));
      // A torus has its arms in the planes of its sections, and scaling leaves them there.
      for (int i = 0; i < 30; ++i) {
        const double u = uniform(random, 0, 1), v = i < 2 ? i : uniform(random, 0, 1),
                     next = u + 1.0 / fold < 1 ? u + 1.0 / fold : u + 1.0 / fold - 1;
        const Vec3 centre = blossom::point(ring.trajectory, v);
        const double arm = (evaluate(result.motion, u, v).point - centre).norm(),
                     copy = (evaluate(result.motion, next, v).point - centre).norm();
        worst = std::max(worst, std::abs(arm - copy) / sizeOfPoles(result.motion, u, v));
      }
    }
    std::printf("figure ring_level_fold %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void pinsAcrossTheSeamHold() {
    const Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus}).motion;
    for (const int level : {-1, 1, 2}) {
      const Vec3 at = evaluate(ring, 0.3, 0).point;
      MotionPull pinned{{{0.3, 0}}, {at + Vec3(0, 0, 2)}, {0, 1, 1}, Vec3::Zero(), {{0.3, 1}}};
      pinned.level = level;
      const EditResult none = pull(ring, pinned);
      QVERIFY(!none.obstacles.empty() && none.obstacles.front().why == Unreached::Pinned);
      QVERIFY((evaluate(none.motion, 0.3, 0).point - at).norm() < 1e-12);
      pinned.pins = {{0.3, 0.99}};
      const Vec3 pin = evaluate(ring, 0.3, 0.99).point;
      const EditResult some = pull(ring, pinned);
      QVERIFY(some.obstacles.empty());
      QVERIFY((evaluate(some.motion, 0.3, 0.99).point - pin).norm() < 1e-11);
      QVERIFY(openness(some.motion) < 1e-12);
    }
  }

  void editAfterEditStaysClosed() {
    auto random = seededRandom();
    Motion ring = primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 30, .profile = 6}).motion;
    for (int k = 0; k < 60; ++k) {
      const MotionPlace at{uniform(random, 0, 1), placeInRing(random, k)};
      MotionPull edit{{at}, {evaluate(ring, at.u, at.v).point + anyVector(random, 0.1)}, {k % 3 == 0 ? 0.5 : 0.0, 1, 1}};
      edit.level = uniformInt(random, -2, 2);
      const EditResult result = pull(ring, edit);
      QVERIFY(result.obstacles.empty());
      ring = result.motion;
      const auto joined = joinedInV(ring);
      QVERIFY(joined && joined->scaling.continuity == 2 && joined->orientation.continuity == 2);
    }
    QVERIFY(openness(ring) < 1e-12);
  }
};

BLOSSOM_TEST(SweepRingLevelsTest)
#include "sweep_ring_levels_test.moc"
