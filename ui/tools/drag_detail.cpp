#include "ui/tools/drag_detail.h"

#include <chrono>
#include <utility>

namespace blossom::ui {

namespace {

/// Of the result itself, wherever it was computed.
double millisecondsOf(const FeatureResult& result) {
  const Value& stats = result.evaluated.stats;
  const Value worker = stats.is_object() ? stats.value("worker_ms", Value(0)) : Value(0);
  return result.kernelMs + (worker.is_number() ? worker.get<double>() : 0);
}

double machineTime() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

DragDetail::DragDetail(Send sender, Newest newest, Clock clock)
    : send_(std::move(sender)), newest_(std::move(newest)), clock_(clock ? std::move(clock) : Clock(machineTime)) {
  rest_.setSingleShot(true);
  rest_.setInterval(restMs);
  connect(&rest_, &QTimer::timeout, this, &DragDetail::handRests);
}

/// The whole one takes long: a coarse one that is being computed is shown before it, or the shape stays behind the hand.
void DragDetail::handRests() {
  look();
  const bool isAwaited = underWay_ == Sent::Coarse && clock_() - since_ < coarseWaitMs;
  if (isAwaited) return rest_.start();
  if (wanted_ && (coarser_ || unsent_)) send(false);
}

bool DragDetail::isBehind() const { return slow_ && coarser_ && wanted_ && (unsent_ || underWay_ == Sent::Coarse); }

void DragDetail::show(Document document, const Coarser& coarser) {
  look();
  wanted_ = std::move(document);
  coarser_ = coarser;
  unsent_ = true;
  if (!slow_) {
    rest_.stop();
    return send(false);
  }
  rest_.start();
  if (!coarser_ && underWay_ == Sent::Nothing) send(false);
  if (coarser_ && underWay_ != Sent::Coarse) send(true);
}

/// What was cancelled by its successor never arrives: it counts for as long as it has been awaited.
void DragDetail::look() {
  if (underWay_ == Sent::Nothing) return;
  const auto now = newest_();
  const bool arrived = now && now != before_;
  const double took = arrived ? millisecondsOf(*now) : clock_() - since_;
  if (underWay_ == Sent::Whole && (arrived || took > budget_)) slow_ = took > budget_;
  if (arrived) underWay_ = Sent::Nothing;
}

void DragDetail::resultsChanged() {
  const bool isFollowed = underWay_ == Sent::Coarse || (underWay_ == Sent::Whole && slow_ && !coarser_);
  look();
  if (isFollowed && underWay_ == Sent::Nothing && unsent_ && wanted_) send(coarser_ != nullptr);
}

// Whoever is sent to may answer at once. A coarser document that cannot be made leaves everything as it was. Whole ones that
// follow each other quickly cancel each other: what counts is how long nothing has come.
void DragDetail::send(bool coarse) {
  const Document document = *wanted_;
  std::optional<Document> coarser;
  if (coarse) coarser = coarser_(document);
  const bool stillAwaited = !coarse && underWay_ == Sent::Whole;
  underWay_ = coarse ? Sent::Coarse : Sent::Whole;
  unsent_ = false;
  before_ = newest_();
  if (!stillAwaited) since_ = clock_();
  if (coarse) ++coarseSent_;
  send_(document, std::move(coarser));
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
