#include "core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/error.h"
#include "core/temporaries.h"

namespace blossom {
namespace fs = std::filesystem;

void cannotWrite(const fs::path& target, const std::string& why) {
  throw Error(ErrorCode::FileUnwritable, fmt::format("The file {} cannot be written: {}.", target.string(), why),
              "Check that the folder exists, that you may write there and that the disk is not full.");
}

namespace {

/// Renaming over it would work all the same, but is not what its owner wants.
void refuseProtected(const fs::path& target) {
  std::error_code ec;
  const fs::perms mode = fs::status(target, ec).permissions();
  constexpr fs::perms anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (ec || !fs::exists(target, ec)) return;
  if (!fs::is_regular_file(target, ec))
    cannotWrite(target, fs::is_directory(target, ec) ? "it is a folder" : "it is a device");
  if ((mode & anyWrite) == fs::perms::none || ::access(target.c_str(), W_OK) != 0)
    throw Error(ErrorCode::FileUnwritable, fmt::format("The file {} is write-protected.", target.string()),
                "Save under another name, or allow writing to it.");
}

/// A failing disk may report a write error only here.
void syncContent(const fs::path& temporary, const fs::path& target) {
  const int fd = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) cannotWrite(target, std::strerror(errno));
  const int why = ::fsync(fd) == 0 ? 0 : errno;
  ::close(fd);
  const bool unknownHere = why == EINVAL || why == ENOTSUP || why == ENOSYS;  // the file system has no such thing
  if (why != 0 && !unknownHere) cannotWrite(target, std::strerror(why));
}

/// The rename is atomic without it; this makes it last.
void syncFolder(const fs::path& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);
  ::close(fd);
}

fs::path folderOf(const fs::path& target) { return target.parent_path().empty() ? fs::path(".") : target.parent_path(); }

/// Names used only by Blossom, so that leftovers may be removed.
std::string temporaryPrefix(const fs::path& target) {
  constexpr std::size_t longest = 160;  // bytes; a name has at most 255
  return ".blossom-writing-" + target.stem().string().substr(0, longest) + "-";
}

/// Beside the target (rename must not cross file systems), with its extension (some writers look at it). Locked as long as
/// somebody writes it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    const std::string suffix = target.extension().string();
    std::string pattern = (folderOf(target) / (temporaryPrefix(target) + "XXXXXX" + suffix)).string();
    fd_ = ::mkostemps(pattern.data(), static_cast<int>(suffix.size()), O_CLOEXEC);
    if (fd_ < 0) cannotWrite(target, std::strerror(errno));
    path_ = pattern;
    noteUnfinishedFile(path_);
    struct stat existing {};
    ::fchmod(fd_, ::stat(target.c_str(), &existing) == 0 ? existing.st_mode & 07777 : 0644);
    ::flock(fd_, LOCK_EX | LOCK_NB);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!moved_) fs::remove(path_, ignored);
    forgetUnfinishedFile(path_);
    ::close(fd_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

  void moveTo(const fs::path& target) {
    std::error_code ec;
    fs::rename(path_, target, ec);
    if (ec) cannotWrite(target, ec.message());
    moved_ = true;
  }

 private:
  fs::path path_;
  int fd_ = -1;
  bool moved_ = false;
};

/// The user knows nothing of the temporary file that a writer complains of.
Error aboutTarget(const Error& error, const fs::path& temporary, const fs::path& target) {
  std::string message = error.message();
  for (std::size_t at; (at = message.find(temporary.string())) != std::string::npos;)
    message.replace(at, temporary.string().size(), target.string());
  return Error(error.code(), message, error.hint());
}

/// What writers of the same target left when they were killed.
void removeLeftovers(const fs::path& target) {
  const std::string prefix = temporaryPrefix(target);
  std::error_code ec;
  for (fs::directory_iterator it(folderOf(target), ec), end; !ec && it != end; it.increment(ec)) {
    const std::string name = it->path().filename().string();
    const std::string suffix = target.extension().string();
    const std::size_t length = prefix.size() + 6 + suffix.size();  // some writers make a ".XXXXXX" of their own beside it
    if (!name.starts_with(prefix) || (name.size() != length && name.size() != length + 7)) continue;
    if (name.compare(prefix.size() + 6, suffix.size(), suffix) != 0) continue;
    const int fd = ::open(it->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (fd < 0) continue;
    std::error_code ignored;
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0) fs::remove(it->path(), ignored);
    ::close(fd);
  }
}

}  // namespace

std::string readFile(const fs::path& path) {
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (!fs::exists(status))
    throw Error(ErrorCode::FileNotFound, fmt::format("The file {} does not exist.", path.string()),
                "Check the name and the folder.");
  if (!fs::is_regular_file(status))
    throw Error(ErrorCode::FileUnreadable, fmt::format("{} is not a file.", path.string()),
                "Give a file, not a folder or a device.");
  const auto size = fs::file_size(path, ec);
  if (!ec && size > maximumFileSize)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The file {} has {} MB; the limit is {} MB.", path.string(), size >> 20, maximumFileSize >> 20));
  std::ifstream in(path, std::ios::binary);
  std::string content(static_cast<std::size_t>(ec ? 0 : size), '\0');
  if (!in || !in.read(content.data(), static_cast<std::streamsize>(content.size())))
    throw Error(ErrorCode::FileUnreadable,
                fmt::format("The file {} cannot be read: {}.", path.string(), std::strerror(errno)));
  return content;
}

void writeAtomically(const fs::path& given, const std::function<void(const fs::path&)>& write) {
  std::error_code ec;
  // A link stays a link: what it points to is replaced.
  const fs::path resolved = fs::is_symlink(given, ec) ? fs::weakly_canonical(given, ec) : given;
  const fs::path& target = resolved.empty() ? given : resolved;
  refuseProtected(target);
  TemporaryFile temporary(target);
  try {
    write(temporary.path());
  } catch (const Error& error) {
    throw aboutTarget(error, temporary.path(), target);
  }
  syncContent(temporary.path(), target);
  temporary.moveTo(target);
  syncFolder(folderOf(target));
  removeLeftovers(target);
}

void writeAtomically(const fs::path& target, std::string_view content) {
  writeAtomically(target, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) cannotWrite(target, std::strerror(errno));
  });
}

TemporaryFolder::TemporaryFolder() : path_(makeTemporaryFolder()) {}

TemporaryFolder::~TemporaryFolder() { removeTemporaryFolder(path_); }

}  // namespace blossom
