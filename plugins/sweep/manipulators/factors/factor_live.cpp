#include "manipulators/factors/factor_live.h"

#include "core/error.h"

namespace blossom::sweep {

void FactorLive::show(const FactorChanges& changes) {
  reason_.clear();
  changes_ = changes;
  try {
    grid_.update(withChangedFactors(before_->motion(), changes).motion);
  } catch (const Error& error) {
    grid_.update(before_->motion());
    reason_ = QString::fromStdString(error.hint().empty() ? error.message() : error.message() + " " + error.hint());
  }
}

}  // namespace blossom::sweep
