#include "kernel/grid/span_parameters.h"

#include <algorithm>

namespace blossom::sweep {

std::vector<double> spanParameters(std::pair<double, double> domain,
                                   std::initializer_list<const std::vector<double>*> knotsOfFactors, std::size_t parts) {
  std::vector<double> breaks;
  for (const auto* knots : knotsOfFactors)
    for (const double knot : *knots)
      if (knot >= domain.first && knot <= domain.second) breaks.push_back(knot);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (std::size_t k = 0; k < parts; ++k)
      result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * static_cast<double>(k) / static_cast<double>(parts));
  result.push_back(breaks.back());
  return result;
}

std::size_t partsWithin(std::size_t spansU, std::size_t spansV, std::size_t parts, std::size_t most) {
  while (parts > 1 && (spansU * parts + 1) * (spansV * parts + 1) > most) --parts;
  return parts;
}

}  // namespace blossom::sweep
