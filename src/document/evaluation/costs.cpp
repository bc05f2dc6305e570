#include "document/evaluation/costs.h"

#include <algorithm>

namespace blossom {

namespace {

constexpr double least = 0.1, typical = 20;                                   // ms
constexpr double showingAShape = 0.25, showingFrames = 3, mostShowing = 100;  // times as long as computing

}  // namespace

void Costs::took(const Feature& feature, double milliseconds) {
  const std::lock_guard lock(mutex_);
  byFeature_[feature.id] = byType_[feature.type] = std::max(least, milliseconds);
}

double Costs::expected(const Feature& feature) const {
  const std::lock_guard lock(mutex_);
  if (const auto known = byFeature_.find(feature.id); known != byFeature_.end()) return known->second;
  const auto alike = byType_.find(feature.type);
  return alike != byType_.end() ? alike->second : typical;
}

void Costs::showingTook(const Feature& feature, bool sequence, double timesAsLong) {
  const std::lock_guard lock(mutex_);
  showingOfFeature_[{feature.id, sequence}] = showingOfType_[{feature.type, sequence}] =
      std::clamp(timesAsLong, 0.0, mostShowing);
}

double Costs::expectedShowing(const Feature& feature, bool sequence) const {
  const std::lock_guard lock(mutex_);
  if (const auto known = showingOfFeature_.find({feature.id, sequence}); known != showingOfFeature_.end())
    return known->second;
  const auto alike = showingOfType_.find({feature.type, sequence});
  if (alike != showingOfType_.end()) return alike->second;
  return sequence ? showingFrames : showingAShape;
}

}  // namespace blossom
