#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace blossom {

/// Size limit, in bytes, of a file that is read into memory.
inline constexpr std::uintmax_t maximumFileSize = 2ull << 30;

/// Returns the whole content of a regular file.
/// @throws Error FileNotFound, FileUnreadable (also for a folder), LimitExceeded.
std::string readFile(const std::filesystem::path&);

/// @throws Error FileUnwritable, with the reason `why` (no full stop) and what to check.
[[noreturn]] void cannotWrite(const std::filesystem::path& target, const std::string& why);

/// Calls `write` with a temporary file beside `target`, syncs that file to the disk and renames it to `target`: after a
/// crash or an exception the old file is intact. The temporary file is removed when `write` throws.
/// @throws Error FileUnwritable; whatever `write` throws.
void writeAtomically(const std::filesystem::path& target,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// Writes `content` in the same way.
void writeAtomically(const std::filesystem::path& target, std::string_view content);

/// A new folder under the system's temporary folder; the destructor removes it with its content.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace blossom
