#include "ui/settings/key_recorder.h"

#include <QKeyEvent>

namespace blossom::ui {

namespace {

bool isModifier(int key) {
  return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta ||
         key == Qt::Key_AltGr || key == Qt::Key_CapsLock || key == Qt::Key_NumLock || key == 0 || key == Qt::Key_unknown;
}

}  // namespace

KeyRecorder::KeyRecorder(QWidget* parent) : QPushButton(parent) {
  setObjectName(QStringLiteral("keyRecorder"));
  setCheckable(true);
  setAutoDefault(false);
  setMinimumWidth(170);
  connect(this, &QPushButton::toggled, this, &KeyRecorder::refresh);
  refresh();
}

void KeyRecorder::showKeys(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& each : keys) texts << each.toString(QKeySequence::NativeText);
  keys_ = texts.join(QStringLiteral(", "));
  setChecked(false);
  refresh();
}

void KeyRecorder::refresh() {
  setText(recording() ? tr("Press keys…") : keys_.isEmpty() ? tr("No keys: click to set") : keys_);
}

// While recording, keys that are shortcuts somewhere come here instead.
bool KeyRecorder::event(QEvent* event) {
  if (recording() && event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  if (recording() && event->type() == QEvent::KeyPress) {
    keyPressEvent(static_cast<QKeyEvent*>(event));  // Tab too
    return true;
  }
  return QPushButton::event(event);
}

void KeyRecorder::keyPressEvent(QKeyEvent* event) {
  if (!recording()) return QPushButton::keyPressEvent(event);
  if (isModifier(event->key())) return;
  setChecked(false);
  if (event->key() == Qt::Key_Escape && event->modifiers() == Qt::NoModifier) return;
  // Shift that only makes another character ("?") is part of that character already.
  Qt::KeyboardModifiers modifiers = event->modifiers() & ~Qt::KeypadModifier;
  const QString text = event->text();
  if (!text.isEmpty() && text.front().isPrint() && !text.front().isLetter() && !text.front().isSpace())
    modifiers &= ~Qt::ShiftModifier;
  emit recorded(QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(event->key()))));
}

void KeyRecorder::focusOutEvent(QFocusEvent* event) {
  setChecked(false);
  QPushButton::focusOutEvent(event);
}

}  // namespace blossom::ui
