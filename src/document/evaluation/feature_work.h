#pragma once
#include "document/evaluation/costs.h"
#include "document/evaluation/file_source.h"
#include "document/evaluation/result_cache.h"
#include "document/evaluator.h"

namespace blossom {

/// What evaluations share; each of these is safe to use from several threads at once.
struct EvaluationSources {
  const Registry& registry;
  ResultCache& cache;
  FileSource& files;
  Costs& costs;
  ResultStore* store = nullptr;  ///< in which results are looked for that are not in the cache
};

/// The work on one feature. It holds all that it needs, so that any thread can do it, and go on when another document is
/// evaluated meanwhile.
struct FeatureWork {
  Feature feature;
  Document document;  ///< in which files are found
  std::shared_ptr<const FeatureType> type;
  Value named;  ///< complete parameters, before files are opened
  Value parameters, keyed;
  Inputs inputs;
  std::string key;               ///< content key
  std::uint64_t generation = 0;  ///< of the cache
};

struct FeatureMade {
  std::shared_ptr<const FeatureResult> result;
  bool worthKeeping = false;  ///< it took so long that a store should keep it
};

/// The result from the store, or computed; it is in the cache afterwards. @throws Error Cancelled only.
FeatureMade resultOf(const FeatureWork&, const EvaluationSources&, const Progress&);

/// As it is told when nothing had to be computed.
std::shared_ptr<const FeatureResult> asKnown(const FeatureResult&);

/// With parameters that name parts as they are in one document.
std::shared_ptr<const FeatureResult> withParts(std::shared_ptr<const FeatureResult>, const Value& parts);

/// Whether the same content would meet the same error again.
bool lasting(const std::optional<Error>&);

/// The parameters with paths that can be opened; `keyed` gets them with content hashes in place of paths.
Value openedFiles(const std::vector<ParameterSpec>&, Value parameters, Value& keyed, FileSource&, const Document&);

}  // namespace blossom
