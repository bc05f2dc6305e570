#pragma once
#include <QString>

#include "geometry/shape/motion_edit.h"
#include "kernel/edit/edit_result.h"
#include "manipulators/live_mesh.h"
#include "manipulators/live_surface.h"

namespace blossom::sweep {

/// The surface during a drag. Every movement starts from a motion as it was when the mouse went down, so that nothing drifts
/// and the way back ends where it began.
class LiveEdit {
 public:
  /// @param capped the ends are drawn closed
  LiveEdit(std::shared_ptr<const LiveSurface> before, bool capped);

  /// Applies an edit to `base`: the motion before the drag, or before the edit that the drag changes. What can be done of an
  /// edit that does not arrive is done. O(poles + changed places).
  void show(const Motion& base, const MotionEdit&);

  [[nodiscard]] const LiveMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Motion& motion() const { return grid_.motion(); }
  [[nodiscard]] bool arrived() const { return reason_.isEmpty(); }
  /// It does not arrive, but comes as near as all of its places can together.
  [[nodiscard]] bool nearest() const { return nearest_; }
  [[nodiscard]] double remainder() const { return remainder_; }  ///< mm or degrees, of the place that is left farthest
  [[nodiscard]] double swing() const { return swing_; }          ///< of an EditResult
  /// Why the edit does not arrive, in the words of the kernel.
  [[nodiscard]] const QString& reason() const { return reason_; }

 private:
  void judge(const EditResult&);

  std::shared_ptr<const LiveSurface> before_;
  LiveGrid grid_;
  LiveMesh mesh_;
  QString reason_;
  bool nearest_ = false;
  double remainder_ = 0, swing_ = 0;
};

}  // namespace blossom::sweep
