#include "manipulators/motion_overlay.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

#include "geometry/bspline/bspline.h"
#include "geometry/shape/motion.h"
#include "kernel/quaternion.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t curveSamples = 200, frames = 9;

/// Polylines drawn in one colour.
class Lines {
 public:
  vtkIdType add(const Vec3& p) { return points_->InsertNextPoint(p.x(), p.y(), p.z()); }
  void connect(std::initializer_list<vtkIdType> ids) {
    cells_->InsertNextCell(static_cast<int>(ids.size()));
    for (const vtkIdType id : ids) cells_->InsertCellPoint(id);
  }
  [[nodiscard]] vtkSmartPointer<vtkProp> actor(const Color& color, double width, double opacity) const {
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(cells_);
    const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    // Controls stay visible on the surface they control.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    const auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color.red, color.green, color.blue);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
    actor->GetProperty()->SetOpacity(opacity);
    actor->ForceOpaqueOn();  // blended in place; a pass for translucent things would cost every frame
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    return actor;
  }

 private:
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
};

double along(std::pair<double, double> domain, std::size_t k, std::size_t count) {
  return domain.first + (domain.second - domain.first) * static_cast<double>(k) / static_cast<double>(count - 1);
}

/// Where the frame at v carries p, from the trajectory: a length that suits the drawing.
double axisLength(const Motion& motion) {
  const double u = motion.domainU().first, v = (motion.domainV().first + motion.domainV().second) / 2;
  const Vec4 s = evaluate(motion.scaling, u, v);
  const double reach = (s.head<3>().cwiseProduct(motion.point) / s[3]).norm();
  const double height =
      (point(motion.trajectory, motion.domainV().second) - point(motion.trajectory, motion.domainV().first)).norm();
  return 0.6 * (reach > 0 ? reach : std::max(height / 10, 1e-3));
}

/// The motion that an edit makes, or a sweep takes.
const Motion* shownMotion(const ui::OverlayContext& context) {
  if (const Motion* made = context.result.get<Motion>()) return made;
  return context.inputs.empty() ? nullptr : context.inputs.front().get<Motion>();
}

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> motionOverlay(const ui::OverlayContext& context) {
  const Motion* motion = shownMotion(context);
  if (!motion) return {};
  Lines trajectory, axes, spokes;
  vtkIdType previous = -1;
  for (std::size_t k = 0; k < curveSamples; ++k) {
    const vtkIdType here = trajectory.add(point(motion->trajectory, along(motion->domainV(), k, curveSamples)));
    if (previous >= 0) trajectory.connect({previous, here});
    previous = here;
  }
  const double length = axisLength(*motion), u = motion->domainU().first;
  for (std::size_t k = 0; k < frames; ++k) {
    const double v = along(motion->domainV(), k, frames);
    const Vec3 origin = point(motion->trajectory, v);
    const Vec4 r = evaluate(motion->orientation, u, v), s = evaluate(motion->scaling, u, v);
    if (!(r.squaredNorm() > 0)) continue;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
      axes.connect({axes.add(origin), axes.add(origin + turned(r, length * axis))});
    // From the frame to the point it sweeps.
    spokes.connect({spokes.add(origin), spokes.add(origin + turned(r, s.head<3>().cwiseProduct(motion->point) / s[3]))});
  }
  const Color& color = context.look.control;
  return {trajectory.actor(color, 2.5, 1), axes.actor(color, 1.5, 1), spokes.actor(color, 1, 0.4)};
}

}  // namespace blossom::sweep
