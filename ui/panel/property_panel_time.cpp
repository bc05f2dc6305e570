// The part of PropertyPanel that keeps the t of a sequence and the timeline one thing.
#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/shape/sequence.h"
#include "ui/fields/parameter_field.h"
#include "ui/panel/property_panel.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

/// The place in a run of `to` frames that lies as far along as `place` does in one of `from`.
std::size_t alongside(std::size_t place, std::size_t from, std::size_t to) {
  if (from < 2 || to < 2) return 0;
  return static_cast<std::size_t>(
      std::lround(static_cast<double>(place) * static_cast<double>(to - 1) / static_cast<double>(from - 1)));
}

std::size_t nearestTo(const std::vector<double>& times, double wanted) {
  const auto nearest = std::min_element(
      times.begin(), times.end(), [wanted](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
  return static_cast<std::size_t>(nearest - times.begin());
}

}  // namespace

/// The times of the frames when the field is the t of a feature whose result is a sequence; else nullptr: then it is a
/// parameter like the others.
const std::vector<double>* PropertyPanel::timesFor(const ParameterField& field) const {
  if (field.spec().name != "t" || field.spec().kind != ParameterKind::Ratio || frames_ < 2) return nullptr;
  const auto view = session_.view(shown_);
  const Sequence* sequence = view && !view->result->error ? view->result->evaluated.shape.get<Sequence>() : nullptr;
  const bool timed = sequence && sequence->frames.size() > 1 && sequence->times.size() == sequence->frames.size();
  return timed ? &sequence->times : nullptr;
}

/// False when the field shows no time of a frame.
bool PropertyPanel::refreshTime(ParameterField& field) {
  const std::vector<double>* times = timesFor(field);
  if (!times) return false;
  const double now =
      times->at(alongside(static_cast<std::size_t>(frame_), static_cast<std::size_t>(frames_), times->size()));
  if (!field.editing() && field.value() != Value(now)) field.setValue(now);
  return true;
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
  frame_ = frame;
  frames_ = frames;
  refreshTimes();
}

/// True when the wish is one for another frame instead of an edit. A step of a key or the wheel is one to the next frame,
/// however far that is; what is dragged or typed leads to the nearest.
bool PropertyPanel::wantTime(ParameterField& field, const Value& time, bool preview) {
  const std::vector<double>* times = timesFor(field);
  if (!times || !time.is_number()) return false;
  const double wanted = time.get<double>();
  std::size_t place = alongside(static_cast<std::size_t>(frame_), static_cast<std::size_t>(frames_), times->size());
  if (preview && QGuiApplication::mouseButtons() == Qt::NoButton) {
    const double before = steppedTo_.value_or(field.value().get<double>());
    steppedTo_ = wanted;
    if (wanted > before) place = std::min(place + 1, times->size() - 1);
    if (wanted < before) place -= std::min<std::size_t>(place, 1);
  } else if (!std::exchange(steppedTo_, std::nullopt)) {
    place = nearestTo(*times, wanted);
  }
  emit frameWanted(static_cast<int>(alongside(place, times->size(), static_cast<std::size_t>(frames_))));
  refreshTimes();
  return true;
}

}  // namespace blossom::ui
