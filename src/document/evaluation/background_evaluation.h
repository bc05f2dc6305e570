#pragma once
#include <functional>
#include <vector>

#include "document/evaluation/evaluation.h"
#include "document/evaluation/workshop.h"

namespace blossom {

/// One evaluation of a document whose features are computed and shown in a workshop: each as soon as its inputs are there.
/// What the workshop computes for an earlier document, and is the same in this one, goes on; the rest is cancelled.
class BackgroundEvaluation {
 public:
  /// @param worthKeeping is called for results that took long, by the threads of the workshop
  BackgroundEvaluation(Document, const EvaluationSources&, Workshop&, Evaluator::Show,
                       std::function<void(const Evaluation::Worthy&)> worthKeeping);

  /// @throws Error Cancelled only; the workshop then still works on what was begun.
  Results run(const Progress&);

 private:
  using Handle = Workshop::Handle;
  enum class Stage { Ahead, Computing, WaitingToShow, Showing, Done };
  struct Place {
    std::shared_ptr<const Feature> feature;
    Stage stage = Stage::Ahead;
    Evaluation::Prepared prepared;
    Handle piece;
    bool shows = false;         ///< the piece shows the result in this document, too
    bool joined = false;        ///< another feature of this document computes it
    double costMs = 0;          ///< of all that is to be done
    double computingShare = 1;  ///< of that, what is not showing
    bool sequence = false;
  };

  bool beginReady(const Progress&);
  [[nodiscard]] bool ready(const Place&) const;
  void start(Place&, const Progress&);
  void startWork(Place&);
  void weigh(Place&, const Value& parameters, const FeatureWork*) const;
  bool advance(Place&);
  void concludeWith(Place&, const std::shared_ptr<const FeatureResult>&);
  void show(Place&);
  std::function<void(const Workshop::Result&, const Progress&)> showing(const Place&, bool measured) const;
  void report(const Progress&);

  Evaluation evaluation_;
  EvaluationSources sources_;
  const std::uint64_t generation_;
  Workshop& workshop_;
  std::shared_ptr<const Evaluator::Show> show_;
  std::function<void(const Evaluation::Worthy&)> worthKeeping_;
  std::vector<Place> places_;
  Results concluded_;
  double reached_ = 0;
};

}  // namespace blossom
