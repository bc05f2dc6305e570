#include "manipulators/live_edit.h"

#include "core/error.h"
#include "kernel/edit/apply_edits.h"

namespace blossom::sweep {

namespace {

QString sentences(const std::string& what, const std::string& remedy) {
  return QString::fromStdString(remedy.empty() ? what : what + " " + remedy);
}

}  // namespace

void LiveEdit::show(const Motion& base, const MotionEdit& edit) {
  reason_.clear();
  try {
    const EditResult result = edited(base, edit);
    grid_.update(result.motion);
    if (result.obstacles.empty()) return;
    const Explanation reason = explain(result.obstacles.front());
    reason_ = sentences(reason.what, reason.remedy);
  } catch (const Error& error) {
    grid_.update(before_->motion());
    reason_ = sentences(error.message(), error.hint());
  }
}

}  // namespace blossom::sweep
