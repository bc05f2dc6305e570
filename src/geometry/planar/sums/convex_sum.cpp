#include "geometry/planar/sums/convex_sum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/tolerance.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_box.h"

namespace blossom::planar {
namespace {

constexpr double oneDirection = 1e-11;  // radians

/// A range of normals, from one angle to that of the next fan, in which the boundary is an arc; a corner has the radius 0.
struct Fan {
  double from = 0;
  Vec2 centre;
  double radius = 0;
};

/// In the order of the boundary, by angles that do not fall and span one turn. Where several fans begin at one angle the
/// last one has the width.
class Fans {
 public:
  Fans(const Path& path, const Progress& progress) {
    for (const Segment& segment : path.segments) {
      progress.check();
      if (const auto* arc = std::get_if<Arc2>(&segment)) {
        endAt(arc->start);
        add(arc->start, arc->center, arc->radius);
        if (path.segments.size() > 1) fans_.push_back({fans_.back().from + arc->sweep, endPoint(segment), 0});
      } else {
        const auto& line = std::get<Line2>(segment);
        const Vec2 along = line.to - line.from;
        if (!along.isZero()) add(std::atan2(-along.x(), along.y()), line.to, 0);
      }
    }
  }

  [[nodiscard]] const std::vector<Fan>& all() const { return fans_; }
  /// How far coordinates reach.
  [[nodiscard]] double reach() const {
    double most = 0;
    for (const Fan& fan : fans_) most = std::max(most, fan.centre.cwiseAbs().maxCoeff() + fan.radius);
    return most;
  }

  [[nodiscard]] const Fan& at(double angle) const {
    const double first = fans_.front().from, inside = first + inOneTurn(angle - first);
    const auto after =
        std::upper_bound(fans_.begin(), fans_.end(), inside, [](double value, const Fan& fan) { return value < fan.from; });
    return after == fans_.begin() ? fans_.back() : *std::prev(after);
  }

 private:
  void add(double angle, const Vec2& centre, double radius) {
    if (fans_.empty()) {
      fans_.push_back({angle, centre, radius});
      return;
    }
    const double before = fans_.back().from;
    fans_.push_back({before + std::max(0.0, std::remainder(angle - before, fullTurn)), centre, radius});
  }

  /// The angles of arcs are known better than those of lines before them, which may come out behind.
  void endAt(double angle) {
    if (fans_.empty()) return;
    const double last = fans_.back().from + std::remainder(angle - fans_.back().from, fullTurn);
    for (auto fan = fans_.rbegin(); fan != fans_.rend() && fan->from > last; ++fan) fan->from = last;
  }

  std::vector<Fan> fans_;
};

/// Angles at which a fan of either begins; those that are one direction once.
std::vector<double> startsOf(const Fans& a, const Fans& b) {
  std::vector<double> starts;
  for (const auto* fans : {&a, &b})
    for (const Fan& fan : fans->all()) starts.push_back(inOneTurn(fan.from));
  std::sort(starts.begin(), starts.end());
  const auto same = [](double p, double q) { return q - p <= oneDirection; };
  starts.erase(std::unique(starts.begin(), starts.end(), same), starts.end());
  while (starts.size() > 1 && same(starts.back(), starts.front() + fullTurn)) starts.pop_back();
  return starts;
}

/// Arcs about one centre that follow each other.
bool continues(const Arc2& arc, const Arc2& next, double rounding) {
  return (arc.center - next.center).norm() <= rounding && std::abs(arc.radius - next.radius) <= rounding;
}

/// Directions of sides far from the origin are known to some digits only: parallel ones leave arcs that are points.
Arc2 withoutSliver(const Arc2& arc, double rounding) {
  if (arc.radius * arc.sweep > rounding) return arc;
  return {arc.center + arc.radius * unitAt(arc.start + arc.sweep / 2), 0, arc.start, arc.sweep};
}

std::vector<Arc2> arcsBetween(const std::vector<double>& starts, const Fans& a, const Fans& b, double rounding,
                              const Progress& progress) {
  std::vector<Arc2> arcs;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    progress.check();
    const double width = (i + 1 < starts.size() ? starts[i + 1] : starts.front() + fullTurn) - starts[i];
    const double middle = inOneTurn(starts[i] + width / 2);
    const Fan &ofA = a.at(middle), &ofB = b.at(middle);
    const Arc2 arc{ofA.centre + ofB.centre, ofA.radius + ofB.radius, starts[i], width};
    if (!arcs.empty() && continues(arcs.back(), arc, rounding))
      arcs.back().sweep += width;
    else
      arcs.push_back(arc);
  }
  if (arcs.size() > 1 && continues(arcs.back(), arcs.front(), rounding)) {
    arcs.front().start = arcs.back().start;
    arcs.front().sweep += arcs.back().sweep;
    arcs.pop_back();
  }
  for (Arc2& arc : arcs) arc = withoutSliver(arc, rounding);
  return arcs;
}

Vec2 beginOf(const Arc2& arc) { return arc.center + arc.radius * unitAt(arc.start); }

/// Makes a line longer by the next one where both are one but for rounding. @returns whether they are
bool isGoneOn(Line2& line, const Line2& next, double rounding) {
  const Vec2 along = next.to - line.from;
  if (std::abs(cross(along, next.from - line.from)) > rounding * along.norm()) return false;
  line.to = next.to;
  return true;
}

/// Of what is drawn, wherever the centres of shallow arcs are.
double mostRounding(const Region& region) {
  const Box2 box = boxAround(region.loops);
  return 1e-15 * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() + 1e-9 * box.sizes().maxCoeff();
}

}  // namespace

Region convexSum(const Region& a, const Region& b, const Progress& progress) {
  const Fans fansA(a.loops.front(), progress), fansB(b.loops.front(), progress);
  const double reach = fansA.reach() + fansB.reach(), most = mostRounding(a) + mostRounding(b);
  const double rounding = std::min(1e-15 * reach, most);
  // Arcs that are off by the rounding of their centres meet, where the gap is none for those who read the result.
  const double meets = std::max(rounding, std::min({4e-15 * reach, Tolerance{}.joining / 2, 1000 * most}));
  const std::vector<Arc2> arcs = arcsBetween(startsOf(fansA, fansB), fansA, fansB, rounding, progress);
  Region result;
  Path& path = result.loops.emplace_back();
  path.closed = true;
  Vec2 at = beginOf(arcs.front());  // where what is drawn ends
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    progress.check();
    const Arc2 &arc = arcs[i], &next = arcs[(i + 1) % arcs.size()];
    if (arc.radius > 0) {
      path.segments.emplace_back(arc);
      at = arc.center + arc.radius * unitAt(arc.start + arc.sweep);
    }
    const Vec2 to = beginOf(next);
    const double gap = (to - at).norm();
    if (gap <= rounding) continue;
    auto* before = path.segments.empty() ? nullptr : std::get_if<Line2>(&path.segments.back());
    if (gap <= meets && (arc.radius > 0 || next.radius > 0)) {
      if (!before) continue;
      before->to = to;
    } else if (!before || !isGoneOn(*before, {at, to}, rounding)) {
      path.segments.emplace_back(Line2{at, to});
    }
    at = to;
  }
  const auto* first = std::get_if<Line2>(&path.segments.front());
  auto* last = std::get_if<Line2>(&path.segments.back());
  if (first && last && path.segments.size() > 2 && isGoneOn(*last, *first, rounding))
    path.segments.erase(path.segments.begin());
  return result;
}

}  // namespace blossom::planar
