#pragma once
#include <QString>

#include "kernel/edit/factor_changes.h"
#include "manipulators/live_surface.h"

namespace blossom::sweep {

/// The surface while poles are changed. Every movement starts from the motion as it was, so that nothing drifts.
class FactorLive {
 public:
  explicit FactorLive(std::shared_ptr<const LiveSurface> before) : before_(std::move(before)), grid_(before_->grid) {}

  /// O(poles + changed places), and the proof that the orientation does not vanish when it changes.
  void show(const FactorChanges&);

  [[nodiscard]] const FactorChanges& changes() const { return changes_; }
  [[nodiscard]] const MotionGrid& grid() const { return grid_.grid(); }
  [[nodiscard]] const MotionGrid& gridBefore() const { return before_->grid.grid(); }
  [[nodiscard]] const Motion& motion() const { return grid_.motion(); }
  [[nodiscard]] bool possible() const { return reason_.isEmpty(); }
  /// Why the changes cannot be made, in the words of the kernel.
  [[nodiscard]] const QString& reason() const { return reason_; }

 private:
  std::shared_ptr<const LiveSurface> before_;
  LiveGrid grid_;
  FactorChanges changes_;
  QString reason_;
};

}  // namespace blossom::sweep
