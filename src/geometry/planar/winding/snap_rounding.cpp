#include "geometry/planar/winding/snap_rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/winding/wide_products.h"
#include "geometry/planar/winding/winding_faces.h"

namespace blossom::planar {
namespace {

/// An edge is bent through vertices that are nearer to it, in units: up to half the diagonal of a cell. Through vertices at
/// nearly 1 on either side it would be bent to and fro.
constexpr double pixel = 0.7071;

Vec2 asVec(const GridPoint& p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

Box2 boxOf(const GridPoint& a, const GridPoint& b) {
  return {asVec({std::min(a.x, b.x), std::min(a.y, b.y)}), asVec({std::max(a.x, b.x), std::max(a.y, b.y)})};
}

double distance(const GridPoint& p, const GridPoint& a, const GridPoint& b) {
  const Vec2 along = asVec(b - a), to = asVec(p - a);
  const double t = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
  // Off the line by the exact cross product: the difference of two long vectors would lose it.
  if (t > 0 && t < 1) return std::abs(static_cast<double>(cross(b - a, p - a))) / along.norm();
  return asVec(t == 0 ? p - a : p - b).norm();
}

/// Whether f lies on one side of the line of e, farther than some units from it. May be false where it does.
bool liesAside(const CountedEdge& e, const CountedEdge& f, double units) {
  const Vec2 along = asVec(e.to - e.from), from = asVec(f.from - e.from), to = asVec(f.to - e.from);
  constexpr double rounding = 1e-14;  // of the products
  const double reach = from.lpNorm<1>() + to.lpNorm<1>();
  const double least = (units + rounding * reach) * along.lpNorm<1>();
  const double first = cross(along, from), last = cross(along, to);
  return (first > least && last > least) || (first < -least && last < -least);
}

bool crossing(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  return signOf(cross(b - a, c - a)) * signOf(cross(b - a, d - a)) < 0 &&
         signOf(cross(d - c, a - c)) * signOf(cross(d - c, b - c)) < 0;
}

/// The end beyond which a point lies, seen along a segment.
std::optional<GridPoint> endBefore(const GridPoint& p, const GridPoint& from, const GridPoint& to) {
  if (dot(p - from, to - from) <= 0) return from;
  if (dot(p - to, from - to) <= 0) return to;
  return std::nullopt;
}

/// Beside an end it is that end: cut there, the segment would go back to what it is cut at, and so on for ever. The end lies
/// no farther from the crossing, and the other segment passes it.
GridPoint crossingPoint(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const double t = static_cast<double>(cross(c - a, d - c)) / static_cast<double>(cross(b - a, d - c));
  const Vec2 off = t * asVec(b - a);
  const GridPoint p = a + GridPoint{std::llround(off.x()), std::llround(off.y())};
  if (const auto end = endBefore(p, a, b)) return *end;
  return endBefore(p, c, d).value_or(p);
}

std::vector<Box2> boxesOf(const std::vector<CountedEdge>& edges) {
  std::vector<Box2> boxes;
  boxes.reserve(edges.size());
  for (const CountedEdge& edge : edges) boxes.push_back(boxOf(edge.from, edge.to));
  return boxes;
}

/// One round: every edge cut where a vertex or a crossing lies on it. Whether there was anything to cut.
bool cutOnce(std::vector<CountedEdge>& edges, const Progress& progress) {
  std::vector<std::vector<GridPoint>> cuts(edges.size());
  bool any = false;
  const auto add = [&](std::size_t edge, const GridPoint& p) {
    if (p == edges[edge].from || p == edges[edge].to) return false;
    cuts[edge].push_back(p);
    return any = true;
  };
  const auto addNear = [&](std::size_t edge, const GridPoint& p) {
    return distance(p, edges[edge].from, edges[edge].to) < pixel && add(edge, p);
  };
  forEachNearPair<2>(boxesOf(edges), pixel, progress, [&](std::size_t i, std::size_t j) {
    const CountedEdge &e = edges[i], &f = edges[j];
    const int bent = addNear(i, f.from) + addNear(i, f.to) + addNear(j, e.from) + addNear(j, e.to);
    // Edges that are bent through each other's ends need not cross any more; a crossing of flat ones may lie far off.
    if (bent == 0 && crossing(e.from, e.to, f.from, f.to)) {
      const GridPoint p = crossingPoint(e.from, e.to, f.from, f.to);
      add(i, p), add(j, p);
    }
    return true;
  });
  if (!any) return false;
  std::vector<CountedEdge> pieces;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const GridPoint along = edges[i].to - edges[i].from;
    std::vector<GridPoint>& points = cuts[i];
    std::sort(points.begin(), points.end(), [&](const GridPoint& a, const GridPoint& b) {
      const Wide s = dot(a, along), t = dot(b, along);
      return s != t ? s < t : a < b;
    });
    // Of two corners beside one place, one on either side, the edge passes one: from one to the other it would run along the
    // other diagonal of their cell, which is bent back, and so on for ever.
    const auto atOnePlace = [&](const GridPoint& a, const GridPoint& b) { return dot(a, along) == dot(b, along); };
    points.erase(std::unique(points.begin(), points.end(), atOnePlace), points.end());
    GridPoint from = edges[i].from;
    points.push_back(edges[i].to);
    for (const GridPoint& to : points) {
      if (from != to) pieces.push_back({from, to, edges[i].count});
      from = to;
    }
  }
  joinEqual(pieces, progress);
  edges = std::move(pieces);
  return true;
}

/// Each loop's own edges, in its direction.
void addEdges(const GridLoop& loop, std::vector<CountedEdge>& edges) {
  for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()], 1});
}

std::vector<CountedEdge> loopEdges(const std::vector<GridPolygon>& polygons) {
  std::vector<CountedEdge> edges;
  for (const GridPolygon& polygon : polygons) {
    addEdges(polygon.outer, edges);
    for (const GridLoop& hole : polygon.holes) addEdges(hole, edges);
  }
  return edges;
}

GridLoop onGrid(const Loop& loop) {
  GridLoop result;
  result.reserve(loop.size());
  for (const Vec2& p : loop) result.push_back({std::llround(p.x()), std::llround(p.y())});
  return cleaned(result);
}

std::vector<GridPolygon> onGrid(const Polygons& polygons) {
  std::vector<GridPolygon> result;
  for (const Polygon& polygon : polygons) {
    GridPolygon image{onGrid(polygon.outer), {}};
    if (image.outer.empty()) continue;
    for (const Loop& hole : polygon.holes)
      if (GridLoop loop = onGrid(hole); !loop.empty()) image.holes.push_back(std::move(loop));
    result.push_back(std::move(image));
  }
  return result;
}

/// Whether two edges come nearer to each other than some units only in one common end, and only where the condition allows
/// it.
template <class Condition>
bool meetOnlyWhere(Condition mayMeet, const std::vector<CountedEdge>& edges, const Progress& progress, double clearance) {
  bool clear = true;
  forEachNearPair<2>(boxesOf(edges), clearance, progress, [&](std::size_t i, std::size_t j) {
    const CountedEdge &e = edges[i], &f = edges[j];
    const auto near = [&](const GridPoint& p, const CountedEdge& edge) {
      return distance(p, edge.from, edge.to) < clearance;
    };
    if (liesAside(e, f, clearance) || liesAside(f, e, clearance)) return true;
    // A common end is one end of each that is near the other edge; any other coincidence needs a look.
    const int ends = int{near(e.from, f)} + int{near(e.to, f)} + int{near(f.from, e)} + int{near(f.to, e)};
    clear = ends == (mayMeet(e, f) ? 2 : 0) && !crossing(e.from, e.to, f.from, f.to);
    return clear;
  });
  return clear;
}

/// How often loops pass the same corner at most.
std::size_t mostPasses(const std::vector<CountedEdge>& loops) {
  std::vector<GridPoint> corners;
  corners.reserve(loops.size());
  for (const CountedEdge& edge : loops) corners.push_back(edge.from);
  std::sort(corners.begin(), corners.end());
  std::size_t most = 0;
  for (auto p = corners.begin(); p != corners.end();) {
    const auto next = std::upper_bound(p, corners.end(), *p);
    most = std::max(most, static_cast<std::size_t>(next - p));
    p = next;
  }
  return most;
}

}  // namespace

std::vector<CountedEdge> snapRounded(std::vector<CountedEdge> edges, const Progress& progress) {
  // Each round but the last bends an edge through another vertex.
  for (std::size_t rounds = edges.size() + 100; rounds > 0; --rounds)
    if (!cutOnce(edges, progress)) return edges;
  throw Error(ErrorCode::Internal, "Rounding the shapes of a sum does not come to an end.",
              "Please report this with the shapes.");
}

std::vector<CountedEdge> edgesOf(const std::vector<GridPolygon>& polygons) {
  std::vector<CountedEdge> edges = loopEdges(polygons);
  joinEqual(edges);
  return edges;
}

bool isClear(const std::vector<GridPolygon>& polygons, const Progress& progress, double clearance) {
  const auto chained = [](const CountedEdge& e, const CountedEdge& f) { return e.to == f.from || e.from == f.to; };
  return meetOnlyWhere(chained, loopEdges(polygons), progress, clearance);
}

bool touchesInCorners(const std::vector<GridPolygon>& polygons, const Progress& progress, double clearance) {
  const auto haveCorner = [](const CountedEdge& e, const CountedEdge& f) {
    return e.to == f.from || e.from == f.to || e.from == f.from || e.to == f.to;
  };
  const std::vector<CountedEdge> edges = loopEdges(polygons);
  return mostPasses(edges) <= 2 && meetOnlyWhere(haveCorner, edges, progress, clearance) &&
         !misplacedFace(edgesOf(polygons), 0, progress);
}

std::vector<GridPolygon> untangled(std::vector<GridPolygon> polygons, const Progress& progress) {
  if (isClear(polygons, progress)) return polygons;
  // What was turned inside out (-1) stays a part. The corners of the faces are vertices of the rounded edges, so nothing is
  // rounded any more.
  return onGrid(windingFaces(snapRounded(edgesOf(polygons), progress), progress, Inside::NonZero));
}

}  // namespace blossom::planar
