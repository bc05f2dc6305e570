#include "ui/help/help_menu.h"

#include <QMenu>

#include "app/reference_page.h"
#include "ui/commands/commands.h"
#include "ui/help/about_dialog.h"
#include "ui/help/manual_window.h"
#include "ui/look/text.h"

namespace blossom::ui {

HelpMenu::HelpMenu(const App& app, Commands& commands, QWidget* window)
    : QObject(window), app_(app), commands_(commands), window_(window) {}

void HelpMenu::addTo(QMenu& menu, std::function<std::string()> selectedType, std::function<std::vector<TourStep>()> tour,
                     std::function<QWidget*()> home) {
  const QString group = tr("Help");
  const auto add = [&](const CommandSpec& spec, std::function<void()> go) {
    menu.addAction(commands_.add(spec, std::move(go)));
  };
  add({"help.manual", group, "manual", tr("&Manual"), tr("Read how everything works."), {QKeySequence::HelpContents}},
      [this] { openManual(QStringLiteral("index.md")); });
  add({"help.reference",
       group,
       "help",
       tr("About the &selected feature"),
       tr("The manual's page of the selected feature: inputs, parameters, examples."),
       {tr("Shift+F1")}},
      [this, selectedType = std::move(selectedType)] {
        const std::string type = selectedType();
        openManual(type.empty() ? QStringLiteral("index.md") : qt(referencePageName(type)));
      });
  add({"help.mouse-and-keys", group, "keyboard", tr("Mouse and &keys"), tr("How to move around, and every key."), {}},
      [this] { openManual(QStringLiteral("keyboard.md")); });
  add({"help.tour", group, "tour", tr("&Tour"), tr("A walk through the window in four steps."), {}},
      [this, tour = std::move(tour), home = std::move(home)] {
        auto* walk = new Tour(window_, tour(), home);
        connect(walk, &Tour::ended, walk, &QObject::deleteLater);
        walk->start();
      });
  menu.addSeparator();
  add({"help.about", group, "about", tr("&About Blossom"), tr("Versions and licence."), {}},
      [this] { (new AboutDialog(window_))->open(); });
}

ManualWindow& HelpMenu::openManual(const QString& page, const QString& anchor) {
  if (!manual_) manual_ = new ManualWindow(window_);
  manual_->setPages(std::make_unique<ManualPages>(app_, commands_));  // keys may have been changed since
  manual_->open(page, anchor);
  return *manual_;
}

}  // namespace blossom::ui
