#include "kernel/grid/factor_comb.h"

#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

std::vector<double> combParameters(std::pair<double, double> domain, std::size_t samples) {
  if (samples < 2) throw Error(ErrorCode::InvalidParameter, "A comb needs at least 2 samples.");
  return evenParameters(domain, samples);
}

/// Value and two derivatives along the line, of a parameter that runs from 0 to 1.
struct LineJet {
  Vec4 value, first, second;
};

/// Euclidean coordinates of a homogeneous line, with derivatives by the quotient rule.
struct PointJet {
  Vec3 value, first, second;
};

PointJet projected(const LineJet& h) {
  PointJet p;
  p.value = h.value.head<3>() / h.value[3];
  p.first = (h.first.head<3>() - h.first[3] * p.value) / h.value[3];
  p.second = (h.second.head<3>() - 2 * h.first[3] * p.first - h.second[3] * p.value) / h.value[3];
  return p;
}

class FactorLine {
 public:
  FactorLine(const Surface& factor, CombAlong along, double across) : factor_(factor), along_(along), across_(across) {
    const auto [first, last] = domain();
    length_ = last - first;
  }
  [[nodiscard]] std::pair<double, double> domain() const {
    return along_ == CombAlong::U ? factor_.domainU() : factor_.domainV();
  }
  [[nodiscard]] LineJet at(double t) const {
    constexpr int order = 2;
    const bool u = along_ == CombAlong::U;
    const std::vector<Vec4> all = derivatives(factor_, u ? t : across_, u ? across_ : t, order);
    constexpr std::size_t rows = order + 1;
    const std::size_t step = u ? rows : 1;  // d/du and d/dv
    return {all[0], length_ * all[step], length_ * length_ * all[2 * step]};
  }

 private:
  const Surface& factor_;
  CombAlong along_;
  double across_, length_ = 1;
};

}  // namespace

TrajectoryComb trajectoryComb(const Motion& motion, std::size_t samples, const Progress& progress) {
  TrajectoryComb comb;
  comb.at = combParameters(motion.trajectory.domain(), samples);
  for (const double v : comb.at) {
    progress.check();
    const std::vector<Vec4> all = derivatives(motion.trajectory, v, 2);
    const PointJet p = projected({all[0], all[1], all[2]});
    const double speed = p.first.squaredNorm();
    // The part of t'' across t', over |t'|^2, is the curvature times the normal.
    const Vec3 across = speed > 0 ? Vec3(p.second - p.second.dot(p.first) / speed * p.first) : Vec3::Zero();
    comb.point.push_back(p.value);
    comb.curvature.push_back(speed > 0 ? Vec3(across / speed) : Vec3::Zero());
  }
  return comb;
}

ScalingComb scalingComb(const Motion& motion, CombAlong along, double across, std::size_t samples,
                        const Progress& progress) {
  const FactorLine line(motion.scaling, along, across);
  ScalingComb comb;
  comb.at = combParameters(line.domain(), samples);
  for (const double t : comb.at) {
    progress.check();
    const PointJet f = projected(line.at(t));
    Vec3 curvature;
    for (Eigen::Index k = 0; k < 3; ++k) curvature[k] = f.second[k] / std::pow(1 + f.first[k] * f.first[k], 1.5);
    comb.factors.push_back(f.value);
    comb.curvature.push_back(curvature);
  }
  return comb;
}

OrientationComb orientationComb(const Motion& motion, CombAlong along, double across, std::size_t samples,
                                const Progress& progress) {
  const FactorLine line(motion.orientation, along, across);
  OrientationComb comb;
  comb.at = combParameters(line.domain(), samples);
  for (const double t : comb.at) {
    progress.check();
    const LineJet r = line.at(t);
    const double square = r.value.squaredNorm();
    comb.velocity.push_back(square > 0 ? Vec3(2 / square * times(r.first, conjugate(r.value)).tail<3>()) : Vec3::Zero());
  }
  return comb;
}

}  // namespace blossom::sweep
