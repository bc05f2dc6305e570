#pragma once
#include <algorithm>
#include <string>
#include <string_view>

namespace blossom {

/// A to Z as a to z; other characters stay, whatever the locale.
inline std::string lowerCase(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

}  // namespace blossom
