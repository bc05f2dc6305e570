#pragma once
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>

#include "core/progress.h"

namespace blossom {

/// Adapter that makes OCCT's long algorithms report to a Progress and stop when it is cancelled. Pass `handle->Start()` as
/// the algorithm's Message_ProgressRange, and call `progress.check()` afterwards, because OCCT only returns early.
class OcctProgress final : public Message_ProgressIndicator {
 public:
  OcctProgress(Progress progress, std::string stage) : progress_(std::move(progress)), stage_(std::move(stage)) {}
  Standard_Boolean UserBreak() override { return progress_.cancelled(); }

 protected:
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    if (!progress_.cancelled()) progress_.report(GetPosition(), stage_);
  }

 private:
  Progress progress_;
  std::string stage_;
};

}  // namespace blossom
