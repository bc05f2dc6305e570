#pragma once
#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <map>
#include <optional>
#include <vector>

#include "document/document.h"
#include "geometry/shape/bounds.h"
#include "scene/picking.h"
#include "scene/scene.h"
#include "scene/surface_study.h"
#include "ui/plugin/tool.h"
#include "ui/view/display_mode.h"
#include "ui/view/items/item_paint.h"
#include "ui/view/items/section_cap.h"

class vtkCamera;
class vtkPlane;
class vtkRenderer;

namespace blossom::ui {

struct ViewItem {
  FeatureId id;
  SceneData scene;
  ItemRole role = ItemRole::Plain;
  Presence presence = Presence::Whole;
  /// What displays of surfaces need; nullptr: there is none yet, and the one before of the same shape stays.
  std::shared_ptr<const SurfaceStudy> study = nullptr;
};

/// What new items have changed.
struct ItemsChange {
  std::vector<FeatureId> shapes;  ///< features whose shape is new or gone
  bool colors = false;            ///< of shapes that stay, or what is told of their surfaces
  [[nodiscard]] bool any() const { return colors || !shapes.empty(); }
};

/// The shapes in the view: their actors in the renderer, how they are painted, and what a ray meets of them.
class ViewItems {
 public:
  explicit ViewItems(vtkRenderer*);
  ~ViewItems();

  /// Shapes that stay the same keep their place on the graphics card, and what has not changed is not touched.
  ItemsChange set(const std::vector<ViewItem>&);
  void setLook(const Look&);  ///< with widths in device pixels
  void setDisplayMode(DisplayMode);
  [[nodiscard]] DisplayMode displayMode() const { return mode_; }
  void setZebra(const ZebraLook&);
  /// The scale of the curvature that is shown, by the shape that bends most; empty: none is shown.
  [[nodiscard]] std::optional<CurvatureRange> curvatureRange() const;
  /// The curvature drawn at a place of a face; empty: none is.
  [[nodiscard]] std::optional<double> curvatureAt(const Pick&) const;
  /// Leaves out the far sides of closed shapes, which are hidden: half the work.
  void setCulling(bool);
  /// Fills and hatches solids where the section cuts them. To be called before each frame.
  /// @param millimetresPerPixel in the plane of the section. @returns whether the renderer has other actors now
  bool followSection(vtkCamera&, double millimetresPerPixel);
  void setHovered(const FeatureId&);  ///< lights up as a whole; empty: none
  /// What a tool shows instead of some shapes, which can be picked all the same. @returns whether other data are shown
  bool setStandIn(const std::optional<StandIn>&);
  [[nodiscard]] bool hasStandIn() const { return standIn_.has_value(); }
  [[nodiscard]] bool canBeCoarser() const { return standIn_ && standIn_->coarseFaces; }
  void drawCoarsely(bool);  ///< of what stands in, the triangles that are fewer
  void setSection(const std::optional<CutPlane>&);
  /// What everything that follows the section is clipped by; nullptr: there is none.
  [[nodiscard]] vtkPlane* clip() const;

  /// Large shapes go to the graphics card piece by piece, one for each frame, so that none is long; what they replace stays
  /// until they are whole.
  [[nodiscard]] bool incomplete() const;
  void bringNextPiece();
  /// Of what has not come yet.
  [[nodiscard]] std::vector<Vec3> pointsToCome() const;

  [[nodiscard]] bool empty() const { return shown_.empty(); }
  [[nodiscard]] bool planar() const;  ///< drawings only, and at least one
  [[nodiscard]] const SceneData* scene(const FeatureId&) const;
  [[nodiscard]] std::size_t triangles() const;
  [[nodiscard]] Bounds extent() const;

  /// The nearest thing along a ray. `base` holds tolerances and section.
  [[nodiscard]] Pick pick(const Ray&, const PickOptions& base, PickMode) const;
  /// What lies within bounds, of the kind of a mode.
  [[nodiscard]] std::vector<Pick> within(const std::vector<CutPlane>& bounds, PickMode, bool crossing) const;

 private:
  struct Shown {
    SceneData scene;
    ItemRole role = ItemRole::Plain;
    Presence presence = Presence::Whole;
    bool replaced = false;  ///< something stands in for it
    std::shared_ptr<const SurfaceStudy> study;
    SectionCap cap;
    std::vector<vtkSmartPointer<vtkActor>> actors;
    std::vector<vtkSmartPointer<vtkActor>> coming;   ///< those of `actors` that are not in the renderer yet, last first
    std::vector<vtkSmartPointer<vtkActor>> leaving;  ///< in the renderer until nothing is coming
  };
  [[nodiscard]] Pick pickAmong(const Ray&, PickOptions, PickMode, bool steppedBack) const;
  [[nodiscard]] bool renew(Shown&, const ViewItem&);
  [[nodiscard]] bool renewStudy(Shown&, const ViewItem&);
  void show(Shown&);
  void replace(Shown&);
  void hide(Shown&);
  void finish(Shown&);
  void paint(const FeatureId&, const Shown&) const;
  [[nodiscard]] ItemPaint paintOf(const FeatureId&, const Shown&) const;
  [[nodiscard]] bool showsEdges() const;
  void paintCaps(vtkCamera&, double millimetresPerPixel) const;
  [[nodiscard]] bool isReplaced(const FeatureId&) const;
  void markReplaced();
  void applyMode(const Shown&) const;
  void shade(vtkActor&, const Shown&) const;
  void recolor(const FeatureId&, Shown&, bool values);
  [[nodiscard]] bool followRange();
  void applySection(const Shown&) const;
  void applyCulling(const Shown&) const;

  vtkRenderer* renderer_;
  std::map<FeatureId, Shown> shown_;
  std::optional<StandIn> standIn_;
  Shown standInShown_;
  bool coarsely_ = false;
  Look look_ = Look::dark();
  DisplayMode mode_ = DisplayMode::ShadedWithEdges;
  ZebraLook zebra_;
  std::optional<CurvatureRange> range_;
  vtkSmartPointer<vtkLookupTable> colors_;  // of the range
  SurfaceDisplay colorsOf_ = SurfaceDisplay::Plain;
  FeatureId hovered_;
  bool culling_ = false;
  std::optional<CutPlane> section_;
  vtkSmartPointer<vtkPlane> clip_;
};

}  // namespace blossom::ui
