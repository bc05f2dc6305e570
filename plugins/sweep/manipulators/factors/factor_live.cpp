#include "manipulators/factors/factor_live.h"

#include "core/error.h"
#include "ui/look/text.h"

namespace blossom::sweep {

FactorLive::FactorLive(std::shared_ptr<const LiveSurface> before, bool capped)
    : before_(std::move(before)), grid_(before_->grid), mesh_(grid_.grid(), liveForm(grid_.motion(), capped)) {}

void FactorLive::show(const FactorChanges& changes) {
  reason_.clear();
  changes_ = changes;
  try {
    mesh_.update(grid_.grid(), grid_.update(withChangedFactors(before_->motion(), changes).motion));
  } catch (const Error& error) {
    mesh_.update(grid_.grid(), grid_.update(before_->motion()));
    reason_ = ui::saidInFull(error);
  }
}

}  // namespace blossom::sweep
