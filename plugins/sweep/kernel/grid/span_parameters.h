#pragma once
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace blossom::sweep {

/// Parameters that divide every span between the knots of some factors into `parts`, and both ends of the domain;
/// increasing.
std::vector<double> spanParameters(std::pair<double, double> domain,
                                   std::initializer_list<const std::vector<double>*> knotsOfFactors, std::size_t parts);

}  // namespace blossom::sweep
