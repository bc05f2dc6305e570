#pragma once
#include <QPointer>
#include <optional>
#include <vector>

#include "parameter/value.h"

namespace blossom::ui {

class ParameterField;
struct FeatureView;

/// Keeps the t of a feature that makes a sequence and the timeline one thing: the field shows the time of the frame that is
/// seen, and what is entered there leads to another frame.
class SequenceTime {
 public:
  /// The current place of the timeline.
  void setTimeline(int frame, int frames);
  /// What the field shows; nothing when it is no time of a frame, but a parameter like the others.
  [[nodiscard]] std::optional<double> shownBy(const ParameterField&, const FeatureView*);
  /// The same by the sequence that shownBy saw last: for the time that one of fewer frames is in its place.
  [[nodiscard]] std::optional<double> lastShownBy(const ParameterField&) const;
  /// The frame of the timeline that a time leads to; nothing when it is an edit. A step of a key or the wheel leads to the
  /// next frame, however far that is; what is dragged or typed leads to the nearest.
  std::optional<int> frameFor(const ParameterField&, const FeatureView*, const Value& time, bool preview);

 private:
  [[nodiscard]] const std::vector<double>* timesFor(const ParameterField&, const FeatureView*) const;
  [[nodiscard]] double timeNow(const std::vector<double>& times) const;

  int frame_ = 0, frames_ = 0;
  std::optional<double> steppedTo_;  // by keys or wheel, until they rest
  QPointer<const ParameterField> lastField_;
  std::vector<double> lastTimes_;  // what lastField_ showed one of
};

}  // namespace blossom::ui
