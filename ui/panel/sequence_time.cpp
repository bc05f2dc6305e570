#include "ui/panel/sequence_time.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/shape/sequence.h"
#include "ui/fields/parameter_field.h"
#include "ui/session/display_cache.h"

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

void SequenceTime::setTimeline(int frame, int frames) {
  frame_ = frame;
  frames_ = frames;
}

/// The times of the frames when the field is the t of a feature whose result is a sequence; else nullptr.
const std::vector<double>* SequenceTime::timesFor(const ParameterField& field, const FeatureView* view) const {
  if (field.spec().name != "t" || field.spec().kind != ParameterKind::Ratio || frames_ < 2) return nullptr;
  const Sequence* sequence = view && !view->result->error ? view->result->evaluated.shape.get<Sequence>() : nullptr;
  const bool timed = sequence && sequence->frames.size() > 1 && sequence->times.size() == sequence->frames.size();
  return timed ? &sequence->times : nullptr;
}

double SequenceTime::timeNow(const std::vector<double>& times) const {
  return times.at(alongside(static_cast<std::size_t>(frame_), static_cast<std::size_t>(frames_), times.size()));
}

std::optional<double> SequenceTime::shownBy(const ParameterField& field, const FeatureView* view) {
  const std::vector<double>* times = timesFor(field, view);
  if (!times) {
    if (lastField_ == &field) lastField_ = nullptr;  // others are asked for as well, and have nothing to do with it
    return std::nullopt;
  }
  lastField_ = &field;
  lastTimes_ = *times;
  return timeNow(lastTimes_);
}

std::optional<double> SequenceTime::lastShownBy(const ParameterField& field) const {
  return lastField_ == &field ? std::optional(timeNow(lastTimes_)) : std::nullopt;
}

std::optional<int> SequenceTime::frameFor(const ParameterField& field, const FeatureView* view, const Value& time,
                                          bool preview) {
  const std::vector<double>* times = timesFor(field, view);
  if (!times || !time.is_number()) return std::nullopt;
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
  return static_cast<int>(alongside(place, times->size(), static_cast<std::size_t>(frames_)));
}

}  // namespace blossom::ui
