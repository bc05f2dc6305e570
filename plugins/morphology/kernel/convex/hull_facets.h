#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace blossom::morphology {

/// A convex hull whose corners and triangles are the same for the same points: corners by x, y and z, each facet as a fan of
/// its lowest corner, fans in the order of their corners.
template <class Point>
struct HullFacets {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
};

namespace hull_facets {

/// For each face the lowest number of a face in its plane. @param lieInPlane four points, exactly
template <class Hull, class LieInPlane>
std::vector<std::size_t> facetOfEachFace(const Hull& hull, const LieInPlane& lieInPlane) {
  std::vector<std::size_t> facet(hull.number_of_faces());
  std::iota(facet.begin(), facet.end(), std::size_t{0});
  const auto rootOf = [&](std::size_t f) {
    while (facet[f] != f) f = facet[f] = facet[facet[f]];
    return f;
  };
  for (const auto edge : hull.edges()) {
    const auto h = hull.halfedge(edge), back = hull.opposite(h);
    const std::size_t one = rootOf(hull.face(h)), other = rootOf(hull.face(back));
    if (one == other) continue;
    const auto corner = [&](auto halfedge) { return hull.point(hull.target(halfedge)); };
    if (lieInPlane(corner(back), corner(h), corner(hull.next(h)), corner(hull.next(back))))
      facet[std::max(one, other)] = std::min(one, other);
  }
  for (std::size_t f = 0; f < facet.size(); ++f) facet[f] = rootOf(f);
  return facet;
}

/// The corners of one facet in their order. @param sides of it, each from one corner to the next
inline std::vector<std::size_t> corners(std::vector<std::pair<std::size_t, std::size_t>>& sides) {
  std::sort(sides.begin(), sides.end());
  std::vector<std::size_t> loop{sides.front().first};
  while (loop.size() < sides.size())
    loop.push_back(std::lower_bound(sides.begin(), sides.end(), std::pair{loop.back(), std::size_t{0}})->second);
  return loop;
}

/// @param loop of numbers, -1 where a corner is left out
inline void addFan(std::vector<int> loop, std::vector<std::array<int, 3>>& triangles) {
  std::erase(loop, -1);
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) triangles.push_back({loop[0], loop[k], loop[k + 1]});
}

}  // namespace hull_facets

/// CGAL's hull begins anew at addresses of memory where it goes on: the order of its faces, and how facets of more corners
/// are divided, tell what ran before. Points within facets and edges are left out. O(n log n). @pre the hull has volume
template <class Hull, class LieInPlane>
HullFacets<typename Hull::Point> hullFacets(const Hull& hull, const LieInPlane& lieInPlane) {
  const std::vector<std::size_t> facet = hull_facets::facetOfEachFace(hull, lieInPlane);
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> sides(facet.size());
  std::vector<int> facetsAt(hull.number_of_vertices());
  for (const auto h : hull.halfedges()) {
    const std::size_t own = facet[hull.face(h)];
    if (own == facet[hull.face(hull.opposite(h))]) continue;
    sides[own].emplace_back(hull.source(h), hull.target(h));
    ++facetsAt[hull.source(h)];
  }
  std::vector<typename Hull::Vertex_index> order;
  std::copy_if(hull.vertices().begin(), hull.vertices().end(), std::back_inserter(order),
               [&](auto v) { return facetsAt[v] > 2; });
  std::sort(order.begin(), order.end(), [&](auto v, auto w) { return hull.point(v) < hull.point(w); });
  HullFacets<typename Hull::Point> made;
  std::vector<int> number(facetsAt.size(), -1);
  for (const auto v : order) {
    number[v] = static_cast<int>(made.points.size());
    made.points.push_back(hull.point(v));
  }
  for (auto& each : sides) {
    if (each.empty()) continue;
    std::vector<int> loop;
    for (const std::size_t corner : hull_facets::corners(each)) loop.push_back(number[corner]);
    hull_facets::addFan(std::move(loop), made.triangles);
  }
  std::sort(made.triangles.begin(), made.triangles.end());
  return made;
}

}  // namespace blossom::morphology
