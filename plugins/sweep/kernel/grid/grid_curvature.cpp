#include "kernel/grid/grid_curvature.h"

#include <cmath>

#include "kernel/grid/frame_arithmetic.h"
#include "kernel/grid/second_order.h"
#include "kernel/grid/trajectory_table.h"

namespace blossom::sweep {

namespace {

/// First and second derivatives in u and v.
struct Derivatives {
  Triple u, v, uu, uv, vv;
};

/// a = s p / sw with its derivatives: differentiates a sw = s p and solves for the highest term.
BLOSSOM_INLINE Derivatives scaledPoint(const FactorJets& s, std::size_t j, const Triple& p, Triple& a) {
  const auto numerator = [&](FactorJets::Part part) __attribute__((always_inline)) {
    return Triple{s.part[part][0][j] * p.x, s.part[part][1][j] * p.y, s.part[part][2][j] * p.z};
  };
  const auto weight = [&](FactorJets::Part part) __attribute__((always_inline)) { return s.part[part][3][j]; };
  const double inverse = 1 / weight(FactorJets::Value), wu = weight(FactorJets::U), wv = weight(FactorJets::V);
  a = inverse * numerator(FactorJets::Value);
  Derivatives d;
  d.u = inverse * (numerator(FactorJets::U) - wu * a);
  d.v = inverse * (numerator(FactorJets::V) - wv * a);
  d.uu = inverse * (numerator(FactorJets::UU) - 2 * wu * d.u - weight(FactorJets::UU) * a);
  d.uv = inverse * (numerator(FactorJets::UV) - wu * d.v - wv * d.u - weight(FactorJets::UV) * a);
  d.vv = inverse * (numerator(FactorJets::VV) - 2 * wv * d.v - weight(FactorJets::VV) * a);
  return d;
}

/// Derivatives of the swept point in the moving frame.
BLOSSOM_INLINE Derivatives inMovingFrame(const FactorJets& r, const FactorJets& s, std::size_t j, const Triple& p,
                                         const Triple& t1, const Triple& t2) {
  const auto quaternion = [&](FactorJets::Part part) __attribute__((always_inline)) {
    return Quaternion{r.part[part][0][j], r.part[part][1][j], r.part[part][2][j], r.part[part][3][j]};
  };
  const Quaternion q = quaternion(FactorJets::Value), qu = quaternion(FactorJets::U), qv = quaternion(FactorJets::V);
  // Angular velocities and their derivatives; |r|^2 changes by the shares du and dv.
  const double two = 2 / dot(q, q), du = two * dot(q, qu), dv = two * dot(q, qv);
  const Triple wu = two * relative(q, qu), wv = two * relative(q, qv);
  const Triple wuu = two * relative(q, quaternion(FactorJets::UU)) - du * wu;
  const Triple wuv = two * (relative(qv, qu) + relative(q, quaternion(FactorJets::UV))) - dv * wu;
  const Triple wvv = two * relative(q, quaternion(FactorJets::VV)) - dv * wv;

  Triple a;
  const Derivatives d = scaledPoint(s, j, p, a);
  const Triple u = d.u + cross(wu, a), v = d.v + cross(wv, a);
  return {u, v + turnedBack(q, two, t1), d.uu + cross(wuu, a) + cross(wu, d.u + u),
          d.uv + cross(wuv, a) + cross(wu, d.v) + cross(wv, u),
          d.vv + cross(wvv, a) + cross(wv, d.v + v) + turnedBack(q, two, t2)};
}

struct ResultRow {
  double *gaussian, *mean;
};

BLOSSOM_FOR_EACH_VECTOR_WIDTH
void combineCurvature(const FactorJets& r, const FactorJets& s, const Triple& p, const TrajectoryTable& t, std::size_t begin,
                      std::size_t count, const ResultRow& out) {
  const double *ax = t.derivative[0].data() + begin, *ay = t.derivative[1].data() + begin,
               *az = t.derivative[2].data() + begin;
  const double *bx = t.second[0].data() + begin, *by = t.second[1].data() + begin, *bz = t.second[2].data() + begin;
  double *const gaussian = out.gaussian + begin, *const mean = out.mean + begin;
  BLOSSOM_INDEPENDENT_STEPS
  for (std::size_t j = 0; j < count; ++j) {
    const Derivatives x = inMovingFrame(r, s, j, p, {ax[j], ay[j], az[j]}, {bx[j], by[j], bz[j]});
    const Triple n = cross(x.u, x.v);
    // The second fundamental form is taken with the normal as it is, |n| too long; |n|^2 = E G - F^2.
    const double e = dot(x.u, x.u), f = dot(x.u, x.v), g = dot(x.v, x.v), square = dot(n, n);
    const double l = dot(x.uu, n), m = dot(x.uv, n), k = dot(x.vv, n);
    const double inverse = square > 0 ? 1 / square : 0;
    gaussian[j] = (l * k - m * m) * inverse * inverse;
    mean[j] = (e * k - 2 * f * m + g * l) * inverse * std::sqrt(inverse) / 2;
  }
}

}  // namespace

void evaluateCurvature(const Motion& motion, std::span<const double> us, std::span<const double> vs, GridCurvature& result,
                       const Progress& progress) {
  result.countU = us.size(), result.countV = vs.size();
  result.gaussian.resize(us.size() * vs.size());
  result.mean.resize(us.size() * vs.size());
  const SecondOrderGrid orientation(motion.orientation, us, vs), scaling(motion.scaling, us, vs);
  const Curve& t = motion.trajectory;
  TrajectoryTable trajectory;
  tabulateTrajectory(t, tabulateBasis(t.degree, t.knots, vs, KnotSide::Right, 2), {0, vs.size()}, trajectory);
  const Triple p = {motion.point.x(), motion.point.y(), motion.point.z()};
  FactorJets r, s;
  for (std::size_t k = 0; k < us.size(); ++k) {
    if (k % 16 == 0) progress.check();
    const ResultRow out = {result.gaussian.data() + k * vs.size(), result.mean.data() + k * vs.size()};
    for (std::size_t begin = 0; begin < vs.size(); begin += jetCount) {
      const std::size_t count = std::min(jetCount, vs.size() - begin);
      orientation.evaluate(k, begin, count, r);
      scaling.evaluate(k, begin, count, s);
      combineCurvature(r, s, p, trajectory, begin, count, out);
    }
  }
}

}  // namespace blossom::sweep
