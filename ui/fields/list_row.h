#pragma once
#include "ui/fields/parameter_field.h"

class QHBoxLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace blossom::ui {

/// One item of a list: its number, its field and its actions. The field of a record is opened by a click and created only
/// then. The number can be dragged to another place.
class ListRow final : public QWidget {
  Q_OBJECT
 public:
  ListRow(const ParameterSpec& element, std::size_t index, const ParameterField::Context&, QWidget* parent);
  void setWritten(const Value& given);  ///< what the document holds of the value that is set next
  void setValue(const Value&);
  [[nodiscard]] bool editing() const { return field_ && field_->editing(); }
  [[nodiscard]] ParameterField* field() const { return field_; }
  void open(bool);
  /// Gives the keyboard to the first line of an open row, whose text is written over by what is typed.
  void startTyping();
  void setEnds(bool first, bool last);

 signals:
  void edited(const blossom::Value&);
  void previewed(const blossom::Value&);
  void reverted();
  void hint(const QString&);
  void pickWanted(blossom::ui::ParameterField*, const blossom::ui::PickRequest&);
  void pickUnwanted(blossom::ui::ParameterField*);
  void moveWanted(int by);
  void removeWanted();
  void copyWanted();
  void dragged(int globalY);
  void dropped(int globalY);

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  void makeField();
  void showMenu();
  void addRecordTitle(QHBoxLayout*);

  ParameterSpec element_;
  ParameterField::Context context_;
  Value value_, written_;
  bool record_;
  bool first_ = false, last_ = false;
  bool dragging_ = false;
  int from_ = 0;
  QVBoxLayout* column_;
  QLabel* number_;
  QToolButton* title_ = nullptr;
  ParameterField* field_ = nullptr;
};

}  // namespace blossom::ui
