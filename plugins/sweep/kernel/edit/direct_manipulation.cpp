#include "kernel/edit/direct_manipulation.h"

#include "core/error.h"
#include "kernel/edit/pull.h"
#include "kernel/edit/twist.h"

namespace blossom::sweep {

namespace {

void takeOver(Motion& motion, EditResult result) {
  if (!result.obstacles.empty()) {
    const Explanation reason = explain(result.obstacles.front());
    throw Error(ErrorCode::InvalidParameter, reason.what, reason.remedy);
  }
  motion = std::move(result.motion);
}

}  // namespace

void dragScaling(Motion& motion, double u, double v, const Vec3& to) {
  takeOver(motion, pull(motion, {.at = {{u, v}}, .to = {to}, .weights = {0, 0, 1}}));
}

void twistOrientation(Motion& motion, double u, double v, const Vec3& axis, double degrees) {
  takeOver(motion, twist(motion, {.at = {{u, v}}, .axis = axis, .angle = degrees}));
}

}  // namespace blossom::sweep
