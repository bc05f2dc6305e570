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

/// One feature of a document. Its type is stored by id, so that a document can be opened without the plugin.
struct Feature {
  FeatureId id;
  std::string type;                    ///< "sweep.sweep"
  std::string name;                    ///< name shown in the tree
  Value parameters = Value::object();  ///< canonical; absent ones have their default
  std::vector<FeatureId> inputs;       ///< in order of the type's input specs
  bool visible = true;
  bool suppressed = false;
  Value extra = Value::object();  ///< keys of newer minor versions, kept when saved again
  friend bool operator==(const Feature&, const Feature&) = default;
};

/// The feature's name in messages.
std::string shownName(const Feature&);

/// An immutable list of features; an edit makes a new document that shares all unchanged parts. O(features) pointers per
/// edit.
class Document {
 public:
  /// A document of these features in any order. O(n log n). @throws Error InvalidInput (an id that is empty or not unique),
  /// NotFound (an input), CycleFound.
  static Document of(std::vector<Feature>);
  /// Appends the feature, or replaces the one with its id (inputs after it are moved before it).
  /// @throws Error NotFound (an input), CycleFound, InvalidInput (no id).
  [[nodiscard]] Document with(Feature) const;
  /// @throws Error InUse when the feature is an input of others; NotFound.
  [[nodiscard]] Document without(const FeatureId&) const;
  /// @throws Error NotFound; InvalidInput when it would come before one of its inputs or after one of its users.
  [[nodiscard]] Document moved(const FeatureId&, std::size_t place) const;
  /// Adds the content of an imported file, by its hash.
  [[nodiscard]] Document withAsset(std::string hash, std::shared_ptr<const std::string> content) const;
  [[nodiscard]] Document withExtra(Value extra) const;
  /// Sets the access rule for files named by parameters; all versions made from this document share it.
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
  /// nullptr for a document made here, which may read any file; relative paths start at the current folder.
  [[nodiscard]] const std::shared_ptr<FileAccess>& access() const { return access_; }
  /// An unused id made from the command of a type: "sweep-2".
  [[nodiscard]] FeatureId freshId(const std::string& command) const;

 private:
  std::vector<std::shared_ptr<const Feature>> features_;
  std::map<std::string, std::shared_ptr<const std::string>> assets_;
  Value extra_ = Value::object();
  std::shared_ptr<FileAccess> access_;
};

}  // namespace blossom
