#pragma once
#include <QWidget>

#include "parameter/parameter.h"

class QLabel;

namespace blossom::ui {

/// One parameter in a form, made from its declaration: label, editor for its kind, and room for what is wrong with the
/// value.
class ParameterField : public QWidget {
  Q_OBJECT
 public:
  /// The editor that fits the kind; lists, records and curves get a text in their written form.
  static ParameterField* make(const ParameterSpec&, QWidget* parent = nullptr);

  [[nodiscard]] const ParameterSpec& spec() const { return spec_; }
  /// Shows a value without telling anyone.
  void setValue(const Value&);
  [[nodiscard]] const Value& value() const { return value_; }
  [[nodiscard]] QString problem() const;

 signals:
  void previewed(const blossom::Value&);  ///< while a slider is dragged
  void edited(const blossom::Value&);     ///< checked and different from before
  void hint(const QString&);

 protected:
  explicit ParameterField(ParameterSpec, QWidget* parent);
  void setEditor(QWidget*);
  /// Checks and passes on; a wrong value is named below the editor and the old one kept.
  void offer(const Value&, bool preview = false);
  void offerText(const QString&);
  void showProblem(const QString&);
  virtual void display(const Value&) = 0;
  void enterEvent(QEnterEvent*) override;

 private:
  ParameterSpec spec_;
  Value value_;
  QLabel* problem_;
  class QGridLayout* grid_;
};

/// The value as a form writes it, with its unit.
QString displayText(const ParameterSpec&, const Value&);

}  // namespace blossom::ui
