#include "document/evaluation/evaluation.h"

#include <fmt/format.h>

#include <optional>

#include "document/error_of.h"
#include "document/part_references.h"
#include "document/storage.h"
#include "feature/acceptance.h"
#include "feature/frame_by_frame.h"

namespace blossom {
namespace {

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
  for (const auto& feature : document_.features()) all += feature->suppressed ? 0 : sources_.costs.expected(*feature);
  ShareDone share(all);
  for (const auto& each : document_.features()) {
    const Feature& feature = *each;
    const double expected = feature.suppressed ? 0 : sources_.costs.expected(feature);
    progress.report(share.now(), shownName(feature));
    const Progress part = shareOf(progress, share.now(), share.with(expected), shownName(feature));
    const Prepared prepared = prepare(feature, part);
    auto result = conclude(feature, prepared, prepared.result ? prepared.result : made(*prepared.work, part));
    share.finish(expected, result->fromCache);
    if (done) done(feature.id, result);
    results.emplace(feature.id, std::move(result));
  }
  progress.report(1);
  return results;
}

std::shared_ptr<const FeatureResult> Evaluation::made(const FeatureWork& work, const Progress& progress) {
  const FeatureMade made = resultOf(work, sources_, progress);
  if (made.worthKeeping) worthy_.emplace_back(work.key, made.result);
  return made.result;
}

Evaluation::Prepared Evaluation::prepare(const Feature& feature, const Progress& progress) {
  Prepared prepared;
  Outcome& outcome = outcomes_[feature.id];
  if (feature.suppressed) {
    prepared.result = passedOn(feature, outcome);
    return prepared;
  }
  auto work = std::make_shared<FeatureWork>();
  work->feature = feature;
  work->document = document_;
  work->generation = generation_;
  std::shared_ptr<const FeatureResult> found;
  const std::optional<Error> error =
      errorOf(shownName(feature), [&] { found = prepareWork(*work, prepared, outcome, progress); });
  prepared.key = work->key;
  if (found) {
    prepared.result = asKnown(*found);
  } else if (error) {
    auto failed = std::make_shared<FeatureResult>();
    failed->error = error;
    failed->lost = prepared.lost;
    if (!work->key.empty() && lasting(error)) sources_.cache.store(work->key, failed, generation_);
    prepared.result = std::move(failed);
  } else {
    prepared.work = std::move(work);
  }
  return prepared;
}

/// The result when it is in the cache; else all is ready for it to be computed.
std::shared_ptr<const FeatureResult> Evaluation::prepareWork(FeatureWork& work, Prepared& prepared, Outcome& outcome,
                                                             const Progress& progress) {
  const Feature& feature = work.feature;
  work.type = sources_.registry.find(feature.type);
  if (!work.type) throw unknownType(feature.type);
  checkInputs(feature, outcome);
  Value named = completed(work.type->parameters, feature.parameters);
  checkNamedInputs(*work.type, named);
  std::optional<Inputs> arranged;
  if (namesParts(work.type->parameters, named)) {
    arranged = inputsOf(feature, *work.type);
    refusePartsOfSequences(*work.type, named, *arranged);
    FoundParts again = foundParts(feature, *work.type, named, *arranged, construction_, progress);
    named = std::move(again.now);
    prepared.parts = std::move(again.kept);
    prepared.lost = std::move(again.lost);
    if (!prepared.lost.empty()) throw lostError(prepared.lost.front());
  }
  work.named = outcome.parameters = named;
  work.parameters = openedFiles(work.type->parameters, std::move(named), work.keyed, sources_.files, document_);
  work.key = keyOf(feature, *work.type, work.parameters, work.keyed);
  if (auto found = sources_.cache.find(work.key)) return found;
  work.inputs = arranged ? std::move(*arranged) : inputsOf(feature, *work.type);
  return nullptr;
}

std::shared_ptr<const FeatureResult> Evaluation::conclude(const Feature& feature, const Prepared& prepared,
                                                          std::shared_ptr<const FeatureResult> result) {
  Outcome& outcome = outcomes_[feature.id];
  outcome.shape = result->evaluated.shape;
  outcome.warnings = result->evaluated.warnings;
  if (!feature.suppressed && !result->error) outcome.key = prepared.key;
  if (result->error && !outcome.rootError) outcome.rootError = std::make_shared<const Error>(*result->error);
  return withParts(std::move(result), prepared.parts);
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
  const auto type = sources_.registry.find(feature->type);
  if (!type) throw unknownType(feature->type);
  ConstructionStep step;
  step.id = feature->id;
  step.sources = feature->inputs;
  step.result = outcomes_.at(feature->id).shape;
  const Inputs arranged = inputsOf(*feature, *type);
  for (std::size_t k = 0; k < type->inputs.size(); ++k)
    for (const Shape& shape : arranged.of(k)) step.inputs.push_back(shape);
  if (sequenceTakenByFrames(*type, arranged)) return step;  // frames have no faces to name
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

std::string Evaluation::keyOf(const Feature& feature, const FeatureType& type, const Value& parameters,
                              const Value& keyed) const {
  Value content = Value::array({feature.type, keyed});
  if (type.dependsOn) content.push_back({{"depends", type.dependsOn(parameters)}});
  for (const auto& input : feature.inputs) content.push_back(outcomes_.at(input).key);
  return contentHash(content.dump(-1, ' ', false, Value::error_handler_t::replace));
}

}  // namespace blossom
