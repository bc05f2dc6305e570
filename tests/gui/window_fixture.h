#pragma once
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <limits>
#include <memory>

#include "app/app.h"
#include "support/mouse.h"
#include "support/support.h"
#include "ui/fields/parameter_field.h"
#include "ui/files/export_dialog.h"
#include "ui/look/theme.h"
#include "ui/panel/error_bar.h"
#include "ui/panel/property_panel.h"
#include "ui/thread/stall_watch.h"
#include "ui/view/view_widget.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

namespace blossom::ui {

/// The real window with the plugins of the build tree, settings and caches in a folder of its own; one new window a test.
class WindowFixture : public QObject {
 protected:
  static QString propeller() { return QString::fromStdString(test::sample("propeller.json").string()); }

  void setUpOnce() {
    setUpApplication();
    keepShaders();
    for (const char* name : {"XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
      qputenv(name, folder_.path().toLocal8Bit());
    if (qEnvironmentVariableIsEmpty("BLOSSOM_WORKER"))
      qputenv("BLOSSOM_WORKER", (test::buildFolder() / "bin/blossom-worker").c_str());
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    ThemeManager::instance().apply(ThemeChoice::Dark);
  }

  void openWindow(const std::vector<std::filesystem::path>& plugins = {test::buildFolder() / "lib/blossom/plugins"}) {
    window_ = std::make_unique<MainWindow>(loadApp(plugins));
    window_->resize(1000, 700);
    window_->show();
    window_->activateWindow();  // no window manager does it; shortcuts need it
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QVERIFY2(window_->view().problem().isEmpty(), qPrintable(window_->view().problem()));
    QCoreApplication::processEvents();  // what the window does once it is there
  }

  /// The graphics driver goes on to use the translated shaders of this user, as it does for everybody after the first start.
  static void keepShaders() {
    const QString caches = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    if (qEnvironmentVariableIsEmpty("MESA_SHADER_CACHE_DIR")) qputenv("MESA_SHADER_CACHE_DIR", caches.toLocal8Bit());
  }

  [[nodiscard]] FeatureId sweep() const {
    for (const auto& feature : window_->session().document().features())
      if (feature->type == "sweep.sweep") return feature->id;
    return {};
  }

  // Waits are long for the sake of sanitizers and busy machines; a test that hangs is ended by who runs the tests.

  /// Opens a file and waits until it is computed and drawn.
  void openAndWait(const QString& file) {
    window_->openFile(file);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->session().document().features().empty() && !window_->session().evaluating() &&
                                 !window_->session().job().running(),
                             300000);
    QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
    QTRY_VERIFY(window_->view().sharp());
  }

  void openPropeller() {
    openAndWait(propeller());
    QVERIFY(!sweep().empty());
  }

  void waitUntilComputed() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && !window_->session().job().running(), 300000);
  }

  void run(const char* command) {
    const Command* found = window_->commands().find(QLatin1String(command));
    QVERIFY2(found, command);
    found->action->trigger();
  }

  /// Types a value into a field of the panel, as a user does.
  void edit(const char* parameter, const char* typed) {
    ParameterField* const field = window_->properties().field(QLatin1String(parameter));
    QVERIFY2(field, parameter);
    auto* const line = field->findChild<QLineEdit*>();
    QVERIFY2(line, parameter);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QLatin1String(typed));
    QTest::keyClick(line, Qt::Key_Return);
  }

  [[nodiscard]] FeatureId last() const { return window_->page().document().features().back()->id; }

  /// A measure of a result by its name; NaN when there is none.
  [[nodiscard]] double measureOf(const FeatureId& id, const char* name) const {
    const auto view = window_->session().view(id);
    if (view)
      for (const Measure& measure : view->measures.values)
        if (measure.name == name) {
          if (const auto* number = std::get_if<double>(&measure.value)) return *number;
          if (const auto* count = std::get_if<std::int64_t>(&measure.value)) return static_cast<double>(*count);
        }
    return std::numeric_limits<double>::quiet_NaN();
  }

  [[nodiscard]] QPoint screenOf(const Vec3& p) const { return window_->view().camera().project(p).toPoint(); }
  void moveTo(const Vec3& p) { test::moveMouse(&window_->view(), screenOf(p)); }
  void clickAt(const Vec3& p, Qt::KeyboardModifiers modifiers = {}) {
    moveTo(p);
    QTest::mouseClick(&window_->view(), Qt::LeftButton, modifiers, screenOf(p));
  }

  /// Answers the next question by the button given; `asked` tells that there was one.
  void answer(QMessageBox::StandardButton button, bool& asked) {
    QTimer::singleShot(0, window_.get(), [this, button, &asked] {
      auto* question = window_->findChild<QMessageBox*>();
      asked = question != nullptr;
      if (question) question->button(button)->click();
    });
  }

  /// The dialogs of File > Export, answered; `options` are set where the format has fields of these names.
  void exportAs(const char* format, const QString& file, const Value& options = Value::object()) {
    const QString saidBefore = window_->errors().message();
    run("file.export");
    const QPointer<ExportDialog> dialog = window_->findChild<ExportDialog*>();
    QVERIFY(dialog);
    dialog->choose(QLatin1String(format));
    QCOMPARE(dialog->format().id, std::string(format));
    for (auto* field : dialog->findChildren<ParameterField*>())
      if (options.contains(field->spec().name)) field->setValue(options.at(field->spec().name));
    QTimer answering;
    connect(&answering, &QTimer::timeout, &answering, [&] {
      auto* chooser = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!chooser) return;
      answering.stop();
      auto* name = chooser->findChild<QLineEdit*>();
      name->setText(file);
      QTest::keyClick(name, Qt::Key_Return);
    });
    answering.start(20);
    dialog->accept();
    waitUntilComputed();
    QCOMPARE(window_->errors().message(), saidBefore);
    QTRY_VERIFY(!dialog);  // the next one is found by its type
  }

  /// The view, once its edges are smooth.
  [[nodiscard]] QImage canvas() {
    if (!QTest::qWaitFor([this] { return window_->view().sharp(); })) qWarning("the view does not come to rest");
    return window_->view().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
  }

  /// Share of the pixels that have about the hue of a colour.
  static double colored(const QImage& image, const QColor& color) {
    qint64 found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        const int turn = std::abs(pixel.hsvHue() - color.hsvHue());
        if (pixel.hsvSaturation() > 90 && std::min(turn, 360 - turn) < 14) ++found;
      }
    return double(found) / (double(image.width()) * image.height());
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace blossom::ui

/// main() of a test program with a window.
#define BLOSSOM_WINDOW_TEST_MAIN(Class)               \
  int main(int argc, char** argv) {                   \
    blossom::ui::prepareApplication();                \
    QApplication application(argc, argv);             \
    Class test;                                       \
    const blossom::ui::StallWatch watch;              \
    const int code = QTest::qExec(&test, argc, argv); \
    watch.print();                                    \
    return code;                                      \
  }
