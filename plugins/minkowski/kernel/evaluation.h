#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace blossom::minkowski {

/// How an in-between is computed; the shape is the same (up to rounding).
enum class Evaluation {
  Automatic,  ///< that of the others which needs the fewest sums
  Recursive,  ///< C_i^r = (1-t) C_i^(r-1) + t C_(i+1)^(r-1), as it stands: 2^n - 1 sums
  BottomUp,   ///< the same, every intermediate shape once: n (n+1) / 2 sums
  Explicit,   ///< sum of t^i (1-t)^(n-i) [C(n,i)] A_i: n sums, and the repetitions [k]A once for all frames
  Convex      ///< [k]A = k A: n sums; only when all control shapes between the first and the last are convex
};

using Arguments = std::vector<double>;  ///< of a blossom, one for each level

/// The weights of A_i in the blossom, the products over all choices of i levels, each with how often it comes: one weight
/// C(n,i) times where all arguments are equal. Weights of 0 are left out.
std::vector<std::map<double, std::size_t>> weightsOf(std::span<const double> t);

/// How many Minkowski sums an evaluation takes for in-betweens of control shapes of which these are convex.
/// @param way not Automatic
std::size_t sumsNeeded(Evaluation way, std::span<const Arguments> arguments, const std::vector<bool>& convex);

/// The way that takes the fewest sums; of two that take the same, the explicit one.
Evaluation wayOfFewestSums(std::span<const Arguments> arguments, const std::vector<bool>& convex);

}  // namespace blossom::minkowski
