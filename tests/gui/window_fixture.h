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

  void setUpOnce();

  void openWindow(const std::vector<std::filesystem::path>& plugins = {test::buildFolder() / "lib/blossom/plugins"});

  /// The graphics driver goes on to use the translated shaders of this user, as it does for everybody after the first start.
  static void keepShaders();

  [[nodiscard]] FeatureId sweep() const;

  // Waits are long for the sake of sanitizers and busy machines; a test that hangs is ended by who runs the tests.

  /// A window with a new document.
  void openNewDocument();

  /// Adds a feature named like its id and waits until it is computed.
  FeatureId add(const char* type, const Value& parameters = Value::object(), std::vector<FeatureId> inputs = {});

  /// Opens a file and waits until it is computed and drawn.
  void openAndWait(const QString& file);

  void openPropeller();

  void waitUntilComputed();

  void run(const char* command);

  /// Types a value into a field of the panel, as a user does.
  void edit(const char* parameter, const char* typed);

  [[nodiscard]] FeatureId last() const { return window_->page().document().features().back()->id; }

  /// A measure of a result by its name; NaN when there is none.
  [[nodiscard]] double measureOf(const FeatureId& id, const char* name) const;

  [[nodiscard]] QPoint screenOf(const Vec3& p) const { return window_->view().camera().project(p).toPoint(); }
  void moveTo(const Vec3& p) { test::moveMouse(&window_->view(), screenOf(p)); }
  /// Straight to the view: moves by way of the display arrive in their own time.
  void mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    mouseIn(&window_->view(), type, at, modifiers);
  }
  void mouseIn(QWidget*, QEvent::Type, const QPointF& at, Qt::KeyboardModifiers modifiers = {});
  void clickAt(const Vec3& p, Qt::KeyboardModifiers modifiers = {});

  /// Files dragged onto the window from another program. @returns whether it takes them.
  bool drop(const QStringList& files);

  /// Answers the next question by the button given; `asked` tells that there was one.
  void answer(QMessageBox::StandardButton button, bool& asked);

  /// The dialogs of File > Export, answered; `options` are set where the format has fields of these names.
  void exportAs(const char* format, const QString& file, const Value& options = Value::object());

  /// The view, once its edges are smooth.
  [[nodiscard]] QImage canvas();

  /// Share of the pixels that have about the hue of a colour.
  static double colored(const QImage& image, const QColor& color);

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
  bool held_ = false;  ///< the button, by `mouse`
};

}  // namespace blossom::ui

namespace blossom::test {

/// Runs a test class of the window, and prints how long its thread stood still.
template <class Test, class Application = QApplication>
int runWindowTest(int argc, char** argv) {
  ui::prepareApplication();
  Application application(argc, argv);
  Test test;
  const ui::StallWatch watch;
  const int code = QTest::qExec(&test, argc, argv);
  watch.print();
  return code;
}

}  // namespace blossom::test

#define BLOSSOM_WINDOW_TEST(Class) BLOSSOM_TEST_RUN(Class, &blossom::test::runWindowTest<Class>)
