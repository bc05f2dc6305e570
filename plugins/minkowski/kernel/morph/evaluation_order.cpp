#include "kernel/morph/evaluation_order.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kernel/morph/repetition.h"

namespace blossom::minkowski {
namespace {

std::size_t binomial(std::size_t n, std::size_t k) {
  std::size_t result = 1;
  for (std::size_t i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// Choices of equal arguments are interchangeable, so each weight is a product of powers.
struct Choice {
  std::size_t levels = 0;  ///< chosen
  double weight = 1;
  std::size_t count = 1;
};

/// Whether a level needs sums; at 0 and 1 de Casteljau's algorithm uses one of two shapes unchanged.
bool isBlend(double t) { return t != 0 && t != 1; }

std::size_t bottomUpSums(std::span<const double> t) {
  std::size_t sums = 0;
  for (std::size_t level = 0; level < t.size(); ++level) sums += isBlend(t[level]) ? t.size() - level : 0;
  return sums;
}

std::size_t recursiveSums(std::span<const double> t) {
  std::size_t sums = 0;
  for (const double level : t) sums = 2 * sums + (isBlend(level) ? 1 : 0);
  return sums;
}

std::size_t convexSums(std::span<const double> t) {
  const std::vector<double> shares = sharesOf(t);
  const auto shapes = std::count_if(shares.begin(), shares.end(), [](double share) { return share > 0; });
  return static_cast<std::size_t>(shapes) - 1;
}

/// @param known the repetitions that earlier in-betweens made
std::size_t explicitSums(std::span<const double> t, const std::vector<bool>& convex,
                         std::set<std::pair<std::size_t, std::size_t>>& known) {
  std::size_t terms = 0, repetitions = 0;
  const auto weights = weightsOf(t);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (const auto& [weight, count] : weights[i]) {
      ++terms;
      if (known.emplace(i, count).second) repetitions += sumsOfRepetition(convex[i], count);
    }
  return terms - 1 + repetitions;
}

}  // namespace

std::vector<std::map<double, std::size_t>> weightsOf(std::span<const double> t) {
  std::map<double, std::size_t> multiplicities;
  for (const double level : t) ++multiplicities[level];
  std::vector<Choice> choices{{}};
  for (const auto& [value, times] : multiplicities) {
    std::vector<Choice> more;
    more.reserve(choices.size() * (times + 1));
    for (const Choice& choice : choices)
      for (std::size_t taken = 0; taken <= times; ++taken) {
        const double factor =
            std::pow(value, static_cast<double>(taken)) * std::pow(1 - value, static_cast<double>(times - taken));
        more.push_back({choice.levels + taken, choice.weight * factor, choice.count * binomial(times, taken)});
      }
    choices = std::move(more);
  }
  std::vector<std::map<double, std::size_t>> weights(t.size() + 1);
  for (const Choice& choice : choices)
    if (choice.weight != 0) weights[choice.levels][choice.weight] += choice.count;
  return weights;
}

std::vector<double> sharesOf(std::span<const double> t) {
  std::vector<double> shares{1};
  for (const double level : t) {
    shares.push_back(0);
    for (std::size_t i = shares.size() - 1; i > 0; --i) shares[i] = (1 - level) * shares[i] + level * shares[i - 1];
    shares.front() *= 1 - level;
  }
  return shares;
}

double choicesOf(std::span<const double> t) {
  std::map<double, std::size_t> multiplicities;
  for (const double level : t) ++multiplicities[level];
  double choices = 1;
  for (const auto& [value, times] : multiplicities) choices *= static_cast<double>(times) + 1;
  return choices;
}

std::size_t sumsNeeded(EvaluationOrder way, std::span<const Arguments> arguments, const std::vector<bool>& convex) {
  std::size_t sums = 0;
  std::set<std::pair<std::size_t, std::size_t>> repetitions;
  for (const Arguments& t : arguments) {
    // Both ends are the control shapes themselves.
    if (std::all_of(t.begin(), t.end(), [&](double level) { return level == t.front() && !isBlend(level); })) continue;
    switch (way) {
      case EvaluationOrder::Recursive:
        sums += recursiveSums(t);
        break;
      case EvaluationOrder::BottomUp:
        sums += bottomUpSums(t);
        break;
      case EvaluationOrder::Convex:
        sums += convexSums(t);
        break;
      case EvaluationOrder::Automatic:
      case EvaluationOrder::Explicit:
        sums += explicitSums(t, convex, repetitions);
        break;
    }
  }
  return sums;
}

EvaluationOrder quickestWay(std::span<const Arguments> arguments, const std::vector<bool>& convex) {
  std::vector<EvaluationOrder> ways{EvaluationOrder::BottomUp};
  double choices = 0;
  std::size_t levels = 0;
  for (const Arguments& t : arguments) {
    choices = std::max(choices, choicesOf(t));
    levels = std::max(levels, t.size());
  }
  if (choices <= mostChoices) ways.insert(ways.begin(), EvaluationOrder::Explicit);
  if (std::all_of(convex.begin() + 1, convex.end() - 1, [](bool each) { return each; }))
    ways.push_back(EvaluationOrder::Convex);
  constexpr std::size_t manyLevels = 3;
  constexpr double fewChoices = 64;
  if (levels > manyLevels && choices <= fewChoices && ways.size() == 2) return EvaluationOrder::Explicit;
  return *std::min_element(ways.begin(), ways.end(), [&](EvaluationOrder a, EvaluationOrder b) {
    return sumsNeeded(a, arguments, convex) < sumsNeeded(b, arguments, convex);
  });
}

}  // namespace blossom::minkowski
