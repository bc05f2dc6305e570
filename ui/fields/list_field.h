#pragma once
#include <QCoreApplication>
#include <optional>
#include <vector>

#include "ui/fields/parameter_field.h"

class QFrame;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace blossom::ui {

class ListRow;

/// A list of items of any kind, which can be added, removed, copied and moved. Long lists are shown in parts.
class ListField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::ListField)
 public:
  ListField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;
  [[nodiscard]] Value written() const override;
  void setWritten(const Value& given) override { given_ = held_ = given; }
  [[nodiscard]] const std::vector<ListRow*>& rows() const { return rows_; }

 private:
  void display(const Value&) override;
  void addToMenu(QMenu&) override;
  void fitRows();
  void addRow();
  void add();
  /// How many items a list is to have; empty: any number.
  [[nodiscard]] std::optional<std::size_t> wantedCount(const ParameterSpec& list) const;
  [[nodiscard]] bool full() const;
  [[nodiscard]] Value newItemOf(const ParameterSpec& list) const;
  [[nodiscard]] Value newItem() const;
  void replace(std::size_t index, const Value&, bool preview);
  void move(std::size_t from, std::size_t to);
  void remove(std::size_t index);
  void copy(std::size_t index);
  void showDropLine(int globalY);
  [[nodiscard]] std::size_t placeAt(int globalY) const;

  Value draft_ = Value::array();  // what is shown; more than the value while an item must still be given
  Value given_;                   // what the document holds, until the rows know
  Value held_;                    // the same, for the items that have no field yet
  std::size_t limit_;
  std::vector<ListRow*> rows_;
  QVBoxLayout* column_;
  QToolButton* add_;
  QPushButton* more_;
  QFrame* dropLine_;
};

}  // namespace blossom::ui
