#include "geometry/planar/winding/bit_raster.h"

#include <algorithm>
#include <bit>

namespace blossom::planar {
namespace {

using Word = BitRaster::Word;
constexpr int wordBits = BitRaster::wordBits;

/// The bits of [first, last) that lie in a word, 0 <= first < last.
Word maskOf(int word, int first, int last) {
  const int from = std::max(first - word * wordBits, 0), to = std::min(last - word * wordBits, wordBits);
  if (from >= to) return 0;
  const Word below = to == wordBits ? ~Word{0} : (Word{1} << to) - 1;
  return below & (~Word{0} << from);
}

/// A word of a row moved to the right by columns, or to the left by a negative number.
Word movedWord(const Word* row, int words, int word, int by) {
  const int bits = ((by % wordBits) + wordBits) % wordBits, whole = (by - bits) / wordBits;
  const auto at = [&](int i) { return i >= 0 && i < words ? row[i] : Word{0}; };
  const int source = word - whole;
  return bits == 0 ? at(source) : at(source) << bits | at(source - 1) >> (wordBits - bits);
}

/// All within `reach` columns to either side. Doubles the width that is looked at, so that it takes few steps.
void erodeRow(const BitRaster& raster, int r, int reach, std::vector<Word>& from, std::vector<Word>& to) {
  const int words = raster.words();
  from.assign(raster.row(r), raster.row(r) + words);
  to.resize(static_cast<std::size_t>(words));
  // After each step a bit says that it and the `done` bits to its right are true.
  for (int done = 0, wanted = 2 * reach; done < wanted;) {
    const int step = std::min(done + 1, wanted - done);
    for (int w = 0; w < words; ++w)
      to[static_cast<std::size_t>(w)] = from[static_cast<std::size_t>(w)] & movedWord(from.data(), words, w, -step);
    std::swap(from, to);
    done += step;
  }
  for (int w = 0; w < words; ++w) to[static_cast<std::size_t>(w)] = movedWord(from.data(), words, w, reach);
}

}  // namespace

BitRaster::BitRaster(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      words_((columns + wordBits - 1) / wordBits),
      bits_(static_cast<std::size_t>(words_) * static_cast<std::size_t>(rows)) {}

void BitRaster::set(int r, int first, int last, bool value) {
  if (first >= last) return;
  Word* const bits = row(r);
  for (int w = first / wordBits; w <= (last - 1) / wordBits; ++w) {
    const Word mask = maskOf(w, first, last);
    bits[w] = value ? bits[w] | mask : bits[w] & ~mask;
  }
}

bool BitRaster::all(int left, int right, int low, int high) const {
  if (left < 0 || low < 0 || right >= columns_ || high >= rows_) return false;
  for (int w = left / wordBits; w <= right / wordBits; ++w) {
    const Word mask = maskOf(w, left, right + 1);
    for (int r = low; r <= high; ++r)
      if ((row(r)[w] & mask) != mask) return false;
  }
  return true;
}

std::vector<BitRun> runsOf(const BitRaster& raster) {
  std::vector<BitRun> runs;
  for (int r = 0; r < raster.rows(); ++r) {
    const Word* const bits = raster.row(r);
    bool open = false;
    for (int w = 0; w < raster.words(); ++w) {
      Word rest = open ? ~bits[w] : bits[w];  // the next change is its lowest bit
      while (rest != 0) {
        const int at = std::countr_zero(rest);
        if (open)
          runs.back().last = w * wordBits + at;
        else
          runs.push_back({r, w * wordBits + at, raster.columns()});
        open = !open;
        rest = (open ? ~bits[w] : bits[w]) & (~Word{0} << at);
      }
    }
    if (open) runs.back().last = raster.columns();
  }
  return runs;
}

BitRaster eroded(const BitRaster& raster, int reach) {
  BitRaster wide(raster.columns(), raster.rows()), result(raster.columns(), raster.rows());
  std::vector<Word> from, to;
  for (int r = 0; r < raster.rows(); ++r) {
    erodeRow(raster, r, reach, from, to);
    std::copy(to.begin(), to.end(), wide.row(r));
  }
  // The same for rows: row r stands for those from r to r + done.
  for (int done = 0, wanted = 2 * reach; done < wanted;) {
    const int step = std::min(done + 1, wanted - done);
    for (int r = 0; r < raster.rows(); ++r)
      for (int w = 0; w < raster.words(); ++w)
        wide.row(r)[w] = r + step < raster.rows() ? wide.row(r)[w] & wide.row(r + step)[w] : 0;
    done += step;
  }
  for (int r = 0; r + reach < raster.rows(); ++r) std::copy_n(wide.row(r), raster.words(), result.row(r + reach));
  return result;
}

}  // namespace blossom::planar
