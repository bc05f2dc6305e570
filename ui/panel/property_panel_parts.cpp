// The part of PropertyPanel that knows faces, edges and points of the inputs: what they look like, and which are lost.
#include <utility>

#include "core/error.h"
#include "ui/fields/parameter_field.h"
#include "ui/panel/property_panel.h"
#include "ui/session/session.h"

namespace blossom::ui {

void PropertyPanel::provideParts() {
  context_->picking = true;
  context_->markChosen = [this](const std::vector<Pick>& chosen) { mark({chosen, marked_.pointed}); };
  context_->markPointed = [this](const std::optional<Pick>& pointed) { mark({marked_.chosen, pointed}); };
  context_->likenessOf = [&session = session_](const Pick& pick) -> std::optional<Likeness> {
    const auto view = session.view(pick.feature);
    if (!view) return std::nullopt;
    try {
      return likenessOf(view->shape, pick.part.kind, pick.part.index);
    } catch (const Error&) {
      return std::nullopt;  // the view shows a shape of before
    }
  };
}

// Fields go away after the panel, and chips tell then that the mouse has left them.
void PropertyPanel::forgetParts() {
  context_->markChosen = FieldContext().markChosen;
  context_->markPointed = FieldContext().markPointed;
}

void PropertyPanel::mark(MarkedParts parts) {
  marked_ = std::move(parts);
  emit partsMarked(marked_);
}

void PropertyPanel::refreshLost() {
  const auto view = session_.view(shown_);
  const std::vector<Value> lost = view ? view->result->lost : std::vector<Value>();
  if (lost == context_->lost) return;
  context_->lost = lost;
  for (ParameterField* field : form_->findChildren<ParameterField*>()) field->lostChanged();
}

}  // namespace blossom::ui
