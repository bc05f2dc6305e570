#include "document/recovery_area.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>

#include "core/file.h"
#include "document/journal_files.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannotWrite(const fs::path& path) {
  throw Error(ErrorCode::FileUnwritable,
              fmt::format("The file {} cannot be written: {}.", path.string(), std::strerror(errno)),
              "Check that the disk is not full and that you may write there.");
}

/// An open file with a lock on it.
class LockFile {
 public:
  enum class Lock { Held, Taken, Unknown };  ///< held by us, by another, or the file system knows no locks
  LockFile(const fs::path& path, bool wait) : fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (fd_ < 0) cannotWrite(path);
    while (::flock(fd_, LOCK_EX | (wait ? 0 : LOCK_NB)) != 0) {
      if (errno == EINTR) continue;
      lock_ = errno == EWOULDBLOCK ? Lock::Taken : Lock::Unknown;
      return;
    }
    lock_ = Lock::Held;
  }
  ~LockFile() { ::close(fd_); }
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;
  [[nodiscard]] Lock lock() const { return lock_; }

 private:
  int fd_;
  Lock lock_ = Lock::Unknown;
};

/// Files of /proc have size 0, so readFile would find them empty.
std::string bootId() {
  std::string id;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
  return id;
}

std::string ownerText() { return fmt::format("{} {}", ::getpid(), bootId()); }

/// Tells by process id and boot id whether the process that wrote this still runs.
bool ownerRuns(const std::string& text) {
  const std::size_t blank = text.find(' ');
  if (blank == std::string::npos || text.substr(blank + 1) != bootId()) return false;
  const long pid = std::strtol(text.c_str(), nullptr, 10);
  return pid > 0 && (::kill(static_cast<pid_t>(pid), 0) == 0 || errno == EPERM);
}

fs::path ownerFile(const fs::path& run) { return run / "owner"; }

bool containsDocuments(const fs::path& run) {
  std::error_code ec;
  for (fs::directory_iterator it(run, ec), end; !ec && it != end; it.increment(ec))
    if (it->is_directory(ec) && !isRemoved(it->path())) return true;
  return false;
}

}  // namespace

struct RecoveryArea::State {
  explicit State(fs::path where) : root(std::move(where)) {}

  // Under the lock of the root, so that no process sees a folder before it is locked.
  void settleIn() {
    const LockFile all(root / "lock", true);
    std::string pattern = (root / "run-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) cannotWrite(pattern);
    own = pattern;
    ownLock = std::make_unique<LockFile>(ownerFile(own), false);
    AppendedFile owner;
    owner.open(ownerFile(own));
    owner.append(ownerText());
  }

  void claimStale() {
    const LockFile all(root / "lock", true);
    std::error_code ec;
    for (fs::directory_iterator it(root, ec), end; !ec && it != end; it.increment(ec)) {
      std::error_code unknown;
      if (!it->is_directory(unknown) || it->path() == own || claimed.contains(it->path())) continue;
      try {
        claim(it->path());
      } catch (const Error&) {
        // Of another user, or unreadable: it must not hide the documents of the others.
      }
    }
  }

  void claim(const fs::path& run) {
    auto lock = std::make_unique<LockFile>(ownerFile(run), false);
    if (lock->lock() == LockFile::Lock::Taken) return;
    if (lock->lock() == LockFile::Lock::Unknown && ownerRuns(readFile(ownerFile(run)))) return;
    std::error_code ignored;
    if (containsDocuments(run))
      claimed.emplace(run, std::move(lock));
    else
      fs::remove_all(run, ignored);
  }

  void tidy(const fs::path& run) {
    std::error_code ignored;
    if (!containsDocuments(run)) fs::remove_all(run, ignored);
  }

  std::mutex guard;
  fs::path root, own;
  std::unique_ptr<LockFile> ownLock;
  std::map<fs::path, std::unique_ptr<LockFile>> claimed;
  std::size_t folders = 0;
};

RecoveryArea::RecoveryArea(fs::path root) : state_(std::make_unique<State>(std::move(root))) {
  std::error_code ec;
  fs::create_directories(state_->root, ec);
  if (ec)
    throw Error(ErrorCode::FileUnwritable,
                fmt::format("The folder {} cannot be made: {}.", state_->root.string(), ec.message()),
                "Check that the disk is not full and that you may write there.");
  state_->settleIn();
}

RecoveryArea::~RecoveryArea() {
  for (const auto& [run, lock] : state_->claimed) state_->tidy(run);
  state_->tidy(state_->own);
}

fs::path RecoveryArea::newFolder() {
  const std::scoped_lock lock(state_->guard);
  return state_->own / fmt::format("document-{}", ++state_->folders);
}

std::vector<LostDocument> RecoveryArea::lost() {
  const std::scoped_lock lock(state_->guard);
  state_->claimStale();
  std::vector<LostDocument> found;
  for (const auto& [run, owner] : state_->claimed) {
    std::error_code ec;
    for (fs::directory_iterator it(run, ec), end; !ec && it != end; it.increment(ec)) {
      if (!it->is_directory(ec) || isRemoved(it->path())) continue;
      try {
        found.push_back({it->path(), summarised(it->path())});
      } catch (const Error&) {
        // Ended before anything was kept; what another version or a bad disk makes unreadable stays.
        if (journalGenerations(it->path()).empty()) removeAtOnce(it->path());
      }
    }
  }
  std::sort(found.begin(), found.end(),
            [](const LostDocument& a, const LostDocument& b) { return a.summary.milliseconds > b.summary.milliseconds; });
  return found;
}

void RecoveryArea::discard(const fs::path& folder) {
  const std::scoped_lock lock(state_->guard);
  removeAtOnce(folder);
  std::error_code ignored;
  const auto run = state_->claimed.find(folder.parent_path());
  if (run == state_->claimed.end() || containsDocuments(run->first)) return;
  fs::remove_all(run->first, ignored);
  state_->claimed.erase(run);
}

}  // namespace blossom
