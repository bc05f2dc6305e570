#pragma once
#include <vtkSmartPointer.h>

#include <QPointF>
#include <QSize>
#include <optional>
#include <vector>

#include "ui/fields/marked_parts.h"
#include "ui/view/ground_grid.h"
#include "ui/view/items/view_items.h"
#include "ui/view/view_highlight.h"

class vtkProp;
class vtkRenderer;

namespace blossom::ui {

class CameraControl;

/// The content of the scene: the shapes, what lights up and is selected of them, the grid on the ground, and what
/// tools and measurements draw over all that. Knows nothing of mouse and widget.
class ViewStage {
 public:
  using Props = std::vector<vtkSmartPointer<vtkProp>>;

  ViewStage();

  [[nodiscard]] vtkRenderer& renderer();
  [[nodiscard]] ViewItems& items() { return items_; }
  [[nodiscard]] const ViewItems& items() const { return items_; }
  ItemsChange setItems(const std::vector<ViewItem>&);
  void setOverlay(Props);
  [[nodiscard]] bool hasOverlay() const { return !overlay_.empty(); }
  void setToolProps(Props);
  void setStandIn(const std::optional<StandIn>&);

  void setLook(const Look&);
  void setScale(double devicePixelsPerPixel);
  void setGridVisible(bool);
  [[nodiscard]] bool gridVisible() const;
  [[nodiscard]] double gridSpacing() const { return grid_.spacing(); }  ///< mm
  void setSection(const std::optional<CutPlane>&);
  [[nodiscard]] const std::optional<CutPlane>& section() const { return section_; }

  /// Lights up a part, or with `whole` its feature.
  void light(const Pick&, bool whole);
  /// @returns whether anything changed.
  bool select(const std::vector<Pick>&);
  [[nodiscard]] const std::vector<Pick>& selected() const { return selected_.picks(); }

  /// Marks parts, also of shapes that are shown later. @returns whether anything changed.
  bool mark(const MarkedParts&);
  [[nodiscard]] const MarkedParts& marked() const { return marks_; }

  [[nodiscard]] Pick pick(const CameraControl&, QPointF at, PickMode) const;
  [[nodiscard]] std::vector<Vec3> points() const;  ///< of all that is shown, and of what is to come

  void bringNextPiece();
  /// What lies over the scene looks as large as ever when only a share of the pixels along each side is drawn.
  void setShare(double);
  /// Places the camera, the grid and the cuts for a frame that lies `offset` device pixels aside in a picture.
  void prepare(const CameraControl&, QSize view, QPointF offset, QSize picture);

 private:
  void replace(Props& shown, Props now);
  void cutOverlay();
  void applyLook();
  bool showMarks();
  void keepGridLast();
  void keepGridInSight();

  vtkSmartPointer<vtkRenderer> renderer_;
  ViewItems items_;
  PartHighlight lit_, selected_, chosen_, pointed_;
  MarkedParts marks_;
  Props overlay_, toolProps_;
  GroundGrid grid_;
  Look look_ = Look::dark();
  double scale_ = 1, share_ = 1;
  std::optional<CutPlane> section_;
};

}  // namespace blossom::ui
