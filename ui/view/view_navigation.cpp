#include "ui/view/view_navigation.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace blossom::ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::Navigation)
};

QString buttonsText(Qt::MouseButtons buttons) {
  if (buttons == (Qt::LeftButton | Qt::MiddleButton)) return Words::tr("left and middle drag");
  if (buttons == Qt::MiddleButton) return Words::tr("middle drag");
  return buttons == Qt::RightButton ? Words::tr("right drag") : Words::tr("drag");
}

QString bindingText(const DragBinding& binding) {
  QStringList keys;
  if (binding.modifiers.testFlag(Qt::ControlModifier)) keys << Words::tr("Ctrl");
  if (binding.modifiers.testFlag(Qt::ShiftModifier)) keys << Words::tr("Shift");
  keys << buttonsText(binding.buttons);
  QString text = keys.join(QLatin1Char('+'));
  text[0] = text[0].toUpper();
  return text;
}

QString actionText(DragAction action) {
  switch (action) {
    case DragAction::Orbit:
      return Words::tr("orbit");
    case DragAction::Pan:
      return Words::tr("pan");
    case DragAction::Zoom:
      return Words::tr("zoom");
    case DragAction::Box:
      return Words::tr("select by a box");
    case DragAction::None:
      break;
  }
  return {};
}

}  // namespace

NavigationStyle navigationStyle(const QString& name) {
  if (name == QLatin1String("freecad")) return NavigationStyle::FreeCad;
  if (name == QLatin1String("rhino")) return NavigationStyle::Rhino;
  return name == QLatin1String("fusion") ? NavigationStyle::Fusion : NavigationStyle::Blossom;
}

const std::vector<DragBinding>& dragBindings(NavigationStyle style) {
  using enum DragAction;
  constexpr Qt::KeyboardModifiers none = Qt::NoModifier, shift = Qt::ShiftModifier, control = Qt::ControlModifier;
  static const std::vector<DragBinding> blossom{{Qt::LeftButton, none, Orbit},    {Qt::LeftButton, shift, Pan},
                                                {Qt::RightButton, none, Pan},     {Qt::MiddleButton, none, Pan},
                                                {Qt::MiddleButton, shift, Orbit}, {Qt::RightButton, control, Zoom},
                                                {Qt::RightButton, shift, Pan},    {Qt::LeftButton, control, Box}};
  static const std::vector<DragBinding> freeCad{{Qt::LeftButton, none, Orbit},
                                                {Qt::LeftButton | Qt::MiddleButton, none, Orbit},
                                                {Qt::RightButton, shift, Orbit},
                                                {Qt::MiddleButton, none, Pan},
                                                {Qt::RightButton, none, Pan},
                                                {Qt::RightButton, control, Pan},
                                                {Qt::RightButton, control | shift, Zoom},
                                                {Qt::LeftButton, shift, Box}};
  static const std::vector<DragBinding> rhino{{Qt::RightButton, none, Orbit},   {Qt::RightButton, shift, Pan},
                                              {Qt::RightButton, control, Zoom}, {Qt::MiddleButton, none, Pan},
                                              {Qt::LeftButton, none, Box},      {Qt::LeftButton, control, Box},
                                              {Qt::LeftButton, shift, Box}};
  static const std::vector<DragBinding> fusion{
      {Qt::MiddleButton, shift, Orbit}, {Qt::MiddleButton, none, Pan}, {Qt::MiddleButton, control | shift, Zoom},
      {Qt::RightButton, none, Pan},     {Qt::LeftButton, none, Box},   {Qt::LeftButton, control, Box},
      {Qt::LeftButton, shift, Box}};
  switch (style) {
    case NavigationStyle::FreeCad:
      return freeCad;
    case NavigationStyle::Rhino:
      return rhino;
    case NavigationStyle::Fusion:
      return fusion;
    case NavigationStyle::Blossom:
      break;
  }
  return blossom;
}

DragAction dragAction(NavigationStyle style, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  const Qt::KeyboardModifiers counted = modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
  const std::vector<DragBinding>& table = dragBindings(style);
  const auto it = std::find_if(table.begin(), table.end(), [&](const DragBinding& binding) {
    return binding.buttons == buttons && binding.modifiers == counted;
  });
  return it == table.end() ? DragAction::None : it->action;
}

QString navigationHint(NavigationStyle style) {
  QStringList parts{Words::tr("Click: select")};
  for (const DragAction action : {DragAction::Orbit, DragAction::Pan, DragAction::Box}) {
    const std::vector<DragBinding>& table = dragBindings(style);
    const auto it =
        std::find_if(table.begin(), table.end(), [&](const DragBinding& binding) { return binding.action == action; });
    if (it != table.end()) parts << QStringLiteral("%1: %2").arg(bindingText(*it), actionText(action));
  }
  parts << Words::tr("Wheel: zoom") << Words::tr("Double click: fit");
  return parts.join(QStringLiteral(" · "));
}

}  // namespace blossom::ui
