// The card of the morph tool, and the ladder that it switches.
#include <vtkProp.h>

#include <algorithm>
#include <functional>

#include "core/error.h"
#include "feature/registry.h"
#include "geometry/measure/measure.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/sequence.h"
#include "kernel/morph/shape_spline.h"
#include "manipulators/influence_chart.h"
#include "manipulators/morph_card.h"
#include "manipulators/morph_tool.h"
#include "sector_values.h"
#include "ui/look/text.h"

namespace blossom::minkowski {

void MorphTool::makeCard() {
  QWidget* const view = host().viewWidget();
  if (!view) return;
  card_ = new MorphCard(view);
  connect(card_, &MorphCard::ladderWanted, this, &MorphTool::setLadder);
  connect(card_, &MorphCard::influencesWanted, this, [this](bool on) {
    habits_.influences = on;
    refreshCard();
  });
  connectPad();
  card_->show();
}

void MorphTool::setLadder(bool on) {
  habits_.ladder = on;
  if (!on) legShown_.reset();
  refreshCard();
  emit changed();
}

void MorphTool::documentChanged() {
  HandleTool::documentChanged();
  refreshCard();
}

/// Control shapes that are sequences are seen as they are in the frame of the timeline.
void MorphTool::frameMoved() {
  if (moving_)
    documentChanged();
  else
    refreshCard();
}

/// Of a sequence the frame that the timeline shows.
const Shape& MorphTool::shapeSeen(const Shape& shape) const {
  const Sequence* sequence = shape.get<Sequence>();
  if (!sequence || sequence->frames.empty()) return shape;
  const int count = static_cast<int>(sequence->frames.size());
  return sequence->frames[static_cast<std::size_t>(std::clamp(host().shownFrame(count), 0, count - 1))];
}

/// The t of the frame that is seen when the morph makes frames itself; in a sequence that comes from its control shapes all
/// frames have the same. As many frames count as the document asks for: while something is dragged there may be fewer.
std::optional<double> MorphTool::timeSeen(const Value& parameters) const {
  const auto result = host().result(feature());
  const bool sequence = result && !result->error && result->evaluated.shape.get<Sequence>();
  const int count = parameters.at("frames").get<int>();
  if (!sequence || count == 0) return std::nullopt;
  return timeOfFrame(parameters, std::clamp(host().shownFrame(count), 0, count - 1), count);
}

/// The area is computed once for each shape that is seen, however often the mouse moves. Until the shape of another t has
/// come, no area is told: that of the shape before is not its own.
QString MorphTool::figures(const Region* seen) {
  if (!seen) return {};
  const auto result = host().result(feature());
  const bool anew = measured_ != result || measuredRegion_ != seen;
  if (anew) {
    area_ = area(*seen);
    measured_ = result;
    measuredRegion_ = seen;
    measuredLevels_ = levels_;
  }
  const QString told =
      measuredLevels_ == levels_ ? ui::readable(Measure{"area", area_, MeasureUnit::Area}) : QString(QChar(0x2026));
  QStringList numbers;
  const bool same = std::adjacent_find(levels_.begin(), levels_.end(), std::not_equal_to<>()) == levels_.end();
  for (const double t : levels_) numbers << QString::number(t, 'g', 4);
  if (same && !numbers.isEmpty()) numbers = QStringList(numbers.front());
  return tr("t %1 · area %2").arg(numbers.join(QStringLiteral(", ")), told);
}

QString MorphTool::ladderNote(const Value& parameters) const {
  if (habits_.path && shapesKnown() && !hasPath(parameters)) return tr("A morph with a degree or knots has no path.");
  if (!habits_.ladder) return {};
  if (!hasLadder(parameters, controls_.size())) return tr("A morph with a degree or knots has no ladder.");
  if (controls_.size() < 3) return tr("Three control shapes or more have a ladder.");
  if (QString leg = legNote(); !leg.isEmpty()) return leg;
  return ladder_ && !ladder_->complete ? tr("Some of the ladder takes too long to be drawn.") : QString();
}

void MorphTool::refreshCard() {
  if (!host().document().contains(feature())) return;
  const Feature& morph = host().document().at(feature());
  Value parameters;
  try {
    parameters = completed(host().registry().at(morph.type)->parameters, morph.parameters);
  } catch (const Error&) {
    return;  // the feature tells what is wrong
  }
  levels_ = levelsSeen(parameters, controls_.size(), timeSeen(parameters));
  askLadder(parameters);
  if (!card_) return;
  const auto result = host().result(feature());
  card_->setFigures(figures(result && !result->error ? shapeSeen(result->evaluated.shape).get<Region>() : nullptr));
  card_->setLadder(habits_.ladder);
  refreshPad(parameters);
  card_->setNote(ladderNote(parameters));
  showInfluences(parameters);
}

/// Nothing is drawn of knots that cannot be, which the feature tells.
void MorphTool::showInfluences(const Value& parameters) {
  bool possible = habits_.influences && controls_.size() > 1;
  try {
    if (possible)
      card_->chart().setMorph(
          knotsFor(controls_.size(), parameters.at("degree").get<int>(), parameters.at("knots").get<std::vector<double>>()),
          levels_);
  } catch (const Error&) {
    possible = false;
  }
  card_->setInfluences(habits_.influences, possible);
}

void MorphTool::askLadder(const Value& parameters) {
  forgetOldLadder();
  const bool possible =
      controls_.size() > 2 && levels_.size() + 1 == controls_.size() && hasLadder(parameters, controls_.size());
  if (!habits_.ladder || !possible) {
    ladder_.reset();
    forgetLostLeg();
    return loader_.ask(std::nullopt);
  }
  LadderQuestion question;
  question.t = levels_;
  question.sectors = sectorsIn(parameters.at("sectors").get<std::vector<Value>>());
  if (const Value& given = parameters.at("tolerance"); given.is_number()) question.tolerance = given.get<double>();
  try {
    for (std::size_t i = 0; i < controls_.size(); ++i)
      question.shapes.push_back(placed(controls_[i].region, placements_[i]));
  } catch (const Error&) {
    ladder_.reset();
    forgetLostLeg();
    return loader_.ask(std::nullopt);
  }
  loader_.ask(std::move(question));
}

}  // namespace blossom::minkowski
