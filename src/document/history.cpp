#include "document/history.h"

#include <atomic>
#include <utility>

namespace blossom {
namespace {

std::uint64_t newSerial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

History::History(Document document) { steps_.push_back({std::move(document), {}, newSerial()}); }

void History::commit(Document document, std::string what) {
  preview_.reset();
  steps_.resize(place_ + 1);
  if (savedPlace_ && *savedPlace_ > place_) savedPlace_.reset();  // what was saved can no longer be reached
  steps_.push_back({std::move(document), std::move(what), newSerial()});
  ++place_;
}

void History::preview(Document document) { preview_ = std::move(document); }

void History::revert() { preview_.reset(); }

void History::amend(Document document) { (preview_ ? *preview_ : steps_[place_].document) = std::move(document); }

bool History::undo() {
  preview_.reset();
  if (place_ == 0) return false;
  --place_;
  return true;
}

bool History::redo() {
  preview_.reset();
  if (place_ + 1 == steps_.size()) return false;
  ++place_;
  return true;
}

const Document& History::current() const { return preview_ ? *preview_ : steps_[place_].document; }

std::string History::undoText() const { return place_ > 0 ? steps_[place_].what : std::string(); }

std::string History::redoText() const { return place_ + 1 < steps_.size() ? steps_[place_ + 1].what : std::string(); }

void History::markSaved(std::uint64_t step) {
  savedPlace_.reset();
  for (std::size_t place = 0; place < steps_.size(); ++place)
    if (steps_[place].serial == step) savedPlace_ = place;
}

void History::markUnsaved() { savedPlace_.reset(); }

bool History::modified() const { return savedPlace_ != place_; }

}  // namespace blossom
