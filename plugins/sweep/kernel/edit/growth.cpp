#include "kernel/edit/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/edit/apply_edits.h"
#include "kernel/edit/motion_symmetry.h"
#include "kernel/grid/motion_point.h"

namespace blossom::sweep {

namespace {

bool sameNet(const Surface& a, const Surface& b) {
  return a.degreeU == b.degreeU && a.degreeV == b.degreeV && a.knotsU == b.knotsU && a.knotsV == b.knotsV;
}

bool goesOnFrom(const Motion& a, const Motion& b) {
  return a.trajectory.degree == b.trajectory.degree && a.trajectory.knots == b.trajectory.knots &&
         sameNet(a.orientation, b.orientation) && sameNet(a.scaling, b.scaling) && a.closedU == b.closedU &&
         a.point == b.point;
}

void betweenPoles(std::vector<Vec4>& poles, const std::vector<Vec4>& to, double share) {
  for (std::size_t i = 0; i < poles.size(); ++i) poles[i] += share * (to[i] - poles[i]);
}

Motion between(const Motion& from, const Motion& to, double share) {
  Motion motion = from;
  betweenPoles(motion.trajectory.poles, to.trajectory.poles, share);
  betweenPoles(motion.orientation.poles, to.orientation.poles, share);
  betweenPoles(motion.scaling.poles, to.scaling.poles, share);
  return motion;
}

/// An edit of which a share is carried out.
struct PartOfEdit {
  const Motion& motion;
  double share;

  MotionEdit operator()(const MotionPull& whole) const {
    MotionPull part = whole;
    for (std::size_t k = 0; k < part.at.size(); ++k) {
      const Vec3 start = evaluate(motion, insidePeriod(motion, part.at[k].u), part.at[k].v).point;
      part.to[k] = start + share * (whole.to[k] - start);
    }
    return part;
  }
  MotionEdit operator()(const MotionTwist& whole) const {
    MotionTwist part = whole;
    part.angle *= share;
    return part;
  }
};

}  // namespace

std::vector<GrowthStep> growthSteps(const Motion& first, std::span<const Motion> following, const Progress& progress) {
  std::vector<GrowthStep> steps;
  std::vector<Motion> grownBy = afterEachEdit(first, progress);
  for (std::size_t i = 0; i < first.edits.size(); ++i) steps.push_back({grownBy[i], grownBy[i + 1], first.edits[i]});
  Motion last = std::move(grownBy.back());
  for (std::size_t k = 0; k < following.size(); ++k) {
    Motion next = withEditsApplied(following[k], progress);
    if (!goesOnFrom(last, next))
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("Motion {} does not go on from the one before: it has other rows, columns or knots.", k + 2),
                  "Refine the motion before its first edit, and begin there.");
    steps.push_back({std::move(last), next, {}});
    last = std::move(next);
  }
  if (steps.empty())
    throw Error(ErrorCode::InvalidInput, "Nothing grows: the motion has no edits of its own, and no other motion follows.",
                "Choose the motion before the first edit, then every pull and twist after it in their order.");
  return steps;
}

Motion grown(const GrowthStep& step, double share, const Progress& progress) {
  if (share <= 0) return step.from;
  if (share >= 1) return step.to;
  if (!step.edit) return between(step.from, step.to, share);
  return edited(step.from, std::visit(PartOfEdit{step.from, share}, *step.edit), progress).motion;
}

GrowthPlace growthPlace(double t, std::size_t steps) {
  const double way = std::clamp(t, 0.0, 1.0) * static_cast<double>(steps);
  const std::size_t step = std::min(static_cast<std::size_t>(std::floor(way)), steps - 1);
  return {step, way - static_cast<double>(step)};
}

GrowthPlace growthPlace(std::size_t frame, std::size_t frames, std::size_t steps) {
  const std::size_t whole = frames - 1, way = frame * steps, step = std::min(way / whole, steps - 1);
  return {step, static_cast<double>(way - step * whole) / static_cast<double>(whole)};
}

}  // namespace blossom::sweep
