#include "kernel/grid/live_grid.h"

#include <algorithm>

#include "core/error.h"

namespace blossom::sweep {

namespace {

void requireAscending(const char* name, const std::vector<double>& parameters) {
  if (parameters.empty() || !std::is_sorted(parameters.begin(), parameters.end()))
    throw Error(ErrorCode::InvalidParameter, std::string("The parameters ") + name + " of a live grid do not ascend.");
}

}  // namespace

LiveGrid::LiveGrid(const Motion& motion, std::vector<double> us, std::vector<double> vs)
    : us_(std::move(us)), vs_(std::move(vs)) {
  requireAscending("u", us_);
  requireAscending("v", vs_);
  grid_.countU = us_.size(), grid_.countV = vs_.size();
  for (auto* arrays : {&grid_.point, &grid_.normal})
    for (auto& array : *arrays) array.resize(us_.size() * vs_.size());
  rebuild(motion);
}

void LiveGrid::rebuild(const Motion& motion) {
  motion_ = motion;
  factors_ = tabulateFactors(motion, us_, vs_);
  trajectoryBasis_ = tabulateBasis(motion.trajectory.degree, motion.trajectory.knots, vs_);
  rectangles_.assign(1, {{0, us_.size()}, {0, vs_.size()}});
  evaluateRows(factors_, rectangles_.front(), grid_);
}

std::span<const GridRectangle> LiveGrid::update(const Motion& motion) {
  if (!haveSameForm(motion_, motion)) {
    rebuild(motion);
    return rectangles_;
  }
  const ChangedPoles changed = changedPoles(motion_, motion);
  dirty_.assign(us_.size(), {});
  updateFactor(factors_.orientation, motion.orientation, changed.orientation);
  updateFactor(factors_.scaling, motion.scaling, changed.scaling);
  updateTrajectory(motion.trajectory, changed.trajectory);
  motion_ = motion;
  gatherRectangles();
  for (const GridRectangle& part : rectangles_) evaluateRows(factors_, part, grid_);
  return rectangles_;
}

void LiveGrid::updateFactor(FactorGrid& factor, const Surface& surface, const std::vector<GridRange>& changed) {
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (changed[i].empty()) continue;
    factor.updateRow(surface, i, changed[i]);
    const GridRange columns = factor.v().support(changed[i]), rows = factor.u().support({i, i + 1});
    for (std::size_t k = rows.begin; k < rows.end; ++k) dirty_[k] = hull(dirty_[k], columns);
  }
}

void LiveGrid::updateTrajectory(const Curve& trajectory, const GridRange& changed) {
  const GridRange columns = trajectoryBasis_.support(changed);
  if (columns.empty()) return;
  tabulateTrajectory(trajectory, trajectoryBasis_, columns, factors_.trajectory);
  for (GridRange& range : dirty_) range = hull(range, columns);
}

void LiveGrid::gatherRectangles() {
  rectangles_.clear();
  for (std::size_t k = 0; k < dirty_.size(); ++k) {
    if (dirty_[k].empty()) continue;
    const GridRange columns = wholeBlocks(dirty_[k], vs_.size());
    GridRectangle* const last = rectangles_.empty() ? nullptr : &rectangles_.back();
    if (last && last->rows.end == k && last->columns == columns) {
      last->rows.end = k + 1;
    } else {
      rectangles_.push_back({{k, k + 1}, columns});
    }
  }
}

}  // namespace blossom::sweep
