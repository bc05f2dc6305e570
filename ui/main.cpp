#include <QApplication>
#include <QCommandLineParser>
#include <QScreen>
#include <QStandardPaths>
#include <csignal>
#include <cstdio>

#include "app/app.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/temporaries.h"
#include "core/version.h"
#include "ui/help/tour.h"
#include "ui/look/icons.h"
#include "ui/look/theme.h"
#include "ui/session/recovery.h"
#include "ui/thread/stall_watch.h"
#include "ui/view/view_widget.h"
#include "ui/window/application.h"
#include "ui/window/first_size.h"
#include "ui/window/guarded_application.h"
#include "ui/window/main_window.h"
#include "ui/window/screenshot.h"
#include "ui/window/startup_clock.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

struct Options {
  QStringList files;
  QString screenshot;
  QSize size;  // empty: as suits the screen
  ThemeChoice theme = ThemeChoice::System;
  DisplayMode display = DisplayMode::ShadedWithEdges;
  bool exitWhenDone = false;
};

[[noreturn]] void wrongUse(const QString& message) {
  std::fprintf(stderr, "blossom-workbench: %s\n", qPrintable(message));
  std::exit(2);
}

QSize parseSize(const QString& text) {
  const QStringList parts = text.split(u'x');
  const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
  if (size.width() < 1 || size.height() < 1) wrongUse(QStringLiteral("\"%1\" is not a size such as 1440x900.").arg(text));
  return size;
}

DisplayMode parseDisplay(const QString& text) {
  const std::optional<DisplayMode> mode = displayModeOf(text);
  if (!mode)
    wrongUse(QStringLiteral("there is no display \"%1\"; displays are %2.")
                 .arg(text, displayModeNames().join(QStringLiteral(", "))));
  return *mode;
}

struct Flags {
  const QCommandLineOption screenshot{QStringLiteral("screenshot"),
                                      QStringLiteral("Write a picture of the window once everything is computed."),
                                      QStringLiteral("PNG")};
  const QCommandLineOption size{QStringLiteral("size"), QStringLiteral("Size of the window."),
                                QStringLiteral("WIDTHxHEIGHT")};
  const QCommandLineOption theme{
      QStringLiteral("theme"), QStringLiteral("dark or light; otherwise as chosen in the window."), QStringLiteral("NAME")};
  const QCommandLineOption display{
      QStringLiteral("display-mode"),  // --display is Qt's, for the X server
      QStringLiteral("How shapes are drawn at first: edges, shaded, wireframe, zebra, gaussian, mean, largest, iso."),
      QStringLiteral("MODE")};
  const QCommandLineOption timings{QStringLiteral("print-timings"),
                                   QStringLiteral("Print when the window was shown and the first shape painted.")};
  const QCommandLineOption leave{QStringLiteral("exit"), QStringLiteral("Close after the screenshot.")};
};

void setUp(QCommandLineParser& parser, const Flags& flags) {
  parser.setApplicationDescription(
      QStringLiteral("The window of Blossom, a workbench for shapes that morph, sweep, grow and melt."));
  parser.addPositionalArgument(QStringLiteral("FILE"),
                               QStringLiteral("Documents, or geometry to be opened in new ones; each in a tab of its own."),
                               QStringLiteral("[FILE..]"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addOptions({flags.screenshot, flags.size, flags.theme, flags.display, flags.timings, flags.leave});
}

// Help and version need no display.
bool answeredWithoutWindow(int argc, char** argv) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  const auto asked = [&](const char* flag) { return arguments.contains(QLatin1String(flag)); };
  if (!asked("-h") && !asked("--help") && !asked("--help-all") && !asked("-v") && !asked("--version")) return false;
  QCoreApplication application(argc, argv);
  QCoreApplication::setApplicationName(QStringLiteral("blossom-workbench"));
  QCoreApplication::setApplicationVersion(QLatin1String(versionText));
  QCommandLineParser parser;
  setUp(parser, Flags());
  parser.process(arguments);
  return true;
}

bool displayMissing() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (!qEnvironmentVariableIsEmpty(name)) return false;
  return true;
}

Options readOptions() {
  const Flags flags;
  QCommandLineParser parser;
  setUp(parser, flags);
  parser.process(*qApp);
  Options options;
  options.files = parser.positionalArguments();
  options.screenshot = parser.value(flags.screenshot);
  if (parser.isSet(flags.size)) options.size = parseSize(parser.value(flags.size));
  if (parser.isSet(flags.display)) options.display = parseDisplay(parser.value(flags.display));
  options.exitWhenDone = parser.isSet(flags.leave);
  printTimings(parser.isSet(flags.timings));
  const QString named = parser.value(flags.theme);
  if (named == QLatin1String("dark"))
    options.theme = ThemeChoice::Dark;
  else if (named == QLatin1String("light"))
    options.theme = ThemeChoice::Light;
  else if (!named.isEmpty())
    wrongUse(QStringLiteral("there is no theme \"%1\"; themes are dark and light.").arg(named));
  else
    options.theme = preferredTheme();
  return options;
}

// A frame counts once it holds a shape: the evaluation has handed it to the view before.
void tellFirstFrame(MainWindow& window) {
  auto shape = std::make_shared<bool>(false);
  QObject::connect(&window.session(), &Session::opened, &window, [] { reached("document read"); });
  QObject::connect(&window.session(), &Session::viewsChanged, &window.view(), [shape] { *shape = true; });
  QObject::connect(&window.view(), &ViewWidget::framePainted, &window.view(),
                   [shape] { reached(*shape ? "first frame with a shape" : "first frame"); });
}

// Whoever starts Blossom for the first time, with nothing particular in mind, is shown round.
void offerTour(MainWindow& window) {
  if (Tour::shownBefore()) return;
  QAction* tour = window.commands().action(QStringLiteral("help.tour"));
  QMetaObject::invokeMethod(tour, &QAction::trigger, Qt::QueuedConnection);
}

// Where no safety copies can be kept, work goes on without them; the window says so.
void keepSafe(MainWindow& window) {
  try {
    Recovery::instance().start();
  } catch (const Error& error) {
    DocumentPage& page = window.page();
    page.showError(error);
    // A file that comes up begins with a clean slate.
    QObject::connect(
        &page, &DocumentPage::opened, &page, [&page, error] { page.showError(error); }, Qt::SingleShotConnection);
  }
}

int run(GuardedApplication& application) {
  const Options options = readOptions();
  reached("main");
  ThemeManager::instance().apply(options.theme);
  QApplication::setWindowIcon(icon(QStringLiteral("blossom")));
  reached("theme");
  App app = loadApp();
  app.results = resultStore(
      (QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + QStringLiteral("/blossom/results"))
          .toStdString());
  reached("plugins");
  MainWindow window(std::move(app));
  reached("window made");
  window.resize(options.size.isEmpty() ? firstSize(application.primaryScreen()->availableSize()) : options.size);
  QObject::connect(&application, &GuardedApplication::escaped, &window,
                   [&window](const Error& error) { window.page().showError(error); });
  tellFirstFrame(window);
  window.page().setDisplayMode(options.display);
  if (!options.files.isEmpty()) window.openFiles(options.files);  // are read while the window comes up
  window.show();
  reached("window shown");
  keepSafe(window);
  if (options.files.isEmpty() && options.screenshot.isEmpty()) offerTour(window);
  if (!options.screenshot.isEmpty()) {
    auto* screenshot = new Screenshot(window, options.screenshot);
    QObject::connect(screenshot, &Screenshot::taken, qApp, [&](bool written) {
      if (!written) std::fprintf(stderr, "blossom-workbench: %s cannot be written.\n", qPrintable(options.screenshot));
      if (options.exitWhenDone) QCoreApplication::exit(written ? 0 : 1);
    });
  }
  std::unique_ptr<StallWatch> watch;
  if (StallWatch::wanted()) watch = std::make_unique<StallWatch>();
  const int code = QApplication::exec();
  if (watch) watch->print();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();
  if (answeredWithoutWindow(argc, argv)) return 0;
  if (displayMissing()) {
    std::fprintf(stderr, "blossom-workbench: there is no display to open a window on. The command blossom needs none.\n");
    return 1;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an error of writing, told as one
  removeAbandonedFolders();
  prepareApplication();
  GuardedApplication application(argc, argv);
  setUpApplication();
  try {
    return run(application);
  } catch (const Error& error) {
    std::fprintf(stderr, "blossom-workbench: %s %s\n", error.what(), error.hint().c_str());
    return 1;
  }
}
