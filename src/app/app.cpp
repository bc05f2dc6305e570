#include "app/app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include "app/literal_feature.h"
#include "core/error.h"
#include "core/file.h"
#include "core/zip_archive.h"
#include "document/file_access.h"
#include "document/file_values.h"
#include "exchange/format/import_feature.h"
#include "scene/scene.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

constexpr const char* importType = "exchange.import";
constexpr const char* sweepType = "sweep.sweep";

/// A file name as the tree shows it; bytes that are not UTF-8 cannot stand in a document.
std::string readableName(const fs::path& file) {
  const std::string name = file.stem().string();
  return Value::parse(Value(name).dump(-1, ' ', false, Value::error_handler_t::replace)).get<std::string>();
}

bool isEmbedded(const Value& file) { return !file.value("asset", std::string()).empty(); }

/// The path of a file value becomes an asset.
void embed(Value& file, Document& document) {
  const std::string path = file.value("path", std::string());
  const FileAccess* const access = document.access().get();
  if (isEmbedded(file) || path.empty() || (access && !access->permits(path))) return;
  auto content = std::make_shared<const std::string>(readFile(access ? access->opened(path) : fs::path(path)));
  if (content->size() > ZipLimits{}.entry)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The file {} has {} MB; a document can keep files of at most {} MB.", path,
                            content->size() >> 20, ZipLimits{}.entry >> 20),
                "Divide the file, or make it smaller.");
  const std::string hash = contentHash(*content);
  document = document.withAsset(hash, std::move(content));
  // Where it lay on this machine is nobody else's business.
  file = Value{{"path", fs::path(path).filename().string()}, {"asset", hash}};
}

using FileVisit = std::function<void(Value& file, Document&)>;

/// The document with every file value as `visit` leaves it.
Document withFilesVisited(const App& app, const Document& document, const FileVisit& visit) {
  Document result = document;
  for (const auto& each : document.features()) {
    const auto type = app.registry->find(each->type);
    if (!type || !hasFileParameter(type->parameters)) continue;
    Feature changed = *each;
    eachFile(type->parameters, changed.parameters, [&](Value& file) { visit(file, result); });
    if (!(changed == *each)) result = result.with(std::move(changed));
  }
  return result;
}

/// A file that a feature of `other` names means in `into` the same file, and may be read there only if it might before.
void settle(Value& file, const Document& other, Document& into) {
  const FileAccess* const access = other.access().get();
  const std::string path = file.value("path", std::string());
  if (!access || path.empty() || other.assets().contains(file.value("asset", std::string()))) return;
  const fs::path place = access->resolved(path);
  file["path"] = place.string();
  if (!access->permits(place)) {
    if (!into.access()) into = into.withAccess(FileAccess::everywhere());
    into.access()->refuse(place);
  } else if (into.access()) {
    into.access()->allow(place);
  }
}

void takeAncestors(const Document& document, const FeatureId& id, std::set<FeatureId>& taken) {
  if (!taken.insert(id).second) return;
  for (const FeatureId& input : document.at(id).inputs) takeAncestors(document, input, taken);
}

std::string commandOf(const App& app, const std::string& type) {
  if (const auto known = app.registry->find(type)) return known->command;
  return type.substr(type.rfind('.') + 1);
}

const Format& readableFormat(const App& app, const fs::path& file) {
  const Format* format = file.has_extension() ? app.formats->find(file.extension().string()) : nullptr;
  if (format && format->read) return *format;
  std::string known;
  for (const Format& each : app.formats->formats())
    if (each.read) known += (known.empty() ? "." : ", .") + each.extensions.front();
  throw Error(ErrorCode::FormatUnknown, fmt::format("The file {} has no extension that Blossom reads.", file.string()),
              fmt::format("Blossom reads {}.", known));
}

}  // namespace

App loadApp(const std::vector<fs::path>& pluginFolders) {
  auto formats = std::make_shared<FormatRegistry>(standardFormats());
  addPictureFormats(*formats);
  auto registry = std::make_shared<Registry>();
  registry->add(importFeature(*formats));
  registry->add(literalFeature(registry));
  App app;
  app.plugins = loadPlugins(*registry, pluginFolders);
  app.formats = std::move(formats);
  app.registry = std::move(registry);
  return app;
}

fs::path resourceFolder() {
  std::error_code ec;
  if (const char* given = std::getenv("BLOSSOM_RESOURCES"); given && *given) return given;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec);
  fs::path installed = program.parent_path().parent_path() / "share/blossom";
  if (fs::is_directory(installed / "samples", ec)) return installed;
  for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (fs::is_directory(folder / "resources/samples", ec)) return folder / "resources";
  throw Error(ErrorCode::NotFound, "Blossom's samples and manual are not installed.",
              fmt::format("They were looked for in {} and beside the program; BLOSSOM_RESOURCES names another folder.",
                          installed.string()));
}

bool isResource(const fs::path& file) {
  fs::path folder;
  try {
    folder = resourceFolder();
  } catch (const Error&) {
    return false;  // nothing is installed
  }
  return FileAccess::below(folder)->permits(fs::absolute(file));
}

void refuseResource(const fs::path& written) {
  if (!isResource(written)) return;
  throw Error(ErrorCode::FileUnwritable, fmt::format("The file {} belongs to Blossom itself.", written.string()),
              "Save in a folder of your own.");
}

bool isDocument(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".blossom";
}

Document withLinked(const App& app, const Document& document, const fs::path& file, FeatureId* added) {
  std::error_code ec;
  const auto status = fs::status(file, ec);
  if (!fs::exists(status))
    throw Error(ErrorCode::FileNotFound, fmt::format("The file {} does not exist.", file.string()),
                "Check the name and the folder.");
  if (!fs::is_regular_file(status))
    throw Error(ErrorCode::FileUnreadable, fmt::format("{} is not a file.", file.string()),
                "Give a file, not a folder or a device.");
  readableFormat(app, file);
  Feature import;
  import.type = importType;
  import.id = document.freshId(commandOf(app, importType));
  import.name = readableName(file);
  const fs::path named = document.access() ? fs::absolute(file) : file;  // whose own paths begin elsewhere
  if (document.access()) document.access()->allow(named);
  import.parameters["file"] = Value{{"path", named.string()}, { "asset", "" }};
  if (added) *added = import.id;
  return document.with(std::move(import));
}

Document withImported(const App& app, const Document& document, const fs::path& file, FeatureId* added) {
  FeatureId id;
  const Document linked = withLinked(app, document, file, &id);
  if (added) *added = id;
  return withFilesEmbedded(app, linked);
}

Document withFilesEmbedded(const App& app, const Document& document) { return withFilesVisited(app, document, embed); }

Document withFoundFilesEmbedded(const App& app, const Document& document) {
  return withFilesVisited(app, document, [](Value& file, Document& result) {
    try {
      embed(file, result);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::FileNotFound && error.code() != ErrorCode::FileUnreadable) throw;
    }
  });
}

std::vector<fs::path> withheldFiles(const App& app, const Document& document) {
  std::set<fs::path> withheld;
  withFilesVisited(app, document, [&](Value& file, Document&) {
    const fs::path path = file.value("path", std::string());
    const bool kept = document.assets().contains(file.value("asset", std::string()));
    if (!kept && !path.empty() && document.access() && !document.access()->permits(path))
      withheld.insert(document.access()->resolved(path));
  });
  return {withheld.begin(), withheld.end()};
}

Document withFeatureOf(const App& app, const Document& into, const Document& other, const FeatureId& wanted,
                       FeatureId* added) {
  std::set<FeatureId> taken;
  takeAncestors(other, wanted, taken);
  Document result = into;
  for (const auto& [hash, content] : other.assets()) result = result.withAsset(hash, content);
  std::map<FeatureId, FeatureId> renamed;
  for (const auto& each : other.features()) {
    if (!taken.contains(each->id)) continue;
    Feature copy = *each;
    if (result.contains(copy.id)) copy.id = result.freshId(commandOf(app, copy.type));
    renamed[each->id] = copy.id;
    for (FeatureId& input : copy.inputs) input = renamed.at(input);
    if (const auto type = app.registry->find(copy.type))
      eachFile(type->parameters, copy.parameters, [&](Value& file) { settle(file, other, result); });
    result = result.with(std::move(copy));
  }
  if (added) *added = renamed.at(wanted);
  return result;
}

const Feature& lastFeature(const Document& document) {
  const auto features = document.features();
  const auto last = std::find_if(features.rbegin(), features.rend(), [](const auto& each) { return !each->suppressed; });
  if (last == features.rend())
    throw Error(ErrorCode::InvalidInput, "The document holds no feature.", "Add one, or choose another document.");
  return **last;
}

OpenedDocument openAny(const App& app, const fs::path& file, bool salvage) {
  if (isDocument(file)) return openDocument(file, salvage);
  FeatureId import;
  OpenedDocument opened{withImported(app, Document(), file, &import), {}};
  const auto sweep = app.registry->find(sweepType);
  if (readableFormat(app, file).id == "motion" && sweep) {
    Feature motion = opened.document.at(import);
    motion.visible = false;
    Feature swept;
    swept.type = sweepType;
    swept.id = opened.document.freshId(sweep->command);
    swept.name = sweep->title;
    swept.inputs = {import};
    opened.document = opened.document.with(std::move(motion)).with(std::move(swept));
  }
  return opened;
}

}  // namespace blossom
