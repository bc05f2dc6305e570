#include "document/journal_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>

#include "core/error.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view basePrefix = "base-";
constexpr std::string_view removedSuffix = ".removed";

}  // namespace

fs::path journalBase(const fs::path& folder, std::size_t generation) {
  return folder / fmt::format("{}{}", basePrefix, generation);
}
fs::path journalSteps(const fs::path& folder, std::size_t generation) {
  return folder / fmt::format("steps-{}", generation);
}
fs::path journalAssets(const fs::path& folder) { return folder / "assets"; }

std::vector<std::size_t> journalGenerations(const fs::path& folder) {
  std::vector<std::size_t> found;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(basePrefix)) continue;
    std::size_t generation = 0;
    const char* const last = name.data() + name.size();
    const auto read = std::from_chars(name.data() + basePrefix.size(), last, generation);
    if (read.ec == std::errc() && read.ptr == last) found.push_back(generation);
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

void removeAtOnce(const fs::path& folder) {
  std::error_code ec;
  fs::path removed = folder;
  removed += removedSuffix;
  fs::remove_all(removed, ec);
  fs::rename(folder, removed, ec);
  if (!ec) fs::remove_all(removed, ec);
}

bool isRemoved(const fs::path& folder) { return folder.extension().string() == removedSuffix; }

void AppendedFile::fail() const {
  throw Error(ErrorCode::FileUnwritable,
              fmt::format("The file {} cannot be written: {}.", path_.string(), std::strerror(errno)),
              "Check that the disk is not full and that you may write there.");
}

void AppendedFile::open(const fs::path& path) {
  close();
  path_ = path;
  fd_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (fd_ < 0) fail();
}

void AppendedFile::append(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AppendedFile::sync() {
  if (::fdatasync(fd_) != 0) fail();
}

void AppendedFile::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

}  // namespace blossom
