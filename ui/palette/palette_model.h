#pragma once
#include <QAbstractListModel>
#include <functional>
#include <vector>

#include "ui/palette/palette_match.h"

namespace blossom::ui {

/// An entry of the palette.
struct PaletteEntry {
  QString id;     ///< stable, to recognise recently used entries: "file.open", "sample:/path"
  QString group;  ///< shown before the text
  QString icon, text, keys;
  QString help;  ///< one line
  bool enabled = true;
  QString whyNot;  ///< shown instead of the help when it is disabled
  std::function<void()> go;
  QStringList keywords = {};                              ///< other words for it, in lower case
  std::function<void(const QString& keyword)> goAs = {};  ///< when it was found by a keyword; not set: as `go`
};

using PaletteSource = std::function<std::vector<PaletteEntry>()>;

/// The entries that match a pattern, best first; recently used ones come before others.
class PaletteModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { GroupRole = Qt::UserRole, IconRole, KeysRole, HelpRole, EnabledRole, LettersRole };
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<PaletteEntry>, const QStringList& lately);
  void setPattern(const QString&);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex&, int role) const override;
  [[nodiscard]] const PaletteEntry& at(int row) const { return entries_[rows_[static_cast<std::size_t>(row)].entry]; }
  /// The keyword by which a row was found; empty: by its text.
  [[nodiscard]] QString keywordOf(int row) const { return rows_[static_cast<std::size_t>(row)].keyword; }

 private:
  struct Row {
    std::size_t entry;
    int score;
    QList<int> letters;  // matching letters of the text
    QString keyword = {};
  };
  [[nodiscard]] std::optional<Row> rowFor(std::size_t entry, const QString& pattern) const;
  [[nodiscard]] std::optional<Row> rowByText(std::size_t entry, const QString& pattern) const;
  [[nodiscard]] std::optional<Row> rowByKeyword(std::size_t entry, const QString& pattern) const;
  [[nodiscard]] int liking(std::size_t entry) const;
  std::vector<PaletteEntry> entries_;
  std::vector<int> latelyScore_;
  std::vector<Row> rows_;
};

}  // namespace blossom::ui
