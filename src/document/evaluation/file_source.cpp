#include "document/evaluation/file_source.h"

#include <fmt/format.h>

#include "core/error.h"
#include "document/file_access.h"
#include "document/storage.h"

namespace blossom {
namespace fs = std::filesystem;

FileSource::Opened FileSource::open(const Value& file, const Document& document) {
  const fs::path path = file.value("path", "");
  const std::string asset = file.value("asset", "");
  if (const auto kept = document.assets().find(asset); !asset.empty() && kept != document.assets().end())
    return {materialised(asset, *kept->second, path.filename()), asset};
  const fs::path place = document.access() ? document.access()->opened(path) : path;
  if (!asset.empty() && !fs::exists(place))
    throw Error(ErrorCode::FileNotFound,
                fmt::format("The content of {} is missing in the document.", path.filename().string()),
                "Import the file again.");
  return {place, hashOf(place)};
}

fs::path FileSource::materialised(const std::string& hash, const std::string& content, const fs::path& name) {
  const bool usable = name.has_filename() && name != "." && name != "..";
  const std::string fileName = usable ? name.string() : "file";
  const std::lock_guard lock(mutex_);
  fs::path& path = written_[{hash, fileName}];
  if (!path.empty()) return path;
  if (!folder_) folder_ = std::make_unique<TemporaryFolder>();
  const fs::path folder = folder_->path() / std::to_string(written_.size());
  fs::create_directories(folder);
  writeAtomically(folder / fileName, content);
  return path = folder / fileName;
}

/// Reads the file only when its size or time differ from the last visit.
std::string FileSource::hashOf(const fs::path& path) {
  std::error_code ignored;
  Stamp stamp{fs::file_size(path, ignored), fs::last_write_time(path, ignored), {}};
  {
    const std::lock_guard lock(mutex_);
    const auto known = hashed_.find(path);
    if (known != hashed_.end() && known->second.size == stamp.size && known->second.time == stamp.time)
      return known->second.hash;
  }
  stamp.hash = contentHash(readFile(path));
  const std::lock_guard lock(mutex_);
  return (hashed_[path] = std::move(stamp)).hash;
}

}  // namespace blossom
