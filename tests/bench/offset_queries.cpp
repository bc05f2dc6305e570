// Offsets of free-form outlines, one distance after the other, beside Clipper's round offset of the same outline in chords,
// and the clearance diagram from which ours are read beside Boost.Polygon's own time for its Voronoi diagram; all in the
// same run. `offset_queries NAME` runs the outlines whose names contain NAME. Outlines that other people drew take part when
// ../shared/data is there.
#include <fmt/format.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <polyclipping/clipper.hpp>
#include <string_view>

#include "core/memory.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/sound_region.h"
#include "pocket/kernel/medial/boundary.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "support/curved_regions.h"
#include "support/exchange.h"
#include "support/timing.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::pocket;

namespace {

constexpr double shareOfSize = 1e-5;  // the tolerance of both
constexpr int distances = 10;

struct Outline {
  std::string name;
  Region region;
};

/// A star of n spikes that a closed cubic spline rounds.
Region roundedStar(int spikes, double reach) {
  Spline2 spline{3, {}, {}};
  const int n = 2 * spikes;
  for (int i = 0; i < n + 3; ++i) {
    const double angle = 2 * std::numbers::pi * (i % n) / n, r = reach * (i % 2 == 0 ? 1.0 : 0.55);
    spline.poles.push_back(Vec2(r * std::cos(angle), r * std::sin(angle)).homogeneous());
  }
  for (int i = 0; i < n + 7; ++i) spline.knots.push_back(i);
  return {{Path{{spline}, true, {}, {}}}};
}

std::vector<Outline> outlines() {
  std::vector<Outline> all;
  for (const int spikes : {5, 20, 80})
    all.push_back({fmt::format("star of {} spikes, a spline", spikes), roundedStar(spikes, 50)});
  if (!std::filesystem::exists(sharedData())) return all;
  for (const auto& file : std::filesystem::directory_iterator(sharedData() / "svg")) {
    Region region = toRegion(*readShape(formats(), file.path()).shape.get<Curves>());
    if (planar::hasSplines(region)) all.push_back({file.path().stem().string(), std::move(region)});
  }
  std::sort(all.begin(), all.end(), [](const Outline& a, const Outline& b) { return a.name < b.name; });
  return all;
}

double sizeOf(const Region& region) {
  Vec2 low = Vec2::Constant(HUGE_VAL), high = -low;
  for (const Path& path : region.loops)
    for (const Vec2& p : flatten(path, 0.01)) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).maxCoeff();
}

/// What Clipper is given: chords within the tolerance, in whole numbers.
class ClipperPeer {
 public:
  ClipperPeer(const Region& region, double tolerance) : unit_(tolerance / 1024), tolerance_(tolerance) {
    for (const Path& path : region.loops) {
      ClipperLib::Path& loop = paths_.emplace_back();
      for (const Vec2& p : flatten(path, tolerance))
        loop.emplace_back(std::llround(p.x() / unit_), std::llround(p.y() / unit_));
    }
  }
  [[nodiscard]] std::size_t corners() const {
    std::size_t count = 0;
    for (const auto& path : paths_) count += path.size();
    return count;
  }
  /// The area of the offset; inside below 0.
  [[nodiscard]] double offset(double distance) const {
    ClipperLib::ClipperOffset offset(2, tolerance_ / unit_);
    offset.AddPaths(paths_, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths made;
    offset.Execute(made, distance / unit_);
    double area = 0;
    for (const auto& path : made) area += ClipperLib::Area(path);
    return area * unit_ * unit_;
  }

 private:
  double unit_, tolerance_;
  ClipperLib::Paths paths_;
};

/// Boost.Polygon's Voronoi diagram of the pieces from which ours is made.
double secondsOfBoost(const Region& region, double tolerance) {
  const Boundary boundary(region, tolerance / 4, Progress::none());
  const double scale = 1e9 / boundary.size();
  const auto whole = [&](double x) { return static_cast<std::int32_t>(std::lround(x * scale)); };
  return medianSeconds([&] {
    boost::polygon::voronoi_builder<std::int32_t> builder;
    for (const Piece& piece : boundary.pieces()) {
      const Vec2 a = piece.from - boundary.middle(), b = piece.to - boundary.middle();
      builder.insert_segment(whole(a.x()), whole(a.y()), whole(b.x()), whole(b.y()));
    }
    boost::polygon::voronoi_diagram<double> diagram;
    builder.construct(&diagram);
  });
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();  // as the programs do
  const std::string_view asked = argc > 1 ? argv[1] : "";
  double logs = 0;
  int count = 0;
  for (const Outline& outline : outlines()) {
    if (outline.name.find(asked) == std::string::npos) continue;
    const double tolerance = shareOfSize * sizeOf(outline.region);
    const ClearanceDiagram diagram(outline.region, {.tolerance = tolerance});
    const double seconds = medianSeconds([&] { ClearanceDiagram(outline.region, {.tolerance = tolerance}); });
    const double boost = secondsOfBoost(outline.region, tolerance);
    const ClipperPeer clipper(outline.region, tolerance);
    double ours = 0, theirs = 0, farthest = 0;
    for (int k = 1; k <= distances; ++k) {
      const double distance = diagram.largestClearance() * k / (distances + 1.0);
      double area = 0, areaThere = 0, perimeter = 0;
      ours += medianSeconds([&] {
        const Region made = diagram.offset(distance, Side::Inside);
        area = blossom::area(made), perimeter = 0;
        for (const Path& path : made.loops) perimeter += length(path);
      });
      theirs += medianSeconds([&] { areaThere = clipper.offset(-distance); });
      farthest = std::max(farthest, std::abs(area - areaThere) / (tolerance * std::max(perimeter, 1e-9)));
    }
    logs += std::log(theirs / ours);
    ++count;
    fmt::print(
        "  {:<30}{:6} sites; offset {:8.3f} ms, Clipper: {:6.1f} times ({:.3f} ms), areas apart {:.2f} tolerances; "
        "diagram {:6.1f} ms, Boost.Polygon: {:.2f} times\n",
        outline.name, diagram.stats().sites, 1e3 * ours / distances, theirs / ours, 1e3 * theirs / distances, farthest,
        1e3 * seconds, seconds / boost);
  }
  if (count > 1) fmt::print("  geometric mean {:.1f} times Clipper\n", std::exp(logs / count));
}
