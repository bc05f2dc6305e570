#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace blossom::minkowski {

/// Order of computation of an in-between shape; the result is the same up to rounding.
enum class EvaluationOrder {
  Automatic,  ///< one of those below, see quickestWay
  Recursive,  ///< C_i^r = (1-t) C_i^(r-1) + t C_(i+1)^(r-1), recursively: 2^n - 1 sums
  BottomUp,   ///< the same, every intermediate shape once: n (n+1) / 2 sums
  Explicit,   ///< sum of t^i (1-t)^(n-i) [C(n,i)] A_i: n sums, and the repetitions [k]A once for all frames
  Convex      ///< [k]A = k A: n sums; only when all control shapes between the first and the last are convex
};

using Arguments = std::vector<double>;  ///< of a blossom, one for each level

/// The weights of A_i in the blossom: products over all choices of i levels, each with its multiplicity. With equal
/// arguments this is one weight C(n,i) times. Weights of 0 are left out.
std::vector<std::map<double, std::size_t>> weightsOf(std::span<const double> t);

/// The sum of the weights of each A_i: the shares of convex shapes, which add up to 1. O(n^2)
std::vector<double> sharesOf(std::span<const double> t);

/// How many weights the explicit form is put together from; it is left to other evaluations above `mostChoices`.
double choicesOf(std::span<const double> t);
constexpr double mostChoices = 1 << 16;

/// Number of Minkowski sums that an evaluation needs for the in-betweens of control shapes; convex[i] says whether shape i
/// is convex.
std::size_t sumsNeeded(EvaluationOrder way, std::span<const Arguments> arguments, const std::vector<bool>& convex);

/// The evaluation with the fewest sums; Explicit when several have equally few, and for more than three levels when its
/// terms are few: its repetitions have few corners, where the in-betweens of in-betweens have very many.
EvaluationOrder quickestWay(std::span<const Arguments> arguments, const std::vector<bool>& convex);

}  // namespace blossom::minkowski
