#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace blossom {

/// Closes a file that was written. @throws Error FileUnwritable when some of it did not arrive on the disk.
void finishBulkFile(std::ofstream&, const std::filesystem::path&);

/// @throws Error Internal: the other process wrote something else than this one reads.
[[noreturn]] void throwUnreadableShapes();

/// An array of numbers as it lies in memory: both sides are one build on one machine.
template <class T>
void writeArray(std::ofstream& stream, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  stream.write(reinterpret_cast<const char*>(&count), sizeof count);
  stream.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

/// From the place of reading to the end of the file.
inline std::uint64_t bytesLeft(std::ifstream& stream) {
  const auto here = stream.tellg();
  stream.seekg(0, std::ios::end);
  const auto end = stream.tellg();
  stream.seekg(here);
  return here < 0 || end < here ? 0 : static_cast<std::uint64_t>(end - here);
}

/// @throws Error Internal.
template <class T>
std::vector<T> readArray(std::ifstream& stream) {
  std::uint64_t count = 0;
  stream.read(reinterpret_cast<char*>(&count), sizeof count);
  if (!stream || count > bytesLeft(stream) / sizeof(T)) throwUnreadableShapes();
  std::vector<T> values(count);
  stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  if (!stream) throwUnreadableShapes();
  return values;
}

}  // namespace blossom
