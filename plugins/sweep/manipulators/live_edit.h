#pragma once
#include <QString>

#include "geometry/shape/motion_edit.h"
#include "manipulators/live_surface.h"

namespace blossom::sweep {

/// The surface during a drag. Every movement starts from a motion as it was when the mouse went down, so that nothing drifts
/// and the way back ends where it began.
class LiveEdit {
 public:
  explicit LiveEdit(std::shared_ptr<const LiveSurface> before) : before_(std::move(before)), grid_(before_->grid) {}

  /// Applies an edit to `base`: the motion before the drag, or before the edit that the drag changes. What can be done of an
  /// edit that does not arrive is done. O(poles + changed places).
  void show(const Motion& base, const MotionEdit&);

  [[nodiscard]] const MotionGrid& grid() const { return grid_.grid(); }
  [[nodiscard]] const MotionGrid& gridBefore() const { return before_->grid.grid(); }
  [[nodiscard]] const Motion& motion() const { return grid_.motion(); }
  [[nodiscard]] bool arrived() const { return reason_.isEmpty(); }
  /// Why the edit does not arrive, in the words of the kernel.
  [[nodiscard]] const QString& reason() const { return reason_; }

 private:
  std::shared_ptr<const LiveSurface> before_;
  LiveGrid grid_;
  QString reason_;
};

}  // namespace blossom::sweep
