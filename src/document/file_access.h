#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>

namespace blossom {

/// The files that a document may read, and the base of its relative paths. Because the author of a document may name any
/// file, it may read only files below its own folder unless the user allows more. What the user allows is not part of the
/// document and applies to all its versions. Symbolic links and ".." are resolved before the decision. Thread-safe.
class FileAccess {
 public:
  /// Access to everything below `folder`; to nothing when it is empty.
  static std::shared_ptr<FileAccess> below(const std::filesystem::path& folder);
  /// Access to every file; relative paths start at `folder`, or at the current folder when it is empty.
  static std::shared_ptr<FileAccess> everywhere(const std::filesystem::path& folder = {});

  /// The target of the path: absolute, without links and dots as far as it exists.
  [[nodiscard]] std::filesystem::path resolved(const std::filesystem::path&) const;
  [[nodiscard]] bool permits(const std::filesystem::path&) const;
  void allow(const std::filesystem::path&);
  void refuse(const std::filesystem::path&);  ///< also below the folder

  /// The file to open for a path named by a document. @throws Error FileUnreadable when it may not be read.
  [[nodiscard]] std::filesystem::path opened(const std::filesystem::path&) const;

 private:
  FileAccess(std::filesystem::path folder, bool everything) : folder_(std::move(folder)), everything_(everything) {}
  std::filesystem::path folder_;  ///< resolved
  bool everything_;
  mutable std::mutex mutex_;
  std::set<std::filesystem::path> allowed_, refused_;  ///< resolved
};

}  // namespace blossom
