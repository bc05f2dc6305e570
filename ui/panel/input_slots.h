#pragma once
#include <QString>
#include <vector>

#include "document/document.h"
#include "feature/feature_type.h"

namespace blossom::ui {

class Session;

/// Which inputs of a feature belong to which input spec of its type, and what else could be taken. As far as results are
/// known; a feature without one is thought to fit.
class InputSlots {
 public:
  InputSlots(const Session&, const Feature&, const FeatureType&);

  /// Inputs of one spec, in order.
  [[nodiscard]] const std::vector<FeatureId>& of(std::size_t spec) const { return taken_.at(spec); }
  /// What spec `spec` could take too: kinds that fit, no feature that needs this one, none that is there already.
  [[nodiscard]] std::vector<FeatureId> candidates(std::size_t spec) const;
  [[nodiscard]] bool accepts(std::size_t spec, const FeatureId&) const;
  /// All inputs with those of one spec replaced.
  [[nodiscard]] std::vector<FeatureId> with(std::size_t spec, const std::vector<FeatureId>&) const;
  /// The feature, or something it needs, takes `id` into account.
  [[nodiscard]] bool dependsOnThis(const FeatureId& id) const;

 private:
  const Session& session_;
  const Feature& feature_;
  const FeatureType& type_;
  std::vector<std::vector<FeatureId>> taken_;
};

}  // namespace blossom::ui
