#pragma once
#include <QKeyEvent>

namespace blossom::ui {

/// Whether a key writes a character, alone or with Shift. Such a key that no field takes is meant for the view.
inline bool isCharacterKey(const QKeyEvent& event) {
  const QString text = event.text();
  const bool plain = !(event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
  return plain && !text.isEmpty() && text.front().isPrint() && event.key() != Qt::Key_Space;
}

}  // namespace blossom::ui
