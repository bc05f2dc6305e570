#include "exchange/format/text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace blossom::parse {
namespace {

constexpr std::size_t maximumNames = 200;

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

/// Well-formed, without overlong forms and surrogates (RFC 3629).
bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || i + length > text.size()) return false;
    unsigned long code = length == 1 ? lead : lead & (0xffu >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      if ((next & 0xc0) != 0x80) return false;
      code = code << 6 | (next & 0x3f);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    if (overlong || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff) return false;
    i += length;
  }
  return true;
}

std::string_view withoutPlus(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

std::optional<double> toNumber(std::string_view word) {
  word = withoutPlus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return {};
  // Too small for a double is as good as zero, too large is not a number to work with.
  if (error == std::errc::result_out_of_range) {
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return tiny ? std::optional<double>(0) : std::nullopt;
  }
  if (error != std::errc() || !std::isfinite(value)) return {};
  return value;
}

std::optional<int> toInteger(std::string_view word) {
  word = withoutPlus(word);
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return value;
}

std::string_view trimmed(std::string_view word) {
  while (!word.empty() && isSpace(word.front())) word.remove_prefix(1);
  while (!word.empty() && isSpace(word.back())) word.remove_suffix(1);
  return word;
}

std::string utf8(std::string_view text) {
  if (isUtf8(text)) return std::string(text);
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xc0 | byte >> 6);
      result += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return result;
}

std::string_view takeWord(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && isSpace(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !isSpace(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

Error damaged(std::size_t line, const std::string& sentence) {
  return Error(ErrorCode::FormatDamaged, fmt::format("Line {}: {}", line, sentence),
               "The file is damaged or was not written completely.");
}

std::string shown(std::string_view text) {
  std::string label = "\"";
  for (const char c : text.substr(0, 30)) label += c >= ' ' && c < 127 ? c : '?';
  return label + (text.size() > 30 ? "..\"" : "\"");
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find_first_of("\r\n");
  line = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
    rest_.remove_prefix(end + (pair ? 2 : 1));
  }
  ++number_;
  return true;
}

void Counter::add(std::string_view name) {
  if (const auto it = counts_.find(name); it != counts_.end()) {
    ++it->second;
    return;
  }
  if (counts_.size() >= maximumNames)
    throw Error(ErrorCode::FormatDamaged, "Most of its statements are unknown.",
                "The file is damaged or of another format.");
  counts_.emplace(utf8(name.substr(0, 60)), 1);
}

std::size_t Counter::total() const {
  std::size_t sum = 0;
  for (const auto& [name, count] : counts_) sum += count;
  return sum;
}

Value Counter::toValue() const {
  Value value = Value::object();
  for (const auto& [name, count] : counts_) value[name] = count;
  return value;
}

}  // namespace blossom::parse
