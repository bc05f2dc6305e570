#pragma once
#include <QCoreApplication>
#include <array>

#include "ui/fields/parameter_field.h"

class QToolButton;

namespace blossom::ui {

class NumberLine;

/// Points and vectors: x, y and z in three lines, or picked in the view (of a vector: the normal of a face).
class VectorField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::VectorField)
 public:
  VectorField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;
  [[nodiscard]] Value written() const override;
  void setWritten(const Value&) override;
  bool takePick(const Pick&) override;
  void pickEnded() override;
  void hideLabel() override;

 private:
  void display(const Value&) override;
  void addToMenu(QMenu&) override;
  void finish(std::size_t axis);
  void takeTyped(std::size_t axis);
  void step(std::size_t axis, double steps, Qt::KeyboardModifiers);
  void togglePick(bool on);
  [[nodiscard]] bool typing() const;

  ParameterSpec component_;
  [[nodiscard]] QString plainText(double value) const;

  std::array<NumberLine*, 3> lines_{};
  QToolButton* pick_ = nullptr;
  Value shown_;
  std::array<QString, 3> expressions_;  // that the coordinates were typed as; empty: as plain numbers
};

}  // namespace blossom::ui
