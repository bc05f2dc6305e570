#include <algorithm>
#include <numeric>

#include "core/lower_case.h"
#include "parameter/parameter.h"

namespace blossom {
namespace {

/// Fewest insertions, deletions, replacements and swaps of neighbours (optimal string alignment distance). O(|a| |b|).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    std::swap(beforeLast, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

constexpr std::size_t longestName = 100;  // what is longer is no misspelt name and would cost quadratic time

}  // namespace

std::string nearestName(std::string_view wanted, const std::vector<std::string>& known) {
  if (wanted.empty() || wanted.size() > longestName) return {};
  const std::string sought = lowerCase(wanted);
  std::string best;
  std::size_t bestDistance = std::string::npos;
  for (const auto& name : known) {
    const std::string candidate = lowerCase(name);
    std::size_t distance = editDistance(sought, candidate);
    const bool beginning = sought.size() >= 2 && candidate.starts_with(sought);
    if (!beginning && distance > std::max(sought.size(), candidate.size()) / 3) continue;
    if (distance < bestDistance) best = name, bestDistance = distance;
  }
  return best;
}

}  // namespace blossom
