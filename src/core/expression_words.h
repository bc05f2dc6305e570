#pragma once
#include <cstddef>
#include <string_view>

/// Letters and words of core/expression.
namespace blossom {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Bytes of the letter at a place, 0 when there is none. Of other alphabets everything counts that no expression uses as a
/// sign: the Latin-1 signs (° · µ), the general punctuation, × ÷ μ and π do not.
std::size_t letterAt(std::string_view text, std::size_t at);

/// End of the word that starts at a place.
std::size_t wordEnd(std::string_view text, std::size_t at);

}  // namespace blossom
