#pragma once
#include <QObject>
#include <memory>
#include <vector>

#include "document/recovery_area.h"
#include "ui/session/job.h"

namespace blossom::ui {

/// The safety copies of unsaved documents, and what an earlier run left of its own. One per application; does nothing until
/// it is started.
class Recovery : public QObject {
  Q_OBJECT
 public:
  static Recovery& instance();

  /// Starts to keep new steps. Looks for lost documents on a thread of its own and then emits `changed`; looks again in the
  /// next seconds, for a process that was killed takes a while to end.
  /// @throws Error FileUnwritable.
  void start(const std::filesystem::path& folder = standardFolder());
  void stop();  ///< as at the end of the program
  static std::filesystem::path standardFolder();

  /// nullptr when there is nothing to keep copies in, or the user does not want any.
  [[nodiscard]] std::unique_ptr<Journal> newJournal(Journal::Problem) const;
  [[nodiscard]] const std::vector<LostDocument>& lost() const { return lost_; }  ///< latest first
  /// Nobody wants it any more. Safe to call from any thread.
  void discard(const std::filesystem::path& folder);

 signals:
  void changed();

 private:
  Recovery() = default;
  void look(const std::shared_ptr<RecoveryArea>&, std::size_t time);
  std::shared_ptr<RecoveryArea> area_;
  std::vector<LostDocument> lost_;
  Job look_;
};

}  // namespace blossom::ui
