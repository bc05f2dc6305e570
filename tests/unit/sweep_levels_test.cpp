#include <numbers>

#include "geometry/bspline/bspline.h"
#include "geometry/bspline/hierarchical_surface.h"
#include "support/motion_sizes.h"
#include "support/motions.h"
#include "support/support.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/begin/motion_knots.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/edit_level.h"
#include "sweep/kernel/edit/motion_symmetry.h"
#include "sweep/kernel/edit/place_row.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/live_grid.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

/// Open, periodic and anti-periodic in turn; half of those that close have 1 to 3 rows.
Motion anyLevelMotion(Random& random, int k) {
  Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), k % 5 == 0, k % 2 == 0 ? uniformInt(random, 1, 3) : 9);
  for (double& each : motion.point)
    if (each != 0) each += each > 0 ? 0.5 : -0.5;
  return motion;
}

/// A pull that one component, or all of them, can do.
MotionPull levelPull(Random& random, const Motion& motion, int level) {
  MotionPull edit;
  edit.at = {{randomParameter(random, motion.domainU()), randomParameter(random, motion.domainV())}};
  edit.to = {anyVector(random, 20)};
  const int way = uniformInt(random, 0, 2);
  edit.weights = way == 0 ? PullWeights{1, 0, 0} : way == 1 ? PullWeights{0, 1, 1} : PullWeights{0.5, 0.5, 1};
  edit.level = level;
  return edit;
}

bool nearlyNoFrameAt(const Motion& motion, const MotionPlace& at) {
  return evaluate(motion.orientation, at.u, at.v).norm() < 0.05;
}

SplineSpace wholeLevelU(const Surface& factor, double closure, const std::vector<double>& base, int level) {
  return levelSpace(withInnerKnots(spaceInU(factor, closure), base), level, 1);
}
SplineSpace wholeLevelV(const Surface& factor, const std::vector<double>& base, int level) {
  return levelSpace(withInnerKnots(spaceInV(factor), base), level, 1);
}

/// The change of a factor by the smallest change of its coefficients that gives `delta` at a place, from the values of
/// functions alone: k(x, place) / k(place, place) * delta with k(x, y) the sum of f(x) f(y) over all functions f.
struct LeastChangeFormula {
  SplineSpace u, v;
  MotionPlace place;

  [[nodiscard]] double share(double x, double y) const {
    return kernel(u, x, place.u) * kernel(v, y, place.v) / (kernel(u, place.u, place.u) * kernel(v, place.v, place.v));
  }
  static double kernel(const SplineSpace& space, double x, double y) {
    double sum = 0;
    for (const FunctionValue& a : functionsAt(space, x))
      for (const FunctionValue& b : functionsAt(space, y))
        if (a.function == b.function) sum += a.value * b.value;
    return sum;
  }
};

std::string obstacleOf(const EditResult& result) {
  return result.obstacles.empty() ? "" : explain(result.obstacles.front()).what;
}

MotionPull scalePull(const MotionPlace& at, const Vec3& to, int level) {
  MotionPull edit{{at}, {to}, {0, 0, 1}};
  edit.level = level;
  return edit;
}

/// Spans of a factor that has the same everywhere: how many knots an edit of a level adds, and where it begins and ends.
struct EvenSpans {
  int spans, degree;

  [[nodiscard]] std::pair<double, double> reach(double t, int level) const {
    const double length = std::ldexp(1.0 / spans, -level), span = std::floor(t / length);
    return {(span - degree) * length, (span + 1 + degree) * length};
  }
  /// Knots of the level inside the reach, its ends among them, that are not there already.
  [[nodiscard]] int knotsFor(double t, int level, bool closed) const {
    const int pieces = 1 << level, span = static_cast<int>(std::floor(t * spans * pieces));
    int count = 0;
    for (int k = span - degree; k <= span + 1 + degree; ++k) {
      const bool inside = closed || (k > 0 && k < spans * pieces);
      if (inside && k % pieces != 0) ++count;
    }
    return count;
  }
};

}  // namespace

class SweepLevelsTest : public QObject {
  Q_OBJECT

 private slots:
  void pullsArriveAtEveryLevel() {
    auto random = seededRandom();
    double worst = 0;
    int pulls = 0;
    for (int k = 0; k < 900; ++k) {
      const Motion motion = anyLevelMotion(random, k);
      const MotionPull edit = levelPull(random, motion, uniformInt(random, -4, 5));
      const MotionPlace at = edit.at.front();
      if (nearlyNoFrameAt(motion, at)) continue;
      const EditResult result = pull(motion, edit);
      QVERIFY2(result.obstacles.empty(), obstacleOf(result).c_str());
      validate(result.motion);
      QVERIFY(repeatsItsRows(result.motion));
      const double size = std::max(sizeOfPoles(motion, at.u, at.v), sizeOfPoles(result.motion, at.u, at.v));
      worst = std::max(worst, (evaluate(result.motion, at.u, at.v).point - edit.to[0]).norm() / size);
      ++pulls;
    }
    QVERIFY(pulls > 700);
    std::printf("figure level_miss_share %.3g\nfigure level_pulls %d\n", worst, pulls);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void theChangeIsTheShortestOfItsLevel() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 400; ++k) {
      Motion motion = anyLevelMotion(random, k);
      if (k % 4 == 3) motion = pull(motion, levelPull(random, motion, uniformInt(random, 1, 3))).motion;  // knots by levels
      const int level = uniformInt(random, -3, 4);
      const MotionPlace at{randomIn(random, motion.domainU()), randomIn(random, motion.domainV())};
      if (nearlyNoFrameAt(motion, at)) continue;
      const BaseKnots base = baseKnots(motion);
      MotionTwist turn{{at}, anyVector(random, 1), uniform(random, -120, 120)};
      turn.level = level;
      const Motion after = twist(motion, turn).motion;
      QVERIFY(sameBits(after.scaling.poles, motion.scaling.poles) &&
              sameBits(after.trajectory.poles, motion.trajectory.poles));
      const LeastChangeFormula formula{
          wholeLevelU(motion.orientation, closureOfOrientation(motion), base.orientation[0], level),
          wholeLevelV(motion.orientation, base.orientation[1], level), at};
      const Vec4 delta = evaluate(after.orientation, at.u, at.v) - evaluate(motion.orientation, at.u, at.v);
      const double size = std::max(magnitude(motion.orientation.poles), magnitude(after.orientation.poles));
      for (int i = 0; i < 30; ++i) {
        const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
        const Vec4 change = evaluate(after.orientation, u, v) - evaluate(motion.orientation, u, v);
        worst = std::max(worst, (change - formula.share(u, v) * delta).norm() / size);
      }
    }
    std::printf("figure level_change_apart %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void aPullIsOneOfTheHierarchy() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 120; ++k) {
      const Motion motion = anyLevelMotion(random, k);
      const int level = uniformInt(random, 1, 3);
      const MotionPlace at{randomIn(random, motion.domainU()), randomIn(random, motion.domainV())};
      if (nearlyNoFrameAt(motion, at)) continue;
      const Motion after = pull(motion, scalePull(at, anyVector(random, 20), level)).motion;
      // The same by a hierarchy of all dyadic levels, each over what its functions at the place reach.
      const Surface& s = motion.scaling;
      const double closure = closureOfScaling(motion);
      const SplineSpace u = spaceInU(s, closure), v = spaceInV(s);
      std::vector<Vec4> free(s.poles.begin(), s.poles.begin() + static_cast<std::ptrdiff_t>(u.size() * v.size()));
      HierarchicalSurface hierarchy(u, v, free);
      for (int l = 1; l <= level; ++l) {
        const SplineSpace finerU = halved(u, l), finerV = halved(v, l);
        const auto [firstU, lastU] = reachAt(finerU, at.u);
        const auto [firstV, lastV] = reachAt(finerV, at.v);
        hierarchy.refine(finerU, finerV, std::vector<ParameterBox>{{firstU, lastU, firstV, lastV}});
      }
      const auto finest = static_cast<std::size_t>(level);
      const Vec4 delta = evaluate(after.scaling, at.u, at.v) - evaluate(s, at.u, at.v);
      double square = 0;
      for (const auto& each : hierarchy.activeAt(at.u, at.v)) {
        QCOMPARE(each.level, finest);
        square += each.value * each.value;
      }
      for (const auto& each : hierarchy.activeAt(at.u, at.v))
        hierarchy.setCoefficient(finest, each.function,
                                 hierarchy.coefficient(finest, each.function) + each.value / square * delta);
      const double size = std::max(magnitude(s.poles), magnitude(after.scaling.poles));
      for (int i = 0; i < 40; ++i) {
        const double x = randomIn(random, motion.domainU()), y = randomIn(random, motion.domainV());
        worst = std::max(worst, (hierarchy.evaluate(x, y) - evaluate(after.scaling, x, y)).norm() / size);
      }
    }
    std::printf("figure hierarchy_pull_apart %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void outsideItsReachNothingChanges() {
    auto random = seededRandom();
    const Motion motion =
        primitiveMotion({.kind = PrimitiveKind::Cylinder, .radius = 10, .height = 40, .rows = 24, .columns = 20}).motion;
    const EvenSpans u{24, motion.scaling.degreeU}, v{20, motion.scaling.degreeV};
    double worst = 0;
    int same = 0;
    for (int k = 0; k < 60; ++k) {
      const int level = k % 4;
      const MotionPlace at{uniform(random, 0, 1), uniform(random, 0, 1)};
      const Motion after = pull(motion, scalePull(at, anyVector(random, 30), level)).motion;
      QVERIFY(after.orientation == motion.orientation && after.trajectory == motion.trajectory);
      QCOMPARE(static_cast<int>(after.scaling.countU() - motion.scaling.countU()), u.knotsFor(at.u, level, true));
      QCOMPARE(static_cast<int>(after.scaling.countV() - motion.scaling.countV()), v.knotsFor(at.v, level, false));
      QCOMPARE(after.base.has_value(), level > 0);
      const auto [firstU, lastU] = u.reach(at.u, level);
      const auto [firstV, lastV] = v.reach(at.v, level);
      // Functions that end in the refined part reach out of it by less than degree + 1 spans.
      const double marginU = (u.degree + 1) / 24.0, marginV = (v.degree + 1) / 20.0;
      const auto beyond = [&](double x, double y, double bySpansU, double bySpansV) {
        const auto clear = [](double t, double first, double last) { return t < first || t > last; };
        bool clearU = true;
        for (const double turns : {-1.0, 0.0, 1.0}) clearU = clearU && clear(x + turns, firstU - bySpansU, lastU + bySpansU);
        return bySpansU > 0 ? clearU && clear(y, firstV - bySpansV, lastV + bySpansV) : clearU || clear(y, firstV, lastV);
      };
      for (int i = 0; i < 200; ++i) {
        const double x = uniform(random, 0, 1), y = uniform(random, 0, 1);
        const Vec3 moved = evaluate(after, x, y).point - evaluate(motion, x, y).point;
        if (!beyond(x, y, 0, 0)) continue;
        worst = std::max(worst, moved.norm() / 40);
        if (!beyond(x, y, marginU, marginV)) continue;
        ++same;
        QVERIFY(sameBits(evaluate(after.scaling, x, y), evaluate(motion.scaling, x, y)));
      }
    }
    QVERIFY(same > 500);
    std::printf("figure outside_reach_share %.3g\n", worst);
    QVERIFY2(worst <= 4e-15, qPrintable(QString::number(worst)));
  }

  void coarseEditsKeepTheKnots() {
    auto random = seededRandom();
    const Motion motion =
        primitiveMotion({.kind = PrimitiveKind::Cylinder, .radius = 10, .height = 40, .rows = 16, .columns = 8}).motion;
    for (int level = -8; level < 0; ++level) {
      const MotionPlace at{uniform(random, 0, 1), uniform(random, 0.05, 0.95)};
      const Motion after = pull(motion, scalePull(at, anyVector(random, 30), level)).motion;
      QVERIFY(haveSameForm(after, motion) && !after.base);
      // Spans of 1/16 and 1/8, doubled until four are left around and one along.
      const double spanU = level == -1 ? 0.125 : 0.25, spanV = std::min(1.0, std::ldexp(0.125, -level));
      const double firstV = (std::floor(at.v / spanV) - 3) * spanV, lastV = firstV + 7 * spanV,
                   firstU = (std::floor(at.u / spanU) - 3) * spanU, lastU = firstU + 7 * spanU;
      int changed = 0;
      for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t j = 0; j < motion.scaling.countV(); ++j) {
          if (sameBits(after.scaling.pole(i, j), motion.scaling.pole(i, j))) continue;
          ++changed;
          QVERIFY(motion.scaling.knotsV[j] >= firstV - 1e-12 && motion.scaling.knotsV[j + 4] <= lastV + 1e-12);
          bool within = lastU - firstU >= 1;
          for (const double turns : {-1.0, 0.0, 1.0})
            within = within || (motion.scaling.knotsU[i] + turns >= firstU - 1e-12 &&
                                motion.scaling.knotsU[i + 4] + turns <= lastU + 1e-12);
          QVERIFY(within);
        }
      QVERIFY(changed > 16);
    }
  }

  void aLevelMeansTheSameAfterFinerEdits() {
    const Motion motion =
        primitiveMotion({.kind = PrimitiveKind::Cylinder, .radius = 10, .height = 40, .rows = 8, .columns = 8}).motion;
    const MotionPlace at{0.3, 0.4};
    const Motion fine = pull(motion, scalePull(at, Vec3(0, 12, 16), 3)).motion;
    QVERIFY(*fine.base == baseKnots(motion));
    const std::size_t poles = fine.scaling.poles.size();
    const Motion wide = pull(fine, scalePull(at, Vec3(0, 14, 16), 0)).motion;
    QCOMPARE(wide.scaling.poles.size(), poles);  // it has all the knots for it
    // As wide as on the motion given: v from 0 to 3/8 + 4/8.
    QVERIFY((evaluate(wide, 0.3, 0.6).point - evaluate(fine, 0.3, 0.6).point).norm() > 1e-2);
    QVERIFY((evaluate(wide, 0.3, 0.88).point - evaluate(fine, 0.3, 0.88).point).norm() < 1e-13);
    // Knots that a user inserts count for the levels.
    const Motion refined = withKnots(fine, {.u = {0.31}, .v = {0.41}});
    validate(refined);
    QCOMPARE(refined.base->scaling[0].size(), baseKnots(motion).scaling[0].size() + 1);
    QVERIFY(std::count(refined.base->scaling[1].begin(), refined.base->scaling[1].end(), 0.41) == 1);
    // Nothing is refined for an edit that changes nothing.
    MotionTwist none{{at}, Vec3::UnitZ(), 0};
    none.level = 3;
    QVERIFY(twist(motion, none).motion == motion);
  }

  void thereAndBackIsTheStart() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 300; ++k) {
      const Motion motion = anyLevelMotion(random, k);
      const MotionPull there = levelPull(random, motion, uniformInt(random, -4, 5));
      const MotionPlace at = there.at.front();
      if (nearlyNoFrameAt(motion, at)) continue;
      MotionPull back = there;
      back.to = {evaluate(motion, at.u, at.v).point};
      const Motion dragged = pull(motion, there).motion, again = pull(dragged, back).motion;
      QVERIFY(haveSameForm(dragged, again) && dragged.base == again.base);
      const auto compare = [&](const Vec4& a, const Vec4& b, const std::vector<Vec4>& poles) {
        worst = std::max(worst, (a - b).norm() / magnitude(poles));
      };
      for (int i = 0; i < 20; ++i) {
        const double u = randomIn(random, motion.domainU()), v = randomIn(random, motion.domainV());
        compare(evaluate(motion.trajectory, v), evaluate(again.trajectory, v), dragged.trajectory.poles);
        compare(evaluate(motion.orientation, u, v), evaluate(again.orientation, u, v), dragged.orientation.poles);
        compare(evaluate(motion.scaling, u, v), evaluate(again.scaling, u, v), dragged.scaling.poles);
      }
    }
    std::printf("figure level_there_and_back %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void foldedEditsStayFoldedAtEveryLevel() {
    auto random = seededRandom();
    double worst = 0, miss = 0;
    for (int k = 0; k < 80; ++k) {
      const int fold = uniformInt(random, 2, 6);
      Motion motion = primitiveMotion({.kind = PrimitiveKind::Cylinder,
                                       .radius = 10,
                                       .height = 40,
                                       .rows = static_cast<std::size_t>(fold * uniformInt(random, 2, 5)),
                                       .columns = 6})
                          .motion;
      const Eigen::Matrix3d step = Eigen::AngleAxisd(2 * std::numbers::pi / fold, Vec3::UnitZ()).toRotationMatrix();
      const auto next = [&](double u) { return u + 1.0 / fold < 1 ? u + 1.0 / fold : u + 1.0 / fold - 1; };
      for (int edits = 0; edits < 2; ++edits) {
        // A place on a knot now and then: its copies are beside theirs by rounding.
        const double u = uniformInt(random, 0, 2) == 0 ? uniformInt(random, 0, 15) / 16.0 : uniform(random, 0, 1);
        MotionPull edit{{{u, uniform(random, 0, 1)}}, {anyVector(random, 20)}};
        edit.symmetry.fold = fold;
        edit.level = uniformInt(random, -3, 3);
        const EditResult result = pull(motion, edit);
        motion = result.motion;
        worst = std::max(worst, asymmetry(random, motion, step, next));
        if (!result.obstacles.empty()) break;
        const Vec3 at = evaluate(motion, u, edit.at[0].v).point;
        miss = std::max(miss, (at - edit.to[0]).norm() / sizeOfPoles(motion, u, edit.at[0].v));
      }
    }
    std::printf("figure level_fold_asymmetry %.3g\nfigure level_fold_miss %.3g\n", worst, miss);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
    QVERIFY2(miss <= 1e-12, qPrintable(QString::number(miss)));
  }

  /// Copies repeat around the motion, so knots are left out in equal parts of u alone: with a number of rows for which that
  /// is the same, a folded edit is the edit of all its copies at once.
  void aFoldMeansNothingAlongV() {
    auto random = seededRandom();
    for (const bool isRing : {false, true})
      for (int level = -5; level < 0; ++level) {
        const PrimitiveKind kind = isRing ? PrimitiveKind::Torus : PrimitiveKind::Cylinder;
        const Motion motion =
            primitiveMotion({.kind = kind, .radius = 10, .profile = 3, .height = 40, .rows = 16, .columns = 16}).motion;
        const double u = uniform(random, 0, 0.25), v = uniform(random, 0.05, 0.95);
        MotionPull folded{{{u, v}}, {evaluate(motion, u, v).point + anyVector(random, 2)}, {0.5, 0, 1}};
        folded.level = level;
        folded.symmetry.fold = 4;
        MotionPull all = folded;
        all.symmetry.fold = 1, all.at.clear(), all.to.clear();
        for (const SymmetricPlace& copy : symmetricPlaces(motion, folded.at[0], folded.symmetry)) {
          const Vec3 middle = point(motion.trajectory, v);
          all.at.push_back(copy.at);
          all.to.push_back(middle + copy.turn * (folded.to[0] - middle));
        }
        const Motion a = pull(motion, folded).motion, b = pull(motion, all).motion;
        QVERIFY(haveSameForm(a, b));
        for (int i = 0; i < 100; ++i) {
          const double x = uniform(random, 0, 1), y = uniform(random, 0, 1);
          const double off = (evaluate(a, x, y).point - evaluate(b, x, y).point).norm();
          QVERIFY2(off <= 1e-9, qPrintable(QString("level %1, ring %2: %3 mm").arg(level).arg(isRing).arg(off)));
        }
      }
  }

  void pinsHoldAtEveryLevel() {
    auto random = seededRandom();
    for (int k = 0; k < 150; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), true);
      const double u = uniform(random, 0.2, 0.8), v = uniform(random, 0.2, 0.8);
      if (nearlyNoFrameAt(motion, {u, v})) continue;
      MotionPull edit{{{u, v}}, {anyVector(random, 20)}, {0, 1, 1}};
      edit.pins = {{u + 0.1, v + 0.05}, {u - 0.15, v}};
      edit.level = uniformInt(random, -2, 4);
      const EditResult result = pull(motion, edit);
      for (const MotionPlace& pin : edit.pins) {
        const double size = std::max(sizeOfPoles(motion, pin.u, pin.v), sizeOfPoles(result.motion, pin.u, pin.v));
        QVERIFY((evaluate(result.motion, pin.u, pin.v).point - evaluate(motion, pin.u, pin.v).point).norm() <= 1e-11 * size);
      }
      if (result.obstacles.empty()) {
        const double size = std::max(sizeOfPoles(motion, u, v), sizeOfPoles(result.motion, u, v));
        QVERIFY((evaluate(result.motion, u, v).point - edit.to[0]).norm() <= 1e-9 * size);
      }
    }
  }

  void theLiveGridFollows() {
    auto random = seededRandom();
    const Motion motion = primitiveMotion({}).motion;
    std::vector<double> us, vs;
    for (int i = 0; i <= 48; ++i) us.push_back(i / 48.0), vs.push_back(i / 48.0);
    LiveGrid grid(motion, us, vs);
    for (int k = 0; k < 20; ++k) {
      MotionPull edit{{{0.3, 0.4}}, {anyVector(random, 40)}};
      edit.level = k / 7 - 1;
      const Motion after = pull(motion, edit).motion;
      grid.update(after);
      const LiveGrid whole(after, us, vs);
      QVERIFY(grid.grid().point == whole.grid().point && grid.grid().normal == whole.grid().normal);
    }
  }

  void whatCannotBeIsRefused() {
    const Motion motion = primitiveMotion({}).motion;
    VERIFY_ERROR(pull(motion, scalePull({0.3, 0.4}, Vec3(1, 2, 3), finestLevel + 1)), ErrorCode::InvalidParameter);
    VERIFY_ERROR(pull(motion, scalePull({0.3, 0.4}, Vec3(1, 2, 3), coarsestLevel - 1)), ErrorCode::InvalidParameter);
    Motion wrong = motion;
    wrong.base = baseKnots(motion);
    validate(wrong);
    wrong.base->scaling[0].push_back(0.123);
    VERIFY_ERROR((validate(wrong), 0), ErrorCode::InvalidInput);
    wrong.base = baseKnots(motion);
    wrong.base->trajectory.push_back(std::nan(""));
    VERIFY_ERROR((validate(wrong), 0), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(SweepLevelsTest)
#include "sweep_levels_test.moc"
