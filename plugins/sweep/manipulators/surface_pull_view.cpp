// What the surface pull tool says and draws.
#include <vtkProp.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "manipulators/marks/axis_ball.h"
#include "manipulators/marks/pull_marks.h"
#include "manipulators/marks/pull_numbers.h"
#include "manipulators/marks/validity_marks.h"
#include "manipulators/surface_pull_tool.h"

namespace blossom::sweep {

namespace {

/// Sentences of others are parts like ours, which have no full stop.
QString joined(QStringList parts) {
  parts.removeAll(QString());
  for (QString& each : parts)
    if (parts.size() > 1 && each.endsWith(u'.')) each.chop(1);
  return parts.join(QStringLiteral(" · "));
}

/// Why there are no copies of a place; empty when there are, or none are wanted.
QString copiesProblem(const Motion& motion, const MotionPlace& at, const EditSymmetry& symmetry, std::vector<Vec3>& copies) {
  try {
    copies = copiesOf(motion, at, symmetry);
  } catch (const Error& error) {
    return QString::fromStdString(error.message());
  }
  return {};
}

std::vector<Vec3> pointsAt(const Motion& motion, const std::vector<MotionPlace>& places) {
  std::vector<Vec3> points;
  points.reserve(places.size());
  for (const MotionPlace& at : places) points.push_back(placeHit(motion, at).point);
  return points;
}

}  // namespace

QString SurfacePullTool::hint() const {
  if (unseen_) return tr("No sweep is made of this motion: choose Sweep to see its surface and pull it");
  if (!surface_) return {};  // the view says what it does by itself
  if (entry_) return typingHint();
  if (held() && edit_) return heldHint();
  if (hovered() && under_) return hoverHint();
  return idleHint();
}

/// What is in force, before the mouse is where it counts.
QString SurfacePullTool::idleHint() const {
  if (!isShown()) return {};
  QStringList parts{mode_.twists() ? tr("Drag a place on the surface to twist it")
                                   : tr("Drag a place on the surface to pull it")};
  if (const QString selected = selectedText(); !selected.isEmpty())
    parts << selected;
  else
    parts << (mode_.twists() || mode_.isPlain() ? QString() : mode_.wayText()) << mode_.symmetryText() << mode_.levelText();
  return joined(parts << chosenHint());
}

QString SurfacePullTool::selectedText() const {
  for (const ChangeableEdit& each : edits_) {
    if (each.id != feature()) continue;
    const PullMode own(each.edit);
    QStringList parts{own.wayText(), own.symmetryText(), own.levelText()};
    parts.removeAll(QString());
    return tr("selected edit: %1").arg(parts.join(QStringLiteral(", ")));
  }
  return {};
}

bool SurfacePullTool::isShown() const {
  if (!placement_) return false;
  return std::any_of(placement_->users.begin(), placement_->users.end(), [this](const FeatureId& sweep) {
    const auto result = host().result(sweep);
    return !result || !result->error;
  });
}

/// What is wrong with the goal that is typed.
QString SurfacePullTool::typingProblem() const {
  if (!refusal_.isEmpty()) return refusal_;
  return edit_->live().arrived() ? QString() : edit_->live().reason();
}

QString SurfacePullTool::typingHint() const {
  if (QString problem = typingProblem(); !problem.isEmpty()) return problem;
  return entry_->isAngle() ? tr("Type the angle of the twist · Enter takes it · Esc leaves it as it is")
                           : tr("Type where the point goes: x, y, z · Enter takes it · Esc leaves it as it is");
}

QString SurfacePullTool::heldHint() const {
  if (edit_->turnsAxis() && edit_->possible())
    return joined({tr("Let go to twist about this axis"), tr("Shift: along x, y, z, the tangent, the arm or across both"),
                   tr("Esc takes it back")});
  const LiveEdit& live = edit_->live();
  if (!edit_->possible()) return tr("Nothing will be changed here: %1").arg(live.reason());
  QStringList parts;
  if (!live.arrived()) parts << tr("The places cannot all arrive; %1 is left at most").arg(leftText());
  if (live.swing() > wildSwing)
    parts << tr("Poles move %1 times as far: places and pins are too near each other").arg(std::lround(live.swing()));
  parts << heldText() << tr("Esc takes it back");
  if (const std::size_t pins = edit_->countOfPins(mode_); pins > 0) parts << tr("%1 pinned").arg(pins);
  const bool followed = edit_->changesFollowed();  // its own way, whatever is chosen for the next one
  if (edit_->twists(mode_))
    parts << (followed ? QString() : tr("A: another axis")) << tr("Enter: type the angle");
  else
    parts << tr("Shift: along the normal") << tr("Enter: type the target");
  if (followed) return joined(parts);
  if (const QString share = mode_.adjustable(); !share.isEmpty()) parts << tr("wheel: share of %1").arg(share);
  return joined(parts << mode_.symmetryText() << mode_.levelText());
}

QString SurfacePullTool::heldText() const {
  if (edit_->changesFollowed())
    return edit_->twists(mode_)
               ? tr("Let go to twist by %1° in the selected edit").arg(QString::number(edit_->angle(mode_), 'f', 1))
               : tr("Let go to pull the point here in the selected edit");
  const std::size_t places = edit_->countOfPlaces(mode_);
  if (!edit_->twists(mode_))
    return places > 1 ? tr("Let go to pull %1 places %2").arg(places).arg(mode_.wayText())
                      : tr("Let go to pull the point here %1").arg(mode_.wayText());
  const QString angle = QString::number(edit_->angle(mode_), 'f', 1);
  return places > 1 ? tr("Let go to twist %1 places by %2° about %3").arg(places).arg(angle, mode_.axisText())
                    : tr("Let go to twist by %1° about %2").arg(angle, mode_.axisText());
}

QString SurfacePullTool::leftText() const {
  const double left = edit_->live().remainder();
  if (edit_->twists(mode_)) return QStringLiteral("%1°").arg(left, 0, 'g', 2);
  const LengthUnit unit = host().lengthUnit();
  return QStringLiteral("%1 %2").arg(left / unit.millimetres, 0, 'g', 2).arg(QString::fromStdString(unit.name));
}

QString SurfacePullTool::hoverHint() const {
  if (isFollowed(*under_) && !selectedSurface_) return tr("The surface of the selected edit is being prepared");
  if (under_->onAxis) return joined({tr("Drag to turn the axis of this twist"), tr("Enter: type the angle")});
  if (isFollowed(*under_))
    return joined(
        {tr("Drag to change the selected edit here; those after it are hidden meanwhile"), tr("Enter: type its goal")});
  std::vector<Vec3> copies;
  if (const QString problem = copiesProblem(surface_->motion(), under_->hit.at, mode_.symmetry(), copies);
      !problem.isEmpty())
    return joined({problem, tr("1: no copies")});
  // What is in force comes before the keys that change it: a narrow window has no room for all.
  QStringList parts;
  if (mode_.twists())
    parts << tr("Drag to twist the surface here about %1").arg(mode_.axisText());
  else
    parts << (under_->of ? tr("Drag to pull further, %1").arg(mode_.wayText()) : tr("Drag to pull %1").arg(mode_.wayText()));
  const QString symmetry = mode_.symmetryText(), level = mode_.levelText();
  if (!symmetry.isEmpty()) parts << tr("%1 (1: none)").arg(symmetry);
  if (!level.isEmpty()) parts << tr("%1 (0: as it is)").arg(level);
  parts << chosenHint() << keysHint(symmetry.isEmpty(), level.isEmpty());
  return joined(parts);
}

QString SurfacePullTool::keysHint(bool single, bool ownLevel) const {
  QStringList parts;
  if (mode_.twists())
    parts << tr("A: another axis") << tr("W: pull");
  else
    parts << tr("T, R, S: one alone (Shift: as well)") << tr("W: twist");
  if (single) parts << tr("2–9, M: copies");
  if (chosen_.empty()) parts << tr("Shift-click: take along") << tr("P: pin it");
  parts << (mode_.twists() ? tr("Enter: type the angle") : tr("Enter: type the target"));
  if (const QString share = mode_.adjustable(); !share.isEmpty()) parts << tr("Shift+wheel: share of %1").arg(share);
  if (ownLevel) parts << tr("+, −: finer, coarser");
  return joined(parts);
}

QString SurfacePullTool::chosenHint() const {
  if (chosen_.empty()) return {};
  return tr("chosen: %1, pinned: %2 (Esc: none)").arg(chosen_.moved.size()).arg(chosen_.pinned.size());
}

std::optional<Vec3> SurfacePullTool::whereabouts() const {
  if (!surface_) return std::nullopt;
  if (edit_ && (held() || entry_)) return placeHit(edit_->live().motion(), edit_->grip().hit.at).point;
  return hovered() && under_ ? std::optional(under_->hit.point) : std::nullopt;
}

/// Where the point that is dragged is now, seen from the trajectory.
QString SurfacePullTool::wayText() const {
  const Motion& now = edit_->live().motion();
  const MotionPlace& at = edit_->grip().hit.at;
  const Vec3 end = placeHit(now, at).point;
  return dragNumbers((end - point(now.trajectory, at.v)).norm(), (end - edit_->from()).norm(), host().lengthUnit(),
                     millimetresPerPixel());
}

std::vector<vtkSmartPointer<vtkProp>> SurfacePullTool::props() const {
  Props props = marksOfResult();
  if (!surface_) return props;
  const Facing face = facing(towards_, millimetresPerPixel());
  PullMarks marks(host(), face, props);
  const bool editing = edit_ && (held() || entry_);
  if (editing)
    markEdit(marks);
  else if (hovered() && under_ && !under_->onAxis)
    markPlace(marks);
  if (!editing) markAxes(marks);
  const Motion& motion = editing ? edit_->live().motion() : surface_->motion();
  marks.chosen(pointsAt(motion, chosen_.moved), pointsAt(motion, chosen_.pinned));
  if (!editing && !edits_.empty() && edits_.front().isFollowed)
    marks.copies(pointsAt(motion, editedPlaces(edits_.front().edit)));
  return props;
}

/// Not while a surface is seen that is no result yet. The card of the place under the mouse hides names beside it.
Props SurfacePullTool::marksOfResult() const {
  const auto result = host().result(feature());
  if (!result || edit_ || lingering_) return {};
  const auto pointed = hovered() && under_ ? host().onScreen(under_->hit.point) : std::nullopt;
  return validityMarks(host(), result->evaluated.stats, [&](const Vec3& place) {
    constexpr double reach = 160;  // logical pixels, of the card and a name
    const auto seen = host().onScreen(place);
    return pointed && seen && (*seen - *pointed).manhattanLength() < reach;
  });
}

void SurfacePullTool::markTurnedAxis(PullMarks& marks, const Vec3& centre, const Vec3& axis) const {
  const Vec3 end = centre + axisPixels * millimetresPerPixel() * axis;
  const Vec3 read = readableAxis(std::get<MotionTwist>(edit_->edit(mode_)).axis);
  marks.ball(end, true);
  if (!entry_) marks.tell(end, QStringLiteral("%1, %2, %3").arg(read.x()).arg(read.y()).arg(read.z()), false);
}

void SurfacePullTool::markPlace(PullMarks& marks) const {
  const Motion& motion = surface_->motion();
  const PlaceHit& hit = under_->hit;
  // Of lines at one depth the first is seen: the ring before the iso-curves.
  const bool followed = isFollowed(*under_);  // changed in its own way, not in that of the ring
  if (!mode_.twists() && !followed) marks.ring(hit.point, mode_);
  marks.place(motion, hit, mode_, towards_);
  std::vector<Vec3> copies;
  copiesProblem(motion, hit.at, mode_.symmetry(), copies);
  marks.copies(copies);
  marks.tell(hit.point, placeNumbers(motion, hit.at), !mode_.twists());
  if (!mode_.twists() || followed) return;
  const Vec3 centre = point(motion.trajectory, hit.at.v);
  marks.axis(centre, twistAxis(motion, hit.at, mode_.axis()));
}

/// Of twists that are there, with the balls by which they are turned.
void SurfacePullTool::markAxes(PullMarks& marks) const {
  for (std::size_t k = 0; k < edits_.size(); ++k) {
    if (!showsAxis(edits_[k])) continue;
    const auto ball = axisBall(surface_->motion(), edits_[k].edit, millimetresPerPixel());
    if (!ball) continue;
    marks.axis(ball->centre, ball->axis);
    marks.ball(ball->at(), hovered() && under_ && under_->onAxis && under_->of->edit == k);
  }
}

void SurfacePullTool::markEdit(PullMarks& marks) const {
  const PlaceHit& hit = edit_->grip().hit;
  const Motion& now = edit_->live().motion();
  const PlaceHit moved = placeHit(now, hit.at);
  const Vec3 &end = moved.point, centre = point(edit_->before().trajectory, hit.at.v);
  if (entry_) marks.entry(end, entry_->text(), entry_->isAngle() ? QStringLiteral("°") : QString(), typingProblem());
  if (edit_->twists(mode_)) {
    const Vec3 axis = edit_->axis(mode_);
    marks.axis(centre, axis);
    if (edit_->turnsAxis()) return markTurnedAxis(marks, centre, axis);
    marks.turn({centre, axis, hit.point - centre, edit_->turnedBy(mode_)},
               entry_ ? QString() : QStringLiteral("%1°").arg(edit_->angle(mode_), 0, 'f', 1));
  } else {
    if (!edit_->changesFollowed()) marks.ring(end, mode_);
    if (!entry_ && edit_->possible()) marks.tell(end, wayText(), true);
  }
  if (!entry_ && !edit_->possible()) marks.problem(end, edit_->live().reason(), false);
  marks.way(edit_->from(), end);
  marks.isoCurves(now, moved, towards_);
  std::vector<Vec3> copies;
  copiesProblem(now, hit.at, mode_.symmetry(), copies);
  marks.copies(copies);
}

}  // namespace blossom::sweep
