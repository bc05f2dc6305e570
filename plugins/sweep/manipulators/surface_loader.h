#pragma once
#include <functional>
#include <memory>

#include "manipulators/live_surface.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"

namespace blossom::sweep {

/// Prepares the surface of a motion for drags on a thread of its own. Only that of the motion wanted last arrives; none does
/// when the motion cannot be swept, which the features made from it tell.
class SurfaceLoader {
 public:
  /// Called in the window's thread, and not after the loader has ended.
  using Arrived = std::function<void(std::shared_ptr<const LiveSurface>)>;

  explicit SurfaceLoader(Arrived);
  ~SurfaceLoader();

  /// Begins with a motion and gives up the one before; an empty shape is none. @returns false when it is wanted already.
  bool load(const Shape& motion);
  /// The motion whose surface has arrived, or is being prepared.
  [[nodiscard]] const Shape& wanted() const { return wanted_; }
  /// Whether a surface is being prepared.
  [[nodiscard]] bool busy() const { return busy_; }

 private:
  void prepare(const Shape& motion, const CancelToken&);

  Arrived arrived_;
  Shape wanted_;
  bool busy_ = false;
  CancelToken loading_;
  ui::Mailbox here_;
  ui::Background thread_;  // ends first
};

}  // namespace blossom::sweep
