#include "document/file_access.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

fs::path withoutLinks(const fs::path& path) {
  std::error_code ec;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, ec), ec);
  return ec ? fs::absolute(path).lexically_normal() : whole;
}

bool liesBelow(const fs::path& folder, const fs::path& path) {
  const auto [end, same] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end() && same != path.end();
}

}  // namespace

std::shared_ptr<FileAccess> FileAccess::below(const fs::path& folder) {
  return std::shared_ptr<FileAccess>(new FileAccess(folder.empty() ? fs::path() : withoutLinks(folder), false));
}

std::shared_ptr<FileAccess> FileAccess::everywhere(const fs::path& folder) {
  return std::shared_ptr<FileAccess>(new FileAccess(folder.empty() ? fs::path() : withoutLinks(folder), true));
}

fs::path FileAccess::resolved(const fs::path& path) const { return withoutLinks(folder_ / path); }

bool FileAccess::permits(const fs::path& path) const {
  const fs::path file = resolved(path);
  const std::lock_guard lock(mutex_);
  if (allowed_.contains(file)) return true;
  if (refused_.contains(file)) return false;
  return everything_ || (!folder_.empty() && liesBelow(folder_, file));
}

void FileAccess::allow(const fs::path& path) {
  const fs::path file = resolved(path);
  const std::lock_guard lock(mutex_);
  allowed_.insert(file);
}

void FileAccess::refuse(const fs::path& path) {
  const fs::path file = resolved(path);
  const std::lock_guard lock(mutex_);
  refused_.insert(file);
}

fs::path FileAccess::opened(const fs::path& path) const {
  const fs::path file = resolved(path);
  if (permits(file)) return file;
  const std::string place = folder_.empty() ? "" : fmt::format(" ({})", folder_.string());
  throw Error(
      ErrorCode::FileUnreadable,
      fmt::format("The document names the file {}, which lies outside the document's folder{}; it was not read.",
                  file.string(), place),
      "If you trust the document, allow it to read that file: in the window with the button in the bar above the view, on "
      "the command line with --allow-files. Or copy the file into the document's folder.");
}

}  // namespace blossom
