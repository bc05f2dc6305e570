#include "ui/settings/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <filesystem>

#include "app/app.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

namespace fs = std::filesystem;

struct Language {
  const char *preference, *code;
};
constexpr Language languages[] = {{"english", ""}, {"deutsch", "de"}, {"한국어", "ko"}};

// Among the resources when installed; in the tree they are built beside the programs.
QString translationFile(const std::string& part, const QString& code) {
  const fs::path name = fs::path("translations") / (part + '_' + code.toStdString() + ".qm");
  std::error_code ec;
  fs::path folder = fs::read_symlink("/proc/self/exe", ec).parent_path();
  if (const fs::path installed = resourceFolder() / name; fs::exists(installed, ec)) return qt(installed.string());
  for (int up = 0; up < 3; ++up, folder = folder.parent_path())
    if (const fs::path built = folder / "share/blossom" / name; fs::exists(built, ec)) return qt(built.string());
  return {};
}

void install(const QString& file) {
  auto* translator = new QTranslator(qApp);
  if (translator->load(file))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

}  // namespace

QString languageCode(const QString& preference, const QStringList& wanted) {
  for (const Language& language : languages)
    if (preference == QString::fromUtf8(language.preference)) return QString::fromUtf8(language.code);
  for (const QString& each : wanted) {
    QString code = each.section(u'-', 0, 0).section(u'_', 0, 0).toLower();
    if (code == QLatin1String("en") || code == QLatin1String("c")) return {};
    for (const Language& language : languages)
      if (code == QString::fromUtf8(language.code)) return code;
  }
  return {};
}

// The preference is read from the settings themselves: the list of preferences is made of translated texts.
void installLanguage() {
  const QString preference = QSettings().value(QStringLiteral("preferences/language")).toString();
  const QString code = languageCode(preference, QLocale::system().uiLanguages());
  if (code.isEmpty()) return;
  install(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_") + code);  // buttons of dialogs
  install(translationFile("blossom", code));
  install(translationFile("features", code));  // texts of the registry
}

}  // namespace blossom::ui
