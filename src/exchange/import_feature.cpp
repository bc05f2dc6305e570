#include "exchange/import_feature.h"

#include <utility>

#include "core/error.h"

namespace blossom {
namespace {

struct ImportParameters {
  FileValue file;
};

std::string readableExtensions(const FormatRegistry& registry) {
  std::string list;
  for (const Format& format : registry.formats())
    if (format.read)
      for (const std::string& extension : format.extensions) list += (list.empty() ? "" : " ") + extension;
  return list;
}

}  // namespace

FeatureType importFeature(const FormatRegistry& registry) {
  using P = ImportParameters;
  return feature<P>("exchange.import", "Import", "A shape read from a file.")
      .command("import")
      .icon("import")
      .example("blossom import part.step -o part.stl")
      .parameter("file", &P::file, file(readableExtensions(registry)), "The file to read.")
      .evaluate([registry](const P& p, const Inputs&, const Progress& progress) {
        if (p.file.path.empty())
          throw Error(ErrorCode::InvalidParameter, "The file to import is not given.", "Choose a file.");
        Imported imported = readShape(registry, p.file.path, Value::object(), progress);
        Value stats = {{"entities", std::move(imported.entities)}, {"skipped", std::move(imported.skipped)}};
        return Evaluated{std::move(imported.shape), std::move(stats), std::move(imported.warnings)};
      });
}

}  // namespace blossom
