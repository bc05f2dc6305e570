#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "support/motion_sizes.h"
#include "support/splines.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/seam_v.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"

/// Motions that close in v, edits of them, and how far they are from closed; for tests of the plugin sweep.
namespace blossom::test {

inline sweep::PrimitiveOptions ringOptions(Random& random) {
  sweep::PrimitiveOptions o;
  o.kind = sweep::PrimitiveKind::Torus;
  o.radius = uniform(random, 20, 40);
  o.profile = uniform(random, 3, 10);
  o.rows = static_cast<std::size_t>(uniformInt(random, 1, 4)) * 4;
  o.columns = static_cast<std::size_t>(uniformInt(random, 2, 8)) * 2;
  return o;
}

/// A period of knots from 0 to 1 that begins with a knot of the given multiplicity.
inline std::vector<double> periodWithSeam(Random& random, int degree, int multiplicity) {
  std::vector<double> period(static_cast<std::size_t>(multiplicity), 0.0);
  double at = 0;
  for (int spans = uniformInt(random, 1, 6); spans > 1; --spans) {
    at += uniform(random, 0.5, 1.5);
    period.insert(period.end(), static_cast<std::size_t>(uniformInt(random, 1, degree)), at);
  }
  for (double& knot : period) knot /= at + 1;
  period.push_back(1);
  return period;
}

/// Row r of one period more is `ratio` times row r.
inline Curve ringCurve(int degree, const std::vector<double>& period, const std::vector<Vec4>& rows, double ratio) {
  Curve curve{degree, unwrappedKnots(degree, period), {}};
  double factor = 1;
  for (std::size_t i = 0; i < rows.size() + static_cast<std::size_t>(degree); ++i) {
    if (i > 0 && i % rows.size() == 0) factor *= ratio;
    curve.poles.emplace_back(factor * rows[i % rows.size()]);
  }
  return curve;
}

struct RingLine {
  int degree = 3;
  std::vector<double> period;
  std::vector<Vec4> rows;
  double ratio = 1;
  [[nodiscard]] Curve clampedCurve() const { return clamped(ringCurve(degree, period, rows, ratio)); }
};

inline RingLine randomRing(Random& random, int continuity, int degree, double ratio) {
  RingLine ring{degree, periodWithSeam(random, degree, degree - continuity), {}, ratio};
  while (ring.rows.size() + 1 < ring.period.size()) ring.rows.push_back(randomPole(random, 10));
  return ring;
}

/// An oval: a circle drawn out in x and bent upwards.
inline Curve closedOval() {
  std::vector<double> breaks;
  for (int i = 0; i <= 12; ++i) breaks.push_back(i / 12.0);
  Curve path{3, unwrappedKnots(3, breaks), {}};
  for (int i = 0; i < 15; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12;
    path.poles.emplace_back(60 * std::cos(angle), 40 * std::sin(angle), 8 * std::cos(2 * angle), 1);
  }
  return clamped(path);
}

/// The largest differences of the factors' derivatives at the two ends, over what they are made of: poles divided by the
/// length of the spans there.
inline double openness(const Motion& motion, const sweep::JoinedFactors& joined) {
  double worst = 0;
  const auto compare = [&](const Curve& line, const sweep::JoinedEnds& ends) {
    const auto [first, last] = line.domain();
    const std::vector<Vec4> start = derivatives(line, first, ends.continuity),
                            end = derivatives(line, last, ends.continuity);
    const std::size_t p = static_cast<std::size_t>(line.degree), n = line.poles.size();
    const double span = std::min(line.knots[p + 1] - line.knots[p], line.knots[n] - line.knots[n - 1]);
    double unit = magnitude(line.poles);
    for (std::size_t k = 0; k < start.size(); ++k) {
      worst = std::max(worst, (end[k] - ends.ratio * start[k]).norm() / unit);
      unit *= static_cast<double>(p - k) / span;
    }
  };
  compare(motion.trajectory, joined.trajectory);
  const auto [first, last] = motion.domainU();
  for (int i = 0; i <= 7; ++i) {
    const double u = first + (last - first) * i / 7;
    compare(isoU(motion.orientation, u), joined.orientation);
    compare(isoU(motion.scaling, u), joined.scaling);
  }
  return worst;
}
inline double openness(const Motion& motion) {
  const auto joined = sweep::joinedInV(motion);
  return joined ? openness(motion, *joined) : INFINITY;
}

enum class EditWay { Translate, Rotate, Scale, Together, Twist };
constexpr EditWay allEditWays[] = {EditWay::Translate, EditWay::Rotate, EditWay::Scale, EditWay::Together, EditWay::Twist};

struct RingEdit {
  MotionPlace at;
  EditWay way = EditWay::Together;
  int fold = 1, level = 0;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< what is done looks the same after this rotation of the ring
};

inline sweep::EditResult editRing(const Motion& motion, const RingEdit& edit) {
  const MotionPlace at = edit.at;
  const Vec3 centre = blossom::point(motion.trajectory, at.v), arm = sweep::evaluate(motion, at.u, at.v).point - centre;
  const Eigen::AngleAxisd little(0.4, edit.turn * Vec3(1, 2, 3).normalized());
  const EditSymmetry symmetry{edit.fold, false};
  const auto pulled = [&](const Vec3& to, const PullWeights& weights) {
    return sweep::pull(motion, {{at}, {centre + to}, weights, Vec3::Zero(), {}, symmetry, edit.level});
  };
  switch (edit.way) {
    case EditWay::Translate:
      return pulled(arm + edit.turn * Vec3(3, -2, 4), {1, 0, 0});
    case EditWay::Rotate:
      return pulled(little * arm, {0, 1, 0});
    case EditWay::Scale:
      return pulled(1.6 * arm, {0, 0, 1});
    case EditWay::Together:
      return pulled(1.4 * (little * arm), {0, 1, 1});
    case EditWay::Twist:
      return sweep::twist(motion, {{at}, little.axis(), 25, {}, symmetry, edit.level});
  }
  return {};
}

}  // namespace blossom::test
