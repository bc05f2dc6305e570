// What tools see of the workbench, and the sequence that is offered of what is selected.

#include "document/named_numbers.h"
#include "ui/controls/typed_expression.h"
#include "ui/look/text.h"
#include "ui/look/units.h"
#include "ui/page/page.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

std::optional<Feature> DocumentPage::offeredSequence() const {
  const std::vector<FeatureId> chosen = selection();
  if (chosen.size() != 1 || !document().contains(chosen.front())) return std::nullopt;
  Feature feature = document().at(chosen.front());
  const auto type = registry().find(feature.type);
  const auto made = result(feature.id);
  if (!type || feature.suppressed || !feature.visible || !made || made->error) return std::nullopt;
  const PlayedBy& played = type->playedBy;
  if (played.parameter.empty() || !feature.parameters.value(played.excludedBy, Value()).empty()) return std::nullopt;
  const Value given = feature.parameters.value(played.parameter, Value(0));
  if (!given.is_number() || given.get<double>() > 1) return std::nullopt;
  feature.parameters[played.parameter] = played.frames;
  return feature;
}

void DocumentPage::makeSequence() {
  if (const auto feature = offeredSequence())
    session_.commit(document().with(*feature), tr("Play %1").arg(qt(shownName(*feature))));
}

std::string DocumentPage::undoText() const {
  const QString own = tools_->started() ? tools_->started()->undoText() : QString();
  return own.isEmpty() ? session_.history().undoText() : own.toStdString();
}

std::string DocumentPage::redoText() const {
  const QString own = tools_->started() ? tools_->started()->redoText() : QString();
  return own.isEmpty() ? session_.history().redoText() : own.toStdString();
}

void DocumentPage::undo() {
  Tool* const started = tools_->started();
  if (started && !started->undoText().isEmpty()) return started->undo();
  session_.undo();
}

void DocumentPage::redo() {
  Tool* const started = tools_->started();
  if (started && !started->redoText().isEmpty()) return started->redo();
  session_.redo();
}

std::optional<QPointF> DocumentPage::onScreen(const Vec3& p) const { return view_->camera().project(p); }

Value DocumentPage::typed(const ParameterSpec& spec, const QString& text) const {
  return writtenTyped(spec, text, namedNumbersOf(document()));
}

std::shared_ptr<const FeatureResult> DocumentPage::result(const FeatureId& id) const {
  const auto view = session_.view(id);
  return view ? view->result : nullptr;
}

LengthUnit DocumentPage::lengthUnit() const { return ui::lengthUnit(); }

void DocumentPage::showOtherFrames(bool on) {
  scene_.showSkins(on);
  view_->markOverlay();
}

double DocumentPage::gridSpacing() const { return view_->gridSpacing(); }
double DocumentPage::pixelRatio() const { return view_->devicePixelRatioF(); }
QWidget* DocumentPage::viewWidget() const { return view_; }
Bounds DocumentPage::extent() const { return view_->extent(); }
std::optional<CutPlane> DocumentPage::section() const { return view_->section(); }
void DocumentPage::setSection(const std::optional<CutPlane>& plane) { view_->setSection(plane); }
std::vector<FeatureId> DocumentPage::selection() const { return tree_->selected(); }
void DocumentPage::select(const FeatureId& id) { tree_->select(id); }

}  // namespace blossom::ui
