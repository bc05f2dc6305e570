#include "kernel/repetition.h"

#include <optional>

#include "kernel/polygon_sum.h"

namespace blossom::minkowski {

Polygons Adder::add(const Polygons& a, const Polygons& b, const Progress& progress) { return sum(a, b, progress); }

Polygons repeated(const Polygons& shape, std::size_t k, Adder& add, const Progress& progress) {
  if (k == 1) return shape;
  if (isConvex(shape)) return scaled(shape, static_cast<double>(k));
  std::optional<Polygons> result;
  Polygons power = shape;
  for (std::size_t rest = k;;) {
    if (rest % 2 == 1) result = result ? add(*result, power, progress) : power;
    rest /= 2;
    if (rest == 0) return *result;
    power = add(power, power, progress);
  }
}

}  // namespace blossom::minkowski
