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

/// Writes a zip whose bytes depend on the entries alone. @throws Error FileUnwritable, Cancelled.
void writeZip(const std::filesystem::path&, const std::vector<ZipEntry>&, const Progress&);

struct ZipContent {
  std::map<std::string, std::string> entries;
  std::vector<std::string> damaged;  ///< sentences on what could not be read
};

/// Entries larger than this, or more of all in sum, are not unpacked: a small file must not fill the memory.
struct ZipLimits {
  std::uint64_t entry = 1ull << 30;
  std::uint64_t total = 2ull << 30;
};

/// The entries whose names `wanted` takes. A damaged entry is left out and told of.
/// @throws Error FormatDamaged when it is no zip or has lost its directory; LimitExceeded.
ZipContent readZip(const std::string& bytes, const std::function<bool(std::string_view name)>& wanted,
                   const ZipLimits& = {});

/// The same from the headers in front of the entries, for a zip whose directory at the end is lost. Of the last entry the
/// part that is there is returned. Hand-written because libzip opens nothing without its directory. @throws Error
/// LimitExceeded.
ZipContent salvageZip(const std::string& bytes, const std::function<bool(std::string_view name)>& wanted,
                      const ZipLimits& = {});

}  // namespace blossom
