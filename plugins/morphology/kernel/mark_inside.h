#pragma once
#include <vector>

namespace blossom::morphology {

/// Writes into every triangle of a constrained triangulation, as its `info()`, how many constraints lie between it and the
/// outside, modulo two: 1 is inside. O(triangles). CGAL 5.5 of Debian 12 has no
/// `mark_domain_in_triangulation` yet.
template <class Triangulation>
void markInside(Triangulation& triangulation) {
  using Face = typename Triangulation::Face_handle;
  for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = -1;
  std::vector<Face> open{triangulation.infinite_face()};
  triangulation.infinite_face()->info() = 0;
  while (!open.empty()) {
    const Face face = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Face next = face->neighbor(k);
      if (next->info() >= 0) continue;
      next->info() = triangulation.is_constrained({face, k}) ? 1 - face->info() : face->info();
      open.push_back(next);
    }
  }
}

}  // namespace blossom::morphology
