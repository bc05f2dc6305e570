#include "geometry/planar/winding/wide_products.h"

#include <cmath>

namespace blossom::planar {
namespace {

__extension__ using Unsigned = unsigned __int128;

/// 256 bits, two's complement.
struct Product {
  Unsigned high, low;
};

Product magnitude(Unsigned a, Unsigned b) {
  constexpr Unsigned mask = (Unsigned(1) << 64) - 1;
  const Unsigned a0 = a & mask, a1 = a >> 64, b0 = b & mask, b1 = b >> 64;
  const Unsigned low = a0 * b0, middle = a0 * b1 + (low >> 64), other = a1 * b0 + (middle & mask);
  return {a1 * b1 + (middle >> 64) + (other >> 64), (other << 64) | (low & mask)};
}

Product product(Wide a, Wide b) {
  const auto size = [](Wide w) { return w < 0 ? Unsigned(0) - Unsigned(w) : Unsigned(w); };
  const Product p = magnitude(size(a), size(b));
  if ((a < 0) == (b < 0)) return p;
  const Unsigned low = Unsigned(0) - p.low;
  return {~p.high + (low == 0 ? 1 : 0), low};
}

}  // namespace

int compareProducts(Wide a, Wide b, Wide c, Wide d) {
  const double left = static_cast<double>(a) * static_cast<double>(b),
               right = static_cast<double>(c) * static_cast<double>(d);
  constexpr double rounding = 1e-15;  // of two conversions and a product, with room
  if (std::abs(left - right) > rounding * (std::abs(left) + std::abs(right))) return left > right ? 1 : -1;
  const Product p = product(a, b), q = product(c, d);
  const Wide high = Wide(p.high), other = Wide(q.high);
  if (high != other) return high > other ? 1 : -1;
  return p.low == q.low ? 0 : p.low > q.low ? 1 : -1;
}

}  // namespace blossom::planar
