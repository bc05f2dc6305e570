#pragma once
#include "document/evaluator.h"
#include "document/file_source.h"
#include "document/result_cache.h"

namespace blossom {

/// One evaluation of a document: the single-threaded part of the evaluator.
class Evaluation {
 public:
  Evaluation(const Document& document, const Registry& registry, ResultCache& cache, FileSource& files)
      : document_(document), registry_(registry), cache_(cache), files_(files) {}

  /// @throws Error Cancelled only.
  Results run(const Progress&, const Evaluator::Done&);

 private:
  /// The result of a feature as needed by its users.
  struct Outcome {
    std::string key;  ///< content key; empty when there is no result
    Shape shape;
    std::vector<std::string> warnings;
    std::shared_ptr<const Error> rootError;  ///< error of the first feature that failed
  };

  std::shared_ptr<const FeatureResult> evaluated(const Feature&, Outcome&, const Progress&);
  std::shared_ptr<const FeatureResult> passedOn(const Feature&, Outcome&);
  void checkInputs(const Feature&, Outcome&) const;
  [[nodiscard]] Inputs inputsOf(const Feature&, const FeatureType&) const;
  Value openedFiles(const std::vector<ParameterSpec>&, Value parameters, Value& keyed);
  void openFiles(const ParameterSpec&, Value& parameter, Value& keyed);
  std::string keyOf(const Feature&, const Value& keyed) const;

  const Document& document_;
  const Registry& registry_;
  ResultCache& cache_;
  FileSource& files_;
  std::map<FeatureId, Outcome> outcomes_;
};

}  // namespace blossom
