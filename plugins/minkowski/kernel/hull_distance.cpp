#include "kernel/hull_distance.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <vector>

#include "geometry/planar/angles.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/sound_region.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

/// The point of a piece nearest to another one.
struct Foot {
  double distance = HUGE_VAL;
  Vec2 at = Vec2::Zero();
  Vec2 along = Vec2::Zero();  ///< direction of the boundary there; in a corner the mean of both
};

/// Part of a boundary, a line or an arc, with the material to its left.
struct BoundaryPart {
  Segment segment;
  Vec2 alongStart = Vec2::Zero(), alongEnd = Vec2::Zero();  ///< as those of feet
};

Vec2 tangentOf(const Segment& segment, bool atEnd) {
  if (const auto* line = std::get_if<Line2>(&segment)) return (line->to - line->from).normalized();
  const auto& arc = std::get<Arc2>(segment);
  const Vec2 out = unitAt(atEnd ? arc.start + arc.sweep : arc.start);
  return arc.sweep > 0 ? Vec2(-out.y(), out.x()) : Vec2(out.y(), -out.x());
}

Foot footOn(const BoundaryPart& part, const Line2& line, const Vec2& p) {
  const Vec2 along = line.to - line.from;
  const double squared = along.squaredNorm(), share = squared > 0 ? (p - line.from).dot(along) / squared : 0;
  if (share <= 0) return {(p - line.from).norm(), line.from, part.alongStart};
  if (share >= 1) return {(p - line.to).norm(), line.to, part.alongEnd};
  const Vec2 at = line.from + share * along;
  return {(p - at).norm(), at, along};
}

Foot footOn(const BoundaryPart& part, const Arc2& arc, const Vec2& p) {
  const Vec2 out = p - arc.center;
  const double distance = out.norm(), sign = arc.sweep > 0 ? 1 : -1;
  if (inOneTurn(sign * (std::atan2(out.y(), out.x()) - arc.start)) <= std::abs(arc.sweep)) {
    const Vec2 unit = distance > 0 ? Vec2(out / distance) : unitAt(arc.start);
    return {std::abs(distance - arc.radius), arc.center + arc.radius * unit, sign * Vec2(-unit.y(), unit.x())};
  }
  const Vec2 start = startPoint(arc), end = endPoint(arc);
  if ((p - start).squaredNorm() <= (p - end).squaredNorm()) return {(p - start).norm(), start, part.alongStart};
  return {(p - end).norm(), end, part.alongEnd};
}

Foot footOn(const BoundaryPart& part, const Vec2& p) {
  if (const auto* line = std::get_if<Line2>(&part.segment)) return footOn(part, *line, p);
  return footOn(part, std::get<Arc2>(part.segment), p);
}

void addParts(const Path& loop, double chord, std::vector<BoundaryPart>& parts) {
  const std::size_t first = parts.size();
  for (const Segment& segment : loop.segments) {
    if (!std::holds_alternative<Spline2>(segment)) {
      if (length(segment) > 0) parts.push_back({segment});
      continue;
    }
    const std::vector<Vec2> points = flatten(segment, chord);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i] != points[i + 1]) parts.push_back({Line2{points[i], points[i + 1]}});
  }
  const std::size_t count = parts.size() - first;
  for (std::size_t i = 0; i < count; ++i) {
    BoundaryPart &part = parts[first + i], &next = parts[first + (i + 1) % count];
    part.alongEnd = next.alongStart = tangentOf(part.segment, true) + tangentOf(next.segment, false);
  }
}

/// The nearest point of a convex polygon.
Vec2 nearestOf(const std::vector<Vec2>& convex, const Vec2& p) {
  double nearest = HUGE_VAL;
  bool inside = true;
  Vec2 place = p;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 &from = convex[i], along = convex[(i + 1) % convex.size()] - from;
    if (cross(along, Vec2(p - from)) < 0) inside = false;
    const double t = std::clamp((p - from).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec2 foot = from + t * along;
    if (const double distance = (p - foot).norm(); distance < nearest) {
      nearest = distance;
      place = foot;
    }
  }
  return inside ? p : place;
}

using Near = std::shared_ptr<const std::vector<const BoundaryPart*>>;

struct Square {
  Vec2 centre;
  double half = 0;
  double bound = 0;  ///< no point of the hull in it is farther from the shape
  Near near;         ///< parts that may be nearest to points of it
};

bool isLess(const Square& a, const Square& b) { return a.bound < b.bound; }

/// The farthest point of the hull.
class FarthestPoint {
 public:
  FarthestPoint(std::vector<BoundaryPart> parts, std::vector<Vec2> hull, double precision)
      : parts_(std::move(parts)), hull_(std::move(hull)), precision_(precision) {}

  HullDistance run(const Progress& progress) {
    Vec2 low = hull_.front(), high = low;
    for (const Vec2& p : hull_) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    std::vector<const BoundaryPart*> all;
    for (const BoundaryPart& part : parts_) all.push_back(&part);
    look((low + high) / 2, (high - low).maxCoeff() / 2, std::make_shared<const std::vector<const BoundaryPart*>>(all));
    while (!squares_.empty() && squares_.top().bound > enough()) {
      progress.check();
      const Square square = squares_.top();
      squares_.pop();
      const double half = square.half / 2;
      for (const Vec2& way : {Vec2(-half, -half), Vec2(half, -half), Vec2(-half, half), Vec2(half, half)})
        look(square.centre + way, half, square.near);
    }
    const double reached = enough();
    climb();
    return {best_.distance, std::max(reached, best_.distance), best_.at};
  }

 private:
  struct Place {
    double distance = 0;
    Vec2 at = Vec2::Zero();
    double step = 0;
    Near near;
  };

  [[nodiscard]] double enough() const {
    constexpr double share = 1e-3;
    return best_.distance + std::max(precision_, share * best_.distance);
  }

  void look(const Vec2& centre, double half, const Near& candidates) {
    const Vec2 place = nearestOf(hull_, centre);
    const double reach = std::sqrt(2.0) * half;
    if ((place - centre).norm() > reach) return;  // outside of the hull
    // The nearest point of the hull is no farther from points of the hull than the centre is.
    Foot nearest;
    std::vector<double> distances;
    distances.reserve(candidates->size());
    for (const BoundaryPart* part : *candidates) {
      const Foot foot = footOn(*part, place);
      distances.push_back(foot.distance);
      if (foot.distance < nearest.distance) nearest = foot;
    }
    const double away = outside(nearest, place);
    const double bound = reach + away;
    if (bound <= std::max(0.0, enough())) return;
    std::vector<const BoundaryPart*> near;
    for (std::size_t i = 0; i < distances.size(); ++i)
      if (distances[i] <= nearest.distance + 2 * reach) near.push_back((*candidates)[i]);
    Square square{centre, half, bound, std::make_shared<const std::vector<const BoundaryPart*>>(std::move(near))};
    if (away > best_.distance) best_ = {away, place, half, square.near};
    squares_.push(std::move(square));
  }

  /// Distance from the shape, negative inside of it: left of the boundary at the nearest point of it.
  static double outside(const Foot& nearest, const Vec2& p) {
    return cross(nearest.along, Vec2(p - nearest.at)) > 0 ? -nearest.distance : nearest.distance;
  }

  /// To the highest place near by.
  void climb() {
    if (!best_.near) return;
    const double shortest = 1e-7 * best_.step;
    while (best_.step > shortest) {
      const Place before = best_;
      for (int k = 0; k < 8; ++k) {
        const Vec2 place = nearestOf(hull_, before.at + before.step * unitAt(k * fullTurn / 8));
        Foot nearest;
        for (const BoundaryPart* part : *best_.near)
          if (const Foot foot = footOn(*part, place); foot.distance < nearest.distance) nearest = foot;
        if (const double away = outside(nearest, place); away > best_.distance) {
          best_.distance = away;
          best_.at = place;
        }
      }
      if (best_.at == before.at) best_.step /= 2;
    }
  }

  std::vector<BoundaryPart> parts_;
  std::vector<Vec2> hull_;
  double precision_;
  Place best_;
  std::priority_queue<Square, std::vector<Square>, decltype(&isLess)> squares_{&isLess};
};

struct Disc {
  Vec2 centre = Vec2::Zero();
  double radius = -1;

  [[nodiscard]] bool holds(const Vec2& p) const { return (p - centre).norm() <= radius * (1 + 1e-12); }
};

Disc discOf(const Vec2& a, const Vec2& b) { return {(a + b) / 2, (a - b).norm() / 2}; }

Disc discOf(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 p = b - a, q = c - a;
  const double twice = 2 * cross(p, q);
  if (twice == 0) {
    const Disc first = discOf(a, b), second = discOf(a, c), third = discOf(b, c);
    return std::max({first, second, third}, [](const Disc& x, const Disc& y) { return x.radius < y.radius; });
  }
  const Vec2 to((q.y() * p.squaredNorm() - p.y() * q.squaredNorm()) / twice,
                (p.x() * q.squaredNorm() - q.x() * p.squaredNorm()) / twice);
  return {a + to, to.norm()};
}

/// Points in an order that makes no worst case likely, the same on every machine.
void shuffle(std::vector<Vec2>& points) {
  std::uint64_t state = 88172645463325252U;  // xorshift (Marsaglia 2003)
  for (std::size_t i = points.size(); i > 1; --i) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    std::swap(points[i - 1], points[state % i]);
  }
}

Disc smallestDisc(std::vector<Vec2> points, const Progress& progress) {
  shuffle(points);
  Disc disc;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (disc.holds(points[i])) continue;
    progress.check();
    disc = {points[i], 0};
    for (std::size_t j = 0; j < i; ++j) {
      if (disc.holds(points[j])) continue;
      disc = discOf(points[i], points[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (!disc.holds(points[k])) disc = discOf(points[i], points[j], points[k]);
    }
  }
  return disc;
}

}  // namespace

HullDistance distanceToHull(const Region& shape, const Region& hull, double precision, const Progress& progress) {
  if (shape.loops.empty() || hull.loops.empty()) return {};
  std::vector<BoundaryPart> parts;
  for (const Path& loop : shape.loops) addParts(loop, precision / 4, parts);
  HullDistance found =
      FarthestPoint(std::move(parts), flatten(hull.loops.front(), precision / 4), precision / 2).run(progress);
  found.atMost += precision / 2;  // by which both polygons may be nearer to each other than what they stand for
  return found;
}

double circumradius(const Region& region, double chord, const Progress& progress) {
  std::vector<Vec2> points;
  for (const Path& loop : region.loops) {
    const std::vector<Vec2> more = flatten(loop, chord);
    points.insert(points.end(), more.begin(), more.end());
  }
  return std::max(0.0, smallestDisc(std::move(points), progress).radius) + (hasCurves(region) ? chord : 0);
}

}  // namespace blossom::minkowski
