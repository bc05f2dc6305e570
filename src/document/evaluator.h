#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/progress.h"
#include "document/document.h"
#include "feature/registry.h"

namespace blossom {

class ResultStore;

/// The state of one feature after an evaluation. Every exception is stored here: those of OCCT and the standard library as
/// Internal, exhausted memory as LimitExceeded.
struct FeatureResult {
  Evaluated evaluated;  ///< empty shape when it failed
  /// Parameters that name faces, edges or vertices, which were found again, as they are to be kept in the document.
  Value parts = Value::object();
  std::optional<Error> error;  ///< its own error, or "The input .. failed."
  double kernelMs = 0;         ///< time of the evaluate function less `worker_ms` of its stats; 0 from the cache
  bool fromCache = false;
  std::vector<Value> lost = {};  ///< parts that were not found again, as the document names them
};

using Results = std::map<FeatureId, std::shared_ptr<const FeatureResult>>;

/// Evaluates documents. Results are cached under a key of type, parameters and the keys of the inputs (files by content), so
/// only what changed is computed again. Thread-safe; least recently used results are dropped beyond `cacheLimit`, or beyond
/// twice the features of the document evaluated last when these are more.
class Evaluator {
 public:
  /// @param store where results that took long are kept, and found again; may be nullptr
  explicit Evaluator(std::shared_ptr<const Registry>, std::size_t cacheLimit = 256,
                     std::shared_ptr<ResultStore> store = nullptr);
  ~Evaluator();

  /// Called after each feature, from the evaluating thread.
  using Done = std::function<void(const FeatureId&, const std::shared_ptr<const FeatureResult>&)>;

  /// Evaluates all features, inputs first. A failing feature stores its error, its users fail with a reference to it, all
  /// others are evaluated.
  /// @throws Error Cancelled only.
  Results evaluate(const Document&, const Progress&, const Done& done = {});

  /// The same for a document beside the one that is worked on: the room in the cache stays as it is.
  Results evaluateBeside(const Document&, const Progress&);

  /// Shows the result of a feature, with progress and cancel; called by several threads at once.
  using Show = std::function<void(const FeatureId&, const std::shared_ptr<const FeatureResult>&, const Progress&)>;

  /// The same on background threads, which make all callbacks: features that do not need each other are computed and shown
  /// side by side, the quickest first. A new call takes the place of the previous one without waiting: what is being
  /// computed or shown for that and is the same now goes on, everything else is cancelled. `finished` is called for the
  /// newest only, when all is shown. Fractions of progress are shares of the time that features took last time, showing
  /// included.
  void evaluateInBackground(Document, std::function<void(double fraction, const std::string& stage)> progress, Show,
                            std::function<void(Results)> finished);
  void cancelBackground();  ///< does not wait
  void forget();            ///< all results: the next evaluation computes everything
  /// Until the background threads are idle; not to be called by a thread that the callbacks wait for.
  void waitForBackground();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace blossom
