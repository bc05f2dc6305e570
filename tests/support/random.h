#pragma once
#include <random>

/// Random numbers of tests.
namespace blossom::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}
inline int uniformInt(Random& random, int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); }

}  // namespace blossom::test
