#include "ui/jobs/log_and_jobs.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QSettings>
#include <QToolButton>

#include "ui/commands/commands.h"
#include "ui/jobs/jobs_list.h"
#include "ui/jobs/jobs_panel.h"
#include "ui/jobs/log_list.h"
#include "ui/jobs/log_panel.h"
#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

const QString stateKey = QStringLiteral("window/docks");
constexpr int startHeight = 160;

// The style's own close button is too small to be hit.
QWidget* titleBar(const QString& title, QDockWidget& dock) {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(16, 5, 12, 3);
  auto* name = new QLabel(title);
  name->setObjectName(QStringLiteral("sectionTitle"));
  auto* close = new QToolButton;
  close->setObjectName(QStringLiteral("quiet"));
  close->setIcon(icon(QStringLiteral("close")));
  close->setIconSize({14, 14});
  close->setToolTip(LogAndJobs::tr("Close"));
  close->setAccessibleName(LogAndJobs::tr("Close"));
  QObject::connect(close, &QToolButton::clicked, &dock, &QWidget::hide);
  row->addWidget(name, 1);
  row->addWidget(close);
  return bar;
}

}  // namespace

LogAndJobs::LogAndJobs(QMainWindow& window, Commands& commands)
    : QObject(&window), window_(window), commands_(commands), jobs_(new JobsList(this)), log_(new LogList(this)) {
  const QString group = tr("View");
  commands.add(
      {"view.jobs", group, "jobs", tr("&Jobs"), tr("Show what is being computed, read and written."), {tr("Ctrl+J")}, true},
      [this] { toggleJobs(); });
  commands.add({"view.log", group, "log", tr("&Log"), tr("Show what has happened so far."), {tr("Ctrl+L")}, true},
               [this] { toggle(*logDock_, "view.log"); });
  auto* jobsPanel = new JobsPanel(*jobs_);
  connect(jobsPanel, &JobsPanel::hint, this, &LogAndJobs::hint);
  jobsDock_ = dock("jobsDock", tr("JOBS"), jobsPanel, QStringLiteral("view.jobs"));
  logDock_ = dock("logDock", tr("LOG"), new LogPanel(*log_), QStringLiteral("view.log"));
  window_.tabifyDockWidget(jobsDock_, logDock_);
  window_.installEventFilter(this);
  jobsDock_->hide();
  logDock_->hide();
}

QDockWidget* LogAndJobs::dock(const char* name, const QString& title, QWidget* content, const QString& command) {
  auto* made = new QDockWidget(title, &window_);
  made->setObjectName(QLatin1String(name));
  made->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  made->setAllowedAreas(Qt::BottomDockWidgetArea | Qt::RightDockWidgetArea);
  made->setTitleBarWidget(titleBar(title, *made));
  made->setWidget(content);
  content->setMinimumHeight(90);
  window_.addDockWidget(Qt::BottomDockWidgetArea, made);
  window_.resizeDocks({made}, {startHeight}, Qt::Vertical);
  // When the window is taken down, its docks outlive its commands.
  connect(made, &QDockWidget::visibilityChanged, this, [made, action = QPointer<QAction>(commands_.action(command))] {
    if (action) action->setChecked(!made->isHidden());
  });
  return made;
}

void LogAndJobs::addTo(QMenu& view) {
  view.addAction(commands_.action(QStringLiteral("view.jobs")));
  view.addAction(commands_.action(QStringLiteral("view.log")));
}

void LogAndJobs::watch(DocumentPage& page) {
  jobs_->watch(page);
  log_->watch(page);
}

void LogAndJobs::restore() { window_.restoreState(QSettings().value(stateKey).toByteArray()); }

// Whether or not the window stays open. While it is taken down it is no main window any more.
bool LogAndJobs::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Close && qobject_cast<QMainWindow*>(watched))
    QSettings().setValue(stateKey, window_.saveState());
  return QObject::eventFilter(watched, event);
}

void LogAndJobs::toggleJobs() { toggle(*jobsDock_, "view.jobs"); }

// What stands behind the other one comes to the front.
void LogAndJobs::toggle(QDockWidget& dock, const char* command) {
  const bool front = dock.isVisible() && !dock.visibleRegion().isEmpty();
  dock.setVisible(!front);
  if (!front) dock.raise();
  commands_.action(QLatin1String(command))->setChecked(!front);
}

}  // namespace blossom::ui
