#include "ui/page/document_commands.h"

#include <QMenu>
#include <QPointer>

#include "document/edits.h"
#include "geometry/shape/bounds.h"
#include "ui/commands/commands.h"
#include "ui/look/text.h"
#include "ui/numbers/numbers_dialog.h"
#include "ui/page/feature_menus.h"
#include "ui/page/page.h"
#include "ui/tree/document_tree.h"
#include "ui/tree/document_tree_panel.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

const std::vector<const char*> history{"edit.undo", "edit.redo"},
    clipboard{"edit.cut", "edit.copy", "edit.paste", "edit.duplicate"},
    featureEdits{"edit.rename",   "edit.show-hide", "edit.isolate",   "edit.show-all",
                 "edit.suppress", "edit.move-up",   "edit.move-down", "edit.delete"},
    selection{"edit.select-all", "edit.select-nothing", "edit.find"}, computing{"edit.numbers", "edit.recompute"};

}  // namespace

DocumentCommands::DocumentCommands(Commands& commands, FeatureMenus& featureMenus, QWidget* window)
    : QObject(window), commands_(commands), featureMenus_(featureMenus), window_(window) {
  declareHistory();
  declareClipboard();
  declareFeatureEdits();
  declareSelection();
}

void DocumentCommands::declareHistory() {
  const QString group = tr("Edit");
  commands_.add({"edit.undo", group, "undo", tr("&Undo"), tr("Take the last change back."), {QKeySequence::Undo}},
                [this] { page_->undo(); });
  commands_.add(
      {"edit.redo", group, "redo", tr("&Redo"), tr("Do again what was taken back."), {tr("Ctrl+Shift+Z"), tr("Ctrl+Y")}},
      [this] { page_->redo(); });
  commands_.add(
      {"edit.numbers", group, "expression", tr("Named &numbers…"), tr("Numbers with names that every field can use."), {}},
      [this] {
        auto* dialog = new NumbersDialog(page_->session(), page_->canvas()->window());
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
      });
  commands_.add({"edit.recompute",
                 group,
                 "refresh",
                 tr("Recomp&ute"),
                 tr("Compute every feature anew, also those whose results are known."),
                 {QKeySequence(Qt::Key_F5)}},
                [this] { page_->session().recompute(); });
}

DocumentTree& DocumentCommands::treeWithoutDrawing() {
  page_->endQuestion();
  return page_->tree();
}

void DocumentCommands::declareClipboard() {
  const QString group = tr("Edit");
  commands_.add({"edit.cut",
                 group,
                 "cut",
                 tr("Cu&t"),
                 tr("Take the selected features out, to be pasted elsewhere."),
                 {QKeySequence(QKeySequence::Cut)}},
                [this] { treeWithoutDrawing().cutSelected(); });
  commands_.add({"edit.copy",
                 group,
                 "copy",
                 tr("&Copy"),
                 tr("Keep the selected features, and what they are made from, to be pasted."),
                 {QKeySequence(QKeySequence::Copy)}},
                [this] { page_->tree().copySelected(); });
  commands_.add({"edit.paste",
                 group,
                 "paste",
                 tr("&Paste"),
                 tr("Add the features that were copied, in this document or another."),
                 {QKeySequence(QKeySequence::Paste)}},
                [this] { treeWithoutDrawing().paste(); });
  commands_.add({"edit.duplicate",
                 group,
                 "duplicate",
                 tr("&Duplicate"),
                 tr("Add the selected features once more, made from the same inputs."),
                 {tr("Ctrl+D")}},
                [this] { treeWithoutDrawing().duplicateSelected(); });
}

void DocumentCommands::declareFeatureEdits() {
  const QString group = tr("Edit");
  commands_.add({"edit.rename", group, "rename", tr("Re&name"), tr("Give the selected feature another name."), {tr("F2")}},
                [this] { page_->tree().renameCurrent(); });
  commands_.add({"edit.show-hide", group, "eye", tr("Show or &hide"), tr("Show or hide the selected features."), {tr("H")}},
                [this] { page_->tree().toggleSelected(); });
  commands_.add({"edit.isolate",
                 group,
                 "isolate",
                 tr("&Isolate"),
                 tr("Show only the selected features; once more: what was shown before."),
                 {tr("I")}},
                [this] { page_->tree().isolateSelected(); });
  commands_.add({"edit.show-all", group, "eye", tr("Sho&w everything"), tr("Show every feature."), {tr("Shift+H")}},
                [this] { page_->tree().showAll(); });
  commands_.add({"edit.suppress",
                 group,
                 "suppress",
                 tr("&Suppress"),
                 tr("Leave the selected features out of the computation, or take them in again."),
                 {tr("Ctrl+Shift+U")}},
                [this] { page_->tree().toggleSuppressed(); });
  commands_.add({"edit.move-up",
                 group,
                 "move-up",
                 tr("Move &up"),
                 tr("Put the selected features one place further up; edits that follow one another change places."),
                 {tr("Alt+Up")}},
                [this] { page_->tree().stepSelected(-1); });
  commands_.add({"edit.move-down",
                 group,
                 "move-down",
                 tr("Move do&wn"),
                 tr("Put the selected features one place further down; edits that follow one another change places."),
                 {tr("Alt+Down")}},
                [this] { page_->tree().stepSelected(1); });
  commands_.add({"edit.delete", group, "delete", tr("De&lete"), tr("Delete the selected features."), {QKeySequence::Delete}},
                [this] { page_->tree().removeSelected(); });
}

void DocumentCommands::declareSelection() {
  const QString group = tr("Edit");
  commands_.add({"edit.select-all",
                 group,
                 "select-all",
                 tr("Select &all"),
                 tr("Select every feature."),
                 {QKeySequence(QKeySequence::SelectAll)}},
                [this] { page_->tree().selectAll(); });
  commands_.add(
      {"edit.select-nothing", group, "select-none", tr("Select n&othing"), tr("Select no feature."), {tr("Ctrl+Shift+A")}},
      [this] { page_->tree().clearSelection(); });
  commands_.add({"edit.find",
                 group,
                 "search",
                 tr("&Find in the document"),
                 tr("Look for features by name, type or state."),
                 {QKeySequence(QKeySequence::Find)}},
                [this] { page_->treePanel().startSearch(); });
  commands_.add({"view.fit-selection",
                 tr("View"),
                 "fit",
                 tr("Fit to &selection"),
                 tr("Show just the selected features, as large as fits."),
                 {tr("Shift+F")}},
                [this] { fitToSelection(); });
}

// The box around what is selected is brought into sight.
void DocumentCommands::fitToSelection() {
  Bounds box;
  for (const FeatureId& id : page_->tree().selected())
    if (const auto view = page_->session().view(id)) box.add(bounds(view->result->evaluated.shape));
  if (box.empty) return page_->view().fit();
  std::vector<Vec3> corners;
  corners.reserve(8);
  for (const double x : {box.low.x(), box.high.x()})
    for (const double y : {box.low.y(), box.high.y()})
      for (const double z : {box.low.z(), box.high.z()}) corners.emplace_back(x, y, z);
  page_->view().fitTo(corners);
}

void DocumentCommands::addTo(QMenu* edit) {
  for (const auto* part : {&history, &clipboard, &featureEdits, &selection, &computing}) {
    for (const char* id : *part) edit->addAction(commands_.action(QLatin1String(id)));
    if (part != &computing) edit->addSeparator();
  }
}

void DocumentCommands::refreshHistory() {
  const auto describe = [&](const char* id, const QString& plain, const QString& full, const std::string& what,
                            const QString& whyNot) {
    QAction& action = *commands_.action(QLatin1String(id));
    const QString iconText = action.iconText();
    commands_.setEnabled(QLatin1String(id), !what.empty(), whyNot);
    action.setText(what.empty() ? plain : full.arg(qt(what)));
    action.setIconText(iconText);
  };
  describe("edit.undo", tr("&Undo"), tr("&Undo: %1"), page_->undoText(), tr("Nothing has been changed yet."));
  describe("edit.redo", tr("&Redo"), tr("&Redo: %1"), page_->redoText(), tr("Nothing was taken back."));
}

// "Hide" or "Show", "Suppress" or "Compute again": what would happen now.
void DocumentCommands::refreshWords() {
  const std::vector<FeatureId> ids = page_->tree().selected();
  const Document& document = page_->session().document();
  if (ids.empty() || !document.contains(ids.front())) return;
  const Feature& first = document.at(ids.front());
  commands_.action(QStringLiteral("edit.show-hide"))->setText(first.visible ? tr("&Hide") : tr("S&how"));
  commands_.action(QStringLiteral("edit.suppress"))->setText(first.suppressed ? tr("Compute a&gain") : tr("&Suppress"));
  const bool alone = areOnlyVisible(document, ids) && document.features().size() > ids.size();
  commands_.action(QStringLiteral("edit.isolate"))->setText(alone ? tr("End &isolation") : tr("&Isolate"));
}

void DocumentCommands::refresh() {
  if (!page_) return;
  refreshHistory();
  refreshWords();
  const std::size_t selected = page_->tree().selected().size();
  const bool empty = page_->session().document().features().empty();
  const QString selectFirst = tr("Select a feature first.");
  for (const char* id : {"edit.cut", "edit.copy", "edit.duplicate", "edit.show-hide", "edit.isolate", "edit.suppress",
                         "edit.move-up", "edit.move-down", "edit.delete", "view.fit-selection"})
    commands_.setEnabled(QLatin1String(id), selected > 0, selectFirst);
  commands_.setEnabled(QStringLiteral("edit.rename"), selected == 1,
                       selected == 0 ? selectFirst : tr("Select one feature only."));
  for (const char* id : {"edit.select-all", "edit.select-nothing", "edit.show-all", "edit.find"})
    commands_.setEnabled(QLatin1String(id), !empty, tr("The document is empty."));
}

void DocumentCommands::fillContextMenu(QMenu& menu) {
  const auto add = [&](const std::vector<const char*>& ids) {
    for (const char* id : ids) menu.addAction(commands_.action(QLatin1String(id)));
    menu.addSeparator();
  };
  if (page_->tree().selected().empty()) {
    add({"edit.paste"});
    add({"edit.show-all", "edit.select-all"});
    add({"view.fit", "view.home"});
    return;
  }
  const std::vector<QAction*> takers = featureMenus_.taking(page_->tree().selectedInTurn());
  if (!takers.empty()) {
    QMenu* use = menu.addMenu(tr("&Make from it"));
    use->addActions(QList<QAction*>(takers.begin(), takers.end()));
    menu.addSeparator();
  }
  add({"edit.rename", "edit.show-hide", "edit.isolate", "edit.suppress"});
  add({"view.fit-selection", "file.export"});
  add({"edit.move-up", "edit.move-down"});
  add({"edit.cut", "edit.copy", "edit.paste", "edit.duplicate"});
  add({"edit.delete"});
}

void DocumentCommands::popup(const QPoint& global) {
  if (!page_) return;
  refresh();
  auto* menu = new QMenu(window_);
  menu->setObjectName(QStringLiteral("contextMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  fillContextMenu(*menu);
  menu->popup(global);
}

}  // namespace blossom::ui
