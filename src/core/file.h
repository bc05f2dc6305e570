#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace blossom {

/// Largest file any reader takes into memory, in bytes.
inline constexpr std::uintmax_t largestFile = 2ull << 30;

/// Whole content of a regular file.
/// @throws Error FileNotFound, FileUnreadable (also for a folder), LimitExceeded.
std::string readFile(const std::filesystem::path&);

/// Lets `write` fill a temporary file beside `target`, syncs it to the disk and renames it over `target`: after a crash or
/// an exception the old file is still whole. The temporary file is removed when `write` throws.
/// @throws Error FileUnwritable; whatever `write` throws.
void writeAtomically(const std::filesystem::path& target,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for content at hand.
void writeAtomically(const std::filesystem::path& target, std::string_view content);

/// A new folder under the system's temporary folder, removed with all in it at the end of its life.
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
