#include "geometry/crossing/surface_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/crossing/crossing_search.h"

namespace blossom {

CrossingResult findCrossing(const Surface& surface, const CrossingOptions& o, const Progress& progress) {
  const double size = sampledSize(surface, progress);
  const SheetMesh mesh = sheetMesh(surface, chordFor(o) * size, progress);
  return searchCrossing(mesh, SmoothSheets(surface), meetingTriangles(mesh, pairsKept, progress), o, progress);
}

CrossingResult findCrossing(const TopoDS_Shape& shape, const CrossingOptions& o, const Progress& progress) {
  const SheetMesh mesh = sheetMeshWithin(chordFor(o), shape, progress);
  return searchCrossing(mesh, SmoothSheets(shape), meetingTriangles(mesh, pairsKept, progress), o, progress);
}

}  // namespace blossom
