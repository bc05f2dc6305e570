#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/version.h"
#include "feature/registry.h"

/// A plugin is a folder with plugin.json, a compute module (no widgets) and, for the window, a manipulator module:
///   {"id": "sweep", "title": "Sweep", "version": "0.1.0", "api": 9, "summary": "..", "icon": "sweep",
///    "compute": "libblossom_sweep.so", "manipulators": "libblossom_sweep_manipulators.so", "features": ["sweep.sweep"],
///    "formats": []}
/// `icon`, `manipulators` and `formats` may be left out.
/// The compute module exports `int blossomPluginApi()`, `std::uint32_t blossomPluginLayout()` and
/// `void blossomRegister(blossom::Registry&)`, which registers feature types, literal forms and file formats. It also
/// exports `void blossomRegisterWorkerCalls()`, by which a worker has the feature types declared once more, and so the calls
/// of those that run there (see isolate/in_worker.h). BLOSSOM_PLUGIN(registry) { .. } defines all four.
#define BLOSSOM_PLUGIN(registry)                                                                                            \
  extern "C" __attribute__((visibility("default"))) int blossomPluginApi() { return ::blossom::pluginApiVersion; }          \
  extern "C" __attribute__((visibility("default"))) std::uint32_t blossomPluginLayout() { return ::blossom::pluginLayout; } \
  extern "C" __attribute__((visibility("default"))) void blossomRegister(::blossom::Registry&);                             \
  extern "C" __attribute__((visibility("default"))) void blossomRegisterWorkerCalls() {                                     \
    ::blossom::Registry declared;                                                                                           \
    blossomRegister(declared);                                                                                              \
  }                                                                                                                         \
  extern "C" __attribute__((visibility("default"))) void blossomRegister(::blossom::Registry& registry)

namespace blossom {

/// Hash of the sizes of types; it differs between modules compiled with different definitions of them.
template <class... Types>
constexpr std::uint32_t layoutNumber() {
  std::uint32_t hash = 2166136261U;  // FNV-1a
  ((hash = (hash ^ static_cast<std::uint32_t>(sizeof(Types))) * 16777619U), ...);
  return hash;
}

/// Layout of the types that program and module exchange. pluginApiVersion has to be raised by hand when a meaning changes;
/// this number changes by itself when a module was compiled with other definitions of these types and would corrupt memory.
inline constexpr std::uint32_t pluginLayout =
    layoutNumber<Registry, FeatureType, InputSpec, ChoiceByOutput, InputByFlags, ParameterSpec, Evaluated, Measure, Inputs,
                 Format, Imported, Shape, Shape::Value, Value, Progress, CancelToken, Region, Curves, Curve, Surface, Brep,
                 Mesh, Motion, Sequence, MedialAxis, Toolpath, Setup>();

/// Content of plugin.json, which is read before any module is loaded.
struct PluginManifest {
  std::string id, title, version, summary, icon;
  int api = 0;
  std::string compute;                         ///< file name of the compute module, in the same folder
  std::string manipulators;                    ///< file name of the manipulator module; empty when there is none
  std::vector<std::string> features, formats;  ///< ids
  std::filesystem::path folder;
};

/// @throws Error PluginBroken naming the key that is missing or wrong.
PluginManifest readManifest(const std::filesystem::path& pluginJson);

struct LoadedPlugin {
  PluginManifest manifest;
  std::string problem;  ///< empty when the plugin was loaded, else a sentence why it was skipped
};

/// Folders searched for plugins, in order; of plugins with equal ids the first is loaded. $BLOSSOM_PLUGIN_PATH (separated by
/// colons), blossom/plugins beside Blossom's own libraries (in the build tree as in an installation), blossom/plugins in
/// $XDG_DATA_HOME or ~/.local/share. Each is either the folder of one plugin or contains such folders.
std::vector<std::filesystem::path> pluginSearchPath();

/// Loads every plugin found under `folders` and registers its features and formats. A plugin that is broken, missing its
/// module, made for another API or registers what its manifest does not declare is reported and skipped, and leaves nothing
/// in the registry. Never throws for a plugin's sake. Modules stay loaded until the process ends.
std::vector<LoadedPlugin> loadPlugins(Registry&, const std::vector<std::filesystem::path>& folders = pluginSearchPath());

}  // namespace blossom
