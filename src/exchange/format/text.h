#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "parameter/value.h"

/// What the readers of text formats share. Numbers never depend on the locale.
namespace blossom::parse {

/// The finite number that the whole of `word` represents, with an optional "+"; empty otherwise ("nan", "1,5", "1e999").
std::optional<double> toNumber(std::string_view word);
/// The integer that the whole of `word` represents, when it fits into an int.
std::optional<int> toInteger(std::string_view word);

std::string_view trimmed(std::string_view);
/// The text itself when it is UTF-8, else decoded as Latin-1, so that names from a file are valid in a document.
std::string utf8(std::string_view);
/// Removes the next word from `rest` and returns it; empty at the end.
std::string_view takeWord(std::string_view& rest);

/// Error FormatDamaged with the message "Line 12: ..".
Error damaged(std::size_t line, const std::string& sentence);
/// Text of the file for a message: shortened and printable.
std::string shown(std::string_view);

/// The lines of a text, numbered from 1; "\r\n", "\n" and "\r" are line ends.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  /// Reads the next line; false at the end.
  bool next(std::string_view& line);
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Counts by name; the number of names is limited, so that a damaged file cannot exhaust memory.
class Counter {
 public:
  /// @throws Error FormatDamaged when the number of names exceeds the limit.
  void add(std::string_view name);
  [[nodiscard]] bool empty() const { return counts_.empty(); }
  [[nodiscard]] std::size_t total() const;
  [[nodiscard]] Value toValue() const;
  [[nodiscard]] const std::map<std::string, std::size_t, std::less<>>& counts() const { return counts_; }

 private:
  std::map<std::string, std::size_t, std::less<>> counts_;
};

}  // namespace blossom::parse
