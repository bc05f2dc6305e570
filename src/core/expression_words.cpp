#include "core/expression_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/expression.h"
#include "core/expression_functions.h"

namespace blossom {

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Calls a function with begin and end of each word. The e of 1e3 is none.
template <class F>
void forEachWord(std::string_view text, const F& function) {
  std::size_t at = 0;
  while (at < text.size()) {
    if (letterAt(text, at) > 0) {
      const std::size_t end = wordEnd(text, at);
      function(at, end);
      at = end;
    } else if (isDigit(text[at]) || text[at] == '.') {
      double number = 0;
      const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
      at = error == std::errc::invalid_argument ? at + 1 : static_cast<std::size_t>(end - text.data());
    } else {
      ++at;
    }
  }
}

}  // namespace

std::size_t letterAt(std::string_view text, std::size_t at) {
  if (at >= text.size()) return 0;
  if (isLetter(text[at])) return 1;
  const auto lead = static_cast<unsigned char>(text[at]);
  constexpr unsigned char firstLetters = 0xC3, punctuation = 0xE2;
  if (lead < firstLetters || lead == punctuation) return 0;
  for (const std::string_view sign : {"×", "÷", "μ", "π"})
    if (text.substr(at).starts_with(sign)) return 0;
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return end - at;
}

std::size_t wordEnd(std::string_view text, std::size_t at) {
  for (;;) {
    const std::size_t letter = letterAt(text, at);
    if (letter == 0 && (at >= text.size() || !isDigit(text[at]))) return at;
    at += std::max<std::size_t>(letter, 1);
  }
}

std::string nameProblem(std::string_view name) {
  if (name.empty()) return "A name is missing.";
  if (letterAt(name, 0) == 0 || wordEnd(name, 0) != name.size())
    return fmt::format("\"{}\" cannot be a name: use letters, digits and _, and begin with a letter.", name);
  if (unitNamed(name)) return fmt::format("\"{}\" is a unit.", name);
  if (findFunction(name)) return fmt::format("\"{}\" is a function.", name);
  return name == "pi" || name == "tau" ? fmt::format("\"{}\" is a constant.", name) : std::string();
}

std::vector<std::string> wordsOf(std::string_view expression) {
  std::vector<std::string> words;
  forEachWord(expression, [&](std::size_t from, std::size_t to) { words.emplace_back(expression.substr(from, to - from)); });
  return words;
}

std::string withWord(std::string_view expression, std::string_view word, std::string_view replacement) {
  std::string text;
  std::size_t done = 0;
  forEachWord(expression, [&](std::size_t from, std::size_t to) {
    if (expression.substr(from, to - from) != word) return;
    text.append(expression.substr(done, from - done)).append(replacement);
    done = to;
  });
  return text.append(expression.substr(done));
}

}  // namespace blossom
