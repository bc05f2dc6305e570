#include "document/evaluation/costs.h"

#include <algorithm>

namespace blossom {

namespace {

constexpr double least = 0.1, typical = 20;  // ms

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

}  // namespace blossom
