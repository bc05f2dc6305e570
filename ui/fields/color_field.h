#pragma once
#include <QCoreApplication>
#include <QPointer>

#include "ui/fields/parameter_field.h"

class QColorDialog;
class QLineEdit;

namespace blossom::ui {

class Swatch;

/// A swatch that opens the colour dialog, and the colour written as #rrggbb or by its name.
class ColorField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::ColorField)
 public:
  ColorField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;

 private:
  void display(const Value&) override;
  void choose();

  Swatch* swatch_;
  QLineEdit* line_;
  QPointer<QColorDialog> dialog_;
};

}  // namespace blossom::ui
