#include "app/import_feature.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"

namespace blossom {
namespace {

constexpr const char* fileParameter = "file";

std::string readableExtensions(const FormatRegistry& registry) {
  std::string list;
  for (const Format& format : registry.formats())
    if (format.read)
      for (const std::string& extension : format.extensions) list += (list.empty() ? "" : " ") + extension;
  return list;
}

/// What the reader of a format leaves to the user, as one parameter.
ParameterSpec optionsOf(const Format& format) {
  ParameterSpec spec = record(format.readOptions);
  spec.name = format.id;
  spec.help = fmt::format("How files of the format {} are read.", format.title);
  spec.fallback = completed(format.readOptions, Value::object());
  return spec;
}

const Format* formatOf(const FormatRegistry& registry, const std::filesystem::path& file) {
  return file.has_extension() ? registry.find(file.extension().string()) : nullptr;
}

/// Options that another format has and that were set say nothing about this file.
std::vector<std::string> unusedOptions(const FormatRegistry& registry, const Value& parameters,
                                       const std::filesystem::path& file) {
  std::vector<std::string> warnings;
  for (const Format& format : registry.formats())
    if (const auto given = parameters.find(format.id);
        given != parameters.end() && !importUses(registry, format.id, file) && *given != optionsOf(format).fallback)
      warnings.push_back(
          fmt::format("The options for {} were not used: {} is another format.", format.title, file.filename().string()));
  return warnings;
}

Evaluated importedBy(const FormatRegistry& registry, const Value& parameters, const Progress& progress) {
  const std::filesystem::path file = parameters.at(fileParameter).value("path", "");
  if (file.empty()) throw Error(ErrorCode::InvalidParameter, "The file to import is not given.", "Choose a file.");
  const Format* format = formatOf(registry, file);
  const bool asks = format && parameters.contains(format->id);
  Imported imported = readShape(registry, file, asks ? parameters.at(format->id) : Value::object(), progress);
  for (std::string& warning : unusedOptions(registry, parameters, file)) imported.warnings.push_back(std::move(warning));
  Value stats = {{"entities", std::move(imported.entities)}, {"skipped", std::move(imported.skipped)}};
  return Evaluated{std::move(imported.shape), std::move(stats), std::move(imported.warnings)};
}

}  // namespace

bool importUses(const FormatRegistry& registry, std::string_view parameter, const std::filesystem::path& file) {
  if (parameter == fileParameter) return true;
  const Format* format = formatOf(registry, file);
  return format && format->id == parameter;
}

FeatureType importFeature(const FormatRegistry& registry) {
  FeatureType type;
  type.id = "exchange.import";
  type.command = type.icon = "import";
  type.title = "Import";
  type.summary = "A shape read from a file.";
  type.examples = {"blossom import part.step -o part.stl",
                   "blossom import surface.cpt --control-points.degree-u 2 -o surface.step"};
  ParameterSpec given = file(readableExtensions(registry));
  given.name = fileParameter;
  given.help = "The file to read.";
  type.parameters.push_back(std::move(given));
  for (const Format& format : registry.formats())
    if (format.read && !format.readOptions.empty()) type.parameters.push_back(optionsOf(format));
  type.evaluate = [registry](const Value& parameters, const Inputs&, const Progress& progress) {
    return importedBy(registry, parameters, progress);
  };
  return type;
}

}  // namespace blossom
