#include "ui/window/manipulator_loader.h"

#include <fmt/format.h>

#include <boost/dll/shared_library.hpp>
#include <list>

#include "core/error.h"

namespace blossom::ui {

namespace {

// Never unloaded: overlays registered by a module are functions inside it.
std::list<boost::dll::shared_library>& loadedModules() {
  static auto* modules = new std::list<boost::dll::shared_library>();
  return *modules;
}

void load(ManipulatorRegistry& registry, const PluginManifest& manifest) {
  const auto file = manifest.folder / manifest.manipulators;
  if (!std::filesystem::exists(file))
    throw Error(ErrorCode::PluginBroken, fmt::format("its module {} is missing", file.filename().string()));
  boost::dll::shared_library module(file.string());
  const int api = module.get<int()>("blossomManipulatorApi")();
  if (api != pluginApiVersion)
    throw Error(ErrorCode::PluginBroken, fmt::format("it was made for interface {}, this is {}", api, pluginApiVersion));
  if (!module.has("blossomManipulatorLayout") ||
      module.get<std::uint32_t()>("blossomManipulatorLayout")() != manipulatorLayout)
    throw Error(ErrorCode::PluginBroken, "it was compiled with headers of another Blossom; compile it again");
  // Registered apart first, so that a module that throws half-way leaves nothing behind.
  ManipulatorRegistry own;
  module.get<void(ManipulatorRegistry&)>("blossomRegisterManipulators")(own);
  registry.add(own);
  loadedModules().push_back(std::move(module));
}

}  // namespace

std::vector<std::string> loadManipulators(ManipulatorRegistry& registry, const std::vector<LoadedPlugin>& plugins) {
  std::vector<std::string> problems;
  for (const LoadedPlugin& plugin : plugins) {
    if (!plugin.problem.empty() || plugin.manifest.manipulators.empty()) continue;
    try {
      load(registry, plugin.manifest);
    } catch (const std::exception& problem) {
      problems.push_back(
          fmt::format("The handles of the plugin {} could not be loaded: {}.", plugin.manifest.title, problem.what()));
    }
  }
  return problems;
}

}  // namespace blossom::ui
