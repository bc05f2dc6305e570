#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/stroke/stroke.h"

namespace blossom::pocket {

/// Point location in the area enclosed by closed loops of strokes, by the even-odd rule: counts the crossings of the
/// boundary with the ray to the right. Immutable, usable from several threads.
///
/// Strokes are indexed by rows of equal height. Those that cross the whole row are sorted, so that only the ones with about
/// the abscissa of the point are tested: O(log n + strokes that end in the row + strokes above or below the point).
class InsideTest {
 public:
  InsideTest() = default;
  explicit InsideTest(const std::vector<Stroke>&);
  [[nodiscard]] bool operator()(const Vec2&) const;

 private:
  /// A part of a stroke that is monotone in y.
  class Slope {
   public:
    explicit Slope(const Stroke&);
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] double minimum() const { return minimum_; }
    [[nodiscard]] bool spans(double y) const { return low_ <= y && y < high_; }  ///< half open: a vertex counts once
    /// Whether it lies to the right of a point within its range of heights.
    [[nodiscard]] bool isRightOf(const Vec2& p) const;
    [[nodiscard]] double maximum() const { return maximum_; }

   private:
    [[nodiscard]] double at(double y) const;
    Vec2 from_, to_, center_;
    double radius_ = 0;
    bool round_ = false, onRight_ = false;  ///< of its centre
    double low_ = 0, high_ = 0;             ///< in y
    double minimum_ = 0, maximum_ = 0;      ///< bounds of `at`, also with rounding, because every step is monotone
  };
  using Index = std::uint32_t;
  struct Row {
    std::vector<Index> ending;      ///< slopes that begin or end in it
    std::vector<Index> across;      ///< slopes through the whole row, by their minimum x
    std::vector<double> reachedBy;  ///< maximum x of each of these and all before it
  };

  void fillRows();
  [[nodiscard]] std::size_t rowOf(double y) const;

  std::vector<Slope> slopes_;
  std::vector<Row> rows_;
  double bottom_ = 0, height_ = 0;
};

}  // namespace blossom::pocket
