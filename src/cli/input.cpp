#include "cli/input.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/import_feature.h"
#include "document/edits.h"
#include "document/file_access.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

/// "model.blossom#sweep-1" -> {"model.blossom", "sweep-1"}; a file whose own name contains the # takes precedence.
std::pair<fs::path, std::string> splitFeature(const std::string& text) {
  const auto mark = text.rfind('#');
  std::error_code ec;
  if (mark == std::string::npos || fs::exists(text, ec) || !isDocument(text.substr(0, mark))) return {text, ""};
  return {text.substr(0, mark), text.substr(mark + 1)};
}

bool isLiteral(const App& app, const std::string& text) {
  const std::string name = text.substr(0, text.find(':'));
  const auto& forms = app.registry->literals();
  return std::any_of(forms.begin(), forms.end(), [&](const auto& form) { return form.name == name; });
}

std::string literalHint(const App& app, const std::string& text) {
  std::string forms;
  for (const auto& form : app.registry->literals()) forms += (forms.empty() ? "" : ", ") + form.syntax;
  if (text.find(':') == std::string::npos || forms.empty()) return "Check the name and the folder.";
  return fmt::format("Shapes that can be written down are {}.", forms);
}

FeatureId addLiteral(Document& document, const std::string& text) {
  Feature literal;
  literal.type = "blossom.literal";
  literal.id = document.freshId("literal");
  literal.name = text;
  literal.parameters["text"] = text;
  document = document.with(literal);
  return literal.id;
}

/// Whether anything of a damaged document is readable, found out by trying.
std::string salvageHint(const App& app, const fs::path& file) {
  try {
    const std::size_t count = openAny(app, file, true).document.features().size();
    return fmt::format("With --salvage, what is readable of it is opened: {} feature{}.", count, count == 1 ? "" : "s");
  } catch (const Error& error) {
    return error.hint();
  }
}

FeatureId addFromDocument(const Invocation& invocation, Document& document, const fs::path& file, const std::string& wanted,
                          std::vector<std::string>& warnings) {
  const OpenedDocument opened = openInput(invocation, file);
  warnings.insert(warnings.end(), opened.warnings.begin(), opened.warnings.end());
  const FeatureId id = wanted.empty() ? lastFeature(opened.document).id : wanted;
  if (!opened.document.contains(id)) {
    std::vector<std::string> known;
    for (const auto& each : opened.document.features()) known.push_back(each->id);
    const std::string near = nearestName(id, known);
    throw Error(ErrorCode::NotFound, fmt::format("The document {} has no feature \"{}\".", file.string(), id),
                near.empty() ? fmt::format("\"blossom info {}\" lists its features.", file.string())
                             : fmt::format("Did you mean {}?", near));
  }
  FeatureId added;
  document = withFeatureOf(*invocation.app.registry, document, opened.document, id, &added);
  return added;
}

}  // namespace

fs::path fileOfInput(const std::string& text) {
  const fs::path file = splitFeature(text).first;
  std::error_code ec;
  return fs::exists(file, ec) ? file : fs::path();
}

OpenedDocument openInput(const Invocation& invocation, const fs::path& file) {
  try {
    OpenedDocument opened = openAny(invocation.app, file, invocation.salvage);
    if (invocation.allowFiles && isDocument(file))
      opened.document = opened.document.withAccess(FileAccess::everywhere(fs::absolute(file).parent_path()));
    return opened;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::FormatDamaged || invocation.salvage || !isDocument(file)) throw;
    throw Error(error.code(), error.message(), salvageHint(invocation.app, file));
  }
}

FeatureId addInput(const Invocation& invocation, Document& document, const std::string& text,
                   std::vector<std::string>& warnings, const Value& options) {
  if (text.empty()) throw UsageError("An input is empty.", "Give the name of a file or a shape such as ball:5:3.");
  const auto [file, wanted] = splitFeature(text);
  std::error_code ec;
  if (!fs::exists(file, ec)) {
    if (isLiteral(invocation.app, text)) return addLiteral(document, text);
    throw Error(ErrorCode::FileNotFound, fmt::format("The file {} does not exist.", file.string()),
                literalHint(invocation.app, text));
  }
  if (isDocument(file) && !fs::is_directory(file, ec)) return addFromDocument(invocation, document, file, wanted, warnings);
  FeatureId added;
  document = withLinked(invocation.app, document, file, &added);
  Feature import = document.at(added);
  for (const auto& [format, given] : options.items())
    if (importUses(*invocation.app.formats, format, file)) import.parameters[format] = given;
  document = document.with(std::move(import));
  return added;
}

const Error& rootCause(const Document& document, const Results& results, const FeatureId& id) {
  for (const FeatureId& input : document.at(id).inputs) {
    const auto result = results.find(input);
    if (result != results.end() && result->second->error) return rootCause(document, results, input);
  }
  return *results.at(id)->error;
}

std::shared_ptr<const FeatureResult> evaluateFor(const App& app, const Document& document, const FeatureId& wanted,
                                                 const Progress& progress, Results* all) {
  Results results = Evaluator(app.registry).evaluate(document, progress);
  const auto found = results.find(wanted);
  if (found == results.end())
    throw Error(ErrorCode::InvalidInput, fmt::format("The feature \"{}\" is suppressed.", wanted),
                "Choose another feature.");
  auto result = found->second;
  if (result->error) throw Error(rootCause(document, results, wanted));
  if (all) *all = std::move(results);
  return result;
}

}  // namespace blossom
