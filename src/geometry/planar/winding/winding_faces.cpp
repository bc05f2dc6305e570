#include "geometry/planar/winding/winding_faces.h"

#include <limits>
#include <utility>

#include "geometry/planar/winding/boundary_pieces.h"

namespace blossom::planar {
namespace {

constexpr int lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();

WindingRule ruleOf(Inside inside) {
  switch (inside) {
    case Inside::Positive:
      return {lowest, 0};
    case Inside::NonZero:
      return {0, 0};
    case Inside::Hollow:
      break;
  }
  return {1, highest};
}

}  // namespace

std::vector<TracedPart> tracedFaces(std::span<const CountedEdge> edges, const Progress& progress, WindingRule rule,
                                    Effort& effort) {
  if (edges.empty()) return {};
  const WindingCells cells(edges, rule, progress);
  const double work = cells.pairs() + Effort::pairsOfEdge * static_cast<double>(edges.size());
  effort.foresee(work);
  effort.spend(static_cast<std::size_t>(work));
  return joinedPieces(boundaryPieces(edges, cells, rule, progress), edges, progress);
}

std::vector<TracedPart> tracedFaces(std::span<const CountedEdge> edges, const Progress& progress, Inside inside,
                                    Effort& effort) {
  return tracedFaces(edges, progress, ruleOf(inside), effort);
}

Polygons windingFaces(std::span<const CountedEdge> edges, const Progress& progress, Inside inside, Effort& effort) {
  Polygons faces;
  for (TracedPart& part : tracedFaces(edges, progress, inside, effort)) {
    Polygon& face = faces.emplace_back(Polygon{std::move(part.outer.corners), {}});
    for (TracedLoop& hole : part.holes) face.holes.push_back(std::move(hole.corners));
  }
  return faces;
}

Polygons windingFaces(std::span<const CountedEdge> edges, const Progress& progress, Inside inside) {
  Effort unlimited;
  return windingFaces(edges, progress, inside, unlimited);
}

std::optional<Vec2> misplacedFace(std::span<const CountedEdge> edges, double width, const Progress& progress) {
  Effort unlimited;
  for (const auto& [outer, holes] : tracedFaces(edges, progress, WindingRule{0, 1}, unlimited))
    if (2 * signedArea(outer.corners) > width * perimeter(outer.corners)) return outer.corners.front();
  return std::nullopt;
}

}  // namespace blossom::planar
