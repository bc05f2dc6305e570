#pragma once
#include <QList>
#include <QString>
#include <optional>

namespace blossom::ui {

struct PaletteMatch {
  int score = 0;       ///< larger: better
  QList<int> letters;  ///< positions of the matching letters in the text, ascending
};

/// Every word of `pattern` occurs in `text` in order of its letters, gaps allowed; letters that begin a word or follow each
/// other count more, gaps cost. An empty pattern meets everything. O(pattern · text²), both are short.
std::optional<PaletteMatch> paletteMatch(const QString& pattern, const QString& text);

}  // namespace blossom::ui
