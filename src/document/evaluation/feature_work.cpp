#include "document/evaluation/feature_work.h"

#include "core/stopwatch.h"
#include "document/error_of.h"
#include "feature/acceptance.h"
#include "feature/frame_by_frame.h"
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

/// Whether what was kept may be a result of this type; files in a folder may be anything.
bool isOf(const FeatureType& type, const KeptResult& kept) {
  try {
    checkResult(type, kept.evaluated.shape);
  } catch (const Error&) {
    return false;
  }
  return !kept.gougeLeftOut || kept.evaluated.shape.get<Toolpath>() != nullptr;
}

std::shared_ptr<const FeatureResult> fromStore(const FeatureWork& work, const EvaluationSources& sources) {
  auto kept = sources.store ? sources.store->find(work.key) : std::nullopt;
  if (!kept || !isOf(*work.type, *kept)) return nullptr;
  if (kept->gougeLeftOut) {
    Toolpath path = *kept->evaluated.shape.get<Toolpath>();
    path.gougeOf = gougeAnew(*work.type, work.parameters, work.inputs);
    kept->evaluated.shape = std::move(path);
  }
  auto found = std::make_shared<FeatureResult>();
  found->evaluated = std::move(kept->evaluated);
  sources.cache.store(work.key, found, work.generation);
  return found;
}

void openFiles(const ParameterSpec& spec, Value& parameter, Value& keyed, FileSource& files, const Document& document) {
  if (parameter.is_null()) return;
  if (spec.kind == ParameterKind::File) {
    const auto opened = files.open(parameter, document);
    // the name counts: readers go by the extension, and some results carry the file's name
    keyed = {{"name", opened.path.filename().string()}, {"content", opened.hash}};
    parameter = {{"path", opened.path.string()}, {"asset", parameter.value("asset", "")}};
  } else if (spec.kind == ParameterKind::List) {
    for (std::size_t i = 0; i < parameter.size(); ++i) openFiles(spec.fields.at(0), parameter[i], keyed[i], files, document);
  } else if (spec.kind == ParameterKind::Record) {
    for (const auto& field : spec.fields) openFiles(field, parameter[field.name], keyed[field.name], files, document);
  }
}

}  // namespace

Value openedFiles(const std::vector<ParameterSpec>& specs, Value parameters, Value& keyed, FileSource& files,
                  const Document& document) {
  keyed = parameters;
  for (const auto& spec : specs) openFiles(spec, parameters[spec.name], keyed[spec.name], files, document);
  return parameters;
}

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

std::shared_ptr<const FeatureResult> asKnown(const FeatureResult& found) {
  auto result = std::make_shared<FeatureResult>(found);
  result->fromCache = true;
  result->kernelMs = 0;
  result->evaluated.stats.erase(workerTime);
  return result;
}

std::shared_ptr<const FeatureResult> withParts(std::shared_ptr<const FeatureResult> result, const Value& parts) {
  if (parts.empty()) return result;
  auto copy = std::make_shared<FeatureResult>(*result);
  copy->parts = parts;
  return copy;
}

FeatureMade resultOf(const FeatureWork& work, const EvaluationSources& sources, const Progress& progress) {
  std::shared_ptr<const FeatureResult> found;
  auto result = std::make_shared<FeatureResult>();
  std::optional<Stopwatch> watch;
  bool changed = false;
  result->error = errorOf(shownName(work.feature), [&] {
    found = fromStore(work, sources);
    if (found) return;
    watch.emplace();
    result->evaluated = evaluatedFeature(*work.type, work.parameters, work.inputs, progress);
    checkResult(*work.type, result->evaluated.shape);
    refuseInfiniteFigures(result->evaluated);
    // A file that was written meanwhile may have been read as it is now: the result is of no content that is known.
    Value after;
    openedFiles(work.type->parameters, work.named, after, sources.files, work.document);
    changed = after != work.keyed;
  });
  if (found) return {asKnown(*found), false};
  if (watch) {
    result->kernelMs = watch->elapsedMs();
    sources.costs.took(work.feature, result->kernelMs);
  }
  if (changed || !lasting(result->error)) return {result, false};
  sources.cache.store(work.key, result, work.generation);
  return {result, !result->error && result->kernelMs > worthIt};
}

}  // namespace blossom
