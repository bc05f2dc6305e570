#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"

namespace blossom {

/// One file inside a zip.
struct ZipEntry {
  std::string name;
  std::string_view content;  ///< must live until writeZip returns
  bool stored = false;       ///< not compressed
};

/// Writes a zip whose bytes depend only on the entries. @throws Error FileUnwritable, Cancelled.
void writeZip(const std::filesystem::path&, const std::vector<ZipEntry>&, const Progress&);

struct ZipContent {
  std::map<std::string, std::string> entries;
  std::vector<std::string> damaged;  ///< one sentence for each entry that could not be read
};

/// Limits in bytes of the unpacked size, of one entry and of all together, so that a small file cannot fill the memory.
struct ZipLimits {
  std::uint64_t entry = 1ull << 30;
  std::uint64_t total = 2ull << 30;
};

/// Reads the entries whose names `wanted` accepts. Damaged entries are left out and reported in `damaged`.
/// @throws Error FormatDamaged when it is no zip or its central directory is missing; LimitExceeded.
ZipContent readZip(const std::string& bytes, const std::function<bool(std::string_view name)>& wanted,
                   const ZipLimits& = {});

/// The same from the headers in front of the entries, for a zip whose directory at the end is lost. Of the last entry the
/// part that is there is returned. Hand-written because libzip opens nothing without its directory. @throws Error
/// LimitExceeded.
ZipContent salvageZip(const std::string& bytes, const std::function<bool(std::string_view name)>& wanted,
                      const ZipLimits& = {});

}  // namespace blossom
