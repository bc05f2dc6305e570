#include "core/temporaries.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "core/error.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view folderPrefix = "blossom-temporary-";
constexpr std::size_t randomLength = 6;  // what mkdtemp puts behind it

struct Temporaries {
  std::mutex mutex;
  std::map<fs::path, int> locks;  ///< of folders, by path
  std::set<fs::path> files;
};

/// Never destroyed: threads may still be at work while the process ends.
Temporaries& temporaries() {
  static auto& all = *new Temporaries;
  return all;
}

[[noreturn]] void noFolder(const fs::path& parent, const std::string& why) {
  throw Error(ErrorCode::FileUnwritable, fmt::format("No temporary folder can be made in {}: {}.", parent.string(), why),
              "Set TMPDIR to a folder that exists and that you may write to.");
}

fs::path parentFolder() {
  const char* named = std::getenv("TMPDIR");
  fs::path parent = named && *named ? named : "/tmp";
  std::error_code ec;
  if (!fs::is_directory(parent, ec)) noFolder(parent, fs::exists(parent, ec) ? "it is not a folder" : "it does not exist");
  return parent;
}

/// @returns -1 when another process holds the lock, or has removed the folder in the meantime
int lockedFolder(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (fd < 0) return -1;
  struct stat held {
  }, there{};
  const bool ours = ::flock(fd, LOCK_EX | LOCK_NB) == 0 && ::fstat(fd, &held) == 0 && ::lstat(path.c_str(), &there) == 0 &&
                    held.st_ino == there.st_ino && held.st_dev == there.st_dev;
  if (ours) return fd;
  ::close(fd);
  return -1;
}

void removeAll(const fs::path& path) noexcept {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

/// Created by mkdtemp, for this user.
bool looksLikeOurs(const fs::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with(folderPrefix) || name.size() != folderPrefix.size() + randomLength) return false;
  const std::string_view random = std::string_view(name).substr(folderPrefix.size());
  const bool alphanumeric = std::all_of(random.begin(), random.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
  struct stat about {};
  return alphanumeric && ::lstat(path.c_str(), &about) == 0 && S_ISDIR(about.st_mode) && about.st_uid == ::geteuid() &&
         (about.st_mode & 07777) == 0700;
}

}  // namespace

fs::path makeTemporaryFolder() {
  const fs::path parent = parentFolder();
  constexpr int maximumAttempts = 3;
  for (int attempt = 1;; ++attempt) {
    std::string pattern = (parent / fmt::format("{}XXXXXX", folderPrefix)).string();
    if (!::mkdtemp(pattern.data())) noFolder(parent, std::strerror(errno));
    const int fd = lockedFolder(pattern);
    // Some file systems have no locks; other processes cannot lock the folder there either, so it is not removed.
    if (fd < 0 && attempt < maximumAttempts) {
      removeAll(pattern);
      continue;
    }
    Temporaries& all = temporaries();
    const std::lock_guard lock(all.mutex);
    all.locks.emplace(pattern, fd);
    return pattern;
  }
}

void removeTemporaryFolder(const fs::path& path) noexcept {
  removeAll(path);
  Temporaries& all = temporaries();
  const std::lock_guard lock(all.mutex);
  const auto found = all.locks.find(path);
  if (found == all.locks.end()) return;
  if (found->second >= 0) ::close(found->second);
  all.locks.erase(found);
}

void noteUnfinishedFile(const fs::path& path) {
  Temporaries& all = temporaries();
  const std::lock_guard lock(all.mutex);
  all.files.insert(path);
}

void forgetUnfinishedFile(const fs::path& path) noexcept {
  Temporaries& all = temporaries();
  const std::lock_guard lock(all.mutex);
  all.files.erase(path);
}

void removeTemporaries() noexcept {
  Temporaries& all = temporaries();
  const std::lock_guard lock(all.mutex);
  for (const auto& [path, fd] : all.locks) removeAll(path);
  for (const fs::path& path : all.files) removeAll(path);
}

void removeAbandonedFolders() noexcept {
  try {
    std::error_code ec;
    for (fs::directory_iterator it(parentFolder(), ec), end; !ec && it != end; it.increment(ec)) {
      if (!looksLikeOurs(it->path())) continue;
      const int fd = lockedFolder(it->path());
      if (fd < 0) continue;
      removeAll(it->path());
      ::close(fd);
    }
  } catch (const std::exception&) {
    // Errors are ignored: the next code that needs a temporary folder will report them.
  }
}

}  // namespace blossom
