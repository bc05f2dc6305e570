#include "ui/main_window.h"

#include <QKeyEvent>
#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/document_tree.h"
#include "ui/error_bar.h"
#include "ui/feature_menus.h"
#include "ui/manipulator_loader.h"
#include "ui/property_panel.h"
#include "ui/start_page.h"
#include "ui/status_line.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/view_widget.h"

namespace blossom::ui {

namespace {

constexpr int sideWidth = 290;

QWidget* withTitle(const QString& title, QWidget* content) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 14, 0, 4);
  column->setSpacing(8);
  auto* label = new QLabel(title);
  label->setObjectName(QStringLiteral("sectionTitle"));
  label->setContentsMargins(16, 0, 16, 0);
  column->addWidget(label);
  column->addWidget(content, 1);
  return box;
}

QStringList problemsOf(const App& app) {
  QStringList problems;
  for (const LoadedPlugin& plugin : app.plugins)
    if (!plugin.problem.empty()) problems << qt(plugin.problem);
  return problems;
}

}  // namespace

MainWindow::MainWindow(App app, QWidget* parent)
    : QMainWindow(parent),
      session_(std::move(app)),
      featureMenus_(new FeatureMenus(session_, this)),
      tree_(new DocumentTree(session_)),
      properties_(new PropertyPanel(session_)),
      view_(new ViewWidget),
      errors_(new ErrorBar),
      status_(new StatusLine),
      start_(new StartPage) {
  setAcceptDrops(true);
  setUnifiedTitleAndToolBarOnMac(true);
  QStringList problems = problemsOf(session_.app());
  for (const std::string& problem : loadManipulators(manipulators_, session_.app().plugins)) problems << qt(problem);
  buildActions();
  buildLayout();
  connectSession();
  connectView();
  connect(&ThemeManager::instance(), &ThemeManager::changed, this, [this] {
    view_->setLook(theme().look());
    refreshOverlay();
    tree_->viewport()->update();
  });
  view_->setLook(theme().look());
  refreshActions();
  refreshStart();
  status_->setHint(ViewWidget::idleHint());
  if (!problems.isEmpty()) errors_->showNote(tr("Not every plugin could be loaded."), problems.join(u'\n'));
}

// The widgets look at the session: they go first.
MainWindow::~MainWindow() { delete takeCentralWidget(); }

void MainWindow::buildLayout() {
  auto* side = new QSplitter(Qt::Vertical);
  side->setObjectName(QStringLiteral("sidePanel"));
  side->addWidget(withTitle(tr("DOCUMENT"), tree_));
  side->addWidget(properties_);
  side->setSizes({250, 450});
  side->setStretchFactor(0, 2);
  side->setStretchFactor(1, 3);
  side->setHandleWidth(1);
  side->setChildrenCollapsible(false);

  auto* canvas = new QWidget;
  auto* column = new QVBoxLayout(canvas);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(errors_);
  column->addWidget(view_, 1);
  start_->setParent(view_);

  auto* across = new QSplitter(Qt::Horizontal);
  across->addWidget(side);
  across->addWidget(canvas);
  across->setSizes({sideWidth, 1100});
  across->setStretchFactor(1, 1);
  across->setHandleWidth(1);
  across->setChildrenCollapsible(false);
  side->setMinimumWidth(230);

  auto* all = new QWidget;
  auto* rows = new QVBoxLayout(all);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(across, 1);
  rows->addWidget(status_);
  setCentralWidget(all);
}

void MainWindow::connectSession() {
  connect(&session_, &Session::documentChanged, this, [this] {
    refreshView();
    refreshActions();
    refreshStart();
  });
  connect(&session_, &Session::opened, this, [this] {
    fitPending_ = true;
    errors_->hide();
    view_->setItems({});
    view_->setOverlay({});
    if (!session_.file().empty()) remember(qt(session_.file().string()));
  });
  connect(&session_, &Session::fileChanged, this, &MainWindow::refreshActions);
  connect(&session_, &Session::viewChanged, this, [this](const QString& id) {
    refreshView();
    if (id.toStdString() == tree_->current()) refreshOverlay();
  });
  connect(&session_, &Session::evaluationStarted, this,
          [this] { status_->setWork(QStringLiteral("a"), tr("Computing"), 0); });
  connect(&session_, &Session::evaluationProgressed, this, [this](double fraction, const QString& stage) {
    status_->setWork(QStringLiteral("a"), stage.isEmpty() ? tr("Computing") : stage, fraction);
  });
  connect(&session_, &Session::evaluationFinished, this, [this] {
    status_->endWork(QStringLiteral("a"));
    if (fitPending_ && tree_->selected().empty()) tree_->selectLast();
    refreshView();
    refreshOverlay();
    fitWhenFirstShown();
  });
  connect(&session_, &Session::featureAdded, this, [this](const QString& id) { tree_->select(id.toStdString()); });
  connect(&session_, &Session::failed, this, &MainWindow::showError);
  connect(&session_, &Session::warned, this, [this](const QStringList& sentences) {
    errors_->showNote(tr("Not everything could be read."), sentences.join(u'\n'));
  });
  connect(&session_, &Session::noted, status_, &StatusLine::announce);
  Job& job = session_.job();
  connect(&job, &Job::started, this, [this](const QString& title) { status_->setWork(QStringLiteral("b"), title, 0); });
  connect(&job, &Job::progressed, this, [this](double fraction, const QString& stage) {
    status_->setWork(QStringLiteral("b"), stage.isEmpty() ? tr("Working") : stage, fraction);
  });
  connect(&job, &Job::finished, this, [this] {
    status_->endWork(QStringLiteral("b"));
    QMetaObject::invokeMethod(this, &MainWindow::refreshStart, Qt::QueuedConnection);  // when what was read is shown
  });
  connect(status_, &StatusLine::cancelled, &session_, &Session::cancel);
}

void MainWindow::connectView() {
  connect(tree_, &DocumentTree::selectionChangedTo, this, &MainWindow::selectionChanged);
  connect(view_, &ViewWidget::picked, this,
          [this](const QString& id, bool extend) { tree_->select(id.toStdString(), extend); });
  connect(view_, &ViewWidget::hint, status_, &StatusLine::setHint);
  connect(view_, &ViewWidget::whereabouts, status_, &StatusLine::setWhereabouts);
  connect(tree_, &DocumentTree::hint, status_, &StatusLine::setHint);
  connect(properties_, &PropertyPanel::hint, status_, &StatusLine::setHint);
  connect(featureMenus_, &FeatureMenus::hint, status_, &StatusLine::setHint);
  connect(start_, &StartPage::openWanted, this, &MainWindow::chooseAndOpen);
  connect(start_, &StartPage::importWanted, this, &MainWindow::chooseAndImport);
  connect(start_, &StartPage::fileChosen, this, &MainWindow::openFile);
}

void MainWindow::selectionChanged() {
  const FeatureId current = tree_->selected().empty() ? FeatureId() : tree_->current();
  properties_->show(current);
  featureMenus_->setSelection(tree_->selected());
  refreshView();
  refreshOverlay();
  refreshActions();
}

void MainWindow::refreshView() {
  const std::vector<FeatureId> selected = tree_->selected();
  const auto holds = [](const std::vector<FeatureId>& ids, const FeatureId& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  std::vector<FeatureId> controls;
  for (const FeatureId& id : selected)
    if (session_.document().contains(id)) {
      const auto& inputs = session_.document().at(id).inputs;
      controls.insert(controls.end(), inputs.begin(), inputs.end());
    }
  std::vector<ViewItem> items;
  for (const auto& feature : session_.document().features()) {
    const auto view = session_.view(feature->id);
    if (!feature->visible || feature->suppressed || !view || view->scene.empty()) continue;
    const ItemRole role = holds(selected, feature->id)   ? ItemRole::Made
                          : holds(controls, feature->id) ? ItemRole::Control
                                                         : ItemRole::Plain;
    items.push_back({feature->id, view->scene, role});
  }
  view_->setItems(items);
}

void MainWindow::refreshOverlay() {
  const FeatureId id = tree_->selected().size() == 1 ? tree_->selected().front() : FeatureId();
  const auto view = session_.view(id);
  if (id.empty() || !session_.document().contains(id) || !view || view->result->error) return view_->setOverlay({});
  const Feature& feature = session_.document().at(id);
  const Overlay* overlay = feature.visible ? manipulators_.overlay(feature.type) : nullptr;
  std::vector<Shape> inputs;
  for (const FeatureId& input : feature.inputs) {
    const auto shown = session_.view(input);
    if (!shown) return view_->setOverlay({});
    inputs.push_back(shown->result->evaluated.shape);
  }
  if (!overlay) return view_->setOverlay({});
  try {
    view_->setOverlay((*overlay)({feature, inputs, view->result->evaluated.shape, theme().look()}));
  } catch (const std::exception& problem) {
    view_->setOverlay({});
    errors_->showError(tr("The handles of %1 cannot be shown.").arg(qt(feature.name)), qt(problem.what()));
  }
}

void MainWindow::fitWhenFirstShown() {
  if (!fitPending_ || session_.document().features().empty()) return;
  fitPending_ = false;
  view_->lookFrom(QStringLiteral("auto"), false);
  parallel_->setChecked(view_->parallel());
}

void MainWindow::refreshStart() {
  const bool empty = session_.document().features().empty() && !session_.job().running();
  if (empty) {
    fitPending_ = true;
    start_->setRecent(recent());
    start_->move(std::max(12, (view_->width() - start_->width()) / 2),
                 std::max(12, (view_->height() - start_->height()) / 2));
  }
  start_->setVisible(empty);
}

void MainWindow::showError(const Error& error, const QString& file) {
  errors_->showError(qt(error.message()), qt(error.hint()));
  const bool damagedDocument = error.code() == ErrorCode::FormatDamaged && !file.isEmpty() && isDocument(file.toStdString());
  if (damagedDocument)
    errors_->offer(tr("Open what is readable"),
                   [this, file] { guarded([this, file] { session_.open(file.toStdString(), true); }); });
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  QMetaObject::invokeMethod(this, &MainWindow::refreshStart, Qt::QueuedConnection);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && errors_->isVisible())
    errors_->hide();
  else if (event->key() == Qt::Key_Escape && (session_.evaluating() || session_.job().running()))
    session_.cancel();
  else
    QMainWindow::keyPressEvent(event);
}

}  // namespace blossom::ui
