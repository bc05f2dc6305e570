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

/// Finite number written by the whole of `word`, with an optional "+"; empty otherwise ("nan", "1,5", "1e999").
std::optional<double> toNumber(std::string_view word);
/// Whole number that fits into an int.
std::optional<int> toInteger(std::string_view word);

std::string_view trimmed(std::string_view);
/// The text itself when it is UTF-8, else read as Latin-1: names from a file must not break a document later.
std::string utf8(std::string_view);
/// Takes the next word off `rest`; empty at its end.
std::string_view takeWord(std::string_view& rest);

/// Error FormatDamaged "Line 12: ..".
Error damaged(std::size_t line, const std::string& sentence);
/// What stands in the file, short and printable enough for a message.
std::string shown(std::string_view);

/// The lines of a text, numbered from 1; "\r\n", "\n" and "\r" end a line.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  /// False at the end.
  bool next(std::string_view& line);
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Counts by name; a file of rubbish cannot make it grow without bound.
class Counter {
 public:
  /// @throws Error FormatDamaged when there are more names than any sane file has.
  void add(std::string_view name);
  [[nodiscard]] bool empty() const { return counts_.empty(); }
  [[nodiscard]] std::size_t total() const;
  [[nodiscard]] Value toValue() const;
  [[nodiscard]] const std::map<std::string, std::size_t, std::less<>>& counts() const { return counts_; }

 private:
  std::map<std::string, std::size_t, std::less<>> counts_;
};

}  // namespace blossom::parse
