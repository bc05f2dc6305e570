#include "kernel/operations/erosion.h"

#include "kernel/convex/hull.h"

namespace blossom::morphology {

namespace {

/// Whether the element fits into the box of the solid with room to move.
bool hasRoom(const Bounds& solid, const Bounds& element) {
  return ((solid.high - solid.low) - (element.high - element.low)).minCoeff() > 0;
}

std::vector<Vec3> pointsOf(const Prepared& element) {
  if (element.hull.faceCount() > 0) return element.hull.points;
  std::vector<Vec3> points = element.triangles.points;
  for (const auto& piece : element.pieces) points.insert(points.end(), piece.begin(), piece.end());
  return points;
}

}  // namespace

Mesh eroded(Work& work, const Prepared& solid, const Prepared& element, const CommonGrid& grid, double from, double to) {
  if (!hasRoom(solid.bounds, element.bounds)) return {};
  if (solid.hull.faceCount() > 0) {
    work.progress().report(from, "Moving faces");
    Stopwatch watch;
    Mesh made = shrunk(solid.hull, pointsOf(element));
    work.stats().way = Way::Planes;
    work.stats().sumMs += watch.lapMs();
    return made;
  }
  auto made = arrangedDifference(termOf(solid), termOf(element), grid.step, work.progress().part(from, to));
  return work.taken(std::move(made), solid);
}

}  // namespace blossom::morphology
