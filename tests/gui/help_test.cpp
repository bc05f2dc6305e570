#include <QClipboard>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QToolButton>

#include "app/app.h"
#include "gui/window_fixture.h"
#include "support/support.h"
#include "ui/commands/commands.h"
#include "ui/fields/parameter_field.h"
#include "ui/help/about_dialog.h"
#include "ui/help/about_versions.h"
#include "ui/help/manual_text.h"
#include "ui/help/manual_window.h"
#include "ui/help/tour.h"
#include "ui/help/tour_bubble.h"
#include "ui/look/icons.h"
#include "ui/look/theme.h"
#include "ui/settings/key_recorder.h"
#include "ui/settings/language.h"
#include "ui/settings/preferences_dialog.h"
#include "ui/settings/preferences_form.h"
#include "ui/settings/shortcut_editor.h"
#include "ui/window/application.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

double channel(double value) { return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

double luminance(const QColor& c) {
  return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
}

/// As WCAG 2.1 defines it.
double contrast(const QColor& a, const QColor& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace

class HelpTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void everyLinkOfTheManualLeadsSomewhere();
  void searchFindsAFeatureAndOpensIt();
  void backAndForwardFollowThePages();
  void aPageIsSetInTheColoursOfTheTheme();
  void theKeysStandInTheManual();
  void versionsAreCopied();
  void theLicenceCanBeRead();
  void aPreferenceHoldsAtOnce();
  void aPageOfPreferencesIsReset();
  void pressedKeysAreTaken();
  void keysOfAnotherCommandAreNotTakenSilently();
  void escLeavesTheKeys();
  void commandsAreFoundByNameAndKeys();
  void theTourIsWalkedWithTheKeyboard();
  void theTourGivesTheKeyboardBack();
  void aStepOfTheTourThatIsPassedGivesWay();
  void theTourIsOfferedOnce();
  void textsAreReadableInBothThemes();
  void iconsTakeTheColoursOfTheTheme();
  void languagesAreChosenByPreferenceOrSystem();

 private:
  void openManual(const QString& page);
  ShortcutEditor& editor() { return preferences_->shortcuts(); }
  QTemporaryDir folder_;
  App app_;
  std::unique_ptr<QWidget> window_;
  std::unique_ptr<Commands> commands_;
  std::unique_ptr<ManualWindow> manual_;
  std::unique_ptr<PreferencesDialog> preferences_;
};

void HelpTest::initTestCase() {
  setUpApplication();
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  ThemeManager::instance().apply(ThemeChoice::Dark);
  app_ = loadApp({test::buildFolder() / "lib/blossom/plugins"});
}

void HelpTest::init() {
  QSettings().clear();
  window_ = std::make_unique<QWidget>();
  window_->resize(900, 600);
  commands_ = std::make_unique<Commands>(window_.get());
  commands_->add({"file.open", "File", "open", "&Open…", "Open a document.", {QKeySequence("Ctrl+O")}}, [] {});
  commands_->add({"view.fit", "View", "fit", "&Fit", "Show everything.", {QKeySequence("F")}}, [] {});
  commands_->add({"view.home", "View", "home", "&Home", "As it was.", {}}, [] {});
  preferences_ = std::make_unique<PreferencesDialog>(*commands_);
}

void HelpTest::cleanup() {
  manual_.reset();
  preferences_.reset();
  commands_.reset();
  window_.reset();
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void HelpTest::openManual(const QString& page) {
  manual_ = std::make_unique<ManualWindow>(window_.get());
  manual_->setPages(std::make_unique<ManualPages>(app_, *commands_));
  manual_->open(page);
  QVERIFY(QTest::qWaitForWindowExposed(manual_.get()));
}

void HelpTest::everyLinkOfTheManualLeadsSomewhere() {
  const ManualPages pages(app_, *commands_);
  const std::filesystem::path folder = resourceFolder() / "manual";
  static const QRegularExpression link(QStringLiteral("\\]\\(([^)#]+)(#[^)]*)?\\)"));
  int links = 0;
  for (const ManualPage& page : pages.all())
    for (auto it = link.globalMatch(page.text); it.hasNext();) {
      const QString target = it.next().captured(1);
      if (target.startsWith(QLatin1String("http"))) continue;
      ++links;
      const bool there = target.endsWith(QLatin1String(".md")) ? pages.find(target) != nullptr
                                                               : std::filesystem::exists(folder / target.toStdString());
      QVERIFY2(there, qPrintable(page.name + QStringLiteral(" names ") + target));
    }
  QVERIFY(links > 10);
}

void HelpTest::searchFindsAFeatureAndOpensIt() {
  openManual(QStringLiteral("index.md"));
  const auto& type = *app_.registry->at("sweep.sweep");
  QTest::keyClicks(&manual_->searchField(), QString::fromStdString(type.id));
  QVERIFY(manual_->hits().count() > 0);
  QTest::keyClick(&manual_->searchField(), Qt::Key_Return);
  QCOMPARE(manual_->text().page(), QStringLiteral("reference/sweep.sweep.md"));
  for (const ParameterSpec& spec : type.parameters)
    QVERIFY(manual_->text().toPlainText().contains(QString::fromStdString(spec.help)));
}

void HelpTest::backAndForwardFollowThePages() {
  openManual(QStringLiteral("index.md"));
  manual_->text().open(QStringLiteral("formats.md"));
  QCOMPARE(manual_->text().page(), QStringLiteral("formats.md"));
  QTest::keyClick(manual_.get(), Qt::Key_Left, Qt::AltModifier);
  QTRY_COMPARE(manual_->text().page(), QStringLiteral("index.md"));
  QTest::keyClick(manual_.get(), Qt::Key_Right, Qt::AltModifier);
  QTRY_COMPARE(manual_->text().page(), QStringLiteral("formats.md"));
}

void HelpTest::aPageIsSetInTheColoursOfTheTheme() {
  openManual(QStringLiteral("sweep.md"));
  for (const ThemeChoice choice : {ThemeChoice::Dark, ThemeChoice::Light}) {
    ThemeManager::instance().apply(choice);
    const QTextBlock heading = manual_->text().document()->begin();
    QCOMPARE(heading.blockFormat().headingLevel(), 1);
    QCOMPARE(heading.begin().fragment().charFormat().foreground().color(), theme().color("text"));
  }
  QVERIFY(manual_->text().headings().size() > 3);
}

void HelpTest::theKeysStandInTheManual() {
  commands_->setKeys(QStringLiteral("view.home"), {QKeySequence("Ctrl+Alt+Y")});
  const ManualPages pages(app_, *commands_);
  const QString text = pages.find(QStringLiteral("keyboard.md"))->text;
  for (const char* each : {"## File", "Open", "`Ctrl+O`", "Home", "`Ctrl+Alt+Y`"})
    QVERIFY2(text.contains(QLatin1String(each)), each);
}

void HelpTest::versionsAreCopied() {
  AboutDialog dialog;
  QGuiApplication::clipboard()->clear();
  dialog.copyVersions();
  const QString copied = QGuiApplication::clipboard()->text();
  for (const LibraryVersion& each : libraryVersions()) {
    QVERIFY(!each.version.isEmpty());
    QVERIFY2(copied.contains(each.name + QStringLiteral(": ") + each.version), qPrintable(each.name));
  }
}

void HelpTest::theLicenceCanBeRead() {
  AboutDialog dialog;
  dialog.showLicence(true);
  QVERIFY(dialog.licenceText().contains(QLatin1String("GNU GENERAL PUBLIC LICENSE")));
}

void HelpTest::aPreferenceHoldsAtOnce() {
  QCOMPARE(theme().name, QStringLiteral("Dark"));
  for (const PreferencesForm* form : preferences_->forms())
    for (ParameterField* field : form->fields())
      if (field->spec().name == "theme") emit field->edited(Value("light"));
  QCOMPARE(Preferences::instance().get<std::string>("theme"), std::string("light"));
  QCOMPARE(theme().name, QStringLiteral("Light"));
}

void HelpTest::aPageOfPreferencesIsReset() {
  Preferences::instance().set("theme", "light");
  Preferences::instance().set("threads", 3);
  preferences_->resetPage();  // the first page: look
  QCOMPARE(Preferences::instance().get<std::string>("theme"), std::string("system"));
  QCOMPARE(Preferences::instance().get<int>("threads"), 3);
}

void HelpTest::pressedKeysAreTaken() {
  preferences_->showShortcuts();
  preferences_->show();
  QVERIFY(QTest::qWaitForWindowExposed(preferences_.get()));
  editor().select(QStringLiteral("view.home"));
  auto* recorder = editor().findChild<KeyRecorder*>();
  recorder->click();
  QVERIFY(recorder->recording());
  QTest::keyClick(recorder, Qt::Key_Control);  // alone it is nothing yet
  QVERIFY(recorder->recording());
  QTest::keyClick(recorder, Qt::Key_J, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(!recorder->recording());
  QCOMPARE(commands_->action(QStringLiteral("view.home"))->shortcut(), QKeySequence("Ctrl+Shift+J"));
  QCOMPARE(recorder->text(), QStringLiteral("Ctrl+Shift+J"));
  editor().resetAll();
  QVERIFY(commands_->action(QStringLiteral("view.home"))->shortcuts().isEmpty());
}

void HelpTest::keysOfAnotherCommandAreNotTakenSilently() {
  editor().select(QStringLiteral("view.home"));
  editor().take(QKeySequence("Ctrl+O"));
  QVERIFY(commands_->action(QStringLiteral("view.home"))->shortcuts().isEmpty());
  QVERIFY2(editor().message().contains(QLatin1String("Open")) && editor().message().contains(QLatin1String("File")),
           qPrintable(editor().message()));
  editor().takeOver().click();
  QCOMPARE(commands_->action(QStringLiteral("view.home"))->shortcut(), QKeySequence("Ctrl+O"));
  QVERIFY(commands_->action(QStringLiteral("file.open"))->shortcuts().isEmpty());
}

void HelpTest::escLeavesTheKeys() {
  preferences_->showShortcuts();
  preferences_->show();
  QVERIFY(QTest::qWaitForWindowExposed(preferences_.get()));
  editor().select(QStringLiteral("view.fit"));
  auto* recorder = editor().findChild<KeyRecorder*>();
  recorder->click();
  QTest::keyClick(recorder, Qt::Key_Escape);
  QVERIFY(!recorder->recording());
  QVERIFY(preferences_->isVisible());
  QCOMPARE(commands_->action(QStringLiteral("view.fit"))->shortcut(), QKeySequence("F"));
}

void HelpTest::commandsAreFoundByNameAndKeys() {
  QCOMPARE(editor().visibleCommands(), 3);
  editor().searchField().setText(QStringLiteral("ctrl+o"));
  QCOMPARE(editor().visibleCommands(), 1);
  editor().searchField().setText(QStringLiteral("view"));
  QCOMPARE(editor().visibleCommands(), 2);
  editor().searchField().clear();
  QCOMPARE(editor().visibleCommands(), 3);
}

void HelpTest::theTourIsWalkedWithTheKeyboard() {
  QWidget left(window_.get()), right(window_.get());
  left.setGeometry(0, 100, 200, 300);
  right.setGeometry(600, 100, 300, 300);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  Tour tour(window_.get(), {{"Left", "One.", [&] { return &left; }},
                            {"Right", "Two.", [&] { return &right; }},
                            {"Nowhere", "Three.", [] { return static_cast<QWidget*>(nullptr); }}});
  QSignalSpy ended(&tour, &Tour::ended);
  tour.start();
  QVERIFY(tour.running());
  const QRect first = tour.bubble()->geometry();
  QVERIFY(window_->rect().contains(first));
  QVERIFY(!first.intersects(left.geometry()));
  QTest::keyClick(tour.bubble(), Qt::Key_Return);
  QCOMPARE(tour.bubble()->title(), QStringLiteral("Right"));
  QVERIFY(!tour.bubble()->geometry().intersects(right.geometry()));
  QTest::keyClick(tour.bubble(), Qt::Key_Left);
  QCOMPARE(tour.step(), std::size_t{0});
  QTest::keyClick(tour.bubble(), Qt::Key_Right);
  QTest::keyClick(tour.bubble(), Qt::Key_Right);
  QCOMPARE(tour.step(), std::size_t{2});
  QVERIFY(window_->rect().contains(tour.bubble()->geometry()));
  QTest::keyClick(tour.bubble(), Qt::Key_Right);
  QVERIFY(!tour.running());
  QCOMPARE(ended.count(), 1);
  tour.start();  // again from the menu
  QTest::keyClick(tour.bubble(), Qt::Key_Escape);
  QVERIFY(!tour.running());
}

/// To what had it or, when that is gone, to what keeps keys from going astray.
void HelpTest::theTourGivesTheKeyboardBack() {
  auto* const name = new QLineEdit(window_.get());
  auto* const before = new QLineEdit(window_.get());
  auto* const canvas = new QPushButton(window_.get());
  window_->show();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  Tour tour(window_.get(), {{"Here", "One.", [] { return static_cast<QWidget*>(nullptr); }}, {"There", "Two.", {}}},
            [canvas] { return canvas; });
  before->setFocus();
  tour.start();
  QTest::keyClick(tour.bubble(), Qt::Key_Escape);
  QVERIFY(before->hasFocus());
  tour.start();
  before->hide();
  QTest::mouseClick(tour.bubble()->findChild<QPushButton*>(QStringLiteral("link")), Qt::LeftButton);
  QVERIFY(!tour.running());
  QVERIFY(canvas->hasFocus());
  // Who has gone on to something else keeps it.
  tour.start();
  name->setFocus();
  tour.end();
  QVERIFY(name->hasFocus());
}

/// It leaves the keyboard where it is: somebody is at work there.
void HelpTest::aStepOfTheTourThatIsPassedGivesWay() {
  auto* const name = new QLineEdit(window_.get());
  window_->show();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  bool begun = false;
  const std::vector<TourStep> steps{{"Begin", "One.", {}, [&] { return begun; }}, {"Go on", "Two.", {}}};
  Tour tour(window_.get(), steps);
  tour.start();
  tour.follow();
  QCOMPARE(tour.bubble()->title(), QStringLiteral("Begin"));
  name->setFocus();
  begun = true;
  tour.follow();
  QCOMPARE(tour.bubble()->title(), QStringLiteral("Go on"));
  QVERIFY(name->hasFocus());
  tour.end();
  tour.start();  // where there is something already, it begins with what comes after
  QCOMPARE(tour.bubble()->title(), QStringLiteral("Go on"));
  tour.end();
}

void HelpTest::theTourIsOfferedOnce() {
  QVERIFY(!Tour::shownBefore());
  Tour tour(window_.get(), {{"Here", "One.", [] { return static_cast<QWidget*>(nullptr); }}});
  tour.start();
  tour.end();
  QVERIFY(Tour::shownBefore());
}

void HelpTest::textsAreReadableInBothThemes() {
  for (const ThemeChoice choice : {ThemeChoice::Dark, ThemeChoice::Light}) {
    ThemeManager::instance().apply(choice);
    const Theme& colors = theme();
    for (const char* text : {"text", "muted", "control", "error", "warning", "madeText"})
      for (const char* ground : {"window", "bar", "panel", "raised", "hover", "field", "errorSoft"}) {
        const double found = contrast(colors.color(text), colors.color(ground));
        QVERIFY2(found >= 4.5, qPrintable(QStringLiteral("%1: %2 on %3 has %4")
                                              .arg(colors.name, QLatin1String(text), QLatin1String(ground))
                                              .arg(found)));
      }
    QVERIFY(contrast(colors.color("onMade"), colors.color("made")) >= 4.5);
    QVERIFY(contrast(colors.color("control"), colors.color("panel")) >= 3);  // the ring around what has the focus
  }
}

void HelpTest::iconsTakeTheColoursOfTheTheme() {
  const std::filesystem::path folder = resourceFolder() / "icons";
  int icons = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".svg" || entry.path().stem() == "blossom") continue;
    const QString name = QString::fromStdString(entry.path().stem().string());
    const QByteArray drawn = iconSource(name, QColor("#123456"), theme());
    QVERIFY2(!drawn.contains("currentColor") && !drawn.contains("\"accent\"") && !drawn.contains("\"onMade\""),
             qPrintable(name));
    QVERIFY2(drawn.contains("#123456"), qPrintable(name));
    QImage image = icon(name).pixmap(20, 20).toImage();
    bool something = false;
    for (int y = 0; y < image.height() && !something; ++y)
      for (int x = 0; x < image.width() && !something; ++x) something = image.pixelColor(x, y).alpha() > 100;
    QVERIFY2(something, qPrintable(name));
    ++icons;
  }
  QVERIFY(icons > 100);
  for (const auto& type : app_.registry->types()) {
    if (type->icon.empty()) continue;
    QVERIFY2(hasIcon(QString::fromStdString(type->icon)), type->icon.c_str());
  }
}

void HelpTest::languagesAreChosenByPreferenceOrSystem() {
  QCOMPARE(languageCode(QStringLiteral("deutsch"), {QStringLiteral("en")}), QStringLiteral("de"));
  QCOMPARE(languageCode(QStringLiteral("한국어"), {}), QStringLiteral("ko"));
  QCOMPARE(languageCode(QStringLiteral("english"), {QStringLiteral("de")}), QString());
  QCOMPARE(languageCode(QStringLiteral("system"), {QStringLiteral("ko-KR"), QStringLiteral("en")}), QStringLiteral("ko"));
  QCOMPARE(languageCode({}, {QStringLiteral("fr-FR"), QStringLiteral("de_AT")}), QStringLiteral("de"));
  QCOMPARE(languageCode({}, {QStringLiteral("en-GB"), QStringLiteral("de")}), QString());
  QCOMPARE(languageCode({}, {QStringLiteral("C")}), QString());
}

BLOSSOM_WINDOW_TEST(HelpTest)
#include "help_test.moc"
