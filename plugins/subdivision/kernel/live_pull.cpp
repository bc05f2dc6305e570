#include "kernel/live_pull.h"

#include <algorithm>

#include "core/error.h"
#include "kernel/free_points.h"

namespace blossom::subdivision {
namespace {

constexpr int piecesAlong = 4;  // pieces along a side of a patch

}  // namespace

LivePull::LivePull(const LimitSurface& surface, std::span<const Vec3> points, std::vector<Handle> handles,
                   const DeformOptions& options, const Progress& progress)
    : surface_(surface),
      options_(options),
      edges_(surface.edges()),
      points_(points.begin(), points.end()),
      handles_(std::move(handles)) {
  for (const Handle& handle : handles_) rows_.push_back(surface.row(handle.foot));
  reach(chosenFree(), progress);
  solve();
}

std::vector<int> LivePull::chosenFree() const {
  std::vector<Vec3> to;
  for (const Handle& handle : handles_) to.push_back(handle.to);
  return subdivision::freePoints(options_.free, {to, rows_, 0}, points_, edges_, false);
}

/// What these free points move: the factor, and the patches within reach.
void LivePull::reach(std::vector<int> free, const Progress& progress) {
  free_ = std::move(free);
  const Resistance resistance = resistanceOf(rows_, free_);
  factor_ = std::make_unique<LeastSquares>(rows_, free_, resistance.shares, edges_, options_.lambda * resistance.strongest,
                                           progress);
  moved_ = points_;
  still_.clear();
  sampleRows_.clear();
  triangles_.clear();
  for (std::size_t p = 0; p < surface_.patchCount(); ++p) {
    if (p % 256 == 0) progress.check();
    const auto patch = static_cast<int>(p);
    const std::vector<int> acting = surface_.controlPoints(patch);
    if (std::any_of(acting.begin(), acting.end(), [&](int i) { return std::binary_search(free_.begin(), free_.end(), i); }))
      addPatch(patch);
  }
  samples_ = still_;
}

void LivePull::addPatch(int patch) {
  const bool triangle = surface_.domain(patch) == Domain::Triangle;
  std::array<std::array<int, piecesAlong + 1>, piecesAlong + 1> number{};
  for (int i = 0; i <= piecesAlong; ++i)
    for (int j = 0; j <= (triangle ? piecesAlong - i : piecesAlong); ++j) {
      const Row row = surface_.row({patch, static_cast<double>(i) / piecesAlong, static_cast<double>(j) / piecesAlong});
      number[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = static_cast<int>(still_.size());
      still_.push_back(combined(row, points_));
      Row& acting = sampleRows_.emplace_back();
      for (std::size_t k = 0; k < row.indices.size(); ++k) {
        const auto found = std::lower_bound(free_.begin(), free_.end(), row.indices[k]);
        if (found == free_.end() || *found != row.indices[k]) continue;
        acting.indices.push_back(static_cast<int>(found - free_.begin()));
        acting.weights.push_back(row.weights[k]);
      }
    }
  const auto at = [&](int i, int j) { return number[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; };
  for (int i = 0; i < piecesAlong; ++i)
    for (int j = 0; j < (triangle ? piecesAlong - i : piecesAlong); ++j) {
      triangles_.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (!triangle || i + j + 1 < piecesAlong) triangles_.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
}

void LivePull::drag(std::size_t k, const Vec3& to) {
  const Vec3 before = handles_.at(k).to;
  handles_[k].to = to;
  if (options_.free.paper) {
    try {
      if (std::vector<int> free = chosenFree(); free != free_) reach(std::move(free), Progress::none());
    } catch (const Error&) {
      handles_[k].to = before;
      throw;
    }
  }
  solve();
}

void LivePull::solve() {
  std::vector<Vec3> residuals;
  for (std::size_t k = 0; k < handles_.size(); ++k) residuals.push_back(handles_[k].to - combined(rows_[k], points_));
  const std::vector<Vec3> moved = factor_->solve(residuals);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const auto p = static_cast<std::size_t>(free_[i]);
    moved_[p] = points_[p] + moved[i];
  }
  for (std::size_t s = 0; s < samples_.size(); ++s) samples_[s] = still_[s] + combined(sampleRows_[s], moved);
}

}  // namespace blossom::subdivision
