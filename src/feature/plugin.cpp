#define BOOST_DLL_USE_STD_FS
#include "feature/plugin.h"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>

#include "core/error.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

/// An object in a module that stays loaded; its address locates Blossom's own libraries.
void anchor() {}

[[noreturn]] void broken(const std::string& why) { throw Error(ErrorCode::PluginBroken, why); }

/// Never unloaded: registered functions, and even the exception of a plugin that failed, have their code in the module.
std::vector<boost::dll::shared_library>& loadedModules() {
  static auto* modules = new std::vector<boost::dll::shared_library>();
  return *modules;
}

const boost::dll::shared_library& loaded(const fs::path& module) {
  if (!fs::exists(module)) broken(fmt::format("Its module {} is missing.", module.filename().string()));
  try {
    // resolves all symbols now: a missing one is reported here instead of ending the program later
    return loadedModules().emplace_back(module, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  } catch (const std::system_error& e) {
    broken(fmt::format("Its module {} cannot be loaded: {}.", module.filename().string(), e.what()));
  }
}

template <class Function>
Function& symbol(const boost::dll::shared_library& module, const char* name) {
  if (!module.has(name))
    broken(fmt::format("Its module does not export {}; it was not made with BLOSSOM_PLUGIN of this Blossom.", name));
  return module.get<Function>(name);
}

std::string wrongApi(const PluginManifest& manifest, int api, const char* who) {
  return fmt::format("{} made for plugin interface {}, and this Blossom has {}. Get a version of {} for Blossom {}.", who,
                     api, pluginApiVersion, manifest.title.empty() ? manifest.id : manifest.title, versionText);
}

void registerFeatures(const PluginManifest& manifest, Registry& scratch) {
  const auto& module = loaded(manifest.folder / manifest.compute);
  const int api = symbol<int()>(module, "blossomPluginApi")();
  if (api != pluginApiVersion) broken(wrongApi(manifest, api, "Its module was"));
  if (symbol<std::uint32_t()>(module, "blossomPluginLayout")() != pluginLayout)
    broken(fmt::format("Its module was compiled with headers of another Blossom. Compile {} again with those of {}.",
                       manifest.title, versionText));
  auto& registerAll = symbol<void(Registry&)>(module, "blossomRegister");
  try {
    registerAll(scratch);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    broken(fmt::format("It failed while registering its features: {}.", e.what()));
  } catch (...) {
    broken("It failed while registering its features.");
  }
}

void compareIds(const std::string& kind, const std::vector<std::string>& declared, const std::set<std::string>& registered) {
  for (const auto& id : registered)
    if (std::find(declared.begin(), declared.end(), id) == declared.end())
      broken(fmt::format("It registers the {} {}, which its plugin.json does not declare.", kind, id));
  for (const auto& id : declared)
    if (!registered.contains(id))
      broken(fmt::format("It does not register the {} {}, which its plugin.json declares.", kind, id));
}

/// What the manifest declares and what is registered must be the same: the manifest is what menus and messages rely on.
void compareWithManifest(const PluginManifest& manifest, const Registry& scratch) {
  std::set<std::string> features, formats;
  for (const auto& type : scratch.types()) features.insert(type->id);
  for (const Format& format : scratch.formats().formats()) formats.insert(format.id);
  compareIds("feature", manifest.features, features);
  compareIds("format", manifest.formats, formats);
}

/// Nothing when a plugin of that id is loaded already.
std::optional<LoadedPlugin> loadPlugin(Registry& registry, const fs::path& file, const std::set<std::string>& loadedIds) {
  LoadedPlugin plugin;
  plugin.manifest.folder = file.parent_path();
  plugin.manifest.id = file.parent_path().filename().string();
  try {
    plugin.manifest = readManifest(file);
    if (loadedIds.contains(plugin.manifest.id)) return std::nullopt;
    if (plugin.manifest.api != pluginApiVersion) broken(wrongApi(plugin.manifest, plugin.manifest.api, "It was"));
    Registry scratch;
    registerFeatures(plugin.manifest, scratch);
    compareWithManifest(plugin.manifest, scratch);
    registry.merge(scratch);
  } catch (const std::exception& e) {
    plugin.problem = e.what();
  }
  return plugin;
}

/// Manifests in the folder itself and in the folders in it, by name.
std::vector<fs::path> manifestsIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ec;
  const auto look = [&](const fs::path& place) {
    std::error_code ignored;
    if (fs::exists(place / "plugin.json", ignored)) found.push_back(place / "plugin.json");
  };
  look(folder);
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) look(it->path());
  std::sort(found.begin(), found.end());
  return found;
}

fs::path homeFolder() {
  if (const char* home = std::getenv("HOME"); home && *home) return home;
  const passwd* user = ::getpwuid(::getuid());
  return user && user->pw_dir ? user->pw_dir : "";
}

fs::path userDataFolder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data) return data;
  const fs::path home = homeFolder();
  return home.empty() ? home : home / ".local/share";
}

}  // namespace

std::vector<fs::path> pluginSearchPath() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("BLOSSOM_PLUGIN_PATH")) {
    std::istringstream list(given);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) folders.emplace_back(folder);
  }
  folders.push_back(boost::dll::symbol_location(anchor).parent_path() / "blossom/plugins");
  if (const fs::path data = userDataFolder(); !data.empty()) folders.push_back(data / "blossom/plugins");
  return folders;
}

std::vector<LoadedPlugin> loadPlugins(Registry& registry, const std::vector<fs::path>& folders) {
  std::vector<LoadedPlugin> plugins;
  std::set<std::string> loadedIds;
  for (const auto& folder : folders) {
    for (const auto& file : manifestsIn(folder)) {
      auto plugin = loadPlugin(registry, file, loadedIds);
      if (!plugin) continue;
      if (plugin->problem.empty()) loadedIds.insert(plugin->manifest.id);
      plugins.push_back(std::move(*plugin));
    }
  }
  return plugins;
}

}  // namespace blossom
