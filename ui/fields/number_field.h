#pragma once
#include <QCoreApplication>

#include "ui/fields/parameter_field.h"

namespace blossom::ui {

class NumberLine;

/// Counts, numbers, lengths and angles: typed as expressions, stepped by keys and wheel, dragged by the label.
class NumberField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::NumberField)
 public:
  NumberField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;
  [[nodiscard]] Value written() const override;
  void setWritten(const Value&) override;

 private:
  void display(const Value&) override;
  void step(double steps, Qt::KeyboardModifiers);
  void scrub(int pixels, Qt::KeyboardModifiers);
  void finish();
  void takeTyped(const QString&);
  void tellResult(const QString& typed);
  [[nodiscard]] double shownNumber() const;

  NumberLine* line_;
  Value shown_;          // of the line: what a preview has made of the value
  QString expression_;   // that the value was typed as; empty: as a plain number
  double fraction_ = 0;  // of a step, for wheels that turn in small parts
};

}  // namespace blossom::ui
