#pragma once
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "document/evaluator.h"

namespace blossom {

/// Cache of results by content key, evicting the least recently used. Thread-safe; every operation is O(1).
class ResultCache {
 public:
  explicit ResultCache(std::size_t minimumLimit) : minimumLimit_(minimumLimit), limit_(minimumLimit) {}
  /// Makes room for a document of so many features as it is and as it was before an edit.
  void makeRoomFor(std::size_t features);
  std::shared_ptr<const FeatureResult> find(const std::string& key);
  void clear();
  /// Rises with each `clear`.
  [[nodiscard]] std::uint64_t generation();
  /// Nothing happens when the cache was cleared since that generation: the result is what was to be forgotten.
  void store(const std::string& key, std::shared_ptr<const FeatureResult> result, std::uint64_t generation);

 private:
  using Entry = std::pair<std::string, std::shared_ptr<const FeatureResult>>;
  std::mutex mutex_;
  const std::size_t minimumLimit_;
  std::size_t limit_;
  std::uint64_t generation_ = 0;
  std::list<Entry> recent_;  ///< most recently used first
  std::unordered_map<std::string, std::list<Entry>::iterator> byKey_;
};

}  // namespace blossom
