#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/evaluator.h"
#include "document/storage.h"
#include "exchange/format/format.h"
#include "feature/plugin.h"
#include "feature/registry.h"

namespace blossom {

/// What command line and window share: the feature types, the formats and the plugins of this installation.
struct App {
  std::shared_ptr<const FormatRegistry> formats;
  std::shared_ptr<const Registry> registry;
  std::vector<LoadedPlugin> plugins;
  std::shared_ptr<ResultStore> results = nullptr;  ///< of the window, which opens the same documents again
};

/// Registers built-in features and formats and loads the plugins. Broken plugins are in `plugins` with their problem.
App loadApp(const std::vector<std::filesystem::path>& pluginFolders = pluginSearchPath());

/// A store of results in a folder for the programs and plugins of this installation: those of others are not found.
std::shared_ptr<ResultStore> resultStore(const std::filesystem::path& folder);

/// Samples, manual and icons: $BLOSSOM_RESOURCES, ../share/blossom beside the program (installed), or the source tree's
/// resources.
/// @throws Error NotFound naming the places looked at.
std::filesystem::path resourceFolder();

/// Whether a file belongs to this installation: samples and manual, which must not be overwritten.
bool isResource(const std::filesystem::path&);
/// @throws Error FileUnwritable for a file of this installation.
void refuseResource(const std::filesystem::path& written);

/// The document with an import feature for `file` added; its content is taken into the document as an asset.
/// @throws Error FileNotFound, FileUnreadable, FormatUnknown.
Document withImported(const App&, const Document&, const std::filesystem::path& file, FeatureId* added = nullptr);

/// The same, but the feature names the file where it lies: for documents that live no longer than a command.
Document withLinked(const App&, const Document&, const std::filesystem::path& file, FeatureId* added = nullptr);

/// A document from any file: a .blossom is opened, anything else imported into a new document. Where the format tells what
/// kind of shape it reads and a feature type opens that kind (a sweep opens motions), a feature of that type follows. What
/// that type takes apart (the edits of a motion) goes between them as features.
OpenedDocument openAny(const App&, const std::filesystem::path&, bool salvage = false);

/// Is it a Blossom document by its extension?
bool isDocument(const std::filesystem::path&);

}  // namespace blossom
