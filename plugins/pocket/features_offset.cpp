#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/stopwatch.h"
#include "core/units.h"
#include "feature_groups.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/segment_point.h"
#include "kernel/offset/offset.h"
#include "part_input.h"

namespace blossom::pocket {

namespace {

enum class Sides { Inside, Outside, Both };

struct OffsetParameters {
  std::vector<double> distance{1};
  Sides side = Sides::Inside;
  SubShapeValue face;
  bool skipOpen = false;
  double tolerance = 1e-3;
};

ParameterSpec distances() {
  ParameterSpec spec = list(positiveLength());
  spec.minimum = 1;
  return spec;
}

const char* nameOf(Side side) { return side == Side::Inside ? "inside" : "outside"; }

Error nothingLeft(double distance, double largest) {
  if (distance < largest * (1 + 1e-9))  // the largest disc just fits: what is left is a point or a line
    return Error(
        ErrorCode::InvalidParameter,
        fmt::format("Nothing with an area is left inside at a distance of {} mm, which is the radius of the largest "
                    "disc that fits.",
                    formatNumber(distance)),
        "Make the distance smaller, or offset to the outside.");
  return Error(
      ErrorCode::InvalidParameter,
      fmt::format("Nothing is left inside at a distance of {} mm; the distance must be below {} mm, the radius of the "
                  "largest disc that fits.",
                  formatNumber(distance), formatNumber(largest)),
      "Make the distance smaller, or offset to the outside.");
}

/// How far the points of an offset are off its distance, by the nearest places of the curves as drawn.
struct OffsetCheck {
  double farthest = 0;  ///< mm
  Vec2 at = Vec2::Zero();
  std::size_t chordJoints =
      0;  ///< ends of segments that have the accuracy of the chords and are not on the offsets of the curves
};

OffsetCheck checked(const ClearanceDiagram& diagram, const Region& region, double distance, const Progress& progress) {
  OffsetCheck check;
  const auto look = [&](const Vec2& p) {
    const double off = std::abs(std::abs(diagram.clearance(p)) - distance);
    if (off > check.farthest) check.farthest = off, check.at = p;
    return off;
  };
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) {
      progress.check();
      if (look(startPoint(segment)) > diagram.tolerance() / 16) ++check.chordJoints;
      look(middleOf(segment));
    }
  return check;
}

/// One offset with its figures in the list `offsets` of the stats; errors above the tolerance cause a warning.
Region measuredOffset(const ClearanceDiagram& diagram, double distance, Side side, Evaluated& out,
                      const Progress& progress) {
  const Stopwatch watch;
  Region region = diagram.offset(distance, side, progress);
  const double took = watch.elapsedMs();
  double perimeter = 0;
  for (const Path& loop : region.loops) perimeter += length(loop);
  const OffsetCheck check = checked(diagram, region, distance, progress);
  out.stats["offsets"].push_back({{"distance", distance},
                                  {"side", nameOf(side)},
                                  {"loops", region.loops.size()},
                                  {"area", area(region)},
                                  {"perimeter", perimeter},
                                  {"farthest_off_mm", check.farthest},
                                  {"chord_joints", check.chordJoints},
                                  {"ms", took}});
  if (check.farthest > diagram.tolerance() && distance >= diagram.tolerance())
    out.warnings.push_back(fmt::format("The offset at {} mm {} is {:.2g} mm off its distance near ({:.3f}, {:.3f}).",
                                       formatNumber(distance), nameOf(side), check.farthest, check.at.x(), check.at.y()));
  return region;
}

/// What lies within the distance on both sides of the outline.
Region band(Region outside, const Region& inside) {
  for (const Path& loop : inside.loops) outside.loops.push_back(reversed(loop));
  return outside;
}

void addLoops(Curves& curves, const Region& region, double distance, Side side) {
  for (Path loop : region.loops) {
    loop.layer = fmt::format("{} {}", nameOf(side), formatNumber(distance));
    curves.paths.push_back(std::move(loop));
  }
}

Evaluated offsetOf(const OffsetParameters& p, const Inputs& inputs, const Progress& progress) {
  const Part part = partOf(inputs.of(0)[0], p.face, p.skipOpen ? OpenLines::LeaveOut : OpenLines::RefuseForNow);
  const ClearanceDiagram diagram(part.region, {.tolerance = p.tolerance}, progress.part(0, 0.7));
  Evaluated out;
  out.warnings = part.warnings;
  addDiagramStats(diagram, out.stats);
  out.stats["offsets"] = Value::array();
  Curves all;
  std::size_t empty = 0;
  for (std::size_t i = 0; i < p.distance.size(); ++i) {
    const double d = p.distance[i];
    const double share = 0.3 / static_cast<double>(p.distance.size());
    const Progress own = progress.part(0.7 + share * double(i), 0.7 + share * double(i + 1));
    Region inside;
    Region outside;
    if (p.side != Sides::Outside) inside = measuredOffset(diagram, d, Side::Inside, out, own);
    if (p.side != Sides::Inside) outside = measuredOffset(diagram, d, Side::Outside, out, own);
    const bool nothing = p.side == Sides::Inside && inside.loops.empty();
    if (nothing && ++empty == p.distance.size()) throw nothingLeft(d, diagram.largestClearance());
    if (nothing || (p.side == Sides::Both && inside.loops.empty()))
      out.warnings.push_back(nothingLeft(d, diagram.largestClearance()).message());
    if (p.distance.size() == 1) {
      out.shape =
          p.side == Sides::Both ? band(std::move(outside), inside) : std::move(p.side == Sides::Inside ? inside : outside);
      return out;
    }
    addLoops(all, inside, d, Side::Inside);
    addLoops(all, outside, d, Side::Outside);
  }
  out.shape = std::move(all);
  return out;
}

FeatureType offsetFeature() {
  using P = OffsetParameters;
  return feature<P>("pocket.offset", "Offset", "Outlines at even distances from the outlines of a part.")
      .icon("offset")
      .keywords({"inset", "parallel outline", "contour"})
      .produces({ShapeKind::Region, ShapeKind::Curves})
      .input(partInput("an outline to offset"))
      .parameter("distance", &P::distance, distances(),
                 "Distance from the outline; several distances make curves, each on a layer of its own.")
      .parameter("side", &P::side, choice({"inside", "outside", "both"}),
                 "Side of the offset; both makes the band along the outline.")
      .parameter("face", &P::face, partFace(), partFaceHelp)
      .parameter("skip-open", &P::skipOpen, flag(), skipOpenHelp)
      .parameter("tolerance", &P::tolerance, positiveLength(), "Largest error of the distance.")
      .example("blossom offset outline.svg --distance 2 -o smaller.dxf")
      .example("blossom offset outline.dxf --distance 1,2,3,4 --side both -o rings.svg --json")
      .example("blossom offset text:Blossom --distance 1.5 --side outside -o sticker.svg")
      .example("blossom offset block.step --face 4 --distance 0.5 -o inset.step")
      .evaluate(offsetOf);
}

}  // namespace

void addDiagramStats(const ClearanceDiagram& diagram, Value& stats) {
  stats["diagram_ms"] = diagram.stats().milliseconds;
  stats["sites"] = diagram.stats().sites;
  stats["voronoi_vertices"] = diagram.stats().vertices;
  stats["diagrams_built"] = diagram.stats().attempts;
  stats["method"] = diagram.stats().method;
  stats["largest_distance"] = diagram.largestClearance();
}

void registerOffsetFeatures(Registry& registry) { registry.addAll(offsetFeature(), medialAxisFeature()); }

}  // namespace blossom::pocket
