#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/error.h"
#include "document/storage.h"

namespace blossom {

/// The document of a journal.
struct JournalOrigin {
  std::filesystem::path file;  ///< file it was last opened from or saved to; empty: none
  std::string name;            ///< name shown in titles
  friend bool operator==(const JournalOrigin&, const JournalOrigin&) = default;
};

/// Stores the unsaved steps of one document on disk, so that a crash loses nothing. Its folder contains a base (the whole
/// document), an append-only list of the steps since, each with a checksum, and the content of imported files by hash.
/// Writing runs on a thread of its own: every call but `settle` returns at once; a recorded step is passed to the system
/// within milliseconds and synced to the disk right after.
///
/// Whenever the process is killed, the folder contains the document of the last step that was completely written: a new base
/// is created by renaming, the previous one is removed afterwards, and a truncated end of the list is ignored.
class Journal {
 public:
  using Problem = std::function<void(const Error&)>;
  /// @param folder created when needed  @param problem called from the journal's thread when writing fails,
  /// once until it succeeds again
  explicit Journal(std::filesystem::path folder, Problem problem = {});
  /// Finishes pending work; the folder remains unless it was cleared.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Records a step that resulted in `document`. The first one becomes the base.
  void record(Document document, std::string what, JournalOrigin origin);
  /// Makes the last step the new base, so that the list stays short. Does nothing when there was no step since the last
  /// base.
  void snapshot();
  /// Removes the folder, because nothing is unsaved.
  void clear();
  /// Calls `then` from the journal's thread once all pending work is on the disk; not when it fails.
  void whenKept(std::function<void()> then);
  /// Waits until all pending work is on the disk; blocks.
  void settle();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Data of a journal that can be read without reading the document.
struct JournalSummary {
  JournalOrigin origin;
  std::string lastStep;           ///< "Change mode of Sweep"
  std::int64_t milliseconds = 0;  ///< time of the last step, since 1970
  std::size_t features = 0;
};

/// @throws Error FileNotFound when the folder contains no readable base.
JournalSummary summarised(const std::filesystem::path& folder);

/// The document of the last complete step; missing or damaged imported files become warnings.
/// @throws Error FileNotFound, FormatDamaged, FormatTooNew.
OpenedDocument recoverDocument(const std::filesystem::path& folder);

}  // namespace blossom
