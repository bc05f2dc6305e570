#pragma once
#include "document/evaluation/costs.h"
#include "document/evaluation/file_source.h"
#include "document/evaluation/result_cache.h"
#include "document/evaluator.h"
#include "naming/construction.h"

namespace blossom {

/// One evaluation of a document: the single-threaded part of the evaluator.
class Evaluation {
 public:
  /// @param store in which results are looked for that are not in the cache; may be nullptr
  Evaluation(const Document& document, const Registry& registry, ResultCache& cache, FileSource& files, Costs& costs,
             ResultStore* store = nullptr)
      : document_(document), registry_(registry), cache_(cache), files_(files), costs_(costs), store_(store) {}

  /// @throws Error Cancelled only.
  Results run(const Progress&, const Evaluator::Done&);

  /// A result with its content key that took so long that a store should keep it.
  using Worthy = std::pair<std::string, std::shared_ptr<const FeatureResult>>;
  [[nodiscard]] std::vector<Worthy> worthKeeping() const { return worthy_; }

 private:
  /// The result of a feature as needed by its users.
  struct Outcome {
    std::string key;  ///< content key; empty when there is no result
    Shape shape;
    std::vector<std::string> warnings;
    Value parameters;  ///< complete, with the numbers that parts have now; null when they have an error
    std::shared_ptr<const Error> rootError;  ///< error of the first feature that failed
  };

  std::shared_ptr<const FeatureResult> evaluated(const Feature&, Outcome&, const Progress&);
  std::shared_ptr<const FeatureResult> passedOn(const Feature&, Outcome&);
  void checkInputs(const Feature&, Outcome&) const;
  [[nodiscard]] Inputs inputsOf(const Feature&, const FeatureType&) const;
  Value openedFiles(const std::vector<ParameterSpec>&, Value parameters, Value& keyed);
  void openFiles(const ParameterSpec&, Value& parameter, Value& keyed);
  std::shared_ptr<const FeatureResult> known(const std::string& key, const FeatureType&, const Value& parameters,
                                             const std::function<const Inputs&()>& arranged);
  std::string keyOf(const Feature&, const FeatureType&, const Value& parameters, const Value& keyed) const;
  [[nodiscard]] ConstructionStep stepOf(const FeatureId&) const;

  const Document& document_;
  const Registry& registry_;
  ResultCache& cache_;
  const std::uint64_t generation_ = cache_.generation();
  FileSource& files_;
  Costs& costs_;
  ResultStore* store_;
  std::vector<Worthy> worthy_;
  std::map<FeatureId, Outcome> outcomes_;
  Construction construction_{[this](const FeatureId& id) { return stepOf(id); }};
};

}  // namespace blossom
