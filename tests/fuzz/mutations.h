#pragma once
#include <algorithm>
#include <array>
#include <cctype>
#include <random>
#include <string>

namespace blossom::test {

/// Damages a file in one to four ways: bits, bytes, numbers, words, lines and chunks are changed, doubled, exchanged, cut
/// away.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string operator()(std::string content) {
    // Mostly once: a file that is hardly damaged gets further into its reader.
    for (std::size_t n = below(3) == 0 ? 2 + below(3) : 1; n > 0 && !content.empty(); --n) damage(content);
    return content;
  }

 private:
  std::size_t below(std::size_t n) { return n < 2 ? 0 : std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  void damage(std::string& s) {
    switch (below(11)) {
      case 0:
        for (std::size_t n = 1 + below(8); n > 0; --n) s[below(s.size())] ^= static_cast<char>(1 << below(8));
        break;
      case 1:
        s.resize(below(s.size()));
        break;
      case 2:
        s.erase(below(s.size()), 1 + below(200));
        break;
      case 3: {
        const std::size_t from = below(s.size());
        s.insert(below(s.size()), s.substr(from, 1 + below(200)));
        break;
      }
      case 4:
        swapChunks(s);
        break;
      case 5:
      case 6:
      case 7:
        replaceNumber(s);
        break;
      case 8:
        insertWord(s);
        break;
      case 9:
        lines(s);
        break;
      default:
        for (std::size_t n = 1 + below(16), at = below(s.size()); n > 0 && at < s.size(); --n)
          s[at++] = static_cast<char>(random_());
    }
  }

  void swapChunks(std::string& s) {
    const std::size_t length = 1 + below(std::min<std::size_t>(100, s.size()));
    if (s.size() < 2 * length) return;
    const std::size_t a = below(s.size() - 2 * length + 1), b = a + length + below(s.size() - 2 * length - a + 1);
    std::swap_ranges(s.begin() + static_cast<std::ptrdiff_t>(a), s.begin() + static_cast<std::ptrdiff_t>(a + length),
                     s.begin() + static_cast<std::ptrdiff_t>(b));
  }

  void replaceNumber(std::string& s) {
    static constexpr std::array<const char*, 20> numbers{"0",
                                                         "-1",
                                                         "1e308",
                                                         "-1e308",
                                                         "1e-320",
                                                         "nan",
                                                         "inf",
                                                         "-inf",
                                                         "",
                                                         "2147483647",
                                                         "-2147483648",
                                                         "4294967295",
                                                         "99999999999999999999",
                                                         "1,5",
                                                         "1.5.5",
                                                         "0x10",
                                                         "1e",
                                                         "000000000000000000001",
                                                         "1e15",
                                                         "3"};
    std::size_t begin = below(s.size());
    while (begin < s.size() && !std::isdigit(static_cast<unsigned char>(s[begin]))) ++begin;
    std::size_t end = begin;
    const auto isPart = [](char c) {
      return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == 'e' || c == 'E';
    };
    while (end < s.size() && isPart(s[end])) ++end;
    if (begin < end) s.replace(begin, end - begin, numbers[below(numbers.size())]);
  }

  /// A word of the file put in another place.
  void insertWord(std::string& s) {
    std::size_t begin = below(s.size());
    while (begin < s.size() && std::isspace(static_cast<unsigned char>(s[begin]))) ++begin;
    std::size_t end = begin;
    while (end < s.size() && end - begin < 60 && !std::isspace(static_cast<unsigned char>(s[end]))) ++end;
    const std::string word = " " + s.substr(begin, end - begin) + " ";
    s.insert(below(s.size()), word);
  }

  /// A line left out, doubled or put in another place.
  void lines(std::string& s) {
    const std::size_t begin = s.rfind('\n', below(s.size())) + 1;
    const std::size_t end = std::min(s.find('\n', begin), s.size() - 1) + 1;
    if (begin >= end) return;
    const std::string line = s.substr(begin, end - begin);
    const std::size_t what = below(3);
    if (what != 1) s.erase(begin, end - begin);
    if (what == 0 || s.empty()) return;
    s.insert(s.rfind('\n', below(s.size())) + 1, line);
  }

  std::mt19937_64 random_;
};

}  // namespace blossom::test
