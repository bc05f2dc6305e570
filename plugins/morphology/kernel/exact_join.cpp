#include "kernel/exact_types.h"
// After the header of Nef polyhedra, because other headers undefine its debugging macros.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <queue>
#include <set>

#include "kernel/flatness.h"

namespace blossom::morphology {

namespace {

using Inexact = CGAL::Epick;

struct HalfSpace {
  Vec3 normal;
  double offset = 0;
  [[nodiscard]] double beyond(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// A convex hull in doubles.
struct Hull {
  std::vector<HalfSpace> sides;
  std::vector<std::pair<Vec3, Vec3>> edges;
  double volume = 0;
};

Hull measuredHull(const std::vector<Vec3>& points) {
  std::vector<Inexact::Point_3> doubles;
  doubles.reserve(points.size());
  for (const Vec3& p : points) doubles.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Inexact::Point_3> surface;
  CGAL::convex_hull_3(doubles.begin(), doubles.end(), surface);
  const auto at = [&](auto v) { return Vec3(surface.point(v).x(), surface.point(v).y(), surface.point(v).z()); };
  Hull hull;
  for (const auto e : surface.edges()) hull.edges.emplace_back(at(surface.vertex(e, 0)), at(surface.vertex(e, 1)));
  for (const auto f : surface.faces()) {
    const auto h = surface.halfedge(f);
    const Vec3 a = at(surface.source(h)), b = at(surface.target(h)), c = at(surface.target(surface.next(h)));
    const Vec3 across = (b - a).cross(c - a);
    hull.volume += (a - points.front()).dot(across) / 6;
    if (across.norm() > 0) hull.sides.push_back({across.normalized(), across.normalized().dot(a)});
  }
  return hull;
}

struct Cell {
  Part part;
  std::vector<Vec3> points;
  Bounds bounds;
  Hull hull;
  std::set<std::size_t> near;
  bool gone = false;
};

Cell cellOf(Part part) {
  Cell cell;
  for (const Point& p : part.points) {
    cell.points.push_back(toVec3(p));
    cell.bounds.add(cell.points.back());
  }
  cell.part = std::move(part);
  cell.hull = measuredHull(cell.points);
  return cell;
}

bool meet(const Bounds& a, const Bounds& b, double slack) {
  return ((a.low - b.high).array() <= slack).all() && ((b.low - a.high).array() <= slack).all();
}

bool liesIn(const Vec3& p, const Cell& cell, double slack) {
  return std::all_of(cell.hull.sides.begin(), cell.hull.sides.end(),
                     [&](const HalfSpace& side) { return side.beyond(p) <= slack; });
}

/// The corners of the wall between two cells: those of one that the other has, too.
std::vector<Vec3> wallBetween(const Cell& a, const Cell& b, double slack) {
  std::vector<Vec3> wall;
  for (const Vec3& p : a.points)
    if (liesIn(p, b, slack)) wall.push_back(p);
  for (const Vec3& p : b.points)
    if (liesIn(p, a, slack)) wall.push_back(p);
  return wall;
}

/// The side of `a` that all of the wall lies in and all of `b` lies behind; nullptr when there is none.
const HalfSpace* sideTowards(const Cell& a, const Cell& b, const std::vector<Vec3>& wall, double slack) {
  for (const HalfSpace& side : a.hull.sides) {
    const auto onIt = [&](const Vec3& p) { return std::abs(side.beyond(p)) <= slack; };
    const auto behind = [&](const Vec3& p) { return side.beyond(p) >= -slack; };
    if (std::all_of(wall.begin(), wall.end(), onIt) && std::all_of(b.points.begin(), b.points.end(), behind)) return &side;
  }
  return nullptr;
}

double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

/// Of a point that does not lie within the wall: how far it is from it.
double distanceTo(const std::vector<Vec3>& wall, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < wall.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, distance(p, wall[i], wall[j]));
  return nearest;
}

/// A straight line from one cell to the other crosses the plane of their wall: where it does so within the wall it lies in
/// the cells, elsewhere it leaves them by no more than its distance from the wall there. So the corners of the hull's
/// section with that plane tell how much larger than the cells it is.
bool addsNothing(const Hull& both, const Cell& a, const Cell& b, const HalfSpace& plane, const std::vector<Vec3>& wall,
                 double slack) {
  const auto nearWall = [&](const Vec3& p) { return distanceTo(wall, p) <= slack; };
  for (const auto* points : {&a.points, &b.points})
    for (const Vec3& p : *points)
      if (std::abs(plane.beyond(p)) <= slack && !nearWall(p)) return false;
  for (const auto& [p, q] : both.edges) {
    const double from = plane.beyond(p), to = plane.beyond(q);
    if (std::min(from, to) >= -slack || std::max(from, to) <= slack) continue;
    if (!nearWall(p + from / (from - to) * (q - p))) return false;
  }
  return true;
}

class Joining {
 public:
  Joining(const PartList& list, double size) : slack_(joinedPartsFlatness * size) {
    for (const Part& part : list.parts) cells_.push_back(cellOf(part));
    for (std::size_t i = 0; i < cells_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (meet(cells_[i].bounds, cells_[j].bounds, slack_)) link(i, j);
  }

  /// Joins the pair with the smallest union first: parts grow evenly.
  Parts joined(const Progress& progress) {
    while (!queue_.empty()) {
      progress.check();
      const auto [order, i, j] = queue_.top();
      queue_.pop();
      if (!cells_[i].gone && !cells_[j].gone) join(i, j);
    }
    auto list = std::make_shared<PartList>();
    for (Cell& cell : cells_)
      if (!cell.gone) list->parts.push_back(std::move(cell.part));
    return list;
  }

 private:
  using Candidate = std::tuple<double, std::size_t, std::size_t>;

  void link(std::size_t i, std::size_t j) {
    Cell &a = cells_[i], &b = cells_[j];
    a.near.insert(j);
    b.near.insert(i);
    // Rounding makes cells as thin as itself.
    const auto fitsIn = [this](const Cell& inner, const Cell& outer) {
      return std::all_of(inner.points.begin(), inner.points.end(), [&](const Vec3& p) { return liesIn(p, outer, slack_); });
    };
    if (fitsIn(a, b) || fitsIn(b, a)) {
      queue_.emplace(std::max(a.hull.volume, b.hull.volume), i, j);
      return;
    }
    const std::vector<Vec3> wall = wallBetween(a, b, slack_);
    if (wall.size() < 3) return;
    const HalfSpace* const plane = sideTowards(a, b, wall, slack_);
    if (!plane) return;
    std::vector<Vec3> points = a.points;
    points.insert(points.end(), b.points.begin(), b.points.end());
    const Hull both = measuredHull(points);
    if (addsNothing(both, a, b, *plane, wall, slack_)) queue_.emplace(both.volume, i, j);
  }
  void join(std::size_t i, std::size_t j) {
    Part part;
    std::vector<Point> both = cells_[i].part.points;
    both.insert(both.end(), cells_[j].part.points.begin(), cells_[j].part.points.end());
    // Exact, so that no corner of one is lost to rounding and neighbours still meet.
    const SurfaceMesh hull = hullOf(both);
    part.points.assign(hull.points().begin(), hull.points().end());
    std::set<std::size_t> near = cells_[i].near;
    near.insert(cells_[j].near.begin(), cells_[j].near.end());
    cells_[i].gone = cells_[j].gone = true;
    const std::size_t made = cells_.size();
    cells_.push_back(cellOf(std::move(part)));
    for (const std::size_t other : near)
      if (!cells_[other].gone) link(made, other);
  }

  double slack_;
  std::vector<Cell> cells_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

Parts joinedParts(const Parts& parts, const Progress& progress) {
  Bounds bounds;
  for (const Part& part : parts->parts)
    for (const Point& p : part.points)
      bounds.add(Vec3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  return Joining(*parts, bounds.diagonal()).joined(progress);
}

}  // namespace blossom::morphology
