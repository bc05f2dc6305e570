#include "ui/page/page.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/look/units.h"
#include "ui/panel/fault_bar.h"
#include "ui/panel/overlaid_bars.h"
#include "ui/panel/property_panel.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/tools/choose_tool.h"
#include "ui/tools/measure_tool.h"
#include "ui/tools/pick_tool.h"
#include "ui/tools/section_tool.h"
#include "ui/tree/document_tree.h"
#include "ui/tree/document_tree_panel.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

ZebraLook preferredZebra() {
  const Preferences& preferences = Preferences::instance();
  return {preferences.get<int>("zebra-stripes"), preferences.get<double>("zebra-angle")};
}

bool holds(const std::vector<FeatureId>& ids, const FeatureId& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

DocumentPage::DocumentPage(App app, const ManipulatorRegistry& manipulators, QObject* parent)
    : QObject(parent),
      manipulators_(manipulators),
      session_(std::move(app)),
      look_(theme().look()),
      tree_(new DocumentTree(session_)),
      treePanel_(new DocumentTreePanel(tree_)),
      properties_(new PropertyPanel(session_)),
      view_(new ViewWidget),
      errors_(new ErrorBar),
      faults_(new FaultBar(session_)),
      timeline_(new TimelineBar(playback_)),
      tools_(std::make_unique<PageTools>(*this, manipulators_, *view_)) {
  view_->setSource(
      {[this] { return shownItems(); }, [this] { return overlayNow(); }, [this] { return scene_.reach(selection()); }});
  buildWidgets();
  connectSession();
  connectNotes();
  connectStudies();
  connectWidgets();
  connectKeys();
  view_->setLook(look_);
  view_->setZebra(preferredZebra());
}

// The widgets look at the session: they go first.
DocumentPage::~DocumentPage() {
  tools_->drop();
  delete side_;
  delete canvas_;
}

void DocumentPage::buildWidgets() {
  auto* side = new QSplitter(Qt::Vertical);
  side->setObjectName(QStringLiteral("sidePanel"));
  side->addWidget(treePanel_);
  side->addWidget(properties_);
  side->setSizes({320, 380});
  side->setStretchFactor(0, 1);
  side->setStretchFactor(1, 1);
  side->setHandleWidth(1);
  side->setChildrenCollapsible(false);
  side->setMinimumWidth(230);
  side_ = side;

  canvas_ = new QWidget;
  auto* column = new QVBoxLayout(canvas_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(view_, 1);
  column->addWidget(timeline_);
  timeline_->hide();
  notes_ = new OverlaidBars(*view_, {errors_, faults_});
}

std::vector<ViewItem> DocumentPage::shownItems() const { return scene_.items(tree_->selected()); }

bool DocumentPage::untouched() const {
  return session_.document().features().empty() && session_.file().empty() && !session_.modified() &&
         !session_.job().running() && !toolStarted();
}

std::shared_ptr<const SurfaceStudy> DocumentPage::studyOf(const Shape& shape) {
  studies_.makeRoomFor(document().features().size());
  const double chord = Preferences::instance().get<double>("drawing-tolerance");
  const int curves = Preferences::instance().get<int>("iso-curves");
  if (needsStudy(view_->displayMode())) studies_.want(shape, chord, curves);
  return studies_.known(shape, chord, curves);
}

void DocumentPage::setDisplayMode(DisplayMode mode) {
  studies_.allowAgain();
  view_->setDisplayMode(mode);
}

/// What the session tells of goes above the view.
void DocumentPage::followViews(const std::set<FeatureId>& features) {
  refreshTimeline();
  view_->markItems();
  if (features.contains(tree_->current())) view_->markOverlay();
  measurements_.documentChanged();
  if (Tool* const active = tool()) active->documentChanged();
  tools_->refreshHandles();
}

void DocumentPage::followPreference(const QString& name) {
  if (name == QLatin1String("navigation"))
    view_->setNavigation(navigationStyle(qt(Preferences::instance().get<std::string>("navigation"))));
  if (name == QLatin1String("zebra-stripes") || name == QLatin1String("zebra-angle")) view_->setZebra(preferredZebra());
  if (name == QLatin1String("iso-curves")) view_->markItems();
  if (name != QLatin1String("length-unit")) return;
  properties_->show(properties_->shown());
  tree_->viewport()->update();
  view_->setLook(look_);  // the grid
  emit measurements_.changed();
  if (Tool* const started = tools_->started()) started->documentChanged();
}

// The same command again puts the tool away.
void DocumentPage::startMeasuring() {
  if (measuring()) return endTool();
  start(std::make_unique<MeasureTool>(*this, measurements_, view_));
}
void DocumentPage::startSection() {
  if (dynamic_cast<SectionTool*>(tools_->started())) return endTool();
  start(std::make_unique<SectionTool>(*this, view_));
}

void DocumentPage::showChoice(std::optional<PageScene::Choice> choice) {
  scene_.choose(std::move(choice));
  view_->markItems();
}

void DocumentPage::choose(const QString& question, const std::vector<FeatureId>& features,
                          std::function<void(const FeatureId&)> then) {
  errors_->hide();
  properties_->endPick();
  auto tool = std::make_unique<ChooseTool>(*this, question, features, view_);
  const ChooseTool* const asking = tool.get();
  const auto answer = [this, asking, features, then = std::move(then)](const FeatureId& id) {
    if (tools_->started() != asking || !holds(features, id)) return;
    endTool();
    then(id);
  };
  // The answer ends the tool: not while it is at work.
  connect(
      asking, &PickTool::answered, this, [answer](const Pick& pick) { answer(pick.feature); }, Qt::QueuedConnection);
  connect(
      tree_, &DocumentTree::selectionChangedTo, asking, [this, answer] { answer(tree_->current()); }, Qt::QueuedConnection);
  start(std::move(tool));
  showChoice(PageScene::Choice{{features.begin(), features.end()}, false});
}

void DocumentPage::endQuestion() {
  const Tool* const started = tools_->started();
  if (dynamic_cast<const ChooseTool*>(started) || (started && started->drawsIn())) tools_->conclude();
}

bool DocumentPage::measuring() const { return dynamic_cast<MeasureTool*>(tools_->started()) != nullptr; }

/// While something coarser is shown, which may have fewer frames, the timeline stays where it is.
void DocumentPage::refreshFrames() {
  if (!session_.coarse()) {
    std::vector<double> beginnings = scene_.beginnings(selection());
    const int count = static_cast<int>(beginnings.size());
    playback_.setPace(std::move(beginnings));
    playback_.setCount(count);
    playback_.setOffered(count < 2 && offeredSequence());
  }
  refreshKeys();
}

/// It goes when all is computed, not while the sequence that is to be played is. It stays where that fails, so that the view
/// does not jump.
void DocumentPage::refreshTimeline() {
  refreshFrames();
  const bool wanted = playback_.playable() || keyedSequence().has_value();
  if (wanted || !session_.evaluating()) timeline_->setVisible(wanted);
}

std::vector<vtkSmartPointer<vtkProp>> DocumentPage::overlayNow() {
  std::vector<vtkSmartPointer<vtkProp>> props = scene_.skins(selection(), look_, pixelRatio());
  const auto add = [&](const std::vector<vtkSmartPointer<vtkProp>>& more) {
    props.insert(props.end(), more.begin(), more.end());
  };
  add(overlayOfSelected());
  add(measurements_.props());
  return props;
}

std::vector<vtkSmartPointer<vtkProp>> DocumentPage::overlayOfSelected() {
  const std::vector<FeatureId> selected = tree_->selected();
  if (selected.size() != 1) return {};
  try {
    return scene_.overlayOf(selected.front(), look_, pixelRatio());
  } catch (const std::exception& problem) {
    errors_->showError(tr("The handles of %1 cannot be shown.").arg(qt(document().at(selected.front()).name)),
                       qt(problem.what()));
    return {};
  }
}

void DocumentPage::showProperties() { properties_->show(tree_->selected().empty() ? FeatureId() : tree_->current()); }

// The view has to fit what the tool of the feature shows, too; the panel takes its time, so it is filled in a turn of its
// own.
void DocumentPage::selectLast() {
  fillPanelLater_ = true;
  tree_->selectLast();
  fillPanelLater_ = false;
  QMetaObject::invokeMethod(this, &DocumentPage::showProperties, Qt::QueuedConnection);
}

void DocumentPage::lookAtFirstShapes() {
  if (document().features().empty()) return;
  if (firstLook_.pending())
    firstLook_.show(*view_);
  else if (firstLook_.awaitsSolid() && showsSolid())
    firstLook_.showSolid(*view_, !toolStarted());
  else
    return;
  emit stateChanged();
}

bool DocumentPage::showsSolid() const {
  const std::vector<ViewItem> items = shownItems();
  return std::any_of(items.begin(), items.end(), [this](const ViewItem& item) {
    const Shape* shape = session_.shape(item.id);
    return shape && !item.scene.planar && (shape->kind() == ShapeKind::Brep || shape->kind() == ShapeKind::Mesh);
  });
}

void DocumentPage::showError(const Error& error, const QString& file) {
  errors_->showError(qt(error.message()), qt(error.hint()));
  const bool damagedDocument = error.code() == ErrorCode::FormatDamaged && !file.isEmpty() && isDocument(file.toStdString());
  if (damagedDocument) errors_->offer(tr("Open what is readable"), [this, file] { emit salvageWanted(file); });
}

}  // namespace blossom::ui
