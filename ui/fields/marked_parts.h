#pragma once
#include <optional>
#include <vector>

#include "ui/plugin/tool.h"

namespace blossom::ui {

/// Parts that a form marks in the view: those that a field holds while more are picked for it, and the one whose chip the
/// mouse is on.
struct MarkedParts {
  std::vector<Pick> chosen;
  std::optional<Pick> pointed;
};

}  // namespace blossom::ui
