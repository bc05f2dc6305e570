#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace blossom::planar {

/// Rows of bits, all false at first.
class BitRaster {
 public:
  using Word = std::uint64_t;
  static constexpr int wordBits = 64;

  BitRaster() = default;
  BitRaster(int columns, int rows);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int words() const { return words_; }  ///< of a row
  [[nodiscard]] Word* row(int r) { return bits_.data() + static_cast<std::ptrdiff_t>(r) * words_; }
  [[nodiscard]] const Word* row(int r) const { return bits_.data() + static_cast<std::ptrdiff_t>(r) * words_; }
  [[nodiscard]] bool at(int column, int r) const { return (row(r)[column / wordBits] >> (column % wordBits) & 1) != 0; }

  /// Sets the bits of [first, last) of a row.
  void set(int r, int first, int last, bool value);
  /// Whether all bits of a box are true, borders included.
  [[nodiscard]] bool all(int left, int right, int low, int high) const;

 private:
  int columns_ = 0, rows_ = 0, words_ = 0;
  std::vector<Word> bits_;
};

/// Neighbouring true bits of a row.
struct BitRun {
  int row, first, last;  ///< [first, last)
};

/// All runs, by rows and from left to right.
std::vector<BitRun> runsOf(const BitRaster&);
/// The places with all within `reach` columns and rows true, and inside the raster.
BitRaster eroded(const BitRaster&, int reach);

}  // namespace blossom::planar
