#include "ui/tools/drag_detail.h"

#include <utility>

namespace blossom::ui {

namespace {

/// Of the result itself, wherever it was computed.
double millisecondsOf(const FeatureResult& result) {
  const Value& stats = result.evaluated.stats;
  const Value worker = stats.is_object() ? stats.value("worker_ms", Value(0)) : Value(0);
  return result.kernelMs + (worker.is_number() ? worker.get<double>() : 0);
}

}  // namespace

DragDetail::DragDetail(Send sender, Newest newest) : send_(std::move(sender)), newest_(std::move(newest)) {
  rest_.setSingleShot(true);
  rest_.setInterval(restMs);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (wanted_) send(false);
  });
}

void DragDetail::show(Document document, const Coarser& coarser) {
  look();
  wanted_ = std::move(document);
  coarser_ = coarser;
  unsent_ = true;
  if (!slow_ || !coarser_) {
    rest_.stop();
    return send(false);
  }
  rest_.start();
  if (underWay_ != Sent::Coarse) send(true);
}

/// What was cancelled by its successor never arrives: it counts for as long as it has been awaited.
void DragDetail::look() {
  if (underWay_ == Sent::Nothing) return;
  const auto now = newest_();
  const bool arrived = now && now != before_;
  const double took = arrived ? millisecondsOf(*now) : static_cast<double>(since_.nsecsElapsed()) / 1e6;
  if (underWay_ == Sent::Whole && (arrived || took > budget_)) slow_ = took > budget_;
  if (arrived) underWay_ = Sent::Nothing;
}

void DragDetail::resultsChanged() {
  const bool coarse = underWay_ == Sent::Coarse;
  look();
  if (coarse && underWay_ == Sent::Nothing && unsent_ && wanted_) send(true);
}

// Whoever is sent to may answer at once.
void DragDetail::send(bool coarse) {
  underWay_ = coarse ? Sent::Coarse : Sent::Whole;
  unsent_ = false;
  before_ = newest_();
  since_.start();
  if (coarse) ++coarseSent_;
  const Document document = *wanted_;
  send_(document, coarse ? std::optional(coarser_(document)) : std::nullopt);
}

void DragDetail::end() {
  rest_.stop();
  look();
  wanted_.reset();
  unsent_ = false;
  underWay_ = Sent::Nothing;
  before_.reset();
}

}  // namespace blossom::ui
