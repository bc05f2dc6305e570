#include "kernel/arcs/sampled_region.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"

namespace blossom::minkowski {
namespace {

constexpr double sameAngle = 1e-9;  // radians

Vec2 unitAt(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// From `of` to `angle` the shorter way, counter-clockwise positive.
double turnFrom(double of, double angle) { return std::remainder(angle - of, 2 * std::numbers::pi); }

double within2Pi(double angle) {
  const double inside = std::fmod(angle, 2 * std::numbers::pi);
  return inside < 0 ? inside + 2 * std::numbers::pi : inside;
}

/// Angle of the outward normal where an arc has the angle phi: away from its centre when it turns left, else towards it.
double normalAt(const Arc2& arc, double phi) { return arc.sweep > 0 ? phi : phi + std::numbers::pi; }

/// Cuts arcs at normals and into chords.
class ArcSampler {
 public:
  ArcSampler(const std::vector<double>& normals, double tolerance) : normals_(normals), tolerance_(tolerance) {}

  /// Angles from the start of an arc to its end, both included.
  std::vector<double> anglesOf(const Arc2& arc) const {
    std::vector<double> cuts = cutsOf(arc), angles;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const int parts = partsOf(arc, cuts[i + 1] - cuts[i]);
      for (int k = 0; k < parts; ++k) angles.push_back(cuts[i] + (cuts[i + 1] - cuts[i]) * k / parts);
    }
    angles.push_back(cuts.back());
    return angles;
  }

 private:
  [[nodiscard]] std::vector<double> cutsOf(const Arc2& arc) const {
    std::vector<double> cuts{arc.start};
    const double sign = arc.sweep > 0 ? 1 : -1, sweep = std::abs(arc.sweep), first = normalAt(arc, arc.start);
    for (const double normal : normals_) {
      const double along = within2Pi(sign * (normal - first));
      if (along > sameAngle && along < sweep - sameAngle) cuts.push_back(arc.start + sign * along);
    }
    std::sort(cuts.begin(), cuts.end(), [sign](double a, double b) { return sign * a < sign * b; });
    cuts.push_back(arc.start + arc.sweep);
    return cuts;
  }

  /// So many that a chord is within the tolerance.
  [[nodiscard]] int partsOf(const Arc2& arc, double sweep) const {
    constexpr double widest = std::numbers::pi / 4;
    const double share = std::clamp(1 - tolerance_ / std::max(std::abs(arc.radius), 1e-300), -1.0, 1.0);
    const double step = std::clamp(2 * std::acos(share), 1e-6, widest);
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(std::abs(sweep) / step - 1e-9)) | 1U));
  }

  const std::vector<double>& normals_;
  double tolerance_;
};

class RegionSampler {
 public:
  RegionSampler(const std::vector<double>& normals, double tolerance, Sampling sampling)
      : arcs_(normals, tolerance), sampling_(sampling) {}

  SampledRegion run(const Region& region) {
    for (const Path& loop : region.loops) add(loop);
    return std::move(out_);
  }

 private:
  void add(const Path& path) {
    const std::size_t first = out_.corners.size();
    for (const Segment& segment : path.segments) {
      if (const auto* arc = std::get_if<Arc2>(&segment))
        add(*arc);
      else if (startPoint(segment) != endPoint(segment))
        addCorner(startPoint(segment)), out_.sides.push_back({});
    }
    close(first);
    Loop loop;
    for (std::size_t i = first; i < out_.corners.size(); ++i) loop.push_back(out_.corners[i].at);
    if (blossom::signedArea(path) > 0)
      out_.polygons.push_back({std::move(loop), {}});
    else
      out_.polygons.back().holes.push_back(std::move(loop));
  }

  void addCorner(const Vec2& at) {
    out_.corners.push_back({});
    out_.corners.back().at = at;
  }

  void add(const Arc2& arc) {
    out_.arcs.push_back({arc.center, arc.sweep > 0 ? arc.radius : -arc.radius});
    const std::vector<double> angles = arcs_.anglesOf(arc);
    if (sampling_ == Sampling::Around && arc.sweep > 0)
      addTangents(arc, angles);
    else
      addChords(arc, angles);
    ends_.emplace_back(out_.corners.size() - 1, normalAt(arc, angles.back()));
  }

  void addChords(const Arc2& arc, const std::vector<double>& angles) {
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
      addCorner(arc.center + arc.radius * unitAt(angles[i]));
      if (i > 0) arrive(arc, angles[i]);
      leave(arc, angles[i], (angles[i] + angles[i + 1]) / 2);
    }
  }

  /// Sides that touch the arc at the angles, and so turn half-way between them.
  void addTangents(const Arc2& arc, const std::vector<double>& angles) {
    const bool closed = std::abs(arc.sweep) >= 2 * std::numbers::pi - sameAngle;
    if (!closed) {
      addCorner(arc.center + arc.radius * unitAt(angles.front()));
      leave(arc, angles.front(), angles.front());
    }
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
      const double middle = (angles[i] + angles[i + 1]) / 2, half = (angles[i + 1] - angles[i]) / 2;
      addCorner(arc.center + arc.radius / std::cos(half) * unitAt(middle));
      arrive(arc, middle);
      leave(arc, middle, angles[i + 1]);
    }
  }

  /// The last corner lies within the last arc.
  void arrive(const Arc2& arc, double angle) {
    out_.corners.back().before = lastArc();
    out_.corners.back().normalBefore = normalAt(arc, angle);
  }
  /// The last arc goes on from the last corner, by a side with its own angle.
  void leave(const Arc2& arc, double angle, double ofSide) {
    out_.corners.back().after = lastArc();
    out_.corners.back().normalAfter = normalAt(arc, angle);
    SampledSide& side = out_.sides.emplace_back();
    side.arc = lastArc();
    side.normal = normalAt(arc, ofSide);
  }
  [[nodiscard]] std::uint32_t lastArc() const { return static_cast<std::uint32_t>(out_.arcs.size() - 1); }

  /// What needs the next corner: ends of sides, and the arcs that end there.
  void close(std::size_t first) {
    const std::size_t count = out_.corners.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      SampledSide& side = out_.sides[first + i];
      side.from = out_.corners[first + i].at;
      side.to = out_.corners[first + (i + 1) % count].at;
      const Vec2 along = side.to - side.from;
      if (!side.arc) side.normal = std::atan2(-along.x(), along.y());
    }
    for (const auto& [last, normal] : ends_) {
      SampledCorner& corner = out_.corners[first + (last - first + 1) % count];
      corner.before = out_.sides[last].arc;
      corner.normalBefore = normal;
    }
    ends_.clear();
  }

  ArcSampler arcs_;
  Sampling sampling_;
  SampledRegion out_;
  std::vector<std::pair<std::size_t, double>> ends_;  ///< last sides of arcs in a loop, and the normals at their ends
};

/// The arc that a convex corner stands for where the normal has an angle; none where it is a point.
const BoundaryArc* arcAt(const SampledRegion& region, const SampledCorner& corner, double normal) {
  const auto convex = [&](const std::optional<std::uint32_t>& arc) { return arc && region.arcs[*arc].radius > 0; };
  if (corner.before && corner.before == corner.after) return convex(corner.before) ? &region.arcs[*corner.before] : nullptr;
  if (convex(corner.before) && turnFrom(corner.normalBefore, normal) < 0) return &region.arcs[*corner.before];
  if (convex(corner.after) && turnFrom(corner.normalAfter, normal) > 0) return &region.arcs[*corner.after];
  return nullptr;
}

}  // namespace

std::vector<double> endNormals(const Region& a, const Region& b) {
  std::vector<double> normals;
  for (const Region* region : {&a, &b})
    for (const Path& loop : region->loops)
      for (const Segment& segment : loop.segments)
        if (const auto* arc = std::get_if<Arc2>(&segment)) {
          normals.push_back(within2Pi(normalAt(*arc, arc->start)));
          normals.push_back(within2Pi(normalAt(*arc, arc->start + arc->sweep)));
        }
  std::sort(normals.begin(), normals.end());
  const auto end = std::unique(normals.begin(), normals.end(), [](double p, double q) { return q - p <= sameAngle; });
  normals.erase(end, normals.end());
  return normals;
}

SampledRegion sampled(const Region& region, const std::vector<double>& normals, double tolerance, Sampling sampling) {
  return RegionSampler(normals, tolerance, sampling).run(region);
}

std::optional<TrueCurve> curveOfPair(const SampledRegion& ofSide, std::uint32_t side, const SampledRegion& ofCorner,
                                     std::uint32_t corner, double point) {
  const SampledSide& moved = ofSide.sides[side];
  const SampledCorner& by = ofCorner.corners[corner];
  const BoundaryArc* along = arcAt(ofCorner, by, moved.normal);
  if (!moved.arc) {
    const Vec2 shift = along ? Vec2(along->centre + along->radius * unitAt(moved.normal)) : by.at;
    return StraightCurve{moved.from + shift, moved.to + shift};
  }
  const BoundaryArc& arc = ofSide.arcs[*moved.arc];
  const double radius = std::abs(arc.radius + (along ? along->radius : 0));
  if (radius <= point) return std::nullopt;
  return Circle{arc.centre + (along ? along->centre : by.at), radius};
}

}  // namespace blossom::minkowski
