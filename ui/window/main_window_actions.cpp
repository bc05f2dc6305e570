// Menus, tool bar and shortcuts of the main window.
#include <QActionGroup>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include "ui/help/help_menu.h"
#include "ui/help/tour.h"
#include "ui/jobs/log_and_jobs.h"
#include "ui/look/icons.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/page/document_commands.h"
#include "ui/page/feature_menus.h"
#include "ui/page/view_commands.h"
#include "ui/palette/command_palette.h"
#include "ui/panel/error_bar.h"
#include "ui/settings/preferences_commands.h"
#include "ui/thread/refreshes.h"
#include "ui/tree/document_tree.h"
#include "ui/tree/find_field.h"
#include "ui/view/view_widget.h"
#include "ui/window/feature_tool_bar.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"
#include "ui/window/tour_steps.h"

namespace blossom::ui {

namespace {

QString themeCommand(const char* name) { return QStringLiteral("view.theme-") + QLatin1String(name); }

const char* nameOf(ThemeChoice choice) {
  if (choice == ThemeChoice::System) return "system";
  return choice == ThemeChoice::Dark ? "dark" : "light";
}

}  // namespace

QAction* MainWindow::add(QMenu* menu, const CommandSpec& spec, std::function<void()> go) {
  QAction* made = commands_.add(spec, std::move(go));
  menu->addAction(made);
  return made;
}

void MainWindow::buildActions() {
  fileCommands_->addTo(*menuBar()->addMenu(tr("&File")));
  buildEditMenu();
  buildViewMenu();
  featureMenus_->addTo(menuBar());
  buildHelpMenu();
  buildToolBar();
}

void MainWindow::buildEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  documentCommands_ = new DocumentCommands(commands_, *featureMenus_, this);
  documentCommands_->addTo(menu);
  add(menu,
      {"edit.find-command",
       tr("Edit"),
       "search",
       tr("Find a co&mmand…"),
       tr("Find a command, a sample, a feature or a page of the manual by a few letters."),
       {tr("Ctrl+K")}},
      [this] { palette_->open(); });
  menu->addSeparator();
  new PreferencesCommands(commands_, *menu, this);
}

void MainWindow::buildViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  const QString group = tr("View");
  add(menu,
      {"view.fit",
       group,
       "fit",
       tr("&Fit"),
       tr("Show everything."),
       {tr("F")},
       false,
       tr("zoom to fit;zoom all;frame").split(u';')},
      [this] { view().fit(); });
  menu->addAction(commands_.action(QStringLiteral("view.fit-selection")));
  add(menu, {"view.home", group, "home", tr("&Home"), tr("Look at everything as when it was opened."), {tr("0")}},
      [this] { view().lookFrom(QStringLiteral("auto")); });
  add(menu, {"view.zoom-in", group, {}, tr("Zoom &in"), tr("Come nearer."), {QKeySequence::ZoomIn}},
      [this] { view().zoomBy(0.8); });
  add(menu, {"view.zoom-out", group, {}, tr("Zoom &out"), tr("Step back."), {QKeySequence::ZoomOut}},
      [this] { view().zoomBy(1.25); });
  menu->addSeparator();
  const std::pair<const char*, QString> sides[] = {{"front", tr("Front")},  {"back", tr("Back")}, {"left", tr("Left")},
                                                   {"right", tr("Right")},  {"top", tr("Top")},   {"bottom", tr("Bottom")},
                                                   {"iso", tr("Isometric")}};
  // A menu of their own: with them the menu of the view would not fit on a small screen.
  QMenu* const from = menu->addMenu(icon(QStringLiteral("view-iso")), tr("Loo&k from"));
  int key = 1;
  for (const auto& [side, title] : sides) {
    const QString name = QLatin1String(side);
    add(from,
        {"view." + name,
         group,
         "view-" + name,
         title,
         tr("Look from: %1.").arg(title),
         {QKeySequence(QString::number(key++))}},
        [this, name] { view().lookFrom(name); });
  }
  menu->addSeparator();
  add(menu,
      {"view.parallel",
       group,
       {},
       tr("&Parallel projection"),
       tr("Without perspective: equal lengths look equal."),
       {tr("P")},
       true,
       tr("orthographic;perspective").split(u';')},
      [this] { view().setParallel(commands_.action("view.parallel")->isChecked()); });
  add(menu, {"view.grid", group, "grid", tr("&Grid"), tr("Show the ground grid."), {tr("G")}, true},
      [this] { view().setGridVisible(commands_.action("view.grid")->isChecked()); });
  menu->addSeparator();
  viewCommands_ = new ViewCommands(
      commands_, [this]() -> DocumentPage& { return page(); }, this);
  QMenu* const select = menuBar()->addMenu(tr("&Select"));
  viewCommands_->addTo(*menu, *select);
  status_->setPickModes(select);
  connect(viewCommands_, &ViewCommands::pickModeShown, status_, &StatusLine::showPickMode);
  menu->addSeparator();
  logAndJobs_ = new LogAndJobs(*this, commands_);
  logAndJobs_->addTo(*menu);
  menu->addSeparator();
  buildThemeMenu(menu->addMenu(icon(QStringLiteral("sun")), tr("&Theme")));
  connect(menu, &QMenu::aboutToShow, this, &MainWindow::refreshActions);  // tools and keys in the view change it, too
}

void MainWindow::buildThemeMenu(QMenu* menu) {
  const QString group = tr("View");
  auto* choices = new QActionGroup(this);
  const auto offer = [&](const char* name, const QString& text, const QString& help) {
    choices->addAction(add(menu, {themeCommand(name), group, "sun", text, help, {}, true},
                           [name] { Preferences::instance().set("theme", name); }));
  };
  offer("system", tr("Theme of the &desktop"), tr("The window is dark or light as the desktop is."));
  offer("dark", tr("&Dark theme"), tr("Light letters on dark ground."));
  offer("light", tr("&Light theme"), tr("Dark letters on light ground."));
  connect(&Preferences::instance(), &Preferences::changed, this, &MainWindow::refreshActions);
}

void MainWindow::buildHelpMenu() {
  auto* help = new HelpMenu(app_, commands_, this);
  help->addTo(
      *menuBar()->addMenu(tr("&Help")),
      [this]() -> std::string {
        const FeatureId current = tree().current();
        return current.empty() ? current : page().document().at(current).type;
      },
      [this] { return windowTour(*this); }, [this]() -> QWidget* { return &view(); });
}

void MainWindow::buildToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  bar->setIconSize({20, 20});
  const auto show = [&](const std::vector<const char*>& ids) {
    for (const char* id : ids) bar->addAction(commands_.action(QLatin1String(id)));
    bar->addSeparator();
  };
  show({"file.open", "file.import", "file.save", "file.export"});
  show({"edit.undo", "edit.redo"});
  for (const char* id : {"view.fit", "view.home", "view.grid"}) bar->addAction(commands_.action(QLatin1String(id)));
  auto* features = new FeatureToolBar(*featureMenus_, new FindField(commands_.action(QStringLiteral("edit.find-command"))));
  connect(features, &FeatureToolBar::hint, status_, &StatusLine::setHint);
  bar->addWidget(features);
  setContextMenuPolicy(Qt::PreventContextMenu);
}

void MainWindow::followState() {
  if (actionState(page()) != actionsShow_) refreshActions();
  if (auto* tour = findChild<Tour*>(QString(), Qt::FindDirectChildrenOnly)) tour->follow();
}

void MainWindow::refreshActions() {
  countRefresh(WindowPart::Actions);
  actionsShow_ = actionState(page());
  const Session& shown = session();
  setWindowTitle(QStringLiteral("%1[*] – Blossom").arg(shown.title()));
  setWindowModified(shown.modified());
  documentCommands_->refresh();
  fileCommands_->refresh();
  commands_.action(QStringLiteral("view.parallel"))->setChecked(view().parallel());
  commands_.action(QStringLiteral("view.grid"))->setChecked(view().gridVisible());
  commands_.action(themeCommand(nameOf(ThemeManager::instance().choice())))->setChecked(true);
  viewCommands_->refresh();
}

}  // namespace blossom::ui
