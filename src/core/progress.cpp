#include "core/progress.h"

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace blossom {

Progress::Progress(CancelToken token, Listener listener) : token_(std::move(token)), listener_(std::move(listener)) {}

void Progress::check() const {
  if (cancelled()) throw Error(ErrorCode::Cancelled, "The work was cancelled.");
}

void Progress::report(double fraction, const std::string& stage) const {
  check();
  if (!listener_) return;
  const double clamped = std::clamp(fraction, 0.0, 1.0);
  const int percent = static_cast<int>(clamped * 100);
  if (lastPercent_->exchange(percent) != percent) listener_(clamped, stage);
}

Progress Progress::part(double from, double to) const {
  if (!listener_) return Progress(token_);
  return Progress(token_, [listener = listener_, from, to](double fraction, const std::string& stage) {
    listener(from + (to - from) * fraction, stage);
  });
}

}  // namespace blossom
