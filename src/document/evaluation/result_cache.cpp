#include "document/evaluation/result_cache.h"

#include <algorithm>

namespace blossom {

void ResultCache::makeRoomFor(std::size_t features) {
  const std::lock_guard lock(mutex_);
  limit_ = std::max(minimumLimit_, 2 * features);
}

void ResultCache::clear() {
  std::list<Entry> dropped;  // destroyed after the lock
  const std::lock_guard lock(mutex_);
  dropped.swap(recent_);
  byKey_.clear();
  ++generation_;
}

std::uint64_t ResultCache::generation() {
  const std::lock_guard lock(mutex_);
  return generation_;
}

std::shared_ptr<const FeatureResult> ResultCache::find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = byKey_.find(key);
  if (found == byKey_.end()) return nullptr;
  recent_.splice(recent_.begin(), recent_, found->second);
  return found->second->second;
}

void ResultCache::store(const std::string& key, std::shared_ptr<const FeatureResult> result, std::uint64_t generation) {
  std::list<Entry> dropped;  // destroyed after the lock: a large shape takes its time
  const std::lock_guard lock(mutex_);
  if (generation != generation_) return;
  if (const auto found = byKey_.find(key); found != byKey_.end()) {
    dropped.splice(dropped.begin(), recent_, found->second);
    byKey_.erase(found);
  }
  recent_.emplace_front(key, std::move(result));
  byKey_[key] = recent_.begin();
  while (recent_.size() > limit_) {
    byKey_.erase(recent_.back().first);
    dropped.splice(dropped.begin(), recent_, std::prev(recent_.end()));
  }
}

}  // namespace blossom
