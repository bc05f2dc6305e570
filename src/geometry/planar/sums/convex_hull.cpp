#include "geometry/planar/sums/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/hermite_spline.h"
#include "geometry/planar/fitting/spline_samples.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// A corner of the region or a point of a spline; its numbers among the samples of the spline that ends there and of the one
/// that goes on from it.
struct HullPoint {
  Vec2 at;
  std::uint32_t before = nowhere, after = nowhere;

  /// Another one in the same place.
  void goOnWith(const HullPoint& other) {
    if (before == nowhere) before = other.before;
    if (after == nowhere) after = other.after;
  }
};

/// What a hull touches in a range of normals, from one angle to that of the next one: a point, or an arc.
struct Touched {
  double from = 0;
  Vec2 centre;
  double radius = 0;
  std::uint32_t point = nowhere;

  [[nodiscard]] bool isSame(const Touched& other) const {
    return centre == other.centre && radius == other.radius && point == other.point;
  }
  [[nodiscard]] Vec2 at(double normal) const { return radius > 0 ? Vec2(centre + radius * unitAt(normal)) : centre; }
};

/// All around, by angles of 0 to 2 pi that rise.
using Support = std::vector<Touched>;

const Touched& touchedAt(const Support& support, double normal) {
  const auto after = std::upper_bound(support.begin(), support.end(), normal,
                                      [](double value, const Touched& each) { return value < each.from; });
  return after == support.begin() ? support.back() : *std::prev(after);
}

double normalOf(const Vec2& along) { return inOneTurn(std::atan2(-along.x(), along.y())); }

/// Angles that rise from one of 0 to 2 pi on, and turn once at most, brought into one turn.
void wrap(Support& support) {
  const auto beyond =
      std::find_if(support.begin(), support.end(), [](const Touched& each) { return each.from >= fullTurn; });
  for (auto each = beyond; each != support.end(); ++each) each->from -= fullTurn;
  std::rotate(support.begin(), beyond, support.end());
}

/// The corners of the hull of points, counter-clockwise (Andrew 1979). What lies closer than `point` is one.
std::vector<HullPoint> hullCorners(std::vector<HullPoint> points, double point) {
  std::sort(points.begin(), points.end(), [](const HullPoint& p, const HullPoint& q) {
    return p.at.x() != q.at.x() ? p.at.x() < q.at.x() : p.at.y() < q.at.y();
  });
  if (points.size() < 2) return points;
  std::vector<HullPoint> hull;
  for (int chain = 0; chain < 2; ++chain) {  // the lower one, then back along the upper one
    const std::size_t begin = hull.size();
    for (const HullPoint& next : points) {
      if (hull.size() > begin && (hull.back().at - next.at).norm() <= point) {
        hull.back().goOnWith(next);
        continue;
      }
      const auto turnsRight = [&] {
        const Vec2 &p = hull[hull.size() - 2].at, &q = hull.back().at;
        return cross(Vec2(q - p), Vec2(next.at - q)) <= 0;
      };
      while (hull.size() >= begin + 2 && turnsRight()) hull.pop_back();
      hull.push_back(next);
    }
    if (hull.size() > begin + 1) hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  while (hull.size() > 1 && (hull.back().at - hull.front().at).norm() <= point) {
    hull.front().goOnWith(hull.back());
    hull.pop_back();
  }
  return hull;
}

/// Of the hull of points.
Support supportOf(const std::vector<HullPoint>& hull) {
  Support support;
  for (std::uint32_t i = 0; i < hull.size(); ++i) {
    const Vec2 along = hull[i].at - hull[(i + hull.size() - 1) % hull.size()].at;
    const double normal = along.isZero() ? 0 : normalOf(along);
    const double from = i == 0 ? normal : support.back().from + std::max(0.0, turnFrom(support.back().from, normal));
    support.push_back({from, hull[i].at, 0, i});
  }
  wrap(support);
  return support;
}

/// Of the region between an arc and its chord.
Support supportOf(const Arc2& arc) {
  if (arc.sweep >= fullTurn - sameAngle) return {{0, arc.center, arc.radius, nowhere}};
  const double start = inOneTurn(arc.start), end = start + arc.sweep, middle = (end + start + fullTurn) / 2;
  Support support{
      {start, arc.center, arc.radius, nowhere}, {end, endPoint(arc), 0, nowhere}, {middle, startPoint(arc), 0, nowhere}};
  wrap(support);
  return support;
}

/// Of two circles one contains the other; a point on a circle lies in it. Neither leaves it by more than rounding.
bool contains(const Touched& larger, const Touched& smaller) {
  constexpr double touches = 1e-14;
  return larger.radius > smaller.radius &&
         larger.radius - smaller.radius >= (1 - touches) * (larger.centre - smaller.centre).norm();
}

/// Normals inside of a range at which two supports are equal: those of the lines that touch both.
std::vector<double> crossingsOf(const Touched& a, const Touched& b, double from, double width) {
  if (contains(a, b) || contains(b, a)) return {};
  const Vec2 between = a.centre - b.centre;
  const double distance = between.norm(), share = (b.radius - a.radius) / distance;
  if (!(std::abs(share) < 1)) return {};
  const double middle = std::atan2(between.y(), between.x()), half = std::acos(share);
  std::vector<double> normals;
  constexpr double narrow = 1e-13;
  for (const double normal : {middle - half, middle + half})
    if (const double along = inOneTurn(normal - from); along > narrow && along < width - narrow)
      normals.push_back(from + along);
  std::sort(normals.begin(), normals.end());
  return normals;
}

/// @pre no normal of the range about `normal` is one of `crossingsOf`
bool leads(const Touched& a, const Touched& b, double normal) {
  if (contains(a, b) || contains(b, a)) return a.radius > b.radius;
  const double lead = (a.centre - b.centre).dot(unitAt(normal)) + a.radius - b.radius;
  constexpr double rounding = 1e-14;  // a point that belongs to a spline stays that
  const bool same = a.radius == 0 && b.radius == 0 && std::abs(lead) <= rounding * (a.centre.norm() + b.centre.norm());
  return same ? a.point != nowhere : lead >= 0;
}

/// The hull of both.
Support larger(const Support& a, const Support& b) {
  std::vector<double> starts;
  for (const Support* support : {&a, &b})
    for (const Touched& each : *support) starts.push_back(each.from);
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  Support result;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const double width = (i + 1 < starts.size() ? starts[i + 1] : starts.front() + fullTurn) - starts[i];
    const double inside = inOneTurn(starts[i] + width / 2);
    const Touched &ofA = touchedAt(a, inside), &ofB = touchedAt(b, inside);
    std::vector<double> cuts = crossingsOf(ofA, ofB, starts[i], width);
    cuts.insert(cuts.begin(), starts[i]);
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      const double to = k + 1 < cuts.size() ? cuts[k + 1] : starts[i] + width;
      Touched next = leads(ofA, ofB, (cuts[k] + to) / 2) ? ofA : ofB;
      next.from = cuts[k];
      if (result.empty() || !result.back().isSame(next)) result.push_back(next);
    }
  }
  wrap(result);
  if (result.size() > 1 && result.back().isSame(result.front())) result.erase(result.begin());
  return result;
}

Support largest(const std::vector<Support>& all, std::size_t begin, std::size_t end, const Progress& progress) {
  progress.check();
  if (end - begin == 1) return all[begin];
  const std::size_t middle = (begin + end) / 2;
  return larger(largest(all, begin, middle, progress), largest(all, middle, end, progress));
}

class HullBuilder {
 public:
  HullBuilder(double tolerance, const Progress& progress) : tolerance_(tolerance), progress_(progress) {}

  void add(const Path& loop) {
    for (const Segment& segment : loop.segments) std::visit([&](const auto& each) { addPoints(each); }, segment);
  }

  Path boundary() {
    double size = 0;
    for (const HullPoint& point : points_) size = std::max(size, (point.at - points_.front().at).norm());
    for (const Arc2& arc : arcs_) size = std::max(size, arc.radius);
    constexpr double rounding = 1e-12;
    point_ = rounding * size;
    points_ = hullCorners(std::move(points_), point_);
    std::vector<Support> all;
    if (!points_.empty()) all.push_back(supportOf(points_));
    for (const Arc2& arc : arcs_) all.push_back(supportOf(arc));
    return pathOf(withoutSlivers(largest(all, 0, all.size(), progress_)));
  }

 private:
  void addPoints(const Line2& line) {
    points_.push_back({line.from});
    points_.push_back({line.to});
  }
  void addPoints(const Arc2& arc) {
    if (arc.sweep > 0) arcs_.push_back(arc);
    if (std::abs(arc.sweep) >= fullTurn - sameAngle) return;
    for (const Vec2& end : {startPoint(arc), endPoint(arc)}) points_.push_back({end});
  }
  void addPoints(const Spline2& spline) {
    for (const std::vector<CurveSample>& part : samplesOf(spline, tolerance_, {})) addPoints(part);
  }
  void addPoints(const std::vector<CurveSample>& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto number = static_cast<std::uint32_t>(normals_.size());
      normals_.push_back(samples[i].normal);
      points_.push_back({samples[i].at, i > 0 ? number : nowhere, i + 1 < samples.size() ? number : nowhere});
    }
    normals_.push_back(0);  // no sample of one part follows the last one of another
  }

  [[nodiscard]] static double widthOf(const Support& support, std::size_t i) {
    return support.size() == 1 ? fullTurn : inOneTurn(support[(i + 1) % support.size()].from - support[i].from);
  }

  /// Without corners in which nothing turns and arcs that are points.
  [[nodiscard]] Support withoutSlivers(const Support& support) const {
    constexpr double straight = 1e-11;
    Support kept;
    for (std::size_t i = 0; i < support.size(); ++i) {
      const double width = widthOf(support, i);
      if (support[i].radius > 0 ? width * support[i].radius <= point_ : width <= straight) continue;
      if (kept.empty() || !kept.back().isSame(support[i])) kept.push_back(support[i]);
    }
    if (kept.size() > 1 && kept.back().isSame(kept.front())) kept.erase(kept.begin());
    return kept.empty() ? support : kept;
  }

  [[nodiscard]] bool isFree(const Touched& from, const Touched& to) const {
    if (from.point == nowhere || to.point == nowhere) return false;
    const std::uint32_t after = points_[from.point].after, before = points_[to.point].before;
    return after != nowhere && before != nowhere && after + 1 == before;
  }

  [[nodiscard]] DirectedPoint directed(const Touched& touched, bool goesOn) const {
    const HullPoint& point = points_[touched.point];
    const double normal = normals_[goesOn ? point.after : point.before];
    return {point.at, Vec2(-std::sin(normal), std::cos(normal))};
  }

  /// Whether a spline that arrives in a point goes on in another direction.
  static bool bends(const DirectedPoint& arriving, const DirectedPoint& leaving) {
    constexpr double kink = 1e-3;  // radians
    return std::abs(cross(arriving.along, leaving.along)) > kink || arriving.along.dot(leaving.along) < 0;
  }

  [[nodiscard]] Path pathOf(const Support& support) const {
    const std::size_t n = support.size();
    Path path;
    path.closed = true;
    if (n == 1) {
      path.segments.emplace_back(Arc2{support[0].centre, support[0].radius, 0, fullTurn});
      return path;
    }
    // From a corner at which no spline passes, when there is one.
    std::size_t first = 0;
    while (first < n && isFree(support[(first + n - 1) % n], support[first])) ++first;
    first %= n;
    std::vector<DirectedPoint> run;
    const auto endRun = [&] {
      if (run.size() > 1) path.segments.emplace_back(splineThrough(run, tolerance_ / 4));
      run.clear();
    };
    for (std::size_t k = 0; k < n; ++k) {
      const Touched &each = support[(first + k) % n], &next = support[(first + k + 1) % n];
      if (each.radius > 0)
        path.segments.emplace_back(Arc2{each.centre, each.radius, each.from, widthOf(support, (first + k) % n)});
      if (isFree(each, next)) {
        if (const DirectedPoint start = directed(each, true); run.empty() || bends(run.back(), start)) {
          endRun();
          run.push_back(start);
        }
        run.push_back(directed(next, false));
        continue;
      }
      endRun();
      const Vec2 from = each.at(next.from), to = next.at(next.from);
      if ((to - from).norm() > point_) path.segments.emplace_back(Line2{from, to});
    }
    endRun();
    return path;
  }

  double tolerance_;
  double point_ = 0;  ///< what is shorter is nothing
  const Progress& progress_;
  std::vector<HullPoint> points_;  ///< then those of their hull
  std::vector<Arc2> arcs_;
  std::vector<double> normals_;  ///< of the samples of splines
};

}  // namespace

Region convexHull(const Region& region, double tolerance, const Progress& progress) {
  if (region.loops.empty()) return {};
  HullBuilder builder(tolerance, progress);
  for (const Path& loop : region.loops) {
    progress.check();
    builder.add(loop);
  }
  Path path = builder.boundary();
  path.layer = region.loops.front().layer;
  path.color = region.loops.front().color;
  return {{std::move(path)}};
}

SoundRegion convexHull(const SoundRegion& shape, const Progress& progress) {
  if (isConvex(shape)) return shape;
  return {convexHull(shape.region, shape.tolerance, progress), shape.tolerance, shape.plain};
}

}  // namespace blossom::planar
