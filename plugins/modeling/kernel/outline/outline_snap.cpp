#include "kernel/outline/outline_snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"

namespace blossom::modeling {
namespace {

using std::numbers::pi;

Vec2 foot(const Guide& guide, const Vec2& p) {
  return guide.origin + (p - guide.origin).dot(guide.direction) * guide.direction;
}

/// Is an angle within the run of an arc?
bool covers(const Arc2& arc, double angle) {
  double turn = std::fmod((angle - arc.start) * (arc.sweep > 0 ? 1 : -1), 2 * pi);
  if (turn < 0) turn += 2 * pi;
  return turn <= std::abs(arc.sweep) + 1e-12;
}

/// Keeps the candidate nearest to the mouse within reach.
class Nearest {
 public:
  explicit Nearest(const SnapQuery& query) : query_(query), distance_(query.reach) {}
  void offer(Snap snap) {
    const double distance = (snap.point - query_.mouse).norm();
    if (distance > distance_) return;
    distance_ = distance;
    best_ = std::move(snap);
  }
  [[nodiscard]] std::optional<Snap> take() { return std::move(best_); }

 private:
  const SnapQuery& query_;
  double distance_;
  std::optional<Snap> best_;
};

std::optional<Snap> pointNear(const SnapScene& scene, const SnapQuery& query, bool start) {
  Nearest nearest(query);
  for (const SnapPoint& point : scene.points)
    if ((point.kind == SnapKind::Start) == start) nearest.offer({point.at, point.kind, {}});
  return nearest.take();
}

/// Feet of perpendiculars from p: one on a line, up to two on an arc.
std::vector<Vec2> feet(const Segment& segment, const Vec2& p) {
  if (const auto* line = std::get_if<Line2>(&segment)) {
    const Vec2 along = line->to - line->from;
    const double t = along.squaredNorm() > 0 ? (p - line->from).dot(along) / along.squaredNorm() : -1;
    if (t < 0 || t > 1) return {};
    return {line->from + t * along};
  }
  const auto* arc = std::get_if<Arc2>(&segment);
  if (!arc || (p - arc->center).norm() == 0) return {};
  std::vector<Vec2> found;
  const Vec2 out = (p - arc->center).normalized();
  for (const Vec2& direction : {out, Vec2(-out)})
    if (covers(*arc, std::atan2(direction.y(), direction.x()))) found.push_back(arc->center + arc->radius * direction);
  return found;
}

std::optional<Snap> footNear(const SnapScene& scene, const SnapQuery& query) {
  if (!query.from) return std::nullopt;
  Nearest nearest(query);
  for (const Segment& curve : scene.curves)
    for (const Vec2& p : feet(curve, *query.from)) {
      if ((p - *query.from).norm() <= query.reach) continue;  // the curve passes the last point itself
      nearest.offer({p, SnapKind::Perpendicular, {{*query.from, (p - *query.from).normalized(), SnapKind::Perpendicular}}});
    }
  return nearest.take();
}

std::optional<Snap> curveNear(const SnapScene& scene, const SnapQuery& query) {
  Nearest nearest(query);
  for (const Segment& curve : scene.curves)
    for (const Vec2& p : feet(curve, query.mouse)) nearest.offer({p, SnapKind::OnCurve, {}});
  return nearest.take();
}

std::vector<Guide> guidesOf(const SnapQuery& query) {
  std::vector<Guide> guides;
  if (query.from) {
    const double h = std::sqrt(0.5);
    // The stronger ones first: of two that coincide the first is named.
    if (query.direction) {
      guides.push_back({*query.from, *query.direction, SnapKind::Tangent});
      guides.push_back({*query.from, {-query.direction->y(), query.direction->x()}, SnapKind::Square});
    }
    guides.push_back({*query.from, {1, 0}, SnapKind::Horizontal});
    guides.push_back({*query.from, {0, 1}, SnapKind::Vertical});
    guides.push_back({*query.from, {h, h}, SnapKind::Diagonal});
    guides.push_back({*query.from, {h, -h}, SnapKind::Diagonal});
  }
  if (query.start && query.start != query.from) {
    guides.push_back({*query.start, {1, 0}, SnapKind::Aligned});
    guides.push_back({*query.start, {0, 1}, SnapKind::Aligned});
  }
  return guides;
}

/// Guides that pass near the mouse, nearest first; one of a bundle of equal ones.
std::vector<Guide> guidesNear(const SnapQuery& query) {
  std::vector<Guide> near;
  for (const Guide& guide : guidesOf(query)) {
    if ((foot(guide, query.mouse) - query.mouse).norm() > query.reach) continue;
    const bool known = std::any_of(near.begin(), near.end(), [&](const Guide& other) {
      return std::abs(cross(guide.direction, other.direction)) < 1e-9 &&
             std::abs(cross(guide.direction, other.origin - guide.origin)) < 1e-9;
    });
    if (!known) near.push_back(guide);
  }
  std::stable_sort(near.begin(), near.end(), [&](const Guide& a, const Guide& b) {
    return (foot(a, query.mouse) - query.mouse).norm() < (foot(b, query.mouse) - query.mouse).norm();
  });
  return near;
}

/// Where guides from different points cross; those from one point cross in it, which is no news.
std::optional<Snap> crossingNear(const std::vector<Guide>& guides, const SnapQuery& query) {
  Nearest nearest(query);
  for (std::size_t i = 0; i < guides.size(); ++i)
    for (std::size_t j = i + 1; j < guides.size(); ++j) {
      const double side = cross(guides[i].direction, guides[j].direction);
      if (std::abs(side) < 1e-6 || guides[i].origin == guides[j].origin) continue;
      const double t = cross(guides[j].origin - guides[i].origin, guides[j].direction) / side;
      nearest.offer({guides[i].origin + t * guides[i].direction, SnapKind::Crossing, {guides[i], guides[j]}});
    }
  return nearest.take();
}

double rounded(double value, double step) { return std::round(value / step) * step; }

/// Horizontal and vertical guides also snap to the grid lines that they cross.
Snap onGuide(const Guide& guide, const SnapQuery& query) {
  Snap snap{foot(guide, query.mouse), guide.kind, {guide}};
  if (!(query.grid > 0)) return snap;
  for (const int axis : {0, 1}) {
    if (guide.direction[1 - axis] != 0) continue;
    const double line = rounded(snap.point[axis], query.grid);
    if (std::abs(line - snap.point[axis]) <= query.reach) snap.point[axis] = line;
  }
  return snap;
}

std::optional<Snap> gridNear(const SnapQuery& query) {
  if (!(query.grid > 0)) return std::nullopt;
  Nearest nearest(query);
  nearest.offer({{rounded(query.mouse.x(), query.grid), rounded(query.mouse.y(), query.grid)}, SnapKind::Grid, {}});
  return nearest.take();
}

}  // namespace

Snap snappedPoint(const SnapScene& scene, const SnapQuery& query) {
  if (const auto start = pointNear(scene, query, true)) return *start;
  if (const auto point = pointNear(scene, query, false)) return *point;
  if (const auto perpendicular = footNear(scene, query)) return *perpendicular;
  const std::vector<Guide> guides = guidesNear(query);
  if (const auto crossing = crossingNear(guides, query)) return *crossing;
  if (!guides.empty()) return onGuide(guides.front(), query);
  if (const auto curve = curveNear(scene, query)) return *curve;
  if (const auto grid = gridNear(query)) return *grid;
  return {query.mouse, SnapKind::None, {}};
}

void addToScene(SnapScene& scene, const Path& path) {
  const auto add = [&](const Vec2& p, SnapKind kind) { scene.points.push_back({p, kind}); };
  for (const Segment& segment : path.segments) {
    const auto* arc = std::get_if<Arc2>(&segment);
    const bool whole = arc && std::abs(std::abs(arc->sweep) - 2 * pi) < 1e-9;
    add(startPoint(segment), SnapKind::Point);
    if (!path.closed && &segment == &path.segments.back()) add(endPoint(segment), SnapKind::Point);
    if (const auto* line = std::get_if<Line2>(&segment)) add((line->from + line->to) / 2, SnapKind::Midpoint);
    if (arc) {
      const auto at = [&](double angle) { return Vec2(arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle))); };
      add(arc->center, SnapKind::Centre);
      if (!whole) add(at(arc->start + arc->sweep / 2), SnapKind::Midpoint);
      for (int quarter = 1; whole && quarter < 4; ++quarter) add(at(arc->start + quarter * pi / 2), SnapKind::Point);
    }
    if (!std::holds_alternative<Spline2>(segment)) scene.curves.push_back(segment);
  }
}

}  // namespace blossom::modeling
