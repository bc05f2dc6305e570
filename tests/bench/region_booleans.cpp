// Booleans of named regions of lines and arcs beside OCCT's in the same run: milliseconds, the median of several runs each,
// everything from regions to a region included, and how many times as fast.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/memory.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/booleans/region_boolean.h"
#include "geometry/planar/planar.h"
#include "modeling/kernel/parts/boolean.h"
#include "modeling/kernel/solid/arrange.h"
#include "support/lattice_regions.h"
#include "support/timing.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

struct Operands {
  const char* name;
  BooleanOperation operation;
  std::vector<Region> regions;
};

/// A disc with so many half discs around it.
Region gear(int teeth, double radius) {
  const double half = pi / (2 * teeth), tooth = radius * std::sin(half);
  Path path;
  path.closed = true;
  for (int i = 0; i < teeth; ++i) {
    const double angle = 2 * pi * i / teeth;
    const Vec2 centre = radius * std::cos(half) * Vec2(std::cos(angle), std::sin(angle));
    path.segments.emplace_back(Arc2{centre, tooth, angle - pi / 2, pi});
    path.segments.emplace_back(Arc2{{0, 0}, radius, angle + half, 2 * half});
  }
  return {{path}};
}

/// Strips that share walls with one another or cross.
Region bars(int count, bool level) {
  Region region;
  for (int i = 0; i < count; ++i) {
    const Vec2 low(2.0 * i, 0), high(2.0 * i + 1, 2.0 * count - 1);
    region.loops.push_back(level ? rectanglePath({low.y(), low.x()}, {high.y(), high.x()}) : rectanglePath(low, high));
  }
  return region;
}

std::vector<Region> discs(int side, double radius) {
  std::vector<Region> all;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) all.push_back(circleRegion(radius, {i, j}));
  return all;
}

std::vector<Operands> operands() {
  using enum BooleanOperation;
  std::vector<Region> drilled = discs(20, 0.3);
  drilled.insert(drilled.begin(), rectangleRegion({-1, -1}, {20, 20}));
  const Region wheel = gear(60, 10), other = moved(gear(50, 9), 1, 0.05, {6, 2});
  return {{"square and disc", Union, {rectangleRegion({0, 0}, {10, 10}), circleRegion(4, {10, 5})}},
          {"convex, many corners", Intersection, {gear(200, 10), circleRegion(10.02)}},
          {"two gears", Union, {wheel, other}},
          {"two gears, common", Intersection, {wheel, other}},
          {"gear less gear", Difference, {wheel, other}},
          {"walls in one plane", Union, {bars(20, false), moved(bars(20, false), 1, 0, {1, 0})}},
          {"thin strips across", Intersection, {bars(30, false), bars(30, true)}},
          {"144 discs", Union, discs(12, 0.6)},
          {"plate with 400 holes", Difference, drilled},
          {"tiny gears", Union, {moved(wheel, 1e-3, 0, {0, 0}), moved(other, 1e-3, 0, {0, 0})}},
          {"gears far away", Union, {moved(wheel, 1, 0, {1e5, -1e5}), moved(other, 1, 0, {1e5, -1e5})}}};
}

Region byOcct(const Operands& each) {
  std::vector<TopoDS_Shape> faces;
  for (const Region& region : each.regions) faces.push_back(toFaces(region));
  return modeling::asRegion(modeling::combine(faces, {.operation = each.operation}).shape);
}

}  // namespace

int main(int argc, char** argv) {
  blossom::keepFreedMemory();  // as the programs do
  const std::string_view asked = argc > 1 ? argv[1] : "";
  double logarithms = 0, least = 1e300;
  int count = 0;
  for (const Operands& each : operands()) {
    if (std::string_view(each.name).find(asked) == std::string_view::npos) continue;
    std::optional<Region> ours;
    Region theirs;
    const double mine = 1e3 * medianSeconds([&] { ours = combined(each.regions, each.operation); });
    const double peer = 1e3 * medianSeconds([&] { theirs = byOcct(each); });
    fmt::print("  {:<24}{:12.3f} ms   OCCT {:12.1f} ms   {:8.1f} times", each.name, mine, peer, peer / mine);
    if (!ours)
      fmt::print("   NOT TOLD");
    else if (std::abs(area(*ours) - area(theirs)) > 1e-7 * area(theirs))
      fmt::print("   AREA {:.12g}, OCCT has {:.12g}", area(*ours), area(theirs));
    fmt::print("\n");
    logarithms += std::log(peer / mine);
    least = std::min(least, peer / mine);
    ++count;
  }
  if (count > 0)
    fmt::print("  region Booleans, geometric mean {:.1f} times, least {:.1f} times\n", std::exp(logarithms / count), least);
}
