#include "ui/controls/resting_line.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace blossom::ui {
namespace {

constexpr const char* restKey = "rests";

bool isEnter(const QEvent& event) {
  if (event.type() != QEvent::KeyPress) return false;
  const int key = static_cast<const QKeyEvent&>(event).key();
  return key == Qt::Key_Return || key == Qt::Key_Enter;
}

/// Ctrl alone may be on its way to undo.
bool isModifier(const QKeyEvent& event) {
  const int key = event.key();
  return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_AltGr || key == Qt::Key_Meta;
}

/// Whoever does this goes on with the line.
bool wakes(const QEvent& event) {
  if (event.type() == QEvent::KeyPress) return !isModifier(static_cast<const QKeyEvent&>(event));
  return event.type() == QEvent::MouseButtonPress || event.type() == QEvent::FocusOut;
}

class Rest final : public QObject {
 public:
  explicit Rest(QLineEdit* line) : QObject(line), line_(line) {
    line->setProperty(restKey, true);
    line->installEventFilter(this);
  }

 private:
  bool eventFilter(QObject*, QEvent* event) override {
    if (!wakes(*event)) return false;
    line_->setProperty(restKey, false);
    line_->removeEventFilter(this);
    deleteLater();
    return false;
  }

  QLineEdit* line_;
};

/// Lines leave Enter to what they stand in, once they have done what it asks for.
class EnterFilter final : public QObject {
 public:
  explicit EnterFilter(QWidget* panel) : QObject(panel), panel_(panel) { panel->installEventFilter(this); }

 private:
  bool eventFilter(QObject*, QEvent* event) override {
    if (!isEnter(*event)) return false;
    auto* const line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    if (line && panel_->isAncestorOf(line) && !line->isModified() && !rests(*line)) new Rest(line);
    return false;
  }

  QWidget* panel_;
};

}  // namespace

void restAfterEnter(QWidget* panel) { new EnterFilter(panel); }

bool rests(const QLineEdit& line) { return line.property(restKey).toBool(); }

}  // namespace blossom::ui
