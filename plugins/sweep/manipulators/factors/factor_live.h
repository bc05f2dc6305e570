#pragma once
#include <QString>

#include "kernel/edit/factor_changes.h"
#include "manipulators/live_mesh.h"
#include "manipulators/live_surface.h"

namespace blossom::sweep {

/// The surface while poles are changed. Every movement starts from the motion as it was, so that nothing drifts.
class FactorLive {
 public:
  /// @param capped the ends are drawn closed
  FactorLive(std::shared_ptr<const LiveSurface> before, bool capped);

  /// O(poles + changed places), and the proof that the orientation does not vanish when it changes.
  void show(const FactorChanges&);

  [[nodiscard]] const FactorChanges& changes() const { return changes_; }
  [[nodiscard]] const LiveMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Motion& motion() const { return grid_.motion(); }
  [[nodiscard]] bool possible() const { return reason_.isEmpty(); }
  /// Why the changes cannot be made, in the words of the kernel.
  [[nodiscard]] const QString& reason() const { return reason_; }

 private:
  std::shared_ptr<const LiveSurface> before_;
  LiveGrid grid_;
  LiveMesh mesh_;
  FactorChanges changes_;
  QString reason_;
};

}  // namespace blossom::sweep
