#include "manipulators/motion_overlay.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <optional>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/shape/motion.h"
#include "kernel/edit/apply_edits.h"
#include "kernel/quaternion.h"
#include "manipulators/motion_lines.h"

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

/// The motion that an edit makes, or a sweep takes.
const Motion* givenMotion(const ui::OverlayContext& context) {
  if (const Motion* made = context.result.get<Motion>()) return made;
  return context.inputs.empty() ? nullptr : context.inputs.front().get<Motion>();
}

/// With the edits that it keeps: what is seen is swept by it as edited. One that cannot be edited so has no surface either.
std::optional<Motion> shownMotion(const ui::OverlayContext& context) {
  const Motion* given = givenMotion(context);
  if (!given) return std::nullopt;
  try {
    return withEditsApplied(*given);
  } catch (const Error&) {
    return *given;
  }
}

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> motionOverlay(const ui::OverlayContext& context) {
  const std::optional<Motion> motion = shownMotion(context);
  if (!motion) return {};
  Lines trajectory, axes, spokes;
  vtkIdType previous = -1;
  for (std::size_t k = 0; k < curveSamples; ++k) {
    const vtkIdType here = trajectory.add(point(motion->trajectory, along(motion->domainV(), k, curveSamples)));
    if (previous >= 0) trajectory.connect({previous, here});
    previous = here;
  }
  const double length = suitableAxis(*motion), u = motion->domainU().first;
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
  const double ratio = context.pixelRatio;
  return {trajectory.actor(color, 2.5 * ratio, 1), axes.actor(color, 1.5 * ratio, 1), spokes.actor(color, ratio, 0.4)};
}

std::vector<vtkSmartPointer<vtkProp>> sweptOverlay(const ui::OverlayContext& context) {
  auto props = motionOverlay(context);
  const std::optional<Motion> motion = shownMotion(context);
  if (!motion) return props;
  Polylines swept;
  try {
    swept = knotCurves(*motion);
  } catch (const Error&) {
    return props;  // its sweep tells what is wrong with it
  }
  Lines curves;
  for (const std::vector<Vec3>& curve : swept) {
    vtkIdType previous = -1;
    for (const Vec3& p : curve) {
      const vtkIdType here = curves.add(p);
      if (previous >= 0) curves.connect({previous, here});
      previous = here;
    }
  }
  props.push_back(curves.actor(context.look.control, context.pixelRatio, 0.5));
  return props;
}

}  // namespace blossom::sweep
