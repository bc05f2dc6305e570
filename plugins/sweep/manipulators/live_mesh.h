#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

#include "geometry/shape/motion.h"
#include "kernel/grid/grid_range.h"
#include "kernel/grid/motion_grid.h"
#include "ui/plugin/tool.h"

class vtkDoubleArray;
class vtkFloatArray;

namespace blossom::sweep {

/// What is drawn of a swept surface beside its places.
struct LiveForm {
  bool closedU = false;  ///< u has no ends
  bool capped = false;   ///< the ends in v are closed, as those of a solid
};

/// @param capped the sweep is to be a solid
LiveForm liveForm(const Motion&, bool capped);

/// The shaded picture of a grid that is kept up to date: triangles between its places, with its own exact normals, and its
/// borders. Points and normals are changed in place, and only where the grid has changed; the triangles stay, so that only
/// points and normals go to the graphics card again, as a whole: 24 bytes for each place.
class LiveMesh {
 public:
  LiveMesh(const MotionGrid&, const LiveForm&);

  /// @param changed what LiveGrid::update has evaluated, of a grid of the size at the beginning. O(changed places + border).
  void update(const MotionGrid&, std::span<const GridRectangle> changed);

  /// What the view draws instead of some features; its data follow every update.
  [[nodiscard]] ui::StandIn standIn(std::vector<FeatureId> insteadOf) const;
  [[nodiscard]] const vtkSmartPointer<vtkPolyData>& faces() const { return faces_; }
  [[nodiscard]] const vtkSmartPointer<vtkPolyData>& edges() const { return edges_; }

 private:
  [[nodiscard]] vtkSmartPointer<vtkPolyData> connected(std::size_t step) const;
  void connectBorders();
  void write(const MotionGrid&, const GridRectangle&);
  void writeCap(const MotionGrid&, std::size_t column, std::size_t first);
  void writeBorders(const MotionGrid&);
  void setPlace(std::size_t index, const Vec3& point, const Vec3& normal);

  LiveForm form_;
  std::size_t countU_, countV_;
  vtkSmartPointer<vtkPolyData> faces_, edges_;
  vtkSmartPointer<vtkPolyData> coarseFaces_;               ///< between every second row and column: the same places
  vtkSmartPointer<vtkDoubleArray> points_, borderPoints_;  ///< places by their index in the grid, then caps
  vtkSmartPointer<vtkFloatArray> normals_;
};

}  // namespace blossom::sweep
