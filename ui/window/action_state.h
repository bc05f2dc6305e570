#pragma once
#include <QString>
#include <string>
#include <vector>

#include "document/document.h"
#include "ui/look/theme.h"
#include "ui/view/items/view_items.h"

namespace blossom::ui {

class DocumentPage;

/// All that title, menus and tool bar show of a document and its view. They are refreshed when it has changed.
struct ActionState {
  const DocumentPage* page = nullptr;
  QString title;
  bool modified = false, hasFile = false, empty = false;
  std::string undo, redo;
  std::vector<FeatureId> selected;
  bool visible = false, suppressed = false, isolated = false;  // the first that is selected; the selected ones
  bool parallel = false, grid = false;
  DisplayMode displayMode = DisplayMode::ShadedWithEdges;
  PickMode pickMode = PickMode::Feature;
  bool sequence = false, onionSkin = false, measuring = false, section = false;
  ThemeChoice theme = ThemeChoice::System;
  bool operator==(const ActionState&) const = default;
};

ActionState actionState(DocumentPage&);

}  // namespace blossom::ui
