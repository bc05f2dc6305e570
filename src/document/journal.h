#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/error.h"
#include "document/storage.h"

namespace blossom {

/// Which document a journal keeps.
struct JournalOrigin {
  std::filesystem::path file;  ///< where it was last opened from or saved to; empty: nowhere
  std::string name;            ///< as a title shows it
  friend bool operator==(const JournalOrigin&, const JournalOrigin&) = default;
};

/// Keeps the unsaved steps of one document on the disk, so that a crash loses nothing. Its folder holds a base (the whole
/// document), an append-only list of the steps since, each with a checksum, and the content of imported files once by hash.
/// Writing happens on a thread of its own: every call but `settle` returns at once, and what was recorded is handed to the
/// system within milliseconds and synced to the disk right after.
///
/// At any point of a kill the folder holds the document as of the last step that was written whole: a new base comes into
/// being by renaming, its predecessor goes only then, and of the list of steps a torn end is dropped.
class Journal {
 public:
  using Problem = std::function<void(const Error&)>;
  /// @param folder made when there is something to keep  @param problem called from the journal's thread when nothing can be
  /// written, once until it works again
  explicit Journal(std::filesystem::path folder, Problem problem = {});
  /// Finishes what was asked for; the folder stays unless it was cleared.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// A step was made: `document` is what the user has now. The first one becomes the base.
  void record(Document document, std::string what, JournalOrigin origin);
  /// The last step becomes the base, so that the list stays short. Nothing to do when there was no step since.
  void snapshot();
  /// Nothing is unsaved any more: the folder goes.
  void clear();
  /// Calls `then` from the journal's thread once everything asked for so far is on the disk; never when that fails.
  void whenKept(std::function<void()> then);
  /// Waits until everything asked for so far is on the disk. Not for a thread that must not wait.
  void settle();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What a journal tells without reading the document.
struct JournalSummary {
  JournalOrigin origin;
  std::string lastStep;           ///< "Change mode of Sweep"
  std::int64_t milliseconds = 0;  ///< when it was made, since 1970
  std::size_t features = 0;
};

/// @throws Error FileNotFound when the folder holds no base that can be read.
JournalSummary summarised(const std::filesystem::path& folder);

/// The document as of the last step that is whole; imported files that are missing or damaged become warnings.
/// @throws Error FileNotFound, FormatDamaged, FormatTooNew.
OpenedDocument recoverDocument(const std::filesystem::path& folder);

}  // namespace blossom
