// The keys of the morph tool: numbers that are typed while a control shape is held.
#include <vtkProp.h>

#include <QKeyEvent>

#include "core/error.h"
#include "manipulators/morph_tool.h"

namespace blossom::minkowski {
namespace {

bool beginsNumber(const QKeyEvent& event) {
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
  const QString text = event.text();
  return !text.isEmpty() && (text[0].isDigit() || QStringLiteral(".-+(").contains(text[0]));
}

}  // namespace

bool MorphTool::key(const QKeyEvent& event) {
  if (typing_) return typingKey(event);
  if (held() && beginsNumber(event)) {
    entry_.open({});
    typing_ = true;
    return typingKey(event);
  }
  const bool plain = !(event.modifiers() & ~Qt::KeypadModifier);
  if (plain && event.key() == Qt::Key_L && !held()) {
    setLadder(!habits_.ladder);
    return true;
  }
  return HandleTool::key(event);
}

bool MorphTool::typingKey(const QKeyEvent& event) {
  const ui::TypedKey key = entry_.key(event);
  if (key == ui::TypedKey::Other) return false;
  refusal_.clear();
  if (key == ui::TypedKey::Text) followTyped();
  if (key == ui::TypedKey::Leave) stopTyping();
  if (key == ui::TypedKey::Take) takeTyped();
  emit changed();
  return true;
}

double MorphTool::typedNumber(ParameterSpec spec, const char* name, const QString& text) const {
  spec.name = name;
  return checked(spec, host().typed(spec, text)).get<double>();
}

/// A lone number moves along x.
Placement MorphTool::typedPlacement() const {
  const auto [shape, grip] = handleOf(*held());
  Placement to = before_[shape];
  const QString text = entry_.text().trimmed();
  if (grip == Grip::Scale) to.scale = typedNumber(positiveNumber(), "scale", text);
  if (grip == Grip::Turn) to.turn = typedNumber(angle(), "turn", text);
  if (grip != Grip::Move) return to;
  const QString x = text.section(u',', 0, 0), y = text.section(u',', 1);
  to.offset = {typedNumber(length(), "x", x), y.trimmed().isEmpty() ? 0.0 : typedNumber(length(), "y", y)};
  return to;
}

/// As far as it can be understood; half a number need not be.
void MorphTool::followTyped() {
  try {
    follow(typedPlacement());
  } catch (const Error&) {
    return;
  }
}

/// Enter ends the drag as letting go does.
void MorphTool::takeTyped() {
  if (entry_.unchanged()) return stopTyping();
  try {
    follow(typedPlacement());
  } catch (const Error& error) {
    refusal_ = QString::fromStdString(error.message());
    return;
  }
  typing_ = false;
  ui::ToolEvent done;
  done.button = Qt::LeftButton;
  release(done);
}

/// The mouse decides again.
void MorphTool::stopTyping() {
  typing_ = false;
  refusal_.clear();
  if (!held()) return;
  if (const auto last = mouse_)
    drag(*last);
  else
    follow(before_[handleOf(*held()).shape]);
}

void MorphTool::keysLost() {
  if (!typing_) return;
  stopTyping();
  emit changed();
}

}  // namespace blossom::minkowski
