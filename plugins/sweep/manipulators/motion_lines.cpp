#include "manipulators/motion_lines.h"

#include <algorithm>

#include "geometry/bspline/bspline.h"
#include "kernel/grid/factor_comb.h"
#include "kernel/grid/iso_curves.h"
#include "kernel/grid/motion_grid.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t isoSamples = 97, combTeeth = 121;

void addKnots(const std::vector<double>& knots, std::pair<double, double> domain, std::vector<double>& all) {
  for (const double knot : knots)
    if (knot >= domain.first && knot <= domain.second) all.push_back(knot);
}

std::vector<double> sortedOnce(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// The end of a closed motion is its start.
std::vector<double> placesAround(const Motion& motion, std::size_t count) {
  if (motion.closedU == ClosedU::No) return evenParameters(motion.domainU(), count);
  std::vector<double> places = evenParameters(motion.domainU(), count + 1);
  places.pop_back();
  return places;
}

}  // namespace

std::array<Polylines, 3> frameLines(const Motion& motion, std::size_t countU, std::size_t countV, double length) {
  std::array<std::vector<std::pair<Vec3, Vec3>>, 3> arms;
  double longest = 0;
  for (const double u : placesAround(motion, countU))
    for (const double v : evenParameters(motion.domainV(), countV)) {
      const Vec4 r = evaluate(motion.orientation, u, v), s = evaluate(motion.scaling, u, v);
      if (!(r.squaredNorm() > 0)) continue;
      const Vec3 factors = s.head<3>() / s[3];
      const Vec3 at = point(motion.trajectory, v) + turned(r, factors.cwiseProduct(motion.point));
      for (int k = 0; k < 3; ++k) {
        const Vec3 arm = turned(r, factors[k] * Vec3::Unit(k));
        longest = std::max(longest, arm.norm());
        arms[static_cast<std::size_t>(k)].emplace_back(at, arm);
      }
    }
  std::array<Polylines, 3> lines;
  if (longest > 0)
    for (std::size_t k = 0; k < arms.size(); ++k)
      for (const auto& [at, arm] : arms[k]) lines[k].push_back({at, at + length / longest * arm});
  return lines;
}

Polylines knotCurves(const Motion& motion) {
  std::vector<double> us, vs;
  for (const Surface* factor : {&motion.orientation, &motion.scaling}) {
    addKnots(factor->knotsU, motion.domainU(), us);
    addKnots(factor->knotsV, motion.domainV(), vs);
  }
  addKnots(motion.trajectory.knots, motion.domainV(), vs);
  IsoCurves curves = isoCurves(motion, sortedOnce(std::move(us)), sortedOnce(std::move(vs)), isoSamples);
  Polylines lines = std::move(curves.constantU);
  lines.insert(lines.end(), std::make_move_iterator(curves.constantV.begin()),
               std::make_move_iterator(curves.constantV.end()));
  return lines;
}

Polylines trajectoryCombLines(const Motion& motion, double length) {
  const TrajectoryComb comb = trajectoryComb(motion, combTeeth);
  double most = 0, size = 0;
  for (std::size_t k = 0; k < comb.at.size(); ++k) {
    most = std::max(most, comb.curvature[k].norm());
    size = std::max(size, (comb.point[k] - comb.point[0]).norm());
  }
  // A straight line bends by rounding alone.
  constexpr double straight = 1e-9;
  if (!(most * size > straight)) return {};
  Polylines lines;
  std::vector<Vec3> ends;
  for (std::size_t k = 0; k < comb.at.size(); ++k) {
    ends.push_back(comb.point[k] - length / most * comb.curvature[k]);
    if (k % 2 == 0) lines.push_back({comb.point[k], ends.back()});
  }
  lines.push_back(std::move(ends));
  return lines;
}

double suitableAxis(const Motion& motion) {
  const double u = motion.domainU().first, v = (motion.domainV().first + motion.domainV().second) / 2;
  const Vec4 s = evaluate(motion.scaling, u, v);
  const double reach = (s.head<3>().cwiseProduct(motion.point) / s[3]).norm();
  const double height =
      (point(motion.trajectory, motion.domainV().second) - point(motion.trajectory, motion.domainV().first)).norm();
  return 0.6 * (reach > 0 ? reach : std::max(height / 10, 1e-3));
}

}  // namespace blossom::sweep
