#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace blossom {

/// SHA-256 (FIPS 180-4) of data that comes in pieces. Hand-written because this room sees no library that has it, Qt and
/// OpenSSL least of all, and seventy lines are less than one more dependency.
class Sha256 {
 public:
  void add(std::string_view data);
  /// The hash in 64 hexadecimal digits. Ends this object's use.
  std::string hex();

 private:
  void block(const unsigned char* bytes);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> pending_{};
  std::size_t pendingSize_ = 0;
  std::uint64_t length_ = 0;  ///< bytes so far
};

}  // namespace blossom
