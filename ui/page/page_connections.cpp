// What a page's session, panels and view tell one another.
#include "ui/page/page.h"

#include <QLabel>
#include <algorithm>

#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/panel/fault_bar.h"
#include "ui/panel/property_panel.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/tools/pick_tool.h"
#include "ui/tools/point_tool.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

const QString evaluationKey = QStringLiteral("a");
const QString jobKey = QStringLiteral("b");
const QString studyKey = QStringLiteral("c");

}  // namespace

void DocumentPage::connectSession() {
  connect(&session_, &Session::documentChanged, this, [this] {
    errors_->documentChanged();
    refreshFrames();
    view_->markItems();
    measurements_.documentChanged();
    if (Tool* const active = tool()) active->documentChanged();
    tools_->refreshHandles();
    emit stateChanged();
  });
  connect(&session_, &Session::opened, this, [this] {
    endTool();
    firstLook_.expect();
    errors_->hide();
    view_->setItems({});
    measurements_.clear();
    view_->setSection(std::nullopt);
    view_->setOverlay({});
    emit opened();
  });
  connect(&session_, &Session::fileChanged, this, &DocumentPage::stateChanged);
  connect(&session_, &Session::viewsChanged, this, &DocumentPage::followViews);
  connect(&session_, &Session::evaluationOverdue, view_, &ViewWidget::markItems);
  connect(&session_, &Session::evaluationStarted, this, [this] { emit workChanged(evaluationKey, tr("Computing"), 0); });
  connect(&session_, &Session::evaluationProgressed, this, [this](double fraction, const QString& stage) {
    emit workChanged(evaluationKey, stage.isEmpty() ? tr("Computing") : stage, fraction);
  });
  connect(&session_, &Session::evaluationFinished, this, [this] {
    emit workEnded(evaluationKey);
    if (firstLook_.pending() && tree_->selected().empty()) selectLast();
    if (firstLook_.pending()) tree_->scrollToTop();
    refreshTimeline();
    if (!session_.evaluating()) playback_.forgetWish();
    view_->markItems();
    view_->markOverlay();
    lookAtFirstShapes();
  });
  connect(&session_, &Session::featureAdded, this, [this](const QString& id) {
    errors_->hide();  // what the command before could not do
    tree_->selectAdded(id.toStdString());
  });
  connect(&session_, &Session::noted, this, &DocumentPage::announced);
  const Job& job = session_.job();
  connect(&job, &Job::started, this, [this](const QString& title) { emit workChanged(jobKey, title, 0); });
  connect(&job, &Job::progressed, this, [this](double fraction, const QString& stage) {
    emit workChanged(jobKey, stage.isEmpty() ? tr("Working") : stage, fraction);
  });
  connect(&job, &Job::finished, this, [this] {
    emit workEnded(jobKey);
    QMetaObject::invokeMethod(this, &DocumentPage::stateChanged, Qt::QueuedConnection);  // when what was read is shown
  });
}

/// What a display of surfaces needs comes later; until then shapes are drawn as ever.
void DocumentPage::connectStudies() {
  scene_.setStudies([this](const Shape& shape) { return studyOf(shape); });
  connect(&studies_, &SurfaceStudies::arrived, view_, &ViewWidget::markItems);
  connect(&studies_, &SurfaceStudies::started, this,
          [this] { emit workChanged(studyKey, tr("Looking at the surfaces"), 0); });
  connect(&studies_, &SurfaceStudies::progressed, this, [this](double fraction) {
    if (studies_.running()) emit workChanged(studyKey, tr("Looking at the surfaces"), fraction);
  });
  connect(&studies_, &SurfaceStudies::ended, this, [this] { emit workEnded(studyKey); });
  connect(&studies_, &SurfaceStudies::failed, errors_, &ErrorBar::showError);
}

void DocumentPage::connectNotes() {
  connect(&session_, &Session::failed, this, &DocumentPage::showError);
  connect(&session_, &Session::warned, this, [this](const QStringList& sentences) {
    errors_->showNote(tr("Not everything could be read."), sentences.join(u'\n'));
  });
  connect(&session_, &Session::exportWarned, this, [this](const QStringList& sentences) {
    errors_->showNote(tr("The file was written; look at this before you use it."), sentences.join(u'\n'));
  });
  connect(&session_, &Session::filesWithheld, this, [this](const QStringList& files) {
    const QString before = errors_->isHidden() ? QString() : errors_->message() + u'\n' + errors_->hint() + u'\n';
    errors_->showNote(tr("This document names files outside its folder. They were not read."), before + files.join(u'\n'));
    errors_->offer(tr("Read them"), [this] { session_.allowFiles(); });
  });
  connect(&session_, &Session::evaluationCancelled, this, [this] {
    errors_->showNote(tr("Computing was cancelled."), tr("What was ready is shown."));
    errors_->offer(tr("Compute"), [this] { session_.compute(); });
    errors_->untilChange();
  });
}

void DocumentPage::connectWidgets() {
  connect(&measurements_, &Measurements::changed, view_, &ViewWidget::markOverlay);
  connect(&playback_, &Playback::moved, view_, &ViewWidget::markItems);
  const auto tellTime = [this] { properties_->setTimeline(playback_.frame(), playback_.count()); };
  connect(&playback_, &Playback::moved, this, tellTime);
  connect(&playback_, &Playback::moved, this, [this] {
    if (Tool* const active = tool()) active->frameMoved();
  });
  connect(&playback_, &Playback::changed, this, tellTime);
  connect(&playback_, &Playback::changed, this, &DocumentPage::stateChanged);
  connect(properties_, &PropertyPanel::frameWanted, &playback_, &Playback::show);
  connect(&playback_, &Playback::wanted, this, &DocumentPage::makeSequence);
  connect(&playback_, &Playback::changed, view_, &ViewWidget::markOverlay);
  connect(tree_, &DocumentTree::selectionChangedTo, this, [this] {
    if (!fillPanelLater_) showProperties();
    faults_->setSelected(tree_->selected().empty() ? FeatureId() : tree_->current());
    refreshTimeline();
    view_->markItems();
    view_->markOverlay();
    tools_->refreshHandles();
    emit selectionChanged();
  });
  connect(view_, &ViewWidget::picked, this,
          [this](const QString& id, bool extend) { tree_->select(id.toStdString(), extend); });
  connect(view_, &ViewWidget::contextMenuWanted, this, [this](const QPoint& global, const Pick& pick) {
    const std::vector<FeatureId> selected = tree_->selected();
    if (std::find(selected.begin(), selected.end(), pick.feature) == selected.end()) tree_->select(pick.feature);
    emit contextMenuWanted(global);
  });
  connect(view_, &ViewWidget::hint, this, &DocumentPage::hint);
  for (const ErrorBar* bar : {errors_, static_cast<ErrorBar*>(faults_)})
    connect(bar, &ErrorBar::focusFreed, view_, [this] { view_->setFocus(); });
  connect(timeline_, &TimelineBar::focusFreed, view_, [this] { view_->setFocus(); });
  connect(faults_, &FaultBar::featureWanted, this, [this](const QString& id) { tree_->select(id.toStdString()); });
  connect(view_, &ViewWidget::whereabouts, this, &DocumentPage::whereabouts);
  connect(tree_, &DocumentTree::hint, this, &DocumentPage::hint);
  connect(tree_, &DocumentTree::contextMenuWanted, this, &DocumentPage::contextMenuWanted);
  connect(tree_, &DocumentTree::refused, this, [this](const Error& error, const std::vector<Offer>& offers) {
    showError(error);
    for (const Offer& offer : offers) errors_->offer(offer.label, offer.go);
    errors_->untilChange();
  });
  connect(properties_, &PropertyPanel::hint, this, &DocumentPage::hint);
  connect(properties_, &PropertyPanel::manualWanted, this, &DocumentPage::manualWanted);
  connect(tools_.get(), &PageTools::changed, this, &DocumentPage::toolChanged);
  connect(tools_.get(), &PageTools::drawn, this, [this] { firstLook_.drawn(); });
  connect(tools_.get(), &PageTools::stepsChanged, this, &DocumentPage::stateChanged);
  connect(tools_.get(), &PageTools::hint, this, &DocumentPage::hint);
  connect(tools_.get(), &PageTools::failed, this, [this](const Error& error) { showError(error); });
  connectPicking();
  view_->setNavigation(navigationStyle(qt(Preferences::instance().get<std::string>("navigation"))));
  connect(&Preferences::instance(), &Preferences::changed, this, &DocumentPage::followPreference);
  connect(&ThemeManager::instance(), &ThemeManager::changed, this, [this] {
    look_ = theme().look();
    view_->setLook(look_);
    view_->markOverlay();
    tree_->viewport()->update();
  });
}

void DocumentPage::connectPicking() {
  connect(view_, &ViewWidget::toolDismissed, this, &DocumentPage::endTool);
  const auto picking = [this] { return qobject_cast<PickTool*>(tools_->started()) != nullptr; };
  connect(properties_, &PropertyPanel::pickWanted, this, [this](const PickRequest& request) {
    auto tool = request.want == PickRequest::Want::Point ? std::make_unique<PointTool>(*this, request)
                                                         : std::make_unique<PickTool>(*this, request);
    connect(tool.get(), &PickTool::answered, properties_, &PropertyPanel::offerPick);
    const bool parts = request.want == PickRequest::Want::SubShape;
    start(std::move(tool));
    if (parts) showChoice(PageScene::Choice{{request.features.begin(), request.features.end()}, true});
  });
  connect(properties_, &PropertyPanel::partsMarked, view_, &ViewWidget::setMarkedParts);
  connect(properties_, &PropertyPanel::pickEnded, this, [this, picking] {
    if (picking()) endTool();
  });
  connect(this, &DocumentPage::toolChanged, properties_, [this, picking] {
    if (!picking()) showChoice(std::nullopt);
    if (!picking() && properties_->wanted()) properties_->endPick();
  });
}

// Sequences of features that are shown move together; the longest gives the count.

}  // namespace blossom::ui
