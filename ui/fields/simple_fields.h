#pragma once
#include <QCoreApplication>

#include "ui/fields/parameter_field.h"

class QComboBox;
class QLineEdit;

namespace blossom::ui {

class RatioSlider;
class SwitchBox;

class FlagField final : public ParameterField {
 public:
  FlagField(const ParameterSpec&, const Context&, QWidget* parent);

 private:
  void display(const Value&) override;
  SwitchBox* box_;
};

class ChoiceField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::ChoiceField)
 public:
  ChoiceField(const ParameterSpec&, const Context&, QWidget* parent);

 private:
  void display(const Value&) override;
  bool eventFilter(QObject*, QEvent*) override;
  QComboBox* box_;
};

class RatioField final : public ParameterField {
 public:
  RatioField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;

 private:
  void display(const Value&) override;
  RatioSlider* slider_;
};

class TextField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::TextField)
 public:
  TextField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;

 private:
  void display(const Value&) override;
  QLineEdit* line_;
};

}  // namespace blossom::ui
