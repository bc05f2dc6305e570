// The path through the blossom, drawn on the pad of the card.
#include <vtkProp.h>

#include <utility>

#include "feature/registry.h"
#include "manipulators/morph_card.h"
#include "manipulators/morph_tool.h"
#include "manipulators/path_pad.h"
#include "parameter/written.h"

namespace blossom::minkowski {

void MorphTool::connectPad() {
  const PathPad& pad = card_->pad();
  connect(card_, &MorphCard::pathWanted, this, &MorphTool::setPathOpen);
  connect(&pad, &PathPad::dragged, this, &MorphTool::previewPath);
  connect(&pad, &PathPad::changed, this, &MorphTool::keepPath);
  connect(&pad, &PathPad::reverted, this, &MorphTool::putPathBack);
}

void MorphTool::setPathOpen(bool open) {
  habits_.path = open;
  refreshCard();
}

/// All of them: with fewer, a point of the path would seem to have other arguments.
bool MorphTool::shapesKnown() const { return controls_.size() == host().document().at(feature()).inputs.size(); }

/// A B-spline of shapes takes no path.
bool MorphTool::hasPath(const Value& parameters) const {
  return shapesKnown() && controls_.size() > 1 && hasLadder(parameters, controls_.size());
}

void MorphTool::refreshPad(const Value& parameters) {
  const bool possible = hasPath(parameters);
  card_->setPath(habits_.path, possible);
  if (!possible) return;
  const PathPoints path(parameters.at("path"), controls_.size() - 1);
  if (!drawingPath_ && path != card_->pad().path()) card_->pad().cancel();  // taken hold of, but not moved yet
  card_->pad().setPath(path);
  card_->pad().setPlace(placeSeen(parameters, timeSeen(parameters)));
}

/// Where there are no frames yet, a path makes as many as the timeline would ask for: it is a way for a sequence. Blossom
/// numbers of a single shape give way to it.
Document MorphTool::with(const PathPoints& path) const {
  Feature morph = base_.at(feature());
  const auto type = host().registry().at(morph.type);
  Value parameters = completed(type->parameters, morph.parameters);
  parameters["path"] = path.written();
  parameters["blossom"] = Value::array();
  if (parameters.at("frames").get<int>() == 0 && !moving_ && !path.isDiagonal())
    parameters["frames"] = type->playedBy.frames;
  morph.parameters = keepWritten(type->parameters, morph.parameters, parameters);
  return base_.with(std::move(morph));
}

void MorphTool::previewPath() {
  if (!drawingPath_) load();
  drawingPath_ = true;
  host().showOtherFrames(true);
  preview(with(card_->pad().path()), [this](const Document& exact) { return coarser(exact); });
}

void MorphTool::keepPath() {
  if (!drawingPath_) load();
  Document drawn = with(card_->pad().path());
  if (drawn.at(feature()) == base_.at(feature())) return putPathBack();
  drawingPath_ = false;
  host().showOtherFrames(false);
  commit(std::move(drawn), tr("Draw the path of the morph"));
}

void MorphTool::putPathBack() {
  drawingPath_ = false;
  host().showOtherFrames(false);
  endPreview();
}

/// Also of a path that is being drawn when the document changes otherwise, or the morph goes.
void MorphTool::revert() {
  if (card_) card_->pad().cancel();
  if (drawingPath_) putPathBack();
  HandleTool::revert();
}

}  // namespace blossom::minkowski
