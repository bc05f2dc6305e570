#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace blossom::morphology::arrangement {

/// The hash of a key of several parts, one after the other.
inline std::uint64_t mixedHash(std::uint64_t sum, std::uint64_t part) {
  return (std::rotl(sum, 5) ^ part) * 0x9E3779B97F4A7C15ULL;
}

/// Numbers of things by the hash of a key, in one flat array (linear probing, at most half full), which is quicker to fill
/// and to free than the nodes of `std::unordered_multimap`. Which of the things with one hash is the wanted one, the caller
/// tells.
class NumberTable {
 public:
  void add(std::uint64_t hash, int number) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    put({hash, number});
    ++count_;
  }

  /// The first number of that hash that is the wanted one; -1 when there is none.
  template <class IsWanted>
  [[nodiscard]] int find(std::uint64_t hash, const IsWanted& isWanted) const {
    if (slots_.empty()) return -1;
    for (std::size_t k = first(hash); slots_[k].number >= 0; k = next(k))
      if (slots_[k].hash == hash && isWanted(slots_[k].number)) return slots_[k].number;
    return -1;
  }

 private:
  struct Slot {
    std::uint64_t hash = 0;
    int number = -1;  ///< -1: free
  };

  /// The lower bits of a product do not depend on the upper ones of its factors: both halves count.
  [[nodiscard]] std::size_t first(std::uint64_t hash) const { return (hash ^ hash >> 32U) & (slots_.size() - 1); }
  [[nodiscard]] std::size_t next(std::size_t k) const { return (k + 1) & (slots_.size() - 1); }

  void put(const Slot& slot) {
    std::size_t k = first(slot.hash);
    while (slots_[k].number >= 0) k = next(k);
    slots_[k] = slot;
  }

  void grow() {
    constexpr std::size_t least = 16;
    const std::vector<Slot> before = std::move(slots_);
    slots_.assign(before.empty() ? least : 2 * before.size(), {});
    for (const Slot& slot : before)
      if (slot.number >= 0) put(slot);
  }

  std::vector<Slot> slots_;  ///< a power of two of them
  std::size_t count_ = 0;
};

}  // namespace blossom::morphology::arrangement
