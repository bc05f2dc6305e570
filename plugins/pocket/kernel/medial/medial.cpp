#include "kernel/medial/medial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/medial/disc_proof.h"
#include "kernel/medial/medial_chains.h"
#include "kernel/medial/medial_feet.h"
#include "kernel/medial/medial_prune.h"

namespace blossom::pocket {

namespace {

double reachOf(const Boundary& boundary) { return 200 * boundary.chord(); }

std::vector<Contact> contactsAround(const Boundary& boundary, const Diagram& diagram, std::size_t vertex,
                                    const std::vector<std::size_t>& halves) {
  const VoronoiGraph& graph = diagram.graph();
  std::vector<Contact> contacts;
  contacts.reserve(halves.size());
  for (const std::size_t h : halves)
    contacts.push_back(contactOf(boundary, graph.cells[graph.edges[h].cell], graph.vertices[vertex]));
  return contacts;
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
    joinNeighbours(axis_.vertices, chains_, tolerance_ / 10);
    for (Chain& chain : chains_) addEdge(chain);
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
      Chain chain{node_[v], none, {pointOf(node_[v])}, {touchedBy(start)}};
      std::size_t h = start;
      while (true) {
        walked_[h / 2] = true;
        const std::vector<Vec3> edge = diagram_.polyline(h, tolerance_ / 8);
        for (std::size_t i = 1; i < edge.size(); ++i) chain.points.push_back(onTrueBisector(h, edge[i]));
        chain.touched.resize(chain.points.size(), touchedBy(h));
        const std::size_t end = graph_.target(h);
        if (node_[end] != none) {
          chain.to = node_[end];
          chain.points.back() = pointOf(chain.to);
          thin(chain, tolerance_ / 8);
          chains_.push_back(std::move(chain));
          break;
        }
        h = *std::find_if(around_[end].begin(), around_[end].end(),
                          [&](std::size_t next) { return kept_.edge[next / 2] && next / 2 != h / 2; });
      }
    }
  }

  [[nodiscard]] Touched touchedBy(std::size_t h) const {
    return {graph_.cells[graph_.edges[h].cell], graph_.cells[graph_.edges[h ^ 1].cell], {}};
  }

  void addLeaf(std::size_t tip) {
    const auto leaf = leafBeyond(boundary_, diagram_, tip);
    const std::size_t from = node_[graph_.edges[tip].origin];
    if (!leaf || from == none) return;
    const Disc& disc = leaf->disc;
    if ((disc.center - axis_.vertices[from].at).norm() < boundary_.weld()) {
      axis_.vertices[from].at = disc.center;
      axis_.vertices[from].clearance = disc.radius;
      return;
    }
    axis_.vertices.push_back({disc.center, disc.radius, false});
    const std::size_t to = axis_.vertices.size() - 1;
    Touched end = touchedBy(tip);
    end.leaf = footAt(boundary_, leaf->curve, leaf->parameter);
    chains_.push_back({from, to, {pointOf(from), pointOf(to)}, {touchedBy(tip), end}});
  }

  [[nodiscard]] MedialFeet feetOf(const Touched& touched, const Vec3& point) const {
    if (touched.leaf) return {*touched.leaf, *touched.leaf};
    return {footOf(boundary_, touched.left, point.head<2>()), footOf(boundary_, touched.right, point.head<2>())};
  }

  void addEdge(Chain& chain) {
    progress_.check();
    MedialEdge edge{chain.from, chain.to, std::move(chain.points), {}};
    edge.feet.reserve(edge.points.size());
    for (std::size_t i = 0; i < edge.points.size(); ++i) edge.feet.push_back(feetOf(chain.touched[i], edge.points[i]));
    axis_.edges.push_back(std::move(edge));
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
  std::vector<Chain> chains_;
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
