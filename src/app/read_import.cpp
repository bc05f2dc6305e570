#include "app/read_import.h"

#include <fmt/format.h>

#include <vector>

#include "exchange/format/format.h"

namespace blossom {
namespace {

/// The feature alone, which has no inputs, with the files of the document.
Document alone(const Document& document, const FeatureId& id) {
  std::vector<FeatureId> others;
  for (const auto& feature : document.features())
    if (feature->id != id) others.push_back(feature->id);
  Document left = document;
  for (auto other = others.rbegin(); other != others.rend(); ++other) left = left.without(*other);  // users first
  return left;
}

/// Whether other options may help: the user then finds them beside the error.
bool optionsMayHelp(const FormatRegistry& formats, const std::filesystem::path& file, const Error& error) {
  switch (error.code()) {
    case ErrorCode::FileNotFound:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FormatDamaged:
    case ErrorCode::FormatUnknown:
      return false;
    default:
      break;
  }
  const Format* format = file.has_extension() ? formats.find(file.extension().string()) : nullptr;
  return format && !format->readOptions.empty();
}

}  // namespace

void readImport(const App& app, Evaluator& evaluator, const Document& document, const FeatureId& import,
                const Progress& progress) {
  const Results results = evaluator.evaluateBeside(alone(document, import), progress);
  const std::optional<Error>& error = results.at(import)->error;
  if (!error) return;
  const std::filesystem::path file = document.at(import).parameters.at("file").value("path", "");
  if (optionsMayHelp(*app.formats, file, *error)) return;
  const std::string name = file.filename().string();
  const bool named = error->message().find(name) != std::string::npos;
  throw Error(error->code(), named ? error->message() : fmt::format("{}: {}", name, error->message()), error->hint());
}

}  // namespace blossom
