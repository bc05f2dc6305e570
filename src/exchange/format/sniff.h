#pragma once
#include <cstdint>
#include <string_view>

namespace blossom {

/// Whether file size and facet count match as in a binary STL file; distinguishes binary files that begin with "solid" from
/// text.
bool looksLikeBinaryStl(std::string_view head, std::uintmax_t fileSize);

}  // namespace blossom
