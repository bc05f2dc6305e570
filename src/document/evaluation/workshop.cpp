#include "document/evaluation/workshop.h"

#include <algorithm>

#include "core/error.h"
#include "core/thread_priority.h"

namespace blossom {
namespace {

constexpr std::size_t leftToQuickOnes = 2;

}  // namespace

Workshop::Workshop()
    : longAtOnce_(std::max(2U, std::thread::hardware_concurrency() / 2)), atOnce_(longAtOnce_ + leftToQuickOnes) {}

Workshop::~Workshop() {
  cancel();
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

Workshop::Joined Workshop::join(const std::string& key, std::uint64_t generation,
                                std::function<void(const Result&, const Progress&)> show) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(pieces_.begin(), pieces_.end(), [&](const Handle& piece) {
    return piece->key == key && piece->generation == generation && !piece->token.cancelled();
  });
  if (key.empty() || found == pieces_.end()) return {};
  Piece& piece = **found;
  const bool shows = !piece.wanted && !piece.showing;  // one that is wanted already shows another feature of the document
  piece.wanted = true;
  if (shows) piece.show.swap(show);  // the former is destroyed after the lock is gone
  return {*found, shows};
}

Workshop::Handle Workshop::begin(Piece made) {
  auto piece = std::make_shared<Piece>(std::move(made));
  const std::lock_guard lock(mutex_);
  pieces_.push_back(piece);
  waiting_.emplace(piece->expectedMs, piece);
  if (threads_.size() < std::min(atOnce_, waiting_.size() + active_)) threads_.emplace_back([this] { serve(); });
  changed_.notify_all();
  return piece;
}

void Workshop::wantNothing() {
  const std::lock_guard lock(mutex_);
  for (const Handle& piece : pieces_) piece->wanted = false;
}

void Workshop::dropUnwanted() {
  std::list<Handle> dropped;  // destroyed after the lock is gone
  const std::lock_guard lock(mutex_);
  dropped = pieces_;
  for (const Handle& piece : dropped)
    if (!piece->wanted) drop(piece);
  changed_.notify_all();
}

void Workshop::cancel() {
  wantNothing();
  dropUnwanted();
}

/// One that was begun ends by itself.
void Workshop::drop(const Handle& piece) {
  piece->token.cancel();
  if (piece->begun) return;
  piece->ended = true;
  std::erase_if(waiting_, [&](const auto& entry) { return entry.second == piece; });
  pieces_.remove(piece);
  news_ = true;
}

Workshop::Look Workshop::look(const Handle& piece) {
  const std::lock_guard lock(mutex_);
  return {piece->result, piece->fraction, piece->stage, piece->ended};
}

void Workshop::waitForNews(const CancelToken& token) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return news_ || token.cancelled(); });
  news_ = false;
}

void Workshop::wake() {
  const std::lock_guard lock(mutex_);
  changed_.notify_all();
}

void Workshop::waitUntilIdle() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return pieces_.empty(); });
}

bool Workshop::ownsThisThread() {
  const std::lock_guard lock(mutex_);
  const auto self = std::this_thread::get_id();
  return std::any_of(threads_.begin(), threads_.end(), [&](const std::thread& thread) { return thread.get_id() == self; });
}

/// The cheapest that waits, if a thread may begin it; nullptr otherwise.
Workshop::Handle Workshop::next() {
  if (waiting_.empty() || active_ >= atOnce_) return nullptr;
  const auto cheapest = waiting_.begin();
  if (cheapest->first >= longFrom && activeLong_ >= longAtOnce_) return nullptr;
  Handle piece = cheapest->second;
  waiting_.erase(cheapest);
  return piece;
}

void Workshop::serve() {
  lowerThreadPriority();
  std::unique_lock lock(mutex_);
  for (;;) {
    Handle piece;
    changed_.wait(lock, [&] { return ending_ || (piece = next()) != nullptr; });
    if (!piece) return;
    const bool takesLong = piece->expectedMs >= longFrom;
    piece->begun = true;
    ++active_;
    activeLong_ += takesLong ? 1 : 0;
    lock.unlock();
    perform(*piece);
    lock.lock();
    piece->ended = true;
    piece->fraction = 1;
    pieces_.remove(piece);
    --active_;
    activeLong_ -= takesLong ? 1 : 0;
    news_ = true;
    lock.unlock();
    piece.reset();  // what it holds ends here, not under the lock
    changed_.notify_all();
    lock.lock();
  }
}

void Workshop::perform(Piece& piece) {
  const Progress progress(piece.token,
                          [this, &piece](double fraction, const std::string& stage) { tell(piece, fraction, stage); });
  try {
    computeAndShow(piece, progress);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::Cancelled) throw;
  }
}

void Workshop::computeAndShow(Piece& piece, const Progress& progress) {
  const bool known = !piece.compute;
  Result result = known ? piece.result : piece.compute(progress.part(0, piece.computing));
  std::function<void(const Result&, const Progress&)> show;
  {
    const std::lock_guard lock(mutex_);
    piece.result = result;
    piece.showing = true;
    show = piece.show;
    news_ = true;
  }
  changed_.notify_all();
  progress.check();
  if (show) show(result, known ? progress : progress.part(piece.computing, 1));
}

void Workshop::tell(Piece& piece, double fraction, const std::string& stage) {
  {
    const std::lock_guard lock(mutex_);
    piece.fraction = std::max(piece.fraction, fraction);
    piece.stage = stage;
    news_ = true;
  }
  changed_.notify_all();
}

}  // namespace blossom
