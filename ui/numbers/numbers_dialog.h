#pragma once
#include <QDialog>
#include <vector>

#include "document/named_numbers.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace blossom::ui {

class Session;

/// The table of named numbers of a document: names, values as typed, and what these come to. All changes are one step of
/// undo; what cannot be is told and nothing is changed.
class NumbersDialog : public QDialog {
  Q_OBJECT
 public:
  explicit NumbersDialog(Session&, QWidget* parent = nullptr);
  void accept() override;

 private:
  struct Row {
    QString before;  ///< its name in the document; empty: new
    NamedNumber now;
  };
  void addRow(const QString& before, const QString& name, const QString& value);
  void removeRow();
  void refresh();
  [[nodiscard]] std::vector<Row> rows() const;  ///< those that are not empty
  [[nodiscard]] static std::vector<NamedNumber> tableOf(const std::vector<Row>&);
  [[nodiscard]] Document changed(const std::vector<Row>&) const;

  Session& session_;
  QTableWidget* table_;
  QLabel* problem_;
  QPushButton* ok_ = nullptr;
};

}  // namespace blossom::ui
