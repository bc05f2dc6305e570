#include "exchange/gcode/gcode_words.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>

namespace blossom {
namespace {

/// Length of a parameter or an expression: "#1", "#<name>", "[#1+2]".
std::size_t expressionLength(std::string_view text) {
  std::size_t at = 0;
  int brackets = 0, angles = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '[') ++brackets;
    if (c == '<') ++angles;
    if (brackets == 0 && angles == 0 && at > 0 && std::isalpha(static_cast<unsigned char>(c))) break;
    if (c == ']') --brackets;
    if (c == '>') --angles;
    ++at;
  }
  return at;
}

/// Takes a number off the front of the text; nothing when there is none.
std::optional<GcodeWord> takeNumber(char letter, std::string_view& text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  const auto length = static_cast<std::size_t>(end - text.data());
  const GcodeWord word{letter, value, text.substr(0, length)};
  text.remove_prefix(length);
  return word;
}

}  // namespace

GcodeWords gcodeWords(std::string_view text) {
  GcodeWords found;
  while (!text.empty()) {
    const char letter = text.front();
    text.remove_prefix(1);
    if (letter == '$' || letter == '^' || letter == '@') {  // spindle numbers and polar words of LinuxCNC
      (void)takeNumber(letter, text);
      found.polar = found.polar || letter != '$';
      continue;
    }
    if (!std::isupper(static_cast<unsigned char>(letter))) {
      found.damage = fmt::format("a word starts with '{}'", letter >= ' ' && letter < 127 ? letter : '?');
      return found;
    }
    if (!text.empty() && (text.front() == '#' || text.front() == '[')) {
      text.remove_prefix(expressionLength(text));
      found.words.push_back({letter, std::nullopt, {}});
      continue;
    }
    const std::optional<GcodeWord> word = takeNumber(letter, text);
    if (!word) {
      found.damage = fmt::format("the word {} has no number", letter);
      return found;
    }
    found.words.push_back(*word);
  }
  return found;
}

}  // namespace blossom
