#include "ui/panel/fault_bar.h"

#include <algorithm>

#include "ui/look/text.h"
#include "ui/session/session.h"

namespace blossom::ui {

FaultBar::FaultBar(const Session& session, QWidget* parent) : ErrorBar(parent), session_(session) {
  setObjectName(QStringLiteral("faultBar"));
  connect(&session, &Session::evaluationFinished, this, &FaultBar::refresh);
  connect(&session, &Session::opened, this, &FaultBar::forget);
}

void FaultBar::setSelected(const FeatureId& id) {
  selected_ = id;
  if (!session_.evaluating()) refresh();
}

// Inputs stand before what uses them: the first that failed is where it began.
const Feature* FaultBar::failed() const {
  const auto fails = [this](const auto& feature) {
    const auto view = session_.view(feature->id);
    return !feature->suppressed && !session_.outdated(feature->id) && view && view->result->error;
  };
  const auto features = session_.document().features();
  const auto isSelected = [this](const auto& feature) { return feature->id == selected_; };
  auto found = std::find_if(features.begin(), features.end(), isSelected);
  if (found == features.end() || !fails(*found)) found = std::find_if(features.begin(), features.end(), fails);
  return found == features.end() ? nullptr : found->get();
}

void FaultBar::refresh() {
  if (session_.previewing()) return;
  const Feature* const feature = failed();
  if (feature)
    tell(*feature);
  else
    forget();
}

void FaultBar::tell(const Feature& feature) {
  const Error& error = *session_.view(feature.id)->result->error;
  const QString why = qt(shownName(feature)) + QStringLiteral(": ") + qt(error.message());
  const bool elsewhere = feature.id != selected_, told = feature.id == told_ && why == why_;
  if (told && (isHidden() || elsewhere == wayOffered_)) return;
  told_ = feature.id;
  why_ = why;
  wayOffered_ = elsewhere;
  showError(why, qt(error.hint()));
  if (!elsewhere) return;
  offer(tr("Show the feature"), [this, id = feature.id] {
    forget();  // the way to it is no dismissal
    emit featureWanted(qt(id));
  });
}

void FaultBar::forget() {
  told_.clear();
  why_.clear();
  hide();
}

}  // namespace blossom::ui
