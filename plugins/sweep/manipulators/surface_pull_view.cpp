// What the surface pull tool says and draws.
#include <vtkProp.h>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "manipulators/pull_marks.h"
#include "manipulators/surface_pull_tool.h"

namespace blossom::sweep {

namespace {

QString joined(const QStringList& parts) { return parts.join(QStringLiteral(" · ")); }

/// Why there are no copies of a place; empty when there are, or none are wanted.
QString copiesProblem(const Motion& motion, const MotionPlace& at, const EditSymmetry& symmetry, std::vector<Vec3>& copies) {
  try {
    copies = copiesOf(motion, at, symmetry);
  } catch (const Error& error) {
    return QString::fromStdString(error.message());
  }
  return {};
}

}  // namespace

QString SurfacePullTool::hint() const {
  if (!surface_) return {};  // the view says what it does by itself
  if (held()) return heldHint();
  if (hovered() && under_) return hoverHint();
  return tr("Drag a place on the surface to pull it");
}

QString SurfacePullTool::heldHint() const {
  if (live_ && !live_->arrived()) return tr("Nothing will be changed here: %1").arg(live_->reason());
  QStringList parts;
  if (mode_.twists())
    parts << tr("Let go to twist by %1° about %2").arg(angle(), 0, 'f', 1).arg(mode_.axisText()) << tr("A: another axis");
  else
    parts << tr("Let go to pull the point here %1").arg(mode_.wayText()) << tr("Shift: along the normal");
  if (const QString symmetry = mode_.symmetryText(); !symmetry.isEmpty()) parts << symmetry;
  return joined(parts << tr("Esc takes it back"));
}

QString SurfacePullTool::hoverHint() const {
  std::vector<Vec3> copies;
  if (const QString problem = copiesProblem(surface_->motion(), under_->at, mode_.symmetry(), copies); !problem.isEmpty())
    return joined({problem, tr("1: no copies")});
  QStringList parts;
  if (mode_.twists())
    parts << tr("Drag to twist the surface here about %1").arg(mode_.axisText()) << tr("A: another axis") << tr("W: pull");
  else
    parts << (onLast_ ? tr("Drag to pull this point further, %1").arg(mode_.wayText())
                      : tr("Drag to pull this point %1").arg(mode_.wayText()))
          << tr("T, R, S: one way alone") << tr("W: twist");
  const QString symmetry = mode_.symmetryText();
  parts << (symmetry.isEmpty() ? tr("2–9, M: copies") : tr("%1 (1: none)").arg(symmetry));
  return joined(parts);
}

std::vector<vtkSmartPointer<vtkProp>> SurfacePullTool::props() const {
  Props props;
  if (!surface_) return props;
  const Facing face = facing(towards_, millimetresPerPixel());
  PullMarks marks(host(), face, props);
  if (held() && live_)
    markDrag(marks);
  else if (hovered() && under_)
    markPlace(marks);
  return props;
}

void SurfacePullTool::markPlace(PullMarks& marks) const {
  const Motion& motion = surface_->motion();
  // Of lines at one depth the first is seen: the ring before the iso-curves.
  if (!mode_.twists()) marks.ring(under_->point, mode_);
  marks.place(motion, *under_, mode_, towards_);
  std::vector<Vec3> copies;
  copiesProblem(motion, under_->at, mode_.symmetry(), copies);
  marks.copies(copies);
  if (!mode_.twists()) return;
  const Vec3 centre = point(motion.trajectory, under_->at.v);
  marks.twist(centre, twistAxis(motion, under_->at, mode_.axis()), under_->point - centre, std::nullopt);
}

void SurfacePullTool::markDrag(PullMarks& marks) const {
  const Vec3 end = placeHit(live_->motion(), under_->at).point, centre = point(surface_->motion().trajectory, under_->at.v);
  if (mode_.twists())
    marks.twist(centre, twistAxis(surface_->motion(), under_->at, mode_.axis()), under_->point - centre, angle());
  else
    marks.ring(end, mode_);
  marks.drag(*live_, target_.start(), end);
  std::vector<Vec3> copies;
  copiesProblem(live_->motion(), under_->at, mode_.symmetry(), copies);
  marks.copies(copies);
}

}  // namespace blossom::sweep
