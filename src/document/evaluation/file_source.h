#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/file.h"
#include "document/document.h"

namespace blossom {

/// Provides the content of file parameters during evaluation. Content stored in the document is written once to a temporary
/// folder under the name of the original file, because readers depend on the extension. Thread-safe.
class FileSource {
 public:
  struct Opened {
    std::filesystem::path path;  ///< a readable file
    std::string hash;            ///< of the content
  };
  /// @param file canonical file value {"path", "asset"}; a path is opened when the access of the document permits it
  /// @throws Error FileNotFound, FileUnreadable, FileUnwritable.
  Opened open(const Value& file, const Document&);

 private:
  struct Stamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
    std::string hash;
  };
  std::filesystem::path materialised(const std::string& hash, const std::string& content, const std::filesystem::path& name);
  std::string hashOf(const std::filesystem::path&);

  std::mutex mutex_;
  std::unique_ptr<TemporaryFolder> folder_;
  std::map<std::pair<std::string, std::string>, std::filesystem::path> written_;  ///< by hash and file name
  std::map<std::filesystem::path, Stamp> hashed_;
};

}  // namespace blossom
