#include <fmt/format.h>

#include <algorithm>

#include "kernel/ball.h"
#include "kernel/morphology.h"
#include "kernel/operations/erosion.h"
#include "kernel/operations/work.h"

namespace blossom::morphology {

namespace {

Operand ballOperand(double radius, const GrowOptions& options) {
  Operand operand;
  operand.mesh = ball({radius, options.subdivisions, options.fit}).mesh;
  operand.name = "The ball";
  return operand;
}

double largestOf(const std::vector<double>& radii) {
  return radii.empty() ? 0 : *std::max_element(radii.begin(), radii.end());
}

/// The solid itself where the radius is 0, otherwise what `step` makes of it with the ball; stops where that is nothing.
template <class Step>
void eachRadius(Work& work, const Operand& a, const GrowOptions& options, const Step& step) {
  requireSolid(a);
  const double largest = largestOf(options.radii);
  const Operand widest = ballOperand(largest > 0 ? largest : 1, options);
  const CommonGrid grid = gridFor(a.bounds(), widest.bounds());
  const Prepared solid = work.united(work.prepare(a, grid, 0, 0.08), grid, 0.08, 0.1);
  const double share = 0.9 / static_cast<double>(std::max<std::size_t>(1, options.radii.size()));
  double from = 0.1;
  for (std::size_t k = 0; k < options.radii.size(); ++k, from += share) {
    const double radius = options.radii[k];
    if (!(radius > 0)) {
      work.finish(solid, grid, from, from + share);
      continue;
    }
    const Prepared element = prepared(ballOperand(radius, options), grid, Progress::none());
    const Mesh made = step(solid, element, grid, from, from + 0.9 * share);
    if (made.faceCount() == 0) {
      if (k == 0 || (k == 1 && !(options.radii[0] > 0) && options.radii.size() == 2))
        nothingLeft(a, "Choose a smaller radius.");
      work.warn(fmt::format("Nothing is left from a radius of {:.6g} mm on; the sequence ends after {} frames.", radius, k));
      break;
    }
    work.finish(made, solid.centre, from + 0.9 * share, from + share);
  }
}

}  // namespace

MorphologyResult inflated(const Operand& a, const GrowOptions& options, const Progress& progress) {
  Work work(progress);
  eachRadius(work, a, options,
             [&](const Prepared& solid, const Prepared& element, const CommonGrid& grid, double from, double to) {
               return work.sum(solid, 1, element, 1, grid, from, to);
             });
  return work.result();
}

MorphologyResult melted(const Operand& a, const GrowOptions& options, const Progress& progress) {
  Work work(progress);
  eachRadius(work, a, options,
             [&](const Prepared& solid, const Prepared& element, const CommonGrid& grid, double from, double to) {
               return eroded(work, solid, element, grid, from, to);
             });
  return work.result();
}

}  // namespace blossom::morphology
