#pragma once
#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>

namespace blossom::minkowski {

/// Thrown when work would go beyond what was allowed. Not an Error: whoever set the limit knows where else to do the work.
struct TooMuchWork : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "These sums take more work than was allowed."; }
};

/// How much work sums may still take, counted in edges and crossings of their arrangements; the same on every machine.
class Effort {
 public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  explicit Effort(std::size_t most = unlimited) : left_(most) {}

  [[nodiscard]] bool isLimited() const { return left_ != unlimited; }
  /// How many sums are to come, this one included: an estimate counts for all of them.
  void expect(std::size_t sums) { sums_ = std::max<std::size_t>(sums, 1); }
  /// @throws TooMuchWork when a sum of about this size, as often as sums are to come, would go beyond.
  void foresee(double work) const {
    if (isLimited() && work * static_cast<double>(sums_) > static_cast<double>(left_)) throw TooMuchWork();
  }
  /// @throws TooMuchWork
  void spend(std::size_t work) {
    if (!isLimited()) return;
    if (work > left_) throw TooMuchWork();
    left_ -= work;
  }

 private:
  std::size_t left_;
  std::size_t sums_ = 1;
};

}  // namespace blossom::minkowski
