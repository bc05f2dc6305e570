#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "parameter/value.h"

namespace blossom {

class FileAccess;
using FeatureId = std::string;  ///< unique in a document: "sweep-1"

/// One step of the model. Its type is kept by id, so that a document survives a missing plugin.
struct Feature {
  FeatureId id;
  std::string type;                    ///< "sweep.sweep"
  std::string name;                    ///< as the tree shows it
  Value parameters = Value::object();  ///< canonical; what is absent is at its default
  std::vector<FeatureId> inputs;       ///< in order of the type's input specs
  bool visible = true;
  bool suppressed = false;
  Value extra = Value::object();  ///< keys of newer minor versions, kept when saved again
  friend bool operator==(const Feature&, const Feature&) = default;
};

/// How sentences call it.
std::string shownName(const Feature&);

/// A list of features; an edit makes a new document that shares all unchanged parts. O(features) pointers per edit.
class Document {
 public:
  /// All at once, in any order; O(n log n). @throws Error InvalidInput (an id twice or empty), NotFound (an input),
  /// CycleFound.
  static Document of(std::vector<Feature>);
  /// Adds at the end, or replaces the feature of that id in its place (inputs that stood after it move before it).
  /// @throws Error NotFound (an input), CycleFound, InvalidInput (no id).
  [[nodiscard]] Document with(Feature) const;
  /// @throws Error InUse while others take it as input; NotFound.
  [[nodiscard]] Document without(const FeatureId&) const;
  /// @throws Error NotFound; InvalidInput when it would stand before one of its inputs or after one of its users.
  [[nodiscard]] Document moved(const FeatureId&, std::size_t place) const;
  /// Content of imported files, by hash.
  [[nodiscard]] Document withAsset(std::string hash, std::shared_ptr<const std::string> content) const;
  [[nodiscard]] Document withExtra(Value extra) const;
  /// Another rule for the files that its parameters name; all versions made from it share the rule.
  [[nodiscard]] Document withAccess(std::shared_ptr<FileAccess>) const;

  /// @throws Error NotFound.
  [[nodiscard]] const Feature& at(const FeatureId&) const;
  [[nodiscard]] bool contains(const FeatureId&) const;
  [[nodiscard]] std::span<const std::shared_ptr<const Feature>> features() const {
    return features_;
  }  ///< inputs before users
  [[nodiscard]] std::vector<FeatureId> usersOf(const FeatureId&) const;
  [[nodiscard]] const std::map<std::string, std::shared_ptr<const std::string>>& assets() const { return assets_; }
  [[nodiscard]] const Value& extra() const { return extra_; }
  /// nullptr: it was made here and reads what it names, relative paths from the current folder.
  [[nodiscard]] const std::shared_ptr<FileAccess>& access() const { return access_; }
  /// "sweep-2": a free id made from a type's command.
  [[nodiscard]] FeatureId freshId(const std::string& command) const;

 private:
  std::vector<std::shared_ptr<const Feature>> features_;
  std::map<std::string, std::shared_ptr<const std::string>> assets_;
  Value extra_ = Value::object();
  std::shared_ptr<FileAccess> access_;
};

}  // namespace blossom
