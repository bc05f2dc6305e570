#pragma once
#include <filesystem>

/// Register of the temporary files and folders of this process, so that they are removed even when it ends without running
/// destructors.
namespace blossom {

/// Creates a folder under the system's temporary folder. It is locked until it is removed or the process ends.
/// @throws Error FileUnwritable.
std::filesystem::path makeTemporaryFolder();
void removeTemporaryFolder(const std::filesystem::path&) noexcept;

/// Registers a file that is being written beside its target.
void noteUnfinishedFile(const std::filesystem::path&);
void forgetUnfinishedFile(const std::filesystem::path&) noexcept;

/// Removes all registered files and folders; for a process that is about to end at once.
void removeTemporaries() noexcept;

/// Removes temporary folders left by processes that were killed or crashed, recognised by their free lock.
void removeAbandonedFolders() noexcept;

}  // namespace blossom
