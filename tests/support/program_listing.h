#pragma once
#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/vector.h"

/// G-code programs as lines of words that can be changed, with a small interpreter of its own: it shares nothing with the
/// reader that is tested, and follows only what the programs of these tests hold.
namespace blossom::test {

struct ListedWord {
  char letter = ' ';
  std::string number;  ///< as written
  std::size_t at = 0, length = 0;
  [[nodiscard]] double value() const { return std::stod(number); }
};

inline std::vector<ListedWord> wordsOf(const std::string& line) {
  std::vector<ListedWord> words;
  int depth = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == ';' && depth == 0) break;
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (depth > 0 || std::isalpha(static_cast<unsigned char>(c)) == 0) continue;
    std::size_t end = i + 1;
    while (end < line.size() && line[end] == ' ') ++end;
    const std::size_t begin = end;
    while (end < line.size() && std::string_view("+-.0123456789").find(line[end]) != std::string_view::npos) ++end;
    words.push_back(
        {static_cast<char>(std::toupper(static_cast<unsigned char>(c))), line.substr(begin, end - begin), i, end - i});
    i = end - 1;
  }
  return words;
}

/// What a line does.
struct ListedMove {
  int motion = -1;                              ///< 0..3; -1: the line does not move the tool, or to the machine's places
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< mm
  bool absolute = true;
  double unit = 1;
  [[nodiscard]] bool cuts() const { return motion > 0; }
};

struct Listing {
  std::vector<std::string> lines;

  explicit Listing(const std::string& text) {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
  }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return all;
  }

  /// One for each line.
  [[nodiscard]] std::vector<ListedMove> moves() const {
    std::vector<ListedMove> all;
    int modal = 0;
    ListedMove state;
    Vec3 at = Vec3::Zero();
    for (const std::string& line : lines) {
      bool machine = false, moved = false;
      const std::vector<ListedWord> words = wordsOf(line);
      for (const ListedWord& w : words) {
        if (w.letter != 'G') continue;
        const double g = w.value();
        if (g == 0 || g == 1 || g == 2 || g == 3) modal = static_cast<int>(g);
        if (g == 20) state.unit = 25.4;
        if (g == 21) state.unit = 1;
        if (g == 90) state.absolute = true;
        if (g == 91) state.absolute = false;
        machine = machine || g == 28 || g == 53 || g == 4;
      }
      Vec3 to = at;
      for (const ListedWord& w : words) {
        const std::size_t axis = std::string_view("XYZ").find(w.letter);
        if (axis == std::string_view::npos || machine) continue;
        const auto k = static_cast<Eigen::Index>(axis);
        to[k] = (state.absolute ? 0 : at[k]) + w.value() * state.unit;
        moved = true;
      }
      for (const ListedWord& w : words) moved = moved || ((w.letter == 'I' || w.letter == 'J') && !machine);
      ListedMove move = state;
      move.motion = moved ? modal : -1;
      move.from = at;
      move.to = at = to;
      all.push_back(move);
    }
    return all;
  }

  [[nodiscard]] std::optional<ListedWord> word(std::size_t line, char letter) const {
    for (const ListedWord& w : wordsOf(lines[line]))
      if (w.letter == letter) return w;
    return std::nullopt;
  }

  /// The number of a word changed by so much, in as many places as it had, and at least so many.
  void change(std::size_t line, char letter, double by, int minimumPlaces) {
    const ListedWord w = *word(line, letter);
    const std::size_t point = w.number.find('.');
    const int places = point == std::string::npos ? 0 : static_cast<int>(w.number.size() - point - 1);
    std::ostringstream number;
    number.imbue(std::locale::classic());
    number << std::fixed;
    number.precision(std::max(places, minimumPlaces));
    number << w.value() + by;
    lines[line].replace(w.at, w.length, lines[line].substr(w.at, 1) + number.str());
  }
  void erase(std::size_t line, const ListedWord& w) { lines[line].erase(w.at, w.length); }
};

}  // namespace blossom::test
