#include "manipulators/live_edit.h"

#include <algorithm>

#include "core/error.h"
#include "kernel/edit/apply_edits.h"
#include "ui/look/text.h"

namespace blossom::sweep {

namespace {

/// What least squares leave of it is as little as can be.
bool isShared(const Obstacle& obstacle) {
  return obstacle.why == Unreached::TooClose || obstacle.why == Unreached::Pinned || obstacle.why == Unreached::TwoTargets;
}

}  // namespace

LiveEdit::LiveEdit(std::shared_ptr<const LiveSurface> before, bool capped)
    : before_(std::move(before)), grid_(before_->grid), mesh_(grid_.grid(), liveForm(grid_.motion(), capped)) {}

void LiveEdit::show(const Motion& base, const MotionEdit& edit) {
  reason_.clear();
  nearest_ = false;
  remainder_ = swing_ = 0;
  try {
    const EditResult result = edited(base, edit);
    mesh_.update(grid_.grid(), grid_.update(result.motion));
    judge(result);
  } catch (const Error& error) {
    mesh_.update(grid_.grid(), grid_.update(before_->motion()));
    reason_ = ui::saidInFull(error);
  }
}

void LiveEdit::judge(const EditResult& result) {
  swing_ = result.swing;
  if (result.obstacles.empty()) return;
  const Explanation reason = explain(result.obstacles.front());
  reason_ = ui::saidInFull(reason.what, reason.remedy);
  nearest_ = result.movedPoles > 0 && std::all_of(result.obstacles.begin(), result.obstacles.end(), isShared);
  remainder_ = result.remainder;
}

}  // namespace blossom::sweep
