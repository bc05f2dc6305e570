#pragma once
#include <vtkSmartPointer.h>

#include <QPointF>
#include <QString>
#include <vector>

#include "geometry/planar/region.h"
#include "kernel/outline/outline_snap.h"
#include "scene/scene.h"
#include "ui/tools/typed_text.h"

class vtkProp;

namespace blossom::modeling {

/// Graphics of a tool over the scene in the plane z = 0, on top of everything: lines, and handles, snap markers and labels
/// of constant size on the screen, facing the viewer.
class ToolPaint {
 public:
  ToolPaint(const Look& look, double millimetresPerPixel, double pixelRatio)
      : look_(look), pixel_(millimetresPerPixel), ratio_(pixelRatio) {}

  void path(const Path&, const Color&, double width = 2);
  void segment(const Segment&, const Color&, double width = 2);
  void dashed(const Vec2& from, const Vec2& to, const Color&);
  /// A construction line through a point, from its origin past `to`.
  void guide(const Guide&, const Vec2& to);
  void square(const Vec2& at, const Color&, bool filled, double half = 4);
  void ring(const Vec2& at, const Color&, double radius = 5);
  /// The marker of the object that the mouse snapped to.
  void snapMarker(const Vec2& at, SnapKind);
  /// A text on a card above a point.
  /// @param shift logical pixels, to the right and up
  void label(const Vec2& at, const QString& text, const Color&, const QPointF& shift = {});
  /// A text that is being typed, like a label; on the colour of a selection as long as the next key takes its place.
  void entry(const Vec2& at, const ui::TypedText&, const QPointF& shift);

  [[nodiscard]] const Look& look() const { return look_; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> take() { return std::move(props_); }

 private:
  void lines(const std::vector<std::vector<Vec2>>&, const Color&, double width, double opacity = 1);
  using Strokes = std::vector<std::vector<Vec2>>;
  /// Strokes (or one filled polygon) in logical pixels around a point.
  void stamp(const Vec2& at, const Strokes&, const Color&, bool filled = false);

  Look look_;
  double pixel_, ratio_;
  std::vector<vtkSmartPointer<vtkProp>> props_;
};

}  // namespace blossom::modeling
