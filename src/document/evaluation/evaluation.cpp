#include "document/evaluation/evaluation.h"

#include <fmt/format.h>

#include <optional>

#include "core/stopwatch.h"
#include "document/error_of.h"
#include "document/part_references.h"
#include "document/storage.h"
#include "feature/acceptance.h"
#include "results/result_store.h"

namespace blossom {
namespace {

/// Where a feature type that runs in a child process tells what that costs beside its kernel.
constexpr const char* workerTime = "worker_ms";

/// What is computed quicker than this, in ms, is not read from the disk any quicker.
constexpr double worthIt = 10;

/// Measures gouge with the function of a result that is computed anew when it is asked for.
GougeOf gougeAnew(const FeatureType& type, const Value& parameters, const Inputs& inputs) {
  return [evaluate = type.evaluate, parameters, inputs](const Toolpath& other, const Progress& progress) {
    const Evaluated made = evaluate(parameters, inputs, progress.part(0, 0.5));
    return made.shape.get<Toolpath>()->gougeOf(other, progress.part(0.5, 1));
  };
}

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

/// Whether what was kept may be a result of this type; files in a folder may be anything.
bool isOf(const FeatureType& type, const KeptResult& kept) {
  try {
    checkResult(type, kept.evaluated.shape);
  } catch (const Error&) {
    return false;
  }
  return !kept.gougeLeftOut || kept.evaluated.shape.get<Toolpath>() != nullptr;
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
  double all = 0;
  for (const auto& feature : document_.features()) all += feature->suppressed ? 0 : costs_.expected(*feature);
  ShareDone share(all);
  for (const auto& each : document_.features()) {
    const Feature& feature = *each;
    const double expected = feature.suppressed ? 0 : costs_.expected(feature);
    progress.report(share.now(), shownName(feature));
    Outcome& outcome = outcomes_[feature.id];
    auto result = feature.suppressed ? passedOn(feature, outcome)
                                     : evaluated(feature, outcome,
                                                 shareOf(progress, share.now(), share.with(expected), shownName(feature)));
    share.finish(expected, result->fromCache);
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
  std::shared_ptr<const FeatureResult> found;
  std::optional<Stopwatch> watch;
  bool changed = false;
  Value parts = Value::object();
  result->error = errorOf(shownName(feature), [&] {
    const auto type = registry_.find(feature.type);
    if (!type) throw unknownType(feature.type);
    checkInputs(feature, outcome);
    Value named = completed(type->parameters, feature.parameters), keyed;
    checkNamedInputs(*type, named);
    std::optional<Inputs> arranged;
    if (namesParts(type->parameters, named)) {
      arranged = inputsOf(feature, *type);
      FoundParts again = foundParts(feature, *type, named, *arranged, construction_, progress);
      named = std::move(again.now);
      parts = std::move(again.kept);
      result->lost = std::move(again.lost);
      if (!result->lost.empty()) throw lostError(result->lost.front());
    }
    const Value before = outcome.parameters = named;
    const Value parameters = openedFiles(type->parameters, std::move(named), keyed);
    key = keyOf(feature, *type, parameters, keyed);
    const auto inputs = [&]() -> const Inputs& {
      if (!arranged) arranged = inputsOf(feature, *type);
      return *arranged;
    };
    found = known(key, *type, parameters, inputs);
    if (found) return;
    inputs();
    watch.emplace();
    result->evaluated = type->evaluate(parameters, *arranged, progress);
    checkResult(*type, result->evaluated.shape);
    refuseInfiniteFigures(result->evaluated);
    // A file that was written meanwhile may have been read as it is now: the result is of no content that is known.
    Value after;
    openedFiles(type->parameters, before, after);
    changed = after != keyed;
  });
  if (watch) {
    result->kernelMs = watch->elapsedMs();
    costs_.took(feature, result->kernelMs);
  }
  if (found) {
    result = std::make_shared<FeatureResult>(*found);
    result->fromCache = true;
    result->kernelMs = 0;
    result->evaluated.stats.erase(workerTime);
  } else if (!key.empty() && !changed && lasting(result->error)) {
    cache_.store(key, std::make_shared<FeatureResult>(*result), generation_);
    if (!result->error && result->kernelMs > worthIt) worthy_.emplace_back(key, result);
  }
  result->parts = std::move(parts);
  if (!result->error) outcome.key = key;
  return result;
}

/// The result of this content from memory, or else from the disk.
std::shared_ptr<const FeatureResult> Evaluation::known(const std::string& key, const FeatureType& type,
                                                       const Value& parameters,
                                                       const std::function<const Inputs&()>& arranged) {
  if (auto found = cache_.find(key)) return found;
  auto kept = store_ ? store_->find(key) : std::nullopt;
  if (!kept || !isOf(type, *kept)) return nullptr;
  if (kept->gougeLeftOut) {
    Toolpath path = *kept->evaluated.shape.get<Toolpath>();
    path.gougeOf = gougeAnew(type, parameters, arranged());
    kept->evaluated.shape = std::move(path);
  }
  auto found = std::make_shared<FeatureResult>();
  found->evaluated = std::move(kept->evaluated);
  cache_.store(key, found, generation_);
  return found;
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

/// For the names of faces: a suppressed feature is what it passes on. @throws Error NotFound.
ConstructionStep Evaluation::stepOf(const FeatureId& id) const {
  const Feature* feature = &document_.at(id);
  while (feature->suppressed && !feature->inputs.empty()) feature = &document_.at(feature->inputs.front());
  const auto type = registry_.find(feature->type);
  if (!type) throw unknownType(feature->type);
  ConstructionStep step;
  step.id = feature->id;
  step.sources = feature->inputs;
  step.result = outcomes_.at(feature->id).shape;
  const Inputs arranged = inputsOf(*feature, *type);
  for (std::size_t k = 0; k < type->inputs.size(); ++k)
    for (const Shape& shape : arranged.of(k)) step.inputs.push_back(shape);
  if (type->images)
    step.images = type->images(outcomes_.at(feature->id).parameters, arranged);
  else
    for (std::size_t k = 0; k < step.inputs.size(); ++k) step.images.push_back({.input = k});
  return step;
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

/// @throws Error InvalidInput that names the first input that failed and where the failure began, or the first that is left
/// out and has nothing to pass on.
void Evaluation::checkInputs(const Feature& feature, Outcome& outcome) const {
  for (const auto& id : feature.inputs) {
    const Outcome& input = outcomes_.at(id);
    if (!input.rootError) {
      const Feature* source = &document_.at(id);
      while (source->suppressed && !source->inputs.empty()) source = &document_.at(source->inputs.front());
      if (!source->suppressed) continue;
      throw Error(ErrorCode::InvalidInput, fmt::format("Its input \"{}\" is suppressed.", shownName(*source)),
                  "Let it be computed again, or take another input.");
    }
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

std::string Evaluation::keyOf(const Feature& feature, const FeatureType& type, const Value& parameters,
                              const Value& keyed) const {
  Value content = Value::array({feature.type, keyed});
  if (type.dependsOn) content.push_back({{"depends", type.dependsOn(parameters)}});
  for (const auto& input : feature.inputs) content.push_back(outcomes_.at(input).key);
  return contentHash(content.dump(-1, ' ', false, Value::error_handler_t::replace));
}

}  // namespace blossom
