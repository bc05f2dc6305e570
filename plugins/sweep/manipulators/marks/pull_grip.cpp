#include "manipulators/marks/pull_grip.h"

#include <algorithm>

#include "kernel/edit/motion_symmetry.h"
#include "manipulators/marks/axis_ball.h"

namespace blossom::sweep {

namespace {

constexpr double gripReach = 8;  // pixels

double distanceFrom(const Ray& ray, const Vec3& p) {
  const Vec3 from = p - ray.origin;
  return (from - std::max(0.0, from.dot(ray.direction)) * ray.direction).norm();
}

/// Takes it out when it is there.
bool takenOut(std::vector<MotionPlace>& places, const MotionPlace& at) { return std::erase(places, at) > 0; }

struct NumberedHit {
  PlaceHit hit;
  std::size_t number;
};

/// The nearest of some places to the ray that is within reach, by its number.
std::optional<NumberedHit> nearestOf(const std::vector<MotionPlace>& places, const Motion& motion,
                                     const ui::ToolEvent& event) {
  std::optional<NumberedHit> best;
  double distance = gripReach * event.millimetresPerPixel;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k].v < motion.domainV().first || places[k].v > motion.domainV().second) continue;
    PlaceHit hit = placeHit(motion, {insidePeriod(motion, places[k].u), places[k].v});
    const double off = distanceFrom(event.ray, hit.point);
    if (off > distance) continue;
    distance = off;
    hit.distance = (hit.point - event.ray.origin).dot(event.ray.direction);
    best = NumberedHit{hit, k};
  }
  return best;
}

std::optional<PullGrip> axisGrip(const Motion& motion, const MotionEdit& edit, std::size_t number,
                                 const ui::ToolEvent& event) {
  const auto ball = axisBall(motion, edit, event.millimetresPerPixel);
  if (!ball || distanceFrom(event.ray, ball->at()) > gripReach * event.millimetresPerPixel) return std::nullopt;
  const MotionPlace& at = editedPlaces(edit).front();
  if (at.v < motion.domainV().first || at.v > motion.domainV().second) return std::nullopt;
  PlaceHit hit = placeHit(motion, {insidePeriod(motion, at.u), at.v});
  hit.distance = (ball->at() - event.ray.origin).dot(event.ray.direction);
  return PullGrip{hit, PullGrip::OfEdit{number, 0}, true};
}

}  // namespace

std::vector<MotionPlace> ChosenPlaces::all() const {
  std::vector<MotionPlace> both = moved;
  both.insert(both.end(), pinned.begin(), pinned.end());
  return both;
}

void ChosenPlaces::toggleMoved(const MotionPlace& at) {
  takenOut(pinned, at);
  if (!takenOut(moved, at)) moved.push_back(at);
}

void ChosenPlaces::togglePinned(const MotionPlace& at) {
  takenOut(moved, at);
  if (!takenOut(pinned, at)) pinned.push_back(at);
}

const std::vector<MotionPlace>& editedPlaces(const MotionEdit& edit) {
  return std::visit([](const auto& each) -> const std::vector<MotionPlace>& { return each.at; }, edit);
}

std::optional<PullGrip> gripUnder(const ui::ToolHost& host, const LiveSurface& surface, const ChosenPlaces& chosen,
                                  const std::vector<ChangeableEdit>& edits, const ShowsAxis& showsAxis,
                                  const ui::ToolEvent& event) {
  for (std::size_t k = 0; k < edits.size(); ++k)
    if (showsAxis(edits[k]))
      if (auto grip = axisGrip(surface.motion(), edits[k].edit, k, event)) return grip;  // drawn over what lies before it
  std::optional<PullGrip> grip;
  if (const auto found = nearestOf(chosen.all(), surface.motion(), event)) grip = PullGrip{found->hit, {}};
  for (std::size_t k = 0; k < edits.size() && !grip; ++k)
    if (const auto found = nearestOf(editedPlaces(edits[k].edit), surface.motion(), event))
      grip = PullGrip{found->hit, PullGrip::OfEdit{k, found->number}};
  if (!grip)
    if (const auto hit = surface.finder.find(event.ray)) grip = PullGrip{*hit, {}};
  if (!grip) return std::nullopt;
  const double slack = gripReach * event.millimetresPerPixel;
  const bool hidden = !event.pick.feature.empty() && event.pick.part.distance < grip->hit.distance - slack;
  const auto cut = host.section();
  if (hidden || (cut && cut->height(grip->hit.point) > 0)) return std::nullopt;
  return grip;
}

}  // namespace blossom::sweep
