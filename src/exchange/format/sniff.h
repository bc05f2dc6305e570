#pragma once
#include <cstdint>
#include <string_view>

namespace blossom {

/// Whether size and count of facets agree as in a binary STL file; tells those that begin with "solid" apart from text.
bool looksLikeBinaryStl(std::string_view head, std::uintmax_t fileSize);

}  // namespace blossom
