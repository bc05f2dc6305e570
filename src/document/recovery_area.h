#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "document/journal.h"

namespace blossom {

/// A document left by a process that ended without closing it.
struct LostDocument {
  std::filesystem::path folder;  ///< of its journal
  JournalSummary summary;
};

/// The folder of all journals. Every process has its own subfolder, locked as long as the process lives (the system releases
/// the lock however the process ends); on file systems without locks, process id and boot id show whether it still runs.
/// Journals of dead processes are lost documents, claimed by the first process that calls `lost`. Thread-safe.
class RecoveryArea {
 public:
  /// @throws Error FileUnwritable.
  explicit RecoveryArea(std::filesystem::path root);
  /// Removes folders without documents.
  ~RecoveryArea();
  RecoveryArea(const RecoveryArea&) = delete;
  RecoveryArea& operator=(const RecoveryArea&) = delete;

  /// A folder for the journal of another document; not created yet.
  [[nodiscard]] std::filesystem::path newFolder();
  /// Lost documents, latest first. Claimed ones are returned again until they are discarded.
  [[nodiscard]] std::vector<LostDocument> lost();
  /// Removes the journal of a lost document that was discarded or recovered.
  void discard(const std::filesystem::path& folder);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace blossom
