#pragma once
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "document/document.h"
#include "document/evaluator.h"

namespace blossom::ui {

/// What is shown while something is dragged: the document itself as long as its results come within the frame budget, else
/// results of a coarser one, until the hand rests and they have come. One coarse document is computed at a time and the
/// newest waits: the shape goes on to follow, however long one takes. So do whole ones that take long where there is none
/// coarser.
class DragDetail final : public QObject {
  Q_OBJECT
 public:
  static constexpr double frameBudget = 33;     ///< ms
  static constexpr int restMs = 100;            ///< after the last movement
  static constexpr double coarseWaitMs = 2000;  ///< how long a coarse result is awaited when the hand rests

  using Coarser = std::function<Document(const Document&)>;
  /// Shows a document; with the results of the second one, if there is one.
  using Send = std::function<void(const Document&, std::optional<Document> coarser)>;
  using Newest = std::function<std::shared_ptr<const FeatureResult>()>;  ///< result of what is dragged

  using Clock = std::function<double()>;  ///< ms since some moment

  /// @param clock not set: that of the machine
  DragDetail(Send, Newest, Clock clock = {});

  /// @param coarser not set: there is none
  void show(Document, const Coarser& coarser);
  /// Call it whenever a result may have come.
  void resultsChanged();
  /// The drag is over: nothing is shown any more.
  void end();
  /// The newest document was sent neither whole nor coarse, or its coarse results have not come.
  [[nodiscard]] bool isBehind() const;

  [[nodiscard]] double budget() const { return budget_; }
  void setBudget(double milliseconds) { budget_ = milliseconds; }
  [[nodiscard]] int coarseSent() const { return coarseSent_; }  ///< how often a coarser document was computed

 private:
  enum class Sent { Nothing, Whole, Coarse };

  void handRests();
  void look();
  void send(bool coarse);

  Send send_;
  Newest newest_;
  double budget_ = frameBudget;
  bool slow_ = false;
  std::optional<Document> wanted_;
  Coarser coarser_;
  bool unsent_ = false;  ///< `wanted_` is newer than what was sent
  Sent underWay_ = Sent::Nothing;
  std::shared_ptr<const FeatureResult> before_;  ///< the newest when it was sent
  Clock clock_;
  double since_ = 0;  ///< when the first was sent of those that are awaited
  QTimer rest_;
  int coarseSent_ = 0;
};

}  // namespace blossom::ui
