#pragma once
#include <string>
#include <vector>

#include "feature/plugin.h"
#include "ui/plugin/manipulator.h"

namespace blossom::ui {

/// Loads the manipulator halves of the plugins that were loaded and registers what they show. A broken one is skipped.
/// @returns what went wrong, a sentence each. Modules stay loaded until the process ends.
std::vector<std::string> loadManipulators(ManipulatorRegistry&, const std::vector<LoadedPlugin>&);

}  // namespace blossom::ui
