#pragma once
#include <fstream>
#include <string>
#include <string_view>

#include "core/file.h"
#include "exchange/formats.h"
#include "support/support.h"

namespace blossom::test {

inline const FormatRegistry& formats() {
  static const FormatRegistry registry = standardFormats();
  return registry;
}

inline void writeText(const fs::path& path, std::string_view content) {
  std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

/// Reads content as if it stood in a file of that extension.
inline Imported readText(std::string_view content, const std::string& extension) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / ("file." + extension);
  writeText(path, content);
  return readShape(formats(), path);
}

/// Writes a shape and reads it back.
inline Imported roundTrip(const Shape& shape, const std::string& extension, const Value& options = Value::object()) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / ("file." + extension);
  writeShape(formats(), shape, path, options);
  return readShape(formats(), path);
}

}  // namespace blossom::test
