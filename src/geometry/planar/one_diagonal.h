#pragma once
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/progress.h"

namespace blossom {

/// Of corners that lie on one circle there are several constrained Delaunay triangulations, and CGAL takes one by the
/// addresses of its faces: this takes the one whose diagonals begin at the lowest corner, by x and then y, whatever the
/// addresses are. Each flip moves a diagonal to a lower corner, so that it ends. O(n) and the flips.
/// @throws Error Cancelled.
template <class Triangulation>
void takeDiagonalsFromTheLowest(Triangulation& triangulation, const Progress& progress = Progress::none()) {
  const auto isLower = [&](auto a, auto b) {
    return triangulation.geom_traits().compare_x_2_object()(a->point(), b->point()) != CGAL::EQUAL
               ? triangulation.geom_traits().less_x_2_object()(a->point(), b->point())
               : triangulation.geom_traits().less_y_2_object()(a->point(), b->point());
  };
  const auto isToFlip = [&](auto edge) {
    const auto [face, k] = edge;
    if (triangulation.is_constrained(edge)) return false;
    const auto beyond = face->neighbor(k);
    if (triangulation.is_infinite(face) || triangulation.is_infinite(beyond)) return false;
    const auto apex = face->vertex(k), opposite = triangulation.tds().mirror_vertex(face, k);
    const auto from = face->vertex(triangulation.cw(k)), to = face->vertex(triangulation.ccw(k));
    const auto lower = isLower(apex, opposite) ? apex : opposite;
    return isLower(lower, from) && isLower(lower, to) &&
           triangulation.side_of_oriented_circle(face, opposite->point()) == CGAL::ON_ORIENTED_BOUNDARY;
  };
  if (triangulation.dimension() < 2) return;
  std::vector<typename Triangulation::Face_handle> open;
  std::size_t looked = 0;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    open.assign(1, face);
    while (!open.empty()) {
      if (++looked % 4096 == 0) progress.check();
      auto handle = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        if (!isToFlip(typename Triangulation::Edge(handle, k))) continue;
        const auto beyond = handle->neighbor(k);
        triangulation.flip(handle, k);
        open.push_back(beyond);
        open.push_back(handle);
        break;
      }
    }
  }
}

/// Each begins at its lowest corner, and they are sorted: their order, too, comes from addresses.
inline void sortTriangles(std::vector<std::array<int, 3>>& triangles) {
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
}

}  // namespace blossom
