#pragma once
#include <cstddef>
#include <numeric>
#include <vector>

namespace blossom {

/// Disjoint sets with path halving; nearly O(1) a call. Hand-written because Boost's disjoint_sets choose their roots by
/// rank, so that numbers would depend on the order of the calls.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The smaller root stays, so that numbering does not depend on the order of the calls.
  void unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    if (a < b) parent_[b] = a;
    if (b < a) parent_[a] = b;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace blossom
