#pragma once
#include <QCoreApplication>

#include "ui/fields/parameter_field.h"

class QToolButton;

namespace blossom::ui {

class FlowLayout;

/// Faces, edges or vertices of the inputs as chips: one, or several (a list of sub-shapes). Picking a chosen one removes it.
/// One that was lost is marked; a part that is picked takes its place where it lies near.
class SubShapeField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::SubShapeField)
 public:
  SubShapeField(const ParameterSpec&, const Context&, QWidget* parent);
  bool takePick(const Pick&) override;
  void pickEnded() override;
  void lostChanged() override { display(value()); }

 private:
  void display(const Value&) override;
  void addToMenu(QMenu&) override;
  void togglePick(bool on);
  void remove(std::size_t index);
  void addChip(const Value& part, std::size_t index);
  void markChosen();
  [[nodiscard]] bool picking() const;
  void pointAt(const Value& part, bool);
  [[nodiscard]] std::optional<Pick> pickOf(const Value& part) const;
  [[nodiscard]] bool several() const { return spec().kind == ParameterKind::List; }
  [[nodiscard]] const ParameterSpec& element() const { return several() ? spec().fields.at(0) : spec(); }
  [[nodiscard]] Value items() const;  ///< always a list

  QWidget* chips_;
  FlowLayout* flow_;
  QToolButton* pick_ = nullptr;
  Value pointed_;  ///< the part whose chip the mouse is on, or null
};

}  // namespace blossom::ui
