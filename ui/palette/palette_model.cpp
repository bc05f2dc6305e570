#include "ui/palette/palette_model.h"

#include <algorithm>

namespace blossom::ui {

namespace {

constexpr int latelyWorth = 3;          // per place in the list of what was used
constexpr int wholeNameWorth = 1000;    // above whatever was used lately
constexpr int wholePageWorth = 300;     // a page of the manual, below the command that it is about
constexpr int wholeKeywordWorth = 500;  // below whole names, above letters scattered in other names
constexpr int keywordPenalty = 15;
constexpr int helpMatchPenalty = 40;  // what only the help line says comes last
constexpr int disabledPenalty = 8;

}  // namespace

void PaletteModel::setEntries(std::vector<PaletteEntry> entries, const QStringList& lately) {
  beginResetModel();
  entries_ = std::move(entries);
  latelyScore_.clear();
  for (const PaletteEntry& entry : entries_) {
    const qsizetype place = lately.indexOf(entry.id);
    latelyScore_.push_back(place < 0 ? 0 : latelyWorth * static_cast<int>(lately.size() - place));
  }
  rows_.clear();
  endResetModel();
  setPattern({});
}

int PaletteModel::liking(std::size_t place) const {
  return latelyScore_[place] - (entries_[place].enabled ? 0 : disabledPenalty);
}

std::optional<PaletteModel::Row> PaletteModel::rowFor(std::size_t place, const QString& pattern) const {
  std::optional<Row> byText = rowByText(place, pattern), byKeyword = rowByKeyword(place, pattern);
  return byKeyword && (!byText || byKeyword->score > byText->score) ? byKeyword : byText;
}

// Other words are met by their beginning only.
std::optional<PaletteModel::Row> PaletteModel::rowByKeyword(std::size_t place, const QString& pattern) const {
  const QString typed = pattern.simplified().toLower();
  std::optional<Row> best;
  for (const QString& word : entries_[place].keywords) {
    if (typed.size() < 2 || !word.startsWith(typed)) continue;
    const auto match = paletteMatch(typed, word);
    const int score = liking(place) + (word == typed ? wholeKeywordWorth : (match ? match->score : 0) - keywordPenalty);
    if (!best || score > best->score) best = Row{place, score, {}, word};
  }
  return best;
}

// Letters may be met in "Group text"; those of the text are lit up.
std::optional<PaletteModel::Row> PaletteModel::rowByText(std::size_t place, const QString& pattern) const {
  const PaletteEntry& entry = entries_[place];
  const int lately = liking(place);
  if (const auto match = paletteMatch(pattern, entry.text)) {
    const bool isTheName = entry.text.compare(pattern.trimmed(), Qt::CaseInsensitive) == 0;
    const int named = entry.id.startsWith(QLatin1String("manual:")) ? wholePageWorth : wholeNameWorth;
    return Row{place, match->score + lately + (isTheName ? named : 10), match->letters, {}};
  }
  const QString full = entry.group + u' ' + entry.text;
  if (const auto match = paletteMatch(pattern, full)) {
    QList<int> letters;
    for (const int at : match->letters)
      if (at > entry.group.size()) letters << at - static_cast<int>(entry.group.size()) - 1;
    return Row{place, match->score + lately, letters, {}};
  }
  // Words of the help line must stand there as they are: gaps in a sentence would meet nearly everything.
  const QStringList words = pattern.split(u' ', Qt::SkipEmptyParts);
  const QString all = full + u' ' + entry.help;
  if (!std::all_of(words.begin(), words.end(), [&](const QString& w) { return all.contains(w, Qt::CaseInsensitive); }))
    return std::nullopt;
  return Row{place, lately - helpMatchPenalty, {}, {}};
}

void PaletteModel::setPattern(const QString& pattern) {
  beginResetModel();
  rows_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (auto row = rowFor(i, pattern)) rows_.push_back(std::move(*row));
  std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return a.score > b.score; });
  endResetModel();
}

int PaletteModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.size()); }

QVariant PaletteModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const PaletteEntry& entry = at(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return entry.text;
    case Qt::AccessibleDescriptionRole:
    case HelpRole:
      return entry.enabled || entry.whyNot.isEmpty() ? entry.help : entry.whyNot;
    case GroupRole:
      return entry.group;
    case IconRole:
      return entry.icon;
    case KeysRole:
      return entry.keys;
    case EnabledRole:
      return entry.enabled;
    case LettersRole:
      return QVariant::fromValue(rows_[static_cast<std::size_t>(index.row())].letters);
    default:
      return {};
  }
}

}  // namespace blossom::ui
