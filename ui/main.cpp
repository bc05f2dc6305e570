#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <cstdio>

#include "app/app.h"
#include "core/error.h"
#include "core/version.h"
#include "ui/application.h"
#include "ui/icons.h"
#include "ui/main_window.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

struct Options {
  QString file, screenshot;
  QSize size;
  ThemeChoice theme = ThemeChoice::System;
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

struct Flags {
  const QCommandLineOption screenshot{QStringLiteral("screenshot"),
                                      QStringLiteral("Write a picture of the window once everything is computed."),
                                      QStringLiteral("PNG")};
  const QCommandLineOption size{QStringLiteral("size"), QStringLiteral("Size of the window."),
                                QStringLiteral("WIDTHxHEIGHT"), QStringLiteral("1440x900")};
  const QCommandLineOption theme{
      QStringLiteral("theme"), QStringLiteral("dark or light; otherwise as chosen in the window."), QStringLiteral("NAME")};
  const QCommandLineOption leave{QStringLiteral("exit"), QStringLiteral("Close after the screenshot.")};
};

void setUp(QCommandLineParser& parser, const Flags& flags) {
  parser.setApplicationDescription(
      QStringLiteral("The window of Blossom, a workbench for shapes that morph, sweep, grow and melt."));
  parser.addPositionalArgument(QStringLiteral("FILE"),
                               QStringLiteral("A .blossom document, or geometry to be opened in a new one."),
                               QStringLiteral("[FILE]"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addOptions({flags.screenshot, flags.size, flags.theme, flags.leave});
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
  if (parser.positionalArguments().size() > 1) wrongUse(QStringLiteral("one file at a time."));
  options.file = parser.positionalArguments().value(0);
  options.screenshot = parser.value(flags.screenshot);
  options.size = parseSize(parser.value(flags.size));
  options.exitWhenDone = parser.isSet(flags.leave);
  const QString named = parser.value(flags.theme);
  if (named == QLatin1String("dark"))
    options.theme = ThemeChoice::Dark;
  else if (named == QLatin1String("light"))
    options.theme = ThemeChoice::Light;
  else if (!named.isEmpty())
    wrongUse(QStringLiteral("there is no theme \"%1\"; themes are dark and light.").arg(named));
  else
    options.theme = static_cast<ThemeChoice>(std::clamp(QSettings().value(QStringLiteral("theme"), 0).toInt(), 0, 2));
  return options;
}

int run() {
  const Options options = readOptions();
  ThemeManager::instance().apply(options.theme);
  QApplication::setWindowIcon(icon(QStringLiteral("blossom")));
  MainWindow window(loadApp());
  window.resize(options.size);
  if (!options.file.isEmpty()) window.openFile(options.file);  // is read while the window comes up
  window.show();
  if (!options.screenshot.isEmpty()) {
    auto* screenshot = new Screenshot(window, options.screenshot);
    QObject::connect(screenshot, &Screenshot::taken, qApp, [&](bool written) {
      if (!written) std::fprintf(stderr, "blossom-workbench: %s cannot be written.\n", qPrintable(options.screenshot));
      if (options.exitWhenDone) QCoreApplication::exit(written ? 0 : 1);
    });
  }
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  if (answeredWithoutWindow(argc, argv)) return 0;
  if (displayMissing()) {
    std::fprintf(stderr, "blossom-workbench: there is no display to open a window on. The command blossom needs none.\n");
    return 1;
  }
  prepareApplication();
  QApplication application(argc, argv);
  setUpApplication();
  try {
    return run();
  } catch (const Error& error) {
    std::fprintf(stderr, "blossom-workbench: %s %s\n", error.what(), error.hint().c_str());
    return 1;
  }
}
