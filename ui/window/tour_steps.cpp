#include "ui/window/tour_steps.h"

#include <QKeySequence>

#include "ui/files/start_page.h"
#include "ui/page/page.h"
#include "ui/panel/property_panel.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "ui/window/main_window.h"

namespace blossom::ui {

std::vector<TourStep> windowTour(MainWindow& window) {
  const auto startOrView = [&window]() -> QWidget* {
    auto* start = window.findChild<StartPage*>();
    return start && start->isVisible() ? static_cast<QWidget*>(start) : &window.view();
  };
  const Command* palette = window.commands().find(QStringLiteral("edit.find-command"));
  const QString keys = palette ? palette->action->shortcut().toString(QKeySequence::NativeText) : QString();
  return {
      {Tour::tr("Begin with a sample"),
       Tour::tr("The start page opens samples and your last documents with one click. Files can be dropped anywhere on the "
                "window."),
       startOrView, [&window] { return !window.page().document().features().empty(); }},
      {Tour::tr("The document"),
       Tour::tr("Every feature stands here, above what is made from it, with what it came to below its name. A failing "
                "feature says why; the rest of the document lives on."),
       [&window] { return static_cast<QWidget*>(&window.tree()); }},
      {Tour::tr("Properties"),
       Tour::tr("What is selected shows its parameters and its result. Values may be expressions with units, such as "
                "3cm + 1/2 in, and every change can be undone."),
       [&window] { return static_cast<QWidget*>(&window.properties()); }},
      {Tour::tr("Canvas and palette"),
       keys.isEmpty()
           ? Tour::tr("Drag to turn, turn the wheel to come nearer, click to select. The status line always tells "
                      "what the mouse would do.")
           : Tour::tr("Drag to turn, turn the wheel to come nearer, click to select. The status line always tells "
                      "what the mouse would do. %1 finds every command by name.")
                 .arg(keys),
       [&window] { return static_cast<QWidget*>(&window.view()); }}};
}

}  // namespace blossom::ui
