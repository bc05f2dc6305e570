#pragma once
#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "document/evaluator.h"
#include "geometry/measure/measure.h"
#include "geometry/tessellate/tessellate.h"
#include "scene/scene.h"

namespace blossom::ui {

/// What the window shows of one result: made once, on a thread of the evaluator.
struct FeatureView {
  std::shared_ptr<const FeatureResult> result;
  Shape shape;  ///< that is drawn: of the result, or the last one before the feature failed
  SceneData scene;
  std::shared_ptr<const std::vector<SceneData>> frames;  ///< of a sequence, else null; `scene` is the last of them
  Measures measures;
};

/// How finely the window draws a shape. @param chord mm; 0: chosen by its size
TessellationOptions drawnFineness(const Shape&, double chord);

/// Remembers the drawings and measures of the last shapes, so that undo shows at once what was shown before. What another
/// thread is drawing is waited for. Thread-safe.
class DisplayCache {
 public:
  /// @param chord mm that what is drawn may lie from the shape; 0: as fine as the window shows it (see tessellate.h).
  /// @throws Error Cancelled. A shape that cannot be drawn or measured becomes a view whose result carries the error.
  std::shared_ptr<const FeatureView> view(const std::shared_ptr<const FeatureResult>&, double chord, const Progress&);
  /// The shapes of a document with so many features are kept, and some of the ones before. It never becomes smaller.
  void makeRoomFor(std::size_t features);

 private:
  struct Entry {
    double chord = 0;
    Shape shape;       // keeps the address that is the key alive
    FeatureView view;  // without result
  };
  using Drawing = std::pair<const void*, double>;  // address of the shape, chord
  [[nodiscard]] const FeatureView* known(const Drawing&);
  [[nodiscard]] bool awaitOrBegin(const Drawing&, FeatureView&, const Progress&);
  void end(const Drawing&);

  std::mutex guard_;
  std::condition_variable drawn_;
  std::set<Drawing> underWay_;
  std::list<Entry> entries_;  // newest first
  std::size_t most_ = 96;
};

}  // namespace blossom::ui
