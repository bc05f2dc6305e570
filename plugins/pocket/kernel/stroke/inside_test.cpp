#include "kernel/stroke/inside_test.h"

#include <algorithm>
#include <cmath>

namespace blossom::pocket {

InsideTest::Slope::Slope(const Stroke& piece)
    : from_(piece.from),
      to_(piece.to),
      center_(piece.center),
      radius_(piece.radius),
      round_(piece.round),
      onRight_(piece.round && piece.at(0.5).x() >= piece.center.x()),
      low_(std::min(piece.from.y(), piece.to.y())),
      high_(std::max(piece.from.y(), piece.to.y())) {
  if (low_ == high_) return;  // spans no height
  const double below = at(low_), above = at(high_);
  minimum_ = std::min(below, above);
  maximum_ = std::max(below, above);
  if (!round_ || center_.y() <= low_ || center_.y() >= high_) return;
  const double beside = at(center_.y());
  minimum_ = std::min(minimum_, beside);
  maximum_ = std::max(maximum_, beside);
}

double InsideTest::Slope::at(double y) const {
  if (!round_) return from_.x() + (y - from_.y()) / (to_.y() - from_.y()) * (to_.x() - from_.x());
  const double dy = y - center_.y();
  const double dx = std::sqrt(std::max(0.0, radius_ * radius_ - dy * dy));
  return center_.x() + (onRight_ ? dx : -dx);
}

bool InsideTest::Slope::isRightOf(const Vec2& p) const {
  if (minimum_ > p.x()) return true;
  return maximum_ > p.x() && at(p.y()) > p.x();
}

InsideTest::InsideTest(const std::vector<Stroke>& strokes) {
  for (const Stroke& stroke : strokes) {
    std::vector<double> cuts{0, 1};
    if (stroke.round)
      for (const Vec2& top : {Vec2(0, 1), Vec2(0, -1)}) {
        const double share = stroke.nearestShare(stroke.center + stroke.radius * top);
        if (share > 0 && share < 1) cuts.push_back(share);
      }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) slopes_.emplace_back(stroke.part(cuts[i], cuts[i + 1]));
  }
  if (!slopes_.empty()) fillRows();
}

void InsideTest::fillRows() {
  bottom_ = slopes_.front().low();
  double top = slopes_.front().high();
  for (const Slope& s : slopes_) {
    bottom_ = std::min(bottom_, s.low());
    top = std::max(top, s.high());
  }
  rows_.resize(std::clamp<std::size_t>(slopes_.size(), 1, 4096));
  height_ = std::max((top - bottom_) / static_cast<double>(rows_.size()), 1e-12);
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    const std::size_t lowest = rowOf(slopes_[i].low()), highest = rowOf(slopes_[i].high());
    const auto index = static_cast<Index>(i);
    rows_[lowest].ending.push_back(index);
    if (highest > lowest) rows_[highest].ending.push_back(index);
    for (std::size_t row = lowest + 1; row < highest; ++row) rows_[row].across.push_back(index);
  }
  for (Row& row : rows_) {
    std::sort(row.across.begin(), row.across.end(),
              [&](Index a, Index b) { return slopes_[a].minimum() < slopes_[b].minimum(); });
    row.reachedBy.reserve(row.across.size());
    double reached = 0;
    for (const Index i : row.across) {
      reached = row.reachedBy.empty() ? slopes_[i].maximum() : std::max(reached, slopes_[i].maximum());
      row.reachedBy.push_back(reached);
    }
  }
}

std::size_t InsideTest::rowOf(double y) const {
  const double row = std::floor((y - bottom_) / height_);
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

bool InsideTest::operator()(const Vec2& p) const {
  if (rows_.empty()) return false;
  const Row& row = rows_[rowOf(p.y())];
  bool inside = false;
  for (const Index i : row.ending)
    if (slopes_[i].spans(p.y()) && slopes_[i].isRightOf(p)) inside = !inside;
  const auto beyond = std::upper_bound(row.across.begin(), row.across.end(), p.x(),
                                       [&](double x, Index i) { return x < slopes_[i].minimum(); });
  if ((row.across.end() - beyond) % 2 != 0) inside = !inside;
  for (auto k = static_cast<std::size_t>(beyond - row.across.begin()); k > 0 && row.reachedBy[k - 1] > p.x(); --k)
    if (slopes_[row.across[k - 1]].isRightOf(p)) inside = !inside;
  return inside;
}

}  // namespace blossom::pocket
