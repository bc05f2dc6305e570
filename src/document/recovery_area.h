#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "document/journal.h"

namespace blossom {

/// A document that a process left behind when it ended without closing it.
struct LostDocument {
  std::filesystem::path folder;  ///< of its journal
  JournalSummary summary;
};

/// The folder where journals live. Every process has a folder of its own in it, locked as long as the process lives (the
/// system drops the lock when the process dies, however it dies); on file systems without locks, process id and boot id tell
/// whether it still runs. Journals of dead processes are lost documents; the first process that looks claims them.
/// Thread-safe.
class RecoveryArea {
 public:
  /// @throws Error FileUnwritable.
  explicit RecoveryArea(std::filesystem::path root);
  /// Removes the folders that hold no document any more.
  ~RecoveryArea();
  RecoveryArea(const RecoveryArea&) = delete;
  RecoveryArea& operator=(const RecoveryArea&) = delete;

  /// For the journal of one more document; does not exist yet.
  [[nodiscard]] std::filesystem::path newFolder();
  /// Latest first. Those claimed once are told again until they are discarded.
  [[nodiscard]] std::vector<LostDocument> lost();
  /// Removes what is left of it: nobody wants it, or it lives on in a journal of this process.
  void discard(const std::filesystem::path& folder);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace blossom
