#pragma once
#include <QApplication>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

#include "app/app.h"
#include "support/mouse.h"
#include "support/support.h"
#include "ui/controls/field_label.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/panel/property_panel.h"
#include "ui/plugin/tool.h"
#include "ui/session/session.h"
#include "widget_test.h"

namespace blossom::ui {

/// What the evaluation of the feature shown meets: it can be held up, and counts.
struct EvaluationGate {
  std::mutex mutex;
  std::condition_variable changed;
  bool closed = false;
  int entered = 0, inside = 0, maximumInside = 0;

  void pass(const Progress& progress) {
    std::unique_lock lock(mutex);
    ++entered;
    maximumInside = std::max(maximumInside, ++inside);
    changed.notify_all();
    changed.wait(lock, [&] { return !closed || progress.cancelled(); });
    --inside;
  }
  void close() {
    const std::lock_guard lock(mutex);
    closed = true;
    entered = 0;
  }
  void open() {
    const std::lock_guard lock(mutex);
    closed = false;
    changed.notify_all();
  }
  int count() {
    const std::lock_guard lock(mutex);
    return entered;
  }
};

ParameterSpec declared(std::string name, ParameterSpec spec, Value fallback = {});
Feature made(const std::string& id, const std::string& type, const std::string& name, std::vector<FeatureId> inputs = {});

/// The panel alone, with settings in a folder of its own, and a document of made-up features. It shows feature "e", which
/// has a parameter of every kind there is and takes feature "a".
class PanelFixture : public QObject {
 protected:
  void setUpOnce();

  void openPanel();

  void closePanel();

  static inline EvaluationGate gate_;

  /// A parameter of every kind there is.
  static FeatureType everything();

  static QPoint middle(const QWidget* widget) { return widget->rect().center(); }

  [[nodiscard]] ParameterField* field(const char* name) const { return panel_->field(QLatin1String(name)); }
  template <class T>
  T* editor(const char* name) const {
    return field(name)->findChild<T*>();
  }
  [[nodiscard]] QToolButton* pickButton(const char* name) const {
    return field(name)->findChild<QToolButton*>(QStringLiteral("fieldButton"));
  }
  [[nodiscard]] FieldLabel* labelOf(const char* name) const { return field(name)->findChild<FieldLabel*>(); }

  [[nodiscard]] Value now(const char* name) const;

  /// The edit arrives in the document, is one step of undo, and is shown again after undo and redo.
  void oneStep(const char* name, const Value& wanted, const std::function<void()>& edit);

  static void type(QLineEdit* line, const QString& text);

  void settle();

  static Pick pickOf(SubShapeKind kind, int index, const FeatureId& feature = "a");

  std::unique_ptr<Session> session_;
  std::unique_ptr<PropertyPanel> panel_;
  QTemporaryDir folder_;
};

}  // namespace blossom::ui
