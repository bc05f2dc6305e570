#include "ui/window/action_state.h"

#include "document/edits.h"
#include "ui/page/page.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

ActionState actionState(DocumentPage& page) {
  const Session& session = page.session();
  const Document& document = session.document();
  const ViewWidget& view = page.view();
  ActionState state;
  state.page = &page;
  state.title = session.title();
  state.modified = session.modified();
  state.hasFile = !session.file().empty();
  state.empty = document.features().empty();
  state.undo = page.undoText();
  state.redo = page.redoText();
  state.selected = page.tree().selected();
  if (!state.selected.empty() && document.contains(state.selected.front())) {
    const Feature& first = document.at(state.selected.front());
    state.visible = first.visible;
    state.suppressed = first.suppressed;
    state.isolated = areOnlyVisible(document, state.selected) && document.features().size() > state.selected.size();
  }
  state.parallel = view.parallel();
  state.grid = view.gridVisible();
  state.displayMode = view.displayMode();
  state.pickMode = view.pickMode();
  state.sequence = page.playback().count() > 1;
  state.onionSkin = page.playback().onionSkin();
  state.measuring = page.measuring();
  state.section = view.section().has_value();
  state.theme = ThemeManager::instance().choice();
  return state;
}

}  // namespace blossom::ui
