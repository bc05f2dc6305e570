#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "feature/feature_type.h"

namespace blossom {

/// Text form of an input, such as "ball:5:3" in place of a file. `parse` receives the text after the name and the colon.
struct LiteralForm {
  std::string name;    ///< "ball"
  std::string syntax;  ///< "ball:RADIUS:SUBDIVISIONS"
  std::string summary;
  std::function<Shape(std::string_view text)> parse;
};

/// All feature types and literal forms of this process; filled at start, read-only afterwards.
class Registry {
 public:
  /// Adds a feature type and converts its defaults to canonical form.
  /// @throws Error PluginBroken when id or command is taken, or the declaration is incomplete or contradictory.
  void add(FeatureType);
  void add(LiteralForm);
  /// Adds everything of `other`, or nothing when it throws. @throws Error PluginBroken as `add`.
  void merge(const Registry& other);
  template <class... Rest>
  void addAll(Rest&&... rest) {
    (add(std::forward<Rest>(rest)), ...);
  }

  [[nodiscard]] const std::vector<std::shared_ptr<const FeatureType>>& types() const { return types_; }
  [[nodiscard]] const std::vector<LiteralForm>& literals() const { return literals_; }
  /// Finds a type by command or id; nullptr when there is none.
  [[nodiscard]] std::shared_ptr<const FeatureType> find(std::string_view commandOrId) const;
  /// Like find. @throws Error NotFound with the nearest name as hint.
  [[nodiscard]] std::shared_ptr<const FeatureType> at(std::string_view commandOrId) const;
  /// The shape written as a literal such as "ball:5:3"; empty when no form has that name.
  /// @throws Error InvalidParameter.
  [[nodiscard]] Shape literal(std::string_view text) const;

 private:
  std::vector<std::shared_ptr<const FeatureType>> types_;
  std::vector<LiteralForm> literals_;
};

}  // namespace blossom
