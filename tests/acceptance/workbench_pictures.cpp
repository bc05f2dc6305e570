// Makes pictures of everything the window shows, to be looked at: workbench_pictures FOLDER dark|light WIDTHxHEIGHT SCALE
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/app.h"
#include "ui/files/tile.h"
#include "ui/help/help_menu.h"
#include "ui/help/manual_window.h"
#include "ui/look/theme.h"
#include "ui/palette/command_palette.h"
#include "ui/settings/preferences_dialog.h"
#include "ui/tools/measurements.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

class Pictures {
 public:
  Pictures(QString folder, QString suffix, QSize size)
      : folder_(std::move(folder)), suffix_(std::move(suffix)), size_(size) {}

  bool make() {
    startPage();
    propeller();
    errorInPlace();
    palette();
    section();
    measure();
    preferences();
    manual();
    return good_;
  }

 private:
  void open() {
    window_ = std::make_unique<MainWindow>(loadApp());
    window_->resize(size_);
    window_->show();
    settle();
  }
  void run(const char* command) { window_->commands().action(QLatin1String(command))->trigger(); }

  /// Until nothing is computed any more and the view has been drawn sharp.
  void settle(int quietMs = 700) {
    QElapsedTimer timer;
    timer.start();
    QElapsedTimer quiet;
    quiet.start();
    while (timer.elapsed() < 60000 && quiet.elapsed() < quietMs) {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
      const Session& session = window_->session();
      const ViewWidget& view = window_->view();
      if (session.evaluating() || session.job().running() || (view.isVisible() && !view.sharp())) quiet.restart();
    }
  }
  void save(QWidget& widget, const char* name) {
    settle();
    good_ = widget.grab().save(QDir(folder_).filePath(QLatin1String(name) + suffix_)) && good_;
  }
  void openSample(const char* name) {
    open();
    window_->openFile(QString::fromStdString((resourceFolder() / "samples" / name).string()));
    settle();
  }
  /// Where the first face from above is seen, and one below it.
  /// On the walls of the two holes for bolts.
  std::vector<QPointF> boltHoles() {
    const ViewWidget& view = window_->view();
    return {view.camera().project({16, 20.3, 6.5}), view.camera().project({64, 20.3, 6.5})};
  }
  void clickAt(const QPointF& at) {
    for (const QEvent::Type type : {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
      const bool moves = type == QEvent::MouseMove, down = type == QEvent::MouseButtonPress;
      QMouseEvent event(type, at, window_->view().mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                        down ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
      QApplication::sendEvent(&window_->view(), &event);
    }
  }

  void startPage() {
    open();
    // The pictures of the samples are made by another program.
    QElapsedTimer timer;
    timer.start();
    const auto tiles = window_->findChildren<Tile*>();
    while (timer.elapsed() < 60000 && !std::all_of(tiles.begin(), tiles.end(), [](Tile* t) { return t->hasPicture(); }))
      QApplication::processEvents(QEventLoop::AllEvents, 20);
    save(*window_, "start");
  }
  void propeller() {
    openSample("propeller.json");
    save(*window_, "propeller");
  }
  void errorInPlace() {
    open();
    run("file.new");
    run("feature.modeling.box");
    settle();
    Feature fillet;
    fillet.id = "fillet-1";
    fillet.type = "modeling.fillet";
    fillet.name = "Fillet";
    fillet.inputs = {window_->page().document().features().back()->id};
    fillet.parameters = {{"radius", 80.0}};
    window_->session().commit(window_->page().document().with(fillet), QStringLiteral("Add Fillet"));
    settle();
    window_->tree().select("fillet-1");
    save(*window_, "error");
  }
  void palette() {
    openSample("bracket.blossom");
    run("edit.find-command");
    settle();
    window_->palette().field()->setText(QStringLiteral("fil"));
    save(*window_, "palette");
  }
  void section() {
    openSample("duct.blossom");
    run("view.section");
    save(*window_, "section");
  }
  void measure() {
    openSample("bracket.blossom");
    run("view.measure");
    for (const QPointF& at : boltHoles()) clickAt(at);
    save(*window_, "measure");
  }
  void preferences() {
    openSample("flange.blossom");
    PreferencesDialog dialog(window_->commands(), window_.get());
    dialog.show();
    save(dialog, "preferences");
  }
  void manual() {
    auto* help = window_->findChild<HelpMenu*>();
    ManualWindow& shown = help->openManual(QStringLiteral("sweep.md"));
    save(shown, "manual");
    shown.close();
  }

  QString folder_, suffix_;
  QSize size_;
  std::unique_ptr<MainWindow> window_;
  bool good_ = true;
};

}  // namespace

int main(int argc, char** argv) {
  prepareApplication();
  QApplication application(argc, argv);
  setUpApplication();
  const QStringList arguments = QApplication::arguments();
  const QStringList size = arguments.value(3).split(u'x');
  if (arguments.size() != 5 || size.size() != 2) {
    std::fprintf(stderr, "workbench_pictures FOLDER dark|light WIDTHxHEIGHT SCALE\n");
    return 2;
  }
  const QTemporaryDir own;  // nothing of the user's own is seen or changed
  for (const char* name : {"XDG_CACHE_HOME", "XDG_DATA_HOME"}) qputenv(name, own.path().toLocal8Bit());
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, own.path());
  ThemeManager::instance().apply(arguments[2] == QLatin1String("light") ? ThemeChoice::Light : ThemeChoice::Dark);
  QDir().mkpath(arguments[1]);
  const QString suffix = QStringLiteral("-%1-%2-%3.png").arg(arguments[2], arguments[3], arguments[4]);
  Pictures pictures(arguments[1], suffix, QSize(size[0].toInt(), size[1].toInt()));
  return pictures.make() ? 0 : 1;
}
