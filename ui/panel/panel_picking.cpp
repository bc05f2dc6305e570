#include "ui/panel/panel_picking.h"

#include <utility>

#include "ui/fields/parameter_field.h"
#include "ui/panel/input_editor.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

void PanelPicking::want(ParameterField* field, InputEditor* input, const PickRequest& request) {
  end();
  field_ = field;
  input_ = input;
  wanted_ = request;
  emit begun(request);
}

bool PanelPicking::isFor(const ParameterField* field) const { return wanted_ && field_.data() == field; }

bool PanelPicking::isFor(const InputEditor* input) const { return wanted_ && input_.data() == input; }

void PanelPicking::offer(const Pick& pick) {
  if (!wanted_) return;
  const bool taken = field_ ? field_->takePick(pick) : input_ && input_->takePick(pick);
  if (taken && wanted_ && !wanted_->several) end();
}

void PanelPicking::end() {
  if (!wanted_) return;
  wanted_.reset();
  const QPointer<ParameterField> field = std::exchange(field_, nullptr);
  const QPointer<InputEditor> input = std::exchange(input_, nullptr);
  if (field) field->pickEnded();
  if (input) input->pickEnded();
  emit ended();
}

}  // namespace blossom::ui
