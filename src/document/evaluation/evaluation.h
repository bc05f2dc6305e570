#pragma once
#include "document/evaluation/feature_work.h"
#include "naming/construction.h"

namespace blossom {

/// One evaluation of a document, in one thread. `run` does all of it; or else the features are prepared and concluded one by
/// one, inputs before their users, and what is between is done by other threads.
class Evaluation {
 public:
  explicit Evaluation(Document document, const EvaluationSources& sources)
      : document_(std::move(document)), sources_(sources) {}
  Evaluation(const Document& document, const Registry& registry, ResultCache& cache, FileSource& files, Costs& costs,
             ResultStore* store = nullptr)
      : Evaluation(document, EvaluationSources{registry, cache, files, costs, store}) {}
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  /// @throws Error Cancelled only.
  Results run(const Progress&, const Evaluator::Done&);

  /// A result with its content key that took so long that a store should keep it.
  using Worthy = std::pair<std::string, std::shared_ptr<const FeatureResult>>;
  [[nodiscard]] std::vector<Worthy> worthKeeping() const { return worthy_; }  ///< of `run`

  /// A feature whose inputs are concluded: its result when that is known, else the work on it.
  struct Prepared {
    std::string key;  ///< content key, when it came so far
    std::shared_ptr<const FeatureResult> result;
    std::shared_ptr<const FeatureWork> work;
    Value parts = Value::object();  ///< see FeatureResult
    std::vector<Value> lost = {};   ///< see FeatureResult
  };
  /// @throws Error Cancelled only.
  Prepared prepare(const Feature&, const Progress&);
  /// What the result is in this document; users of the feature may be prepared from here on.
  std::shared_ptr<const FeatureResult> conclude(const Feature&, const Prepared&, std::shared_ptr<const FeatureResult>);

  [[nodiscard]] const Document& document() const { return document_; }

 private:
  /// The result of a feature as needed by its users.
  struct Outcome {
    std::string key;  ///< content key; empty when there is no result
    Shape shape;
    std::vector<std::string> warnings;
    Value parameters;  ///< complete, with the numbers that parts have now; null when they have an error
    std::shared_ptr<const Error> rootError;  ///< error of the first feature that failed
  };

  std::shared_ptr<const FeatureResult> made(const FeatureWork&, const Progress&);
  std::shared_ptr<const FeatureResult> prepareWork(FeatureWork&, Prepared&, Outcome&, const Progress&);
  std::shared_ptr<const FeatureResult> passedOn(const Feature&, Outcome&);
  void checkInputs(const Feature&, Outcome&) const;
  [[nodiscard]] Inputs inputsOf(const Feature&, const FeatureType&) const;
  std::string keyOf(const Feature&, const FeatureType&, const Value& parameters, const Value& keyed) const;
  [[nodiscard]] ConstructionStep stepOf(const FeatureId& id) const;

  const Document document_;
  const EvaluationSources sources_;
  const std::uint64_t generation_ = sources_.cache.generation();
  std::vector<Worthy> worthy_;
  std::map<FeatureId, Outcome> outcomes_;
  Construction construction_{[this](const FeatureId& id) { return stepOf(id); }};
};

}  // namespace blossom
