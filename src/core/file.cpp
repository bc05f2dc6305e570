#include "core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/error.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

void syncToDisk(const fs::path& path, int flags) {
  const int fd = ::open(path.c_str(), flags);
  if (fd < 0) return;  // a folder that may not be opened: the rename itself is still atomic
  ::fsync(fd);
  ::close(fd);
}

[[noreturn]] void cannotWrite(const fs::path& target, const std::string& why) {
  throw Error(ErrorCode::FileUnwritable, fmt::format("The file {} cannot be written: {}.", target.string(), why),
              "Check that the folder exists, that you may write there and that the disk is not full.");
}

/// Renaming over it would work all the same, but is not what its owner wants.
void refuseProtected(const fs::path& target) {
  std::error_code ec;
  const fs::perms mode = fs::status(target, ec).permissions();
  constexpr fs::perms anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (ec || !fs::exists(target, ec)) return;
  if ((mode & anyWrite) == fs::perms::none || ::access(target.c_str(), W_OK) != 0)
    throw Error(ErrorCode::FileUnwritable, fmt::format("The file {} is write-protected.", target.string()),
                "Save under another name, or allow writing to it.");
}

/// Beside the target (rename must not cross file systems), with its extension (some writers look at it).
fs::path temporaryBeside(const fs::path& target) {
  fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
  const std::string suffix = target.extension().string();
  std::string pattern = (folder / ("." + target.stem().string() + "-XXXXXX" + suffix)).string();
  const int fd = ::mkstemps(pattern.data(), static_cast<int>(suffix.size()));
  if (fd < 0) cannotWrite(target, std::strerror(errno));
  struct stat existing {};
  ::fchmod(fd, ::stat(target.c_str(), &existing) == 0 ? existing.st_mode & 07777 : 0644);
  ::close(fd);
  return pattern;
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
  if (!ec && size > largestFile)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The file {} has {} MB; the limit is {} MB.", path.string(), size >> 20, largestFile >> 20));
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
  if (fs::is_directory(target, ec)) cannotWrite(target, "it is a folder");
  refuseProtected(target);
  const fs::path temporary = temporaryBeside(target);
  try {
    write(temporary);
    syncToDisk(temporary, O_RDONLY);
    fs::rename(temporary, target, ec);
    if (ec) cannotWrite(target, ec.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  syncToDisk(target.parent_path().empty() ? fs::path(".") : target.parent_path(), O_RDONLY | O_DIRECTORY);
}

void writeAtomically(const fs::path& target, std::string_view content) {
  writeAtomically(target, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) cannotWrite(target, std::strerror(errno));
  });
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "blossom-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) cannotWrite(pattern, std::strerror(errno));
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace blossom
