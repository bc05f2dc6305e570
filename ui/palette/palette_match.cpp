#include "ui/palette/palette_match.h"

#include <algorithm>
#include <vector>

namespace blossom::ui {

namespace {

constexpr int letterScore = 4, runScore = 8, wordStartScore = 10, textStartScore = 6, gapCost = 1, wholeWordScore = 12;
constexpr int never = -1'000'000;

bool beginsWord(const QString& text, qsizetype at) {
  return at == 0 || (!text[at - 1].isLetterOrNumber() && text[at].isLetterOrNumber());
}

int scoreOf(const QString& text, qsizetype at) {
  return letterScore + (beginsWord(text, at) ? wordStartScore : 0) + (at == 0 ? textStartScore : 0);
}

// best[i][j]: letters 0..i of the word met, the last of them at place j of the text.
std::optional<PaletteMatch> wordMatch(const QString& word, const QString& text) {
  const auto size = static_cast<std::size_t>(text.size());
  std::vector<std::vector<int>> best(static_cast<std::size_t>(word.size()), std::vector<int>(size, never));
  std::vector<std::vector<std::size_t>> from(best.size(), std::vector<std::size_t>(size, 0));
  for (std::size_t i = 0; i < best.size(); ++i)
    for (std::size_t j = i; j < size; ++j) {
      if (text[static_cast<qsizetype>(j)] != word[static_cast<qsizetype>(i)]) continue;
      const int own = scoreOf(text, static_cast<qsizetype>(j));
      if (i == 0) best[i][j] = own;
      for (std::size_t k = 0; i > 0 && k < j; ++k) {
        if (best[i - 1][k] == never) continue;
        const int step = j == k + 1 ? runScore : -gapCost * static_cast<int>(std::min<std::size_t>(j - k - 1, 12));
        if (best[i - 1][k] + own + step > best[i][j]) best[i][j] = best[i - 1][k] + own + step, from[i][j] = k;
      }
    }
  const auto end = std::max_element(best.back().begin(), best.back().end());
  if (end == best.back().end() || *end == never) return std::nullopt;
  PaletteMatch match{*end, {}};
  auto place = static_cast<std::size_t>(end - best.back().begin());
  for (std::size_t i = best.size(); i-- > 0; place = from[i][place]) match.letters.prepend(static_cast<int>(place));
  const qsizetype after = match.letters.back() + 1;
  const bool whole = match.letters.back() - match.letters.front() + 1 == word.size() &&
                     beginsWord(text, match.letters.front()) && (after == text.size() || !text[after].isLetterOrNumber());
  if (whole) match.score += wholeWordScore;
  return match;
}

}  // namespace

std::optional<PaletteMatch> paletteMatch(const QString& pattern, const QString& text) {
  PaletteMatch all;
  const QString lower = text.toLower();
  for (const QString& word : pattern.toLower().split(u' ', Qt::SkipEmptyParts)) {
    const auto match = wordMatch(word, lower);
    if (!match) return std::nullopt;
    all.score += match->score;
    all.letters << match->letters;
  }
  std::sort(all.letters.begin(), all.letters.end());
  return all;
}

}  // namespace blossom::ui
