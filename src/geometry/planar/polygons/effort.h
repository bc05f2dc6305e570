#pragma once
#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>

namespace blossom::planar {

/// Thrown when a computation would exceed its Effort. Not an Error, because the caller that set the limit computes
/// elsewhere.
struct TooMuchWork : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "These sums take more work than was allowed."; }
};

/// Limit on the work of sums, counted in pairs of edges that are compared and thus the same on every machine.
class Effort {
 public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  static constexpr double pairsOfEdge = 16;  ///< an edge takes as long as comparing so many pairs
  explicit Effort(std::size_t maximum = unlimited) : left_(maximum) {}

  [[nodiscard]] bool isLimited() const { return left_ != unlimited; }
  /// Sets the number of sums to come, including the next one; `foresee` estimates for all of them.
  void expect(std::size_t sums) { sums_ = std::max<std::size_t>(sums, 1); }
  /// @throws TooMuchWork when the expected number of sums of about this size would exceed the limit.
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

}  // namespace blossom::planar
