#include "geometry/planar/medial_axis.h"

namespace blossom {

double lengthOf(const MedialAxis& axis) {
  double sum = 0;
  for (const MedialEdge& edge : axis.edges)
    for (std::size_t i = 1; i < edge.points.size(); ++i)
      sum += (edge.points[i].head<2>() - edge.points[i - 1].head<2>()).norm();
  return sum;
}

Curves drawingOf(const MedialAxis& axis) {
  Curves drawing;
  for (const MedialEdge& edge : axis.edges) {
    Path path;
    for (std::size_t i = 1; i < edge.points.size(); ++i)
      if (edge.points[i].head<2>() != edge.points[i - 1].head<2>())
        path.segments.emplace_back(Line2{edge.points[i - 1].head<2>(), edge.points[i].head<2>()});
    if (!path.segments.empty()) drawing.paths.push_back(std::move(path));
  }
  return drawing;
}

}  // namespace blossom
