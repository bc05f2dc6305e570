#pragma once
#include <QCoreApplication>
#include <QPointF>
#include <vector>

#include "ui/fields/parameter_field.h"

namespace blossom::ui {

class CurveEditor;
class NumberLine;

/// A control function: drawn, and its chosen point in numbers.
class CurveField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::CurveField)
 public:
  CurveField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;

 private:
  void display(const Value&) override;
  void addToMenu(QMenu&) override;
  void showChosen();
  void typed();

  CurveEditor* editor_;
  NumberLine* t_;
  NumberLine* number_;
};

}  // namespace blossom::ui
