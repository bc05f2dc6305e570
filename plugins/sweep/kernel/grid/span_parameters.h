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

/// The greatest number of parts of every span, `parts` at most and 1 at least, with which a grid has no more than `most`
/// places.
std::size_t partsWithin(std::size_t spansU, std::size_t spansV, std::size_t parts, std::size_t most);

}  // namespace blossom::sweep
