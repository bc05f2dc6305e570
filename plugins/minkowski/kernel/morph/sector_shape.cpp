#include "kernel/morph/sector_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/convex_hull.h"
#include "geometry/planar/sums/flattening.h"
#include "kernel/morph/point_shape.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

/// Segments of a convex path with the angles of the normals at their ends, from those of the first segment on.
struct TurningSegment {
  Segment segment;
  double from = 0, to = 0;
};

std::vector<TurningSegment> turningSegments(const Path& convex) {
  std::vector<TurningSegment> turning;
  for (const Segment& segment : convex.segments) {
    double normal = 0, sweep = 0;
    if (const auto* arc = std::get_if<Arc2>(&segment)) {
      normal = arc->start;
      sweep = arc->sweep;
    } else {
      const Vec2 along = endPoint(segment) - startPoint(segment);
      normal = std::atan2(-along.x(), along.y());
    }
    const double from =
        turning.empty() ? inOneTurn(normal) : turning.back().to + std::max(0.0, turnFrom(turning.back().to, normal));
    turning.push_back({segment, from, from + sweep});
  }
  return turning;
}

/// An arc goes on with that before it where both are parts of one circle, which a file may begin anywhere.
void addArc(Path& chain, const Arc2& arc) {
  auto* before = chain.segments.empty() ? nullptr : std::get_if<Arc2>(&chain.segments.back());
  if (before && before->center == arc.center && before->radius == arc.radius &&
      std::abs(turnFrom(before->start + before->sweep, arc.start)) <= sameAngle)
    before->sweep += arc.sweep;
  else
    chain.segments.emplace_back(arc);
}

/// The parts whose normals lie between two angles, less than one turn apart. Three turns around the path are in the order of
/// the normals. A side that faces one of the two angles, but for rounding, belongs to them.
Path chainWithin(const Path& convex, double from, double to) {
  const std::vector<TurningSegment> all = turningSegments(convex);
  Path chain;
  for (const double turn : {-fullTurn, 0.0, fullTurn})
    for (const TurningSegment& each : all) {
      const double low = std::max(each.from + turn, from), high = std::min(each.to + turn, to);
      const auto* arc = std::get_if<Arc2>(&each.segment);
      if (!arc && low <= high + sameAngle)
        chain.segments.push_back(each.segment);
      else if (arc && high - low > sameAngle)
        addArc(chain, {arc->center, arc->radius, low, high - low});
    }
  return chain;
}

Path polygonAround(const Path& convex, double tolerance) {
  const std::vector<Vec2> corners = flatten(convex, tolerance);
  Path polygon;
  polygon.closed = true;
  for (std::size_t i = 0; i < corners.size(); ++i)
    polygon.segments.emplace_back(Line2{corners[i], corners[(i + 1) % corners.size()]});
  return polygon;
}

/// What encloses nothing with its chord.
bool isStraight(const Path& chain, double tolerance) {
  const Vec2 from = startPoint(chain), chord = endPoint(chain) - from;
  const std::vector<Vec2> corners = flatten(chain, tolerance / 8);
  return std::all_of(corners.begin(), corners.end(), [&](const Vec2& p) {
    const Vec2 off = p - from;
    if (chord.norm() <= tolerance) return off.norm() <= tolerance;
    return std::abs(chord.x() * off.y() - chord.y() * off.x()) <= tolerance * chord.norm();
  });
}

}  // namespace

SoundRegion facing(const SoundRegion& shape, const Sector& sector, const std::string& name, const Progress& progress) {
  SoundRegion hull = convexHull(shape, progress);
  const double width = inOneTurn(sector.to - sector.from);
  const bool allAround = std::min(width, fullTurn - width) <= sameAngle;
  if (allAround && (sector.to == sector.from || std::abs(sector.to - sector.from) > fullTurn / 2)) return hull;
  const Path& around = hull.region.loops.front();
  const double from = inOneTurn(sector.from);
  Path chain = chainWithin(hasSplines(hull.region) ? polygonAround(around, shape.tolerance) : around, from, from + width);
  if (allAround || chain.segments.empty() || isStraight(chain, hull.tolerance))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("Of {}, only a {} faces the directions from {:.4g} to {:.4g} degrees.", name,
                            chain.segments.empty() ? "corner" : "straight side", sector.from * 360 / fullTurn,
                            sector.to * 360 / fullTurn),
                "Give a wider sector.");
  chain.closed = true;
  const Vec2 end = endPoint(chain), start = startPoint(chain);
  if (end != start) chain.segments.emplace_back(Line2{end, start});
  return {{{std::move(chain)}}, hull.tolerance, hull.plain};
}

void faceSectors(std::vector<Region>& shapes, std::span<const Sector> sectors, const std::optional<double>& tolerance,
                 const Progress& progress) {
  if (sectors.size() > shapes.size())
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("{} sectors are given for {} control shapes.", sectors.size(), shapes.size()),
                "Leave out those too many.");
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    const bool allAround =
        sectors[i].from == sectors[i].to || std::abs(sectors[i].to - sectors[i].from) > fullTurn - sameAngle;
    if (allAround || pointIn(shapes[i])) continue;
    const std::string name = fmt::format("control shape {}", i + 1);
    shapes[i] = facing(soundRegion(shapes[i], {.tolerance = tolerance}, name, progress), sectors[i], name, progress).region;
  }
}

}  // namespace blossom::minkowski
