#include "kernel/touching.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"

namespace blossom::morphology {

namespace {

std::size_t numbered(int index) { return static_cast<std::size_t>(index); }

/// The faces around each of the given vertices.
using FacesAt = std::map<int, std::vector<std::size_t>>;

FacesAt facesAt(const Mesh& shell, const std::vector<int>& vertices) {
  FacesAt faces;
  for (const int v : vertices) faces[v];
  for (std::size_t f = 0; f < shell.faceCount(); ++f)
    for (const int v : shell.face(f))
      if (const auto found = faces.find(v); found != faces.end()) found->second.push_back(f);
  return faces;
}

/// The two other corners, in the face's order.
std::array<int, 2> othersOf(const Mesh& shell, std::size_t face, int vertex) {
  const auto corners = shell.face(face);
  const auto at = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
  return {corners[numbered(static_cast<int>((at + 1) % 3))], corners[numbered(static_cast<int>((at + 2) % 3))]};
}

/// Into the solid, as long as the shortest edge at the vertex.
Vec3 inwards(const Mesh& shell, const std::vector<std::size_t>& faces, int vertex) {
  const Vec3& here = shell.points[numbered(vertex)];
  Vec3 sum = Vec3::Zero();
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::size_t face : faces) {
    const auto [q, r] = othersOf(shell, face, vertex);
    const Vec3 a = shell.points[numbered(q)] - here, b = shell.points[numbered(r)] - here;
    const Vec3 across = a.cross(b);
    sum -= std::atan2(across.norm(), a.dot(b)) * across.normalized();
    shortest = std::min({shortest, a.norm(), b.norm()});
  }
  const double length = sum.norm();
  return length > 1e-9 ? Vec3(sum * (shortest / length)) : Vec3(Vec3::UnitX() * shortest);
}

/// Away from what the faces touch: into the solid where it lies between them, and into the space between them where that is
/// a hollow, whose neighbour lies in the solid.
Vec3 away(const Mesh& shell, const std::vector<std::size_t>& faces, int vertex) {
  const Vec3 inside = inwards(shell, faces, vertex);
  Vec3 edges = Vec3::Zero();
  for (const std::size_t face : faces)
    for (const int other : othersOf(shell, face, vertex))
      edges += (shell.points[numbered(other)] - shell.points[numbered(vertex)]).normalized();
  return edges.dot(inside) < 0 ? Vec3(-inside) : inside;
}

/// Smaller from try to try, and after the first in other directions, the same ones each time.
Mesh moved(const Mesh& shell, const std::map<int, Vec3>& directions, int attempt) {
  std::mt19937_64 random(static_cast<std::uint64_t>(attempt));
  std::uniform_real_distribution<double> aside(-1, 1);
  const double reach = std::ldexp(1, -4 - attempt / 3);
  Mesh result = shell;
  for (const auto& [vertex, direction] : directions) {
    const Vec3 turn(aside(random), aside(random), aside(random));
    const Vec3 step = attempt == 0 ? direction : Vec3(direction + 0.7 * direction.norm() * turn);
    result.points[numbered(vertex)] += reach * step;
  }
  return result;
}

/// Moves one vertex after the other to its new position, together with its faces.
std::vector<std::array<Vec3, 4>> swept(const Mesh& from, const Mesh& to, const FacesAt& faces) {
  std::vector<std::array<Vec3, 4>> tetrahedra;
  std::vector<Vec3> places = from.points;
  for (const auto& [vertex, around] : faces) {
    const Vec3 &before = from.points[numbered(vertex)], &after = to.points[numbered(vertex)];
    for (const std::size_t face : around) {
      const auto [q, r] = othersOf(from, face, vertex);
      tetrahedra.push_back({after, before, places[numbered(q)], places[numbered(r)]});
    }
    places[numbered(vertex)] = after;
  }
  return tetrahedra;
}

}  // namespace

std::vector<int> touchingVertices(const Mesh& shell) {
  std::vector<bool> used(shell.points.size(), false);
  for (const int v : shell.faceVertices) used[numbered(v)] = true;
  std::map<std::array<double, 3>, int> first;
  std::vector<int> touching;
  for (std::size_t v = 0; v < shell.points.size(); ++v) {
    const Vec3& p = shell.points[v];
    if (used[v] && !first.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, static_cast<int>(v)).second)
      touching.push_back(static_cast<int>(v));
  }
  return touching;
}

std::optional<PulledApart> pulledApart(const Mesh& shell, const Progress& progress) {
  constexpr int attempts = 60;
  const FacesAt faces = facesAt(shell, touchingVertices(shell));
  // Where more than two parts touch in a corner, neither way suits all of its vertices for sure: both are tried in turn.
  std::map<int, Vec3> inside, apartFromHollows;
  for (const auto& [vertex, around] : faces) {
    inside[vertex] = inwards(shell, around, vertex);
    apartFromHollows[vertex] = away(shell, around, vertex);
  }
  for (int attempt = 0; attempt < 2 * attempts; ++attempt) {
    Mesh apart = moved(shell, attempt % 2 == 0 ? inside : apartFromHollows, attempt / 2);
    if (!touchingVertices(apart).empty() || firstCrossing(apart, progress)) continue;
    auto between = swept(shell, apart, faces);
    return PulledApart{std::move(apart), std::move(between)};
  }
  return std::nullopt;
}

}  // namespace blossom::morphology
