#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/morph/sector_shape.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"

namespace blossom::minkowski {

/// What a ladder is drawn of.
struct LadderQuestion {
  std::vector<Region> shapes;   ///< where they stand
  std::vector<Sector> sectors;  ///< of the first ones
  std::vector<double> t;        ///< one for each level
  std::optional<double> tolerance;
  friend bool operator==(const LadderQuestion&, const LadderQuestion&) = default;
};

/// A shape between the control shapes and the result.
struct LadderShape {
  std::vector<std::vector<Vec3>> lines;
  double area = 0;  ///< mm^2
};

/// The shapes between the control shapes and the result.
struct LadderLines {
  std::vector<std::vector<LadderShape>> levels;  ///< the levels 1 to n-1 of de Casteljau's algorithm
  bool complete = true;                          ///< no level took too much work
};

/// Computes ladders on a thread of its own. One is computed at a time and the newest question waits: during a drag ladders
/// go on to arrive, however long one takes.
class LadderLoader {
 public:
  /// Called in the window's thread, and not after the loader has ended; nullptr: there is no ladder of these shapes, which
  /// the morph tells.
  using Arrived = std::function<void(std::shared_ptr<const LadderLines>)>;

  explicit LadderLoader(Arrived);
  ~LadderLoader();

  /// Nothing gives up what is under way. What was asked last is not asked again.
  void ask(std::optional<LadderQuestion>);

 private:
  void start();
  void compute(const LadderQuestion&, const CancelToken&);
  void finished(std::shared_ptr<const LadderLines>, const CancelToken&);

  Arrived arrived_;
  std::optional<LadderQuestion> asked_;  ///< last
  bool waiting_ = false;                 ///< it has not been begun
  bool running_ = false;
  CancelToken token_;
  ui::Mailbox here_;
  ui::Background thread_;  // ends first
};

}  // namespace blossom::minkowski
