#pragma once
#include <filesystem>
#include <fstream>

namespace blossom {

/// Closes a file that was written. @throws Error FileUnwritable when some of it did not arrive on the disk.
void finishBulkFile(std::ofstream&, const std::filesystem::path&);

/// @throws Error Internal: the other process wrote something else than this one reads.
[[noreturn]] void throwUnreadableShapes();

}  // namespace blossom
