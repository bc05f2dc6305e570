#pragma once
#include <QString>
#include <optional>
#include <vector>

#include "document/document.h"
#include "feature/feature_type.h"

namespace blossom::ui {

class Session;

/// Assignment of a feature's inputs to the input specs of its type, and the features that could be added. Uses known
/// results; a feature without a result is assumed to be suitable.
class InputSlots {
 public:
  InputSlots(const Session&, const Feature&, const FeatureType&);

  /// Inputs of one spec, in order.
  [[nodiscard]] const std::vector<FeatureId>& of(std::size_t spec) const { return taken_.at(spec); }
  /// Features that input `spec` could get: of suitable kinds, not depending on this feature, not chosen yet but for control
  /// shapes, of which one may stand at several places.
  [[nodiscard]] std::vector<FeatureId> candidates(std::size_t spec) const;
  [[nodiscard]] bool accepts(std::size_t spec, const FeatureId&) const;
  /// The feature with the inputs of one spec replaced; what its lists hold for each of them goes with them.
  [[nodiscard]] Feature with(std::size_t spec, const std::vector<FeatureId>&) const;
  /// Whether `id` is this feature or depends on it.
  [[nodiscard]] bool dependsOnThis(const FeatureId& id) const;

 private:
  const Session& session_;
  const Feature& feature_;
  const FeatureType& type_;
  std::vector<std::vector<FeatureId>> taken_;
};

/// The document without features of which those that are made from them can do without; nothing where one cannot.
std::optional<Document> withoutInputs(const Session&, const std::vector<FeatureId>& ids);

}  // namespace blossom::ui
