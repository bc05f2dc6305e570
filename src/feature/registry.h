#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/format/format.h"
#include "feature/feature_type.h"

namespace blossom {

/// Text form of an input, such as "ball:5:3" in place of a file. `parse` receives the text after the name and the colon.
struct LiteralForm {
  std::string name;    ///< "ball"
  std::string syntax;  ///< "ball:RADIUS:SUBDIVISIONS"
  std::string summary;
  std::function<Shape(std::string_view text)> parse;
  std::function<std::string()> dependsOn = {};  ///< as in FeatureType
};

/// All feature types, literal forms and file formats known to this process. Filled at start, then only read.
class Registry {
 public:
  /// Adds a feature type and converts its defaults to canonical form.
  /// @throws Error PluginBroken when id or command is taken, or the declaration is incomplete or contradictory.
  void add(FeatureType);
  void add(LiteralForm);
  /// @throws Error PluginBroken when the id or an extension is taken, or the declaration is incomplete.
  void add(Format);
  /// Puts a declaration in place of the one with the same id and command. @throws Error PluginBroken.
  void replace(FeatureType);
  /// Everything of `other`, or nothing when it throws. @throws Error PluginBroken as add does.
  void merge(const Registry& other);
  template <class... Rest>
  void addAll(Rest&&... rest) {
    (add(std::forward<Rest>(rest)), ...);
  }

  [[nodiscard]] const std::vector<std::shared_ptr<const FeatureType>>& types() const { return types_; }
  [[nodiscard]] const std::vector<LiteralForm>& literals() const { return literals_; }
  [[nodiscard]] const FormatRegistry& formats() const { return formats_; }
  /// By command or id; nullptr when there is none.
  [[nodiscard]] std::shared_ptr<const FeatureType> find(std::string_view commandOrId) const;
  /// Like find. @throws Error NotFound with the nearest name as hint.
  [[nodiscard]] std::shared_ptr<const FeatureType> at(std::string_view commandOrId) const;
  /// The first feature type that opens shapes of that kind; nullptr when there is none.
  [[nodiscard]] std::shared_ptr<const FeatureType> opening(ShapeKind) const;
  /// The shape that a literal such as "ball:5:3" stands for; empty when no form has that name.
  /// @throws Error InvalidParameter.
  [[nodiscard]] Shape literal(std::string_view text) const;

 private:
  std::vector<std::shared_ptr<const FeatureType>> types_;
  std::vector<LiteralForm> literals_;
  FormatRegistry formats_;
};

}  // namespace blossom
