#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "core/error.h"

namespace blossom {

/// Reads numbers of either byte order from a block of memory, with a check for its end.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::endian order) : bytes_(bytes), swap_(order != std::endian::native) {}

  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - at_; }

  /// @throws Error FormatDamaged at the end of the block.
  template <class T>
  T take() {
    static_assert(std::is_arithmetic_v<T>);
    if (remaining() < sizeof(T))
      throw Error(ErrorCode::FormatDamaged, "The file ends in the middle of its data.", "It was not written completely.");
    char raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[swap_ ? sizeof(T) - 1 - i : i] = bytes_[at_ + i];
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool swap_;
};

/// Appends the bytes of a number, least significant first.
template <class T, class Out>
void appendLittleEndian(Out& out, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i)
    out.push_back(raw[std::endian::native == std::endian::little ? i : sizeof(T) - 1 - i]);
}

}  // namespace blossom
