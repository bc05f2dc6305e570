#include "kernel/medial/medial.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "kernel/medial/disc_proof.h"
#include "kernel/medial/medial_prune.h"

namespace blossom::pocket {

namespace {

double reachOf(const Boundary& boundary) { return 200 * boundary.chord(); }

std::vector<Contact> contactsAround(const Boundary& boundary, const Diagram& diagram, std::size_t vertex,
                                    const std::vector<std::size_t>& halves) {
  const VoronoiGraph& graph = diagram.graph();
  std::vector<Contact> contacts;
  for (const std::size_t h : halves)
    contacts.push_back(contactOf(boundary, graph.cells[graph.edges[h].cell], graph.vertices[vertex]));
  return contacts;
}

/// Keeps the points that a polyline needs to stay within `tolerance` of the one given (Douglas & Peucker 1973).
void thin(const std::vector<Vec3>& points, std::size_t from, std::size_t to, double tolerance, std::vector<bool>& keep) {
  double worst = tolerance;
  std::size_t where = from;
  const Vec3 along = points[to] - points[from];
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share =
        along.squaredNorm() > 0 ? std::clamp((points[i] - points[from]).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
    const double away = (points[from] + share * along - points[i]).norm();
    if (away > worst) {
      worst = away;
      where = i;
    }
  }
  if (where == from) return;
  keep[where] = true;
  thin(points, from, where, tolerance, keep);
  thin(points, where, to, tolerance, keep);
}

std::vector<Vec3> thinned(const std::vector<Vec3>& points, double tolerance) {
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  // A closed chain has no chord: keep its middle first.
  const std::size_t middle = points.size() / 2;
  keep[middle] = true;
  thin(points, 0, middle, tolerance, keep);
  thin(points, middle, points.size() - 1, tolerance, keep);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i]) out.push_back(points[i]);
  return out;
}

class AxisMaker {
 public:
  AxisMaker(const Boundary& boundary, const Diagram& diagram, double tolerance, const Progress& progress)
      : boundary_(boundary),
        diagram_(diagram),
        graph_(diagram.graph()),
        tolerance_(tolerance),
        progress_(progress),
        kept_(keptEdges(boundary, diagram, tolerance, progress)),
        around_(graph_.vertices.size()),
        node_(graph_.vertices.size(), none) {
    for (std::size_t h = 0; h < graph_.edges.size(); ++h)
      if (graph_.edges[h].origin != atInfinity) around_[graph_.edges[h].origin].push_back(h);
  }

  MedialAxis make() {
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
      if (kept_.degree[v] > 0 && kept_.degree[v] != 2) takeNode(v);
    for (const std::size_t v : kept_.lonely) lonely(v);
    walked_.assign(kept_.edge.size(), false);
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
      if (node_[v] != none) walkFrom(v);
    for (std::size_t e = 0; e < kept_.edge.size(); ++e) {
      if (!kept_.edge[e] || walked_[e]) continue;  // a closed chain: any vertex of it will do
      const std::size_t v = graph_.edges[2 * e].origin;
      takeNode(v);
      walkFrom(v);
    }
    for (const std::size_t tip : kept_.tips) addLeaf(tip);
    joinNeighbours();
    certify();
    return std::move(axis_);
  }

 private:
  static constexpr std::size_t none = atInfinity;

  void takeNode(std::size_t v) {
    Disc disc{graph_.vertices[v], diagram_.clearance(v)};
    if (disc.radius > 0) disc = exactDisc(v, disc);
    node_[v] = axis_.vertices.size();
    axis_.vertices.push_back({disc.center, disc.radius, false});
  }

  [[nodiscard]] Disc exactDisc(std::size_t v, const Disc& rough) const {
    if (kept_.degree[v] != 2)
      if (const auto exact = discTouching(contactsAround(boundary_, diagram_, v, around_[v]), rough, reachOf(boundary_)))
        return *exact;
    for (const std::size_t h : around_[v]) {
      if (!kept_.edge[h / 2]) continue;
      const Vec3 point = onTrueBisector(h, {rough.center.x(), rough.center.y(), rough.radius});
      return {point.head<2>(), point.z()};
    }
    return rough;
  }

  void lonely(std::size_t v) {
    const Disc disc = trueDisc(boundary_, diagram_, v);
    axis_.vertices.push_back({disc.center, disc.radius, false});
  }

  [[nodiscard]] Vec3 pointOf(std::size_t node) const {
    const MedialVertex& v = axis_.vertices[node];
    return {v.at.x(), v.at.y(), v.clearance};
  }

  [[nodiscard]] Vec3 onTrueBisector(std::size_t h, const Vec3& rough) const {
    if (rough.z() <= 0) return rough;
    const Vec2 at = rough.head<2>();
    Contact a = contactOf(boundary_, graph_.cells[graph_.edges[h].cell], at);
    const Contact b = contactOf(boundary_, graph_.cells[graph_.edges[h ^ 1].cell], at);
    const auto exact = pointBetween(a, b, at, reachOf(boundary_));
    if (!exact) return rough;
    return {exact->x(), exact->y(), (*exact - footOn(a, *exact)).norm()};
  }

  void walkFrom(std::size_t v) {
    for (const std::size_t start : around_[v]) {
      if (!kept_.edge[start / 2] || walked_[start / 2]) continue;
      progress_.check();
      std::vector<Vec3> points{pointOf(node_[v])};
      std::size_t h = start;
      while (true) {
        walked_[h / 2] = true;
        const std::vector<Vec3> edge = diagram_.polyline(h, tolerance_ / 8);
        for (std::size_t i = 1; i < edge.size(); ++i) points.push_back(onTrueBisector(h, edge[i]));
        const std::size_t end = graph_.target(h);
        if (node_[end] != none) {
          points.back() = pointOf(node_[end]);
          axis_.edges.push_back({node_[v], node_[end], thinned(points, tolerance_ / 8)});
          break;
        }
        h = *std::find_if(around_[end].begin(), around_[end].end(),
                          [&](std::size_t next) { return kept_.edge[next / 2] && next / 2 != h / 2; });
      }
    }
  }

  void addLeaf(std::size_t tip) {
    const auto leaf = leafBeyond(boundary_, diagram_, tip);
    const std::size_t from = node_[graph_.edges[tip].origin];
    if (!leaf || from == none) return;
    if ((leaf->center - axis_.vertices[from].at).norm() < boundary_.weld()) {
      axis_.vertices[from].at = leaf->center;
      axis_.vertices[from].clearance = leaf->radius;
      return;
    }
    axis_.vertices.push_back({leaf->center, leaf->radius, false});
    axis_.edges.push_back({from, axis_.vertices.size() - 1, {pointOf(from), pointOf(axis_.vertices.size() - 1)}});
  }

  /// Vertices that only rounding or the flattening keeps apart become one; a vertex where a leaf was added and nothing
  /// branches is none.
  void joinNeighbours() {
    const double apart = tolerance_ / 10;
    std::vector<std::size_t> same(axis_.vertices.size());
    for (std::size_t i = 0; i < same.size(); ++i) same[i] = i;
    const auto root = [&](std::size_t i) {
      while (same[i] != i) i = same[i] = same[same[i]];
      return i;
    };
    std::vector<MedialEdge> edges;
    for (MedialEdge& edge : axis_.edges) {
      const bool corner = axis_.vertices[edge.from].clearance == 0 || axis_.vertices[edge.to].clearance == 0;
      double length = 0;
      for (std::size_t i = 1; i < edge.points.size(); ++i) length += (edge.points[i] - edge.points[i - 1]).head<2>().norm();
      if (length < apart && !corner && edge.from != edge.to)
        same[root(edge.from)] = root(edge.to);
      else
        edges.push_back(std::move(edge));
    }
    for (MedialEdge& edge : edges) {
      edge.from = root(edge.from);
      edge.to = root(edge.to);
      edge.points.front() = pointOf(edge.from);
      edge.points.back() = pointOf(edge.to);
    }
    std::vector<bool> used(same.size(), false);
    for (std::size_t i = 0; i < same.size(); ++i) used[root(i)] = true;
    axis_.edges = std::move(edges);
    joinLeaves(used);
    renumber(used);
  }

  /// The straight piece up to a leaf continues the chain it was added to.
  void joinLeaves(std::vector<bool>& used) {
    std::vector<std::vector<std::size_t>> at(axis_.vertices.size());
    for (std::size_t e = 0; e < axis_.edges.size(); ++e) {
      at[axis_.edges[e].from].push_back(e);
      at[axis_.edges[e].to].push_back(e);
    }
    std::vector<bool> gone(axis_.edges.size(), false);
    for (std::size_t v = 0; v < at.size(); ++v) {
      if (at[v].size() != 2 || at[v][0] == at[v][1]) continue;
      MedialEdge& keep = axis_.edges[at[v][0]];
      MedialEdge& drop = axis_.edges[at[v][1]];
      const std::size_t far = drop.from == v ? drop.to : drop.from;
      if (keep.from == keep.to || far == v || keep.from == far || keep.to == far) continue;
      std::vector<Vec3> more = drop.points;
      if (drop.from != v) std::reverse(more.begin(), more.end());
      if (keep.to != v) {
        std::reverse(keep.points.begin(), keep.points.end());
        std::swap(keep.from, keep.to);
      }
      keep.points.insert(keep.points.end(), more.begin() + 1, more.end());
      keep.to = far;
      std::replace(at[far].begin(), at[far].end(), at[v][1], at[v][0]);
      gone[at[v][1]] = true;
      used[v] = false;
    }
    std::vector<MedialEdge> edges;
    for (std::size_t e = 0; e < axis_.edges.size(); ++e)
      if (!gone[e]) edges.push_back(std::move(axis_.edges[e]));
    axis_.edges = std::move(edges);
  }

  void renumber(const std::vector<bool>& used) {
    std::vector<std::size_t> number(used.size(), none);
    std::vector<MedialVertex> vertices;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      number[i] = vertices.size();
      vertices.push_back(axis_.vertices[i]);
    }
    axis_.vertices = std::move(vertices);
    for (MedialEdge& edge : axis_.edges) {
      edge.from = number[edge.from];
      edge.to = number[edge.to];
    }
  }

  /// A vertex is certified when its disc touches the boundary and is proved to contain no point of the curves as drawn.
  void certify() {
    const DiscProof proof(boundary_.region(), tolerance_ / 8, progress_);
    for (MedialVertex& vertex : axis_.vertices) {
      progress_.check();
      vertex.certified = std::abs(boundary_.nearest(vertex.at).distance - vertex.clearance) <= tolerance_ / 2 &&
                         proof.isClear(vertex.at, vertex.clearance - tolerance_ / 2);
    }
  }

  const Boundary& boundary_;
  const Diagram& diagram_;
  const VoronoiGraph& graph_;
  double tolerance_;
  const Progress& progress_;
  KeptEdges kept_;
  std::vector<std::vector<std::size_t>> around_;  ///< by vertex: the half-edges that leave it
  std::vector<std::size_t> node_;                 ///< by vertex: its number in the axis
  std::vector<bool> walked_;
  MedialAxis axis_;
};

}  // namespace

Disc trueDisc(const Boundary& boundary, const Diagram& diagram, std::size_t vertex) {
  const VoronoiGraph& graph = diagram.graph();
  const Disc rough{graph.vertices[vertex], diagram.clearance(vertex)};
  Disc best{rough.center, boundary.nearest(rough.center).distance};
  const auto consider = [&](const Vec2& center) {
    const double radius = boundary.nearest(center).distance;
    if (radius > best.radius) best = {center, radius};
  };
  std::vector<std::size_t> halves;
  for (std::size_t h = 0; h < graph.edges.size(); ++h)
    if (graph.edges[h].origin == vertex) halves.push_back(h);
  const double reach = reachOf(boundary);
  const std::vector<Contact> contacts = contactsAround(boundary, diagram, vertex, halves);
  for (const Contact& contact : contacts)
    if (const Arc2* arc = contact.curve ? contact.curve->arc() : nullptr; arc && (arc->center - rough.center).norm() < reach)
      consider(arc->center);
  if (const auto exact = discTouching(contacts, rough, reach)) consider(exact->center);
  for (std::size_t i = 0; i < std::min<std::size_t>(contacts.size(), 8); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const auto exact = pointBetween(contacts[i], contacts[k], rough.center, reach)) consider(*exact);
  return best;
}

MedialAxis medialAxis(const Boundary& boundary, const Diagram& diagram, double tolerance, const Progress& progress) {
  return AxisMaker(boundary, diagram, tolerance, progress).make();
}

}  // namespace blossom::pocket
