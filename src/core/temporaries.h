#pragma once
#include <filesystem>

/// What a process has under way on the disk, so that it can be taken away at an end that runs no destructors.
namespace blossom {

/// A new folder under the system's temporary folder, locked until it is removed or the process ends.
/// @throws Error FileUnwritable.
std::filesystem::path makeTemporaryFolder();
void removeTemporaryFolder(const std::filesystem::path&) noexcept;

/// A file that is being written beside its target.
void noteUnfinishedFile(const std::filesystem::path&);
void forgetUnfinishedFile(const std::filesystem::path&) noexcept;

/// Removes all of the above; for a process that is about to end at once.
void removeTemporaries() noexcept;

/// Removes temporary folders of processes that ended without doing so (kill -9, a crash). Nobody holds their lock any more.
void removeAbandonedFolders() noexcept;

}  // namespace blossom
