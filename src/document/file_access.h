#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>

namespace blossom {

/// Which files a document may read, and where its relative paths begin. A document that somebody else wrote names whatever
/// its author liked: unasked it reads nothing but what lies below its own folder. What the user allows is no part of the
/// document and holds for all its versions. Symbolic links and ".." are resolved before anything is decided. Thread-safe.
class FileAccess {
 public:
  /// Everything that lies below `folder`; with an empty one nothing.
  static std::shared_ptr<FileAccess> below(const std::filesystem::path& folder);
  /// Every file there is; relative paths begin at `folder`, or, with an empty one, at the current folder.
  static std::shared_ptr<FileAccess> everywhere(const std::filesystem::path& folder = {});

  /// Where the path leads: absolute, without links and dots as far as it exists.
  [[nodiscard]] std::filesystem::path resolved(const std::filesystem::path&) const;
  [[nodiscard]] bool permits(const std::filesystem::path&) const;
  void allow(const std::filesystem::path&);
  void refuse(const std::filesystem::path&);  ///< also below the folder

  /// The file to be opened for a path that a document names. @throws Error FileUnreadable when it may not be read.
  [[nodiscard]] std::filesystem::path opened(const std::filesystem::path&) const;

 private:
  FileAccess(std::filesystem::path folder, bool everything) : folder_(std::move(folder)), everything_(everything) {}
  std::filesystem::path folder_;  ///< resolved
  bool everything_;
  mutable std::mutex mutex_;
  std::set<std::filesystem::path> allowed_, refused_;  ///< resolved
};

}  // namespace blossom
