#include "document/evaluation.h"

#include <fmt/format.h>

#include <optional>

#include "core/stopwatch.h"
#include "document/error_of.h"
#include "document/storage.h"
#include "feature/acceptance.h"

namespace blossom {
namespace {

/// Whether the same content would meet the same error again.
bool lasting(const std::optional<Error>& error) {
  if (!error) return true;
  switch (error->code()) {
    case ErrorCode::InvalidParameter:
    case ErrorCode::InvalidInput:
    case ErrorCode::Degenerate:
    case ErrorCode::FormatDamaged:
    case ErrorCode::FormatUnknown:
      return true;
    default:
      return false;
  }
}

Error unknownType(const std::string& type) {
  const std::string plugin = type.substr(0, type.find('.'));
  return Error(ErrorCode::NotFound, fmt::format("The feature type \"{}\" is not known here.", type),
               fmt::format("It belongs to the plugin \"{}\", which is missing or could not be loaded.", plugin));
}

/// Fraction and stage of one feature as a share of the whole.
Progress shareOf(const Progress& whole, double from, double to, const std::string& name) {
  return Progress(whole.token(), [whole, from, to, name](double fraction, const std::string& stage) {
    whole.report(from + (to - from) * fraction, stage.empty() ? name : name + ": " + stage);
  });
}

}  // namespace

Results Evaluation::run(const Progress& progress, const Evaluator::Done& done) {
  Results results;
  const auto features = document_.features();
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Feature& feature = *features[i];
    const double from = static_cast<double>(i) / static_cast<double>(features.size());
    progress.report(from, shownName(feature));
    Outcome& outcome = outcomes_[feature.id];
    auto result =
        feature.suppressed
            ? passedOn(feature, outcome)
            : evaluated(feature, outcome,
                        shareOf(progress, from, from + 1.0 / static_cast<double>(features.size()), shownName(feature)));
    outcome.shape = result->evaluated.shape;
    outcome.warnings = result->evaluated.warnings;
    if (result->error && !outcome.rootError) outcome.rootError = std::make_shared<const Error>(*result->error);
    if (done) done(feature.id, result);
    results.emplace(feature.id, std::move(result));
  }
  progress.report(1);
  return results;
}

std::shared_ptr<const FeatureResult> Evaluation::evaluated(const Feature& feature, Outcome& outcome,
                                                           const Progress& progress) {
  auto result = std::make_shared<FeatureResult>();
  std::string key;
  std::shared_ptr<const FeatureResult> known;
  std::optional<Stopwatch> watch;
  result->error = errorOf(shownName(feature), [&] {
    const auto type = registry_.find(feature.type);
    if (!type) throw unknownType(feature.type);
    checkInputs(feature, outcome);
    Value keyed;
    const Value parameters = openedFiles(type->parameters, completed(type->parameters, feature.parameters), keyed);
    checkNamedInputs(*type, parameters);
    key = keyOf(feature, keyed);
    known = cache_.find(key);
    if (known) return;
    const Inputs arranged = inputsOf(feature, *type);
    watch.emplace();
    result->evaluated = type->evaluate(parameters, arranged, progress);
    checkGiven(*type, result->evaluated.shape);
    refuseInfiniteFigures(result->evaluated);
  });
  if (watch) result->kernelMs = watch->elapsedMs();
  if (known) {
    result = std::make_shared<FeatureResult>(*known);
    result->fromCache = true;
    result->kernelMs = 0;
  } else if (!key.empty() && lasting(result->error)) {
    cache_.store(key, result);
  }
  if (!result->error) outcome.key = key;
  return result;
}

/// @throws Error of arrangedInputs; what the inputs were warned of may be why they do not fit.
Inputs Evaluation::inputsOf(const Feature& feature, const FeatureType& type) const {
  std::vector<Shape> shapes;
  std::string told;
  for (const FeatureId& id : feature.inputs) {
    const Outcome& input = outcomes_.at(id);
    shapes.push_back(input.shape);
    for (const std::string& warning : input.warnings)
      told += fmt::format(" \"{}\": {}", shownName(document_.at(id)), warning);
  }
  try {
    return arrangedInputs(type, shapes);
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), error.hint() + told);
  }
}

std::shared_ptr<const FeatureResult> Evaluation::passedOn(const Feature& feature, Outcome& outcome) {
  auto result = std::make_shared<FeatureResult>();
  if (feature.inputs.empty()) return result;
  result->error = errorOf(shownName(feature), [&] {
    Feature first = feature;
    first.inputs.resize(1);
    checkInputs(first, outcome);
  });
  const Outcome& input = outcomes_.at(feature.inputs.front());
  result->evaluated.shape = input.shape;
  outcome.key = input.key;
  return result;
}

/// @throws Error InvalidInput that names the first input that failed and where the failure began.
void Evaluation::checkInputs(const Feature& feature, Outcome& outcome) const {
  for (const auto& id : feature.inputs) {
    const Outcome& input = outcomes_.at(id);
    if (!input.rootError) continue;
    outcome.rootError = input.rootError;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("Its input \"{}\" failed: {}", shownName(document_.at(id)), input.rootError->message()),
                input.rootError->hint());
  }
}

/// The parameters with paths that can be opened; `keyed` gets them with content hashes in place of paths.
Value Evaluation::openedFiles(const std::vector<ParameterSpec>& specs, Value parameters, Value& keyed) {
  keyed = parameters;
  for (const auto& spec : specs) openFiles(spec, parameters[spec.name], keyed[spec.name]);
  return parameters;
}

void Evaluation::openFiles(const ParameterSpec& spec, Value& parameter, Value& keyed) {
  if (parameter.is_null()) return;
  if (spec.kind == ParameterKind::File) {
    const auto opened = files_.open(parameter, document_);
    // the name counts: readers go by the extension, and some results carry the file's name
    keyed = {{"name", opened.path.filename().string()}, {"content", opened.hash}};
    parameter = {{"path", opened.path.string()}, {"asset", parameter.value("asset", "")}};
  } else if (spec.kind == ParameterKind::List) {
    for (std::size_t i = 0; i < parameter.size(); ++i) openFiles(spec.fields.at(0), parameter[i], keyed[i]);
  } else if (spec.kind == ParameterKind::Record) {
    for (const auto& field : spec.fields) openFiles(field, parameter[field.name], keyed[field.name]);
  }
}

std::string Evaluation::keyOf(const Feature& feature, const Value& keyed) const {
  Value content = Value::array({feature.type, keyed});
  for (const auto& input : feature.inputs) content.push_back(outcomes_.at(input).key);
  return contentHash(content.dump(-1, ' ', false, Value::error_handler_t::replace));
}

}  // namespace blossom
