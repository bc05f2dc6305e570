#include "app/app.h"

#include <fmt/format.h>

#include <cstdlib>

#include "app/import_feature.h"
#include "app/literal_feature.h"
#include "app/picture_format.h"
#include "core/error.h"
#include "core/lower_case.h"
#include "document/edits.h"
#include "document/file_access.h"
#include "document/named_numbers.h"
#include "exchange/formats.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

constexpr const char* importType = "exchange.import";

/// A file name as the tree shows it; bytes that are not UTF-8 cannot stand in a document.
std::string readableName(const fs::path& file) {
  const std::string name = file.stem().string();
  return Value::parse(Value(name).dump(-1, ' ', false, Value::error_handler_t::replace)).get<std::string>();
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
  auto registry = std::make_shared<Registry>();
  const FormatRegistry standard = standardFormats();
  for (const Format& format : standard.formats()) registry->add(format);
  registry->add(pngFormat());
  registry->add(ogvFormat());
  registry->add(importFeature(registry->formats()));
  registry->add(literalFeature(registry));
  App app;
  app.plugins = loadPlugins(*registry, pluginFolders);
  registry->replace(importFeature(registry->formats()));  // now it reads the formats of the plugins, too
  app.formats = std::shared_ptr<const FormatRegistry>(registry, &registry->formats());
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

bool isDocument(const fs::path& file) { return lowerCase(file.extension().string()) == ".blossom"; }

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
  Feature import = newFeature(document, *app.registry->at(importType));
  import.name = freeName(document, readableName(file));
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
  return withFilesEmbedded(*app.registry, linked);
}

namespace {

/// The shape of an import taken apart by the type that opens it. A file that cannot be read is told of by its import.
TakenApart takenApart(const App& app, const FeatureType& opener, const fs::path& file) {
  if (!opener.takesApart) return {};
  try {
    return opener.takesApart(readShape(*app.formats, file, Value::object(), Progress::none()).shape);
  } catch (const Error&) {
    return {};
  }
}

/// The import, the steps that the shape is taken apart into, and the feature that opens it.
Document withOpened(const App& app, Document document, const FeatureId& import, const TakenApart& apart,
                    const FeatureType& opener) {
  FeatureId last = import;
  for (const TakenApart::Step& step : apart.steps) {
    Feature feature = newFeature(document, *app.registry->at(step.type), {last});
    feature.parameters.update(step.parameters);
    last = feature.id;
    document = document.with(std::move(feature));
  }
  return document.with(newFeature(document, opener, {last}));
}

}  // namespace

OpenedDocument openAny(const App& app, const fs::path& file, bool salvage) {
  if (isDocument(file)) {
    OpenedDocument document = openDocument(file, salvage);
    document.document = withNumbersApplied(document.document, *app.registry);
    return document;
  }
  FeatureId import;
  OpenedDocument opened{withImported(app, Document(), file, &import), {}};
  const auto opener = app.registry->opening(readableFormat(app, file).reads);
  if (opener) {
    Feature read = opened.document.at(import);
    const TakenApart apart = takenApart(app, *opener, file);
    read.parameters.update(apart.importedWith);
    read.visible = opener->inputs.front().use == InputUse::Consumed;  // which steps back by itself
    opened.document = withOpened(app, opened.document.with(std::move(read)), import, apart, *opener);
  }
  return opened;
}

}  // namespace blossom
