// The part of PropertyPanel that shows the time of the frame in the view in the field "t", and turns edits of it into wishes
// for a frame.
#include "ui/fields/parameter_field.h"
#include "ui/panel/property_panel.h"
#include "ui/session/session.h"

namespace blossom::ui {

/// False when the field shows no time of a frame.
bool PropertyPanel::refreshTime(ParameterField& field) {
  const auto now = session_.coarse() ? time_.lastShownBy(field) : time_.shownBy(field, session_.view(shown_).get());
  if (now && !field.editing() && field.value() != Value(*now)) field.setValue(*now);
  return now.has_value();
}

// What showed the time of a frame and does no longer shows what the document holds.
void PropertyPanel::refreshTimes() {
  if (shown_.empty() || !session_.document().contains(shown_)) return;
  const Feature& feature = session_.document().at(shown_);
  for (ParameterField* field : fields_) {
    if (field->spec().name != "t" || refreshTime(*field) || field == previewed_) continue;
    const auto given = feature.parameters.find("t");
    refreshField(*field, given == feature.parameters.end() || given->is_null() ? field->spec().fallback : *given);
  }
}

void PropertyPanel::setTimeline(int frame, int frames) {
  time_.setTimeline(frame, frames);
  refreshTimes();
}

/// True when the wish is one for another frame instead of an edit.
bool PropertyPanel::wantTime(ParameterField& field, const Value& time, bool preview) {
  const std::optional<int> frame = time_.frameFor(field, session_.view(shown_).get(), time, preview);
  if (!frame) return false;
  emit frameWanted(*frame);
  refreshTimes();
  return true;
}

}  // namespace blossom::ui
