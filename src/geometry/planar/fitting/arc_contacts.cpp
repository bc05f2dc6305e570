#include "geometry/planar/fitting/arc_contacts.h"

#include <algorithm>

#include "geometry/planar/angles.h"

namespace blossom::planar {

ArcContacts::ArcContacts(const std::vector<Path>& loops) {
  for (const Path& loop : loops)
    for (const Segment& segment : loop.segments)
      if (const auto* arc = std::get_if<Arc2>(&segment)) {
        ends_.push_back(endOf(*arc, true));
        ends_.push_back(endOf(*arc, false));
      }
  std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.at.x() < b.at.x(); });
}

bool ArcContacts::beside(const Arc2& arc, bool start) const {
  constexpr double near = 1e-7;  // of the size, and of a direction
  const End here = endOf(arc, start);
  const double within = near * (here.at.cwiseAbs().maxCoeff() + arc.radius);
  const auto first = std::lower_bound(ends_.begin(), ends_.end(), here.at.x() - within,
                                      [](const End& end, double x) { return end.at.x() < x; });
  for (auto each = first; each != ends_.end() && each->at.x() <= here.at.x() + within; ++each)
    if (each->radius < arc.radius && (each->at - here.at).norm() <= within && (each->away - here.away).norm() <= near &&
        each->turnsLeft == here.turnsLeft)
      return true;
  return false;
}

bool ArcContacts::any(const std::vector<Path>& loops) const {
  const auto touches = [&](const Segment& segment) {
    const auto* arc = std::get_if<Arc2>(&segment);
    return arc && (beside(*arc, true) || beside(*arc, false));
  };
  return std::any_of(loops.begin(), loops.end(),
                     [&](const Path& loop) { return std::any_of(loop.segments.begin(), loop.segments.end(), touches); });
}

ArcContacts::End ArcContacts::endOf(const Arc2& arc, bool start) {
  const Vec2 out = unitAt(start ? arc.start : arc.start + arc.sweep);
  const bool turnsLeft = (arc.sweep > 0) == start;
  const Vec2 across(-out.y(), out.x());
  return {arc.center + arc.radius * out, turnsLeft ? across : Vec2(-across), arc.radius, turnsLeft};
}

}  // namespace blossom::planar
