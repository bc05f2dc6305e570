#pragma once
#include <cstddef>

namespace blossom::minkowski {

/// A number of a facet, side or corner as a place in a vector.
inline std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace blossom::minkowski
