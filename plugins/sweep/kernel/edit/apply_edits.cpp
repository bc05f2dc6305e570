#include "kernel/edit/apply_edits.h"

#include <fmt/format.h>

#include "core/error.h"
#include "kernel/edit/pull.h"
#include "kernel/edit/twist.h"

namespace blossom::sweep {

namespace {

struct Edited {
  const Motion& motion;
  const Progress& progress;
  EditResult operator()(const MotionPull& edit) const { return pull(motion, edit, progress); }
  EditResult operator()(const MotionTwist& edit) const { return twist(motion, edit, progress); }
};

Motion afterEdit(const Motion& motion, std::size_t index, const MotionEdit& edit, const Progress& progress) {
  EditResult result;
  try {
    result = edited(motion, edit, progress);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) throw;
    throw Error(ErrorCode::InvalidInput, fmt::format("edits[{}] cannot be applied. {}", index, error.message()),
                error.hint().empty() ? "The manual page \"Sweep\" describes the edits of a motion file." : error.hint());
  }
  if (result.obstacles.empty()) return std::move(result.motion);
  const Explanation reason = explain(result.obstacles.front());
  throw Error(ErrorCode::InvalidInput,
              fmt::format("edits[{}] cannot be reached: {:.4g} {} are left. {}", index, result.remainder,
                          std::holds_alternative<MotionPull>(edit) ? "mm" : "degrees", reason.what),
              reason.remedy);
}

}  // namespace

EditResult edited(const Motion& motion, const MotionEdit& edit, const Progress& progress) {
  return std::visit(Edited{motion, progress}, edit);
}

Motion withEditsApplied(const Motion& given, const Progress& progress) {
  Motion motion = given;
  motion.edits.clear();
  for (std::size_t i = 0; i < given.edits.size(); ++i) motion = afterEdit(motion, i, given.edits[i], progress);
  return motion;
}

std::vector<Motion> afterEachEdit(const Motion& given, const Progress& progress) {
  std::vector<Motion> motions{given};
  motions.front().edits.clear();
  for (std::size_t i = 0; i < given.edits.size(); ++i)
    motions.push_back(afterEdit(motions.back(), i, given.edits[i], progress));
  return motions;
}

}  // namespace blossom::sweep
