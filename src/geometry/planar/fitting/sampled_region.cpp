#include "geometry/planar/fitting/sampled_region.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/tolerance.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/arc_contacts.h"
#include "geometry/planar/fitting/spline_samples.h"
#include "geometry/planar/planar.h"

namespace blossom::planar {
namespace {

/// Cuts arcs at normals and into chords.
class ArcSampler {
 public:
  ArcSampler(std::vector<double> normals, double tolerance, const std::vector<Path>& loops)
      : normals_(std::move(normals)), tolerance_(tolerance), contacts_(loops) {
    if (!contacts_.any(loops)) return;
    // The material lies on opposite sides of arcs that touch from within, and both are cut at the same places.
    const std::size_t oneWay = normals_.size();
    for (std::size_t i = 0; i < oneWay; ++i) normals_.push_back(inOneTurn(normals_[i] + std::numbers::pi));
    std::sort(normals_.begin(), normals_.end());
    const auto same = [](double p, double q) { return q - p <= sameAngle; };
    normals_.erase(std::unique(normals_.begin(), normals_.end(), same), normals_.end());
  }

  /// Angles from the start of an arc to its end, both included, and one between: a single chord would not tell a hollow side
  /// from a bulging one, of which sums make other curves.
  std::vector<double> anglesOf(const Arc2& arc) const {
    std::vector<double> cuts = cutsOf(arc), angles;
    const int least = cuts.size() == 2 ? 2 : 1;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const int parts = std::max(least, partsOf(arc, cuts[i + 1] - cuts[i]));
      for (int k = 0; k < parts; ++k) angles.push_back(cuts[i] + (cuts[i + 1] - cuts[i]) * k / parts);
    }
    angles.push_back(cuts.back());
    if (contacts_.beside(arc, true)) angles.insert(angles.begin() + 1, (angles[0] + angles[1]) / 2);
    if (contacts_.beside(arc, false)) angles.insert(angles.end() - 1, (angles.end()[-1] + angles.end()[-2]) / 2);
    return angles;
  }

 private:
  [[nodiscard]] std::vector<double> cutsOf(const Arc2& arc) const {
    std::vector<double> cuts{arc.start};
    const double sign = arc.sweep > 0 ? 1 : -1, sweep = std::abs(arc.sweep), first = normalAt(arc, arc.start);
    for (const double normal : normals_) {
      const double along = inOneTurn(sign * (normal - first));
      if (along > sameAngle && along < sweep - sameAngle) cuts.push_back(arc.start + sign * along);
    }
    std::sort(cuts.begin(), cuts.end(), [sign](double a, double b) { return sign * a < sign * b; });
    cuts.push_back(arc.start + arc.sweep);
    return cuts;
  }

  /// So many that a chord is within the tolerance.
  [[nodiscard]] int partsOf(const Arc2& arc, double sweep) const {
    const double step = arcStep(arc.radius, tolerance_);
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(std::abs(sweep) / step - 1e-9)) | 1U));
  }

  std::vector<double> normals_;
  double tolerance_;
  ArcContacts contacts_;
};

class RegionSampler {
 public:
  /// @param loops all that arcs can touch in
  RegionSampler(const std::vector<double>& normals, double tolerance, Sampling sampling, const std::vector<Path>& loops)
      : arcs_(normals, tolerance, loops), normals_(normals), tolerance_(tolerance), sampling_(sampling) {}

  SampledRegion run(const Region& region, const Progress& progress) {
    for (const Path& loop : region.loops) {
      progress.check();
      add(loop);
    }
    return std::move(out_);
  }

  SampledRegion run(const SoundSet& set, const Progress& progress) {
    for (const Path& loop : set.area.region.loops) add(loop);
    for (const Path& curve : set.curves) {
      progress.check();
      addThereAndBack(curve);
    }
    for (const Vec2& point : set.points) {
      out_.thin.push_back({static_cast<std::uint32_t>(out_.corners.size()), 0});
      addCorner(point);
      out_.sides.push_back({point, point});
    }
    return std::move(out_);
  }

 private:
  /// Both ways by the same points.
  void addThereAndBack(const Path& curve) {
    sampling_ = Sampling::Chords;
    const std::size_t first = out_.corners.size();
    for (const Segment& segment : curve.segments) std::visit([&](const auto& each) { addSides(each); }, segment);
    const std::size_t sides = out_.corners.size() - first;
    for (auto segment = curve.segments.rbegin(); segment != curve.segments.rend(); ++segment)
      std::visit([&](const auto& each) { addBack(each); }, *segment);
    for (std::size_t i = 0; i < sides; ++i)
      out_.corners[first + sides + i].at = i == 0 ? endPoint(curve) : out_.corners[first + sides - i].at;
    close(first);
    out_.thin.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(sides)});
  }

  void addBack(const Line2& line) { addSides(Line2{line.to, line.from}); }

  void addBack(const Arc2& arc) {
    const Arc2 back{arc.center, arc.radius, arc.start + arc.sweep, -arc.sweep};
    std::vector<double> angles = arcs_.anglesOf(arc);
    std::reverse(angles.begin(), angles.end());
    addArc(back, angles);
  }

  void addBack(const Spline2& spline) {
    std::vector<std::vector<CurveSample>> parts = samplesOf(spline, tolerance_, normals_);
    std::reverse(parts.begin(), parts.end());
    for (std::vector<CurveSample>& samples : parts) {
      std::reverse(samples.begin(), samples.end());
      for (CurveSample& sample : samples) sample.normal = inOneTurn(sample.normal + std::numbers::pi);
      addSamples(samples);
    }
  }

  void add(const Path& path) {
    const std::size_t first = out_.corners.size();
    for (const Segment& segment : path.segments) std::visit([&](const auto& each) { addSides(each); }, segment);
    close(first);
    Loop loop;
    for (std::size_t i = first; i < out_.corners.size(); ++i) loop.push_back(out_.corners[i].at);
    if (out_.polygons.empty() || blossom::signedArea(path) > 0)
      out_.polygons.push_back({std::move(loop), {}});
    else
      out_.polygons.back().holes.push_back(std::move(loop));
  }

  void addSides(const Line2& line) {
    if (line.from == line.to) return;
    addCorner(line.from);
    out_.sides.push_back({});
  }

  void addSides(const Arc2& arc) { addArc(arc, arcs_.anglesOf(arc)); }

  void addArc(const Arc2& arc, const std::vector<double>& angles) {
    out_.curves.push_back({false, arc.center, arc.sweep > 0 ? arc.radius : -arc.radius});
    if (sampling_ == Sampling::Around && arc.sweep > 0)
      addTangents(arc, angles);
    else
      addChords(arc, angles);
    if (arc.sweep > 0) ends_.emplace_back(out_.corners.size() - 1, normalAt(arc, angles.back()));
  }

  void addSides(const Spline2& spline) {
    for (const std::vector<CurveSample>& part : samplesOf(spline, tolerance_, normals_)) addSamples(part);
  }

  void addSamples(const std::vector<CurveSample>& samples) {
    out_.curves.push_back({true});
    const auto turnsLeft = [&](std::size_t i) { return turnFrom(samples[i].normal, samples[i + 1].normal) > 0; };
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      addCorner(samples[i].at);
      if (i > 0) arrive(samples[i].normal);
      if (i > 0 || turnsLeft(i)) leave(samples[i].normal);
      addCurvedSide(samples[i].normal, samples[i + 1].normal);
    }
    if (turnsLeft(samples.size() - 2)) ends_.emplace_back(out_.corners.size() - 1, samples.back().normal);
  }

  void addChords(const Arc2& arc, const std::vector<double>& angles) {
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
      const double normal = normalAt(arc, angles[i]);
      addCorner(arc.center + arc.radius * unitAt(angles[i]));
      if (i > 0 && arc.sweep > 0) arrive(normal);
      if (arc.sweep > 0) leave(normal);
      addCurvedSide(normal, normalAt(arc, angles[i + 1]));
    }
  }

  /// Sides that touch the arc at the angles, and so turn half-way between them.
  void addTangents(const Arc2& arc, const std::vector<double>& angles) {
    const bool closed = std::abs(arc.sweep) >= fullTurn - sameAngle;
    if (!closed) {
      addCorner(arc.center + arc.radius * unitAt(angles.front()));
      leave(angles.front());
      addCurvedSide(angles.front(), angles.front());
    }
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
      const double middle = (angles[i] + angles[i + 1]) / 2, half = (angles[i + 1] - angles[i]) / 2;
      addCorner(arc.center + arc.radius / std::cos(half) * unitAt(middle));
      arrive(middle);
      leave(middle);
      addCurvedSide(angles[i + 1], angles[i + 1]);
    }
  }

  void addCorner(const Vec2& at) {
    out_.corners.push_back({});
    out_.corners.back().at = at;
  }
  /// The last curve comes to the last corner, and goes on from it.
  void arrive(double normal) {
    out_.corners.back().before = lastCurve();
    out_.corners.back().normalBefore = normal;
  }
  void leave(double normal) {
    out_.corners.back().after = lastCurve();
    out_.corners.back().normalAfter = normal;
  }
  void addCurvedSide(double normalFrom, double normalTo) {
    SampledSide& side = out_.sides.emplace_back();
    side.curve = lastCurve();
    side.normalFrom = normalFrom;
    side.normalTo = normalTo;
  }
  [[nodiscard]] std::uint32_t lastCurve() const { return static_cast<std::uint32_t>(out_.curves.size() - 1); }

  /// What needs the next corner: ends of sides, and the curves that end there.
  void close(std::size_t first) {
    const std::size_t count = out_.corners.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      SampledSide& side = out_.sides[first + i];
      side.from = out_.corners[first + i].at;
      side.to = out_.corners[first + (i + 1) % count].at;
      const Vec2 along = side.to - side.from;
      side.normal = std::atan2(-along.x(), along.y());
      if (side.curve && !out_.curves[*side.curve].isFree)
        side.normal = side.normalFrom + turnFrom(side.normalFrom, side.normalTo) / 2;
      if (!side.curve) side.normalFrom = side.normalTo = side.normal;
    }
    for (const auto& [last, normal] : ends_) {
      SampledCorner& corner = out_.corners[first + (last - first + 1) % count];
      corner.before = out_.sides[last].curve;
      corner.normalBefore = normal;
    }
    ends_.clear();
  }

  ArcSampler arcs_;
  const std::vector<double>& normals_;
  double tolerance_;
  Sampling sampling_;
  SampledRegion out_;
  std::vector<std::pair<std::size_t, double>> ends_;  ///< last sides of curves in a loop, and the normals at their ends
};

/// What a convex corner stands for where the normal has an angle: a point of a curve, or the corner alone.
struct CornerCurve {
  std::optional<std::uint32_t> curve{};
  double normal = 0;  ///< of the curve in the corner
};

CornerCurve curveAt(const SampledCorner& corner, double normal) {
  if (corner.before && corner.before == corner.after) return {corner.before, corner.normalAfter};
  if (corner.before && turnFrom(corner.normalBefore, normal) < 0) return {corner.before, corner.normalBefore};
  if (corner.after && turnFrom(corner.normalAfter, normal) > 0) return {corner.after, corner.normalAfter};
  return {};
}

/// The point of the curve beside a side where the normal has an angle, as if the curve were an arc there; nothing where that
/// is at an end.
std::optional<FreePoint> pointBeside(const SampledSide& side, double normal) {
  const double turn = turnFrom(side.normalFrom, side.normalTo), part = turnFrom(side.normalFrom, normal);
  const double share = std::abs(turn) > sameAngle ? part / turn : 0;
  constexpr double margin = 1e-3;
  if (!(share > margin && share < 1 - margin)) return std::nullopt;
  const double rise = (side.to - side.from).norm() * turn / 2 * share * (1 - share);
  return FreePoint{side.from + share * (side.to - side.from) + rise * unitAt(side.normal), normal};
}

FreeSide freeSide(const SampledSide& side, const SampledCorner& by, std::uint32_t corner, const CornerCurve& along) {
  const auto onCurve = [&](double normal) { return !along.curve || std::abs(turnFrom(along.normal, normal)) <= sameAngle; };
  const std::uint64_t moves = along.curve ? 2 * std::uint64_t{*along.curve} : 2 * std::uint64_t{corner} + 1;
  FreeSide made{{2 * std::uint64_t{*side.curve}, moves},
                {side.from + by.at, side.normalFrom, onCurve(side.normalFrom)},
                {side.to + by.at, side.normalTo, onCurve(side.normalTo)}};
  if (along.curve && !made.from.isOnCurve && !made.to.isOnCurve) made.between = pointBeside(side, along.normal);
  if (made.between) made.between->at += by.at;
  return made;
}

}  // namespace

double arcStep(double radius, double tolerance) {
  constexpr double widest = std::numbers::pi / 4;
  const double share = std::clamp(1 - tolerance / std::max(std::abs(radius), 1e-300), -1.0, 1.0);
  return std::clamp(2 * std::acos(share), 1e-6, widest);
}

SampledRegion sampled(const SoundSet& set, double share, const std::vector<double>& normals, Sampling sampling,
                      const Progress& progress) {
  return RegionSampler(normals, share * set.tolerance, sampling, set.area.region.loops).run(set, progress);
}

SampledRegion sampled(const SoundRegion& shape, double share, const std::vector<double>& normals, Sampling sampling,
                      const Progress& progress) {
  return RegionSampler(normals, share * shape.tolerance, sampling, shape.region.loops).run(shape.region, progress);
}

std::optional<TrueCurve> curveOfPair(const SampledRegion& ofSide, std::uint32_t side, const SampledRegion& ofCorner,
                                     std::uint32_t corner, double point) {
  const SampledSide& moved = ofSide.sides[side];
  const SampledCorner& by = ofCorner.corners[corner];
  const CornerCurve along = curveAt(by, moved.normal);
  const BoundaryCurve* moves = along.curve ? &ofCorner.curves[*along.curve] : nullptr;
  if (moved.curve && (ofSide.curves[*moved.curve].isFree || (moves && moves->isFree)))
    return freeSide(moved, by, corner, along);
  const bool arc = moves && !moves->isFree;
  if (!moved.curve) {
    const Vec2 shift = arc ? Vec2(moves->centre + moves->radius * unitAt(moved.normal)) : by.at;
    return StraightCurve{moved.from + shift, moved.to + shift};
  }
  const BoundaryCurve& curve = ofSide.curves[*moved.curve];
  const double sum = curve.radius + (arc ? moves->radius : 0), radius = std::abs(sum);
  // A hollow arc that is filled by a larger one bounds nothing but what its polygon leaves.
  if (radius <= point || (curve.radius < 0 && sum > 0)) return std::nullopt;
  return Circle{curve.centre + (arc ? moves->centre : by.at), radius};
}

double longestChord(const SampledRegion& region) {
  double longest = 0;
  for (const SampledSide& side : region.sides)
    if (side.curve) longest = std::max(longest, (side.to - side.from).norm());
  return longest;
}

double roundingOf(const SampledRegion& region, const Grid& grid) {
  constexpr double roundings = 32 * std::numeric_limits<double>::epsilon();
  double drawn = 0, withCentres = 0;
  for (const SampledCorner& corner : region.corners) drawn = std::max(drawn, corner.at.cwiseAbs().maxCoeff());
  for (const BoundaryCurve& arc : region.curves)
    withCentres = std::max(withCentres, arc.centre.cwiseAbs().maxCoeff() + std::abs(arc.radius));
  // Who reads the result takes wider gaps for openings, wherever the centres of its arcs are.
  return 64 * grid.unit + std::max(roundings * drawn, std::min(roundings * withCentres, Tolerance{}.joining / 4));
}

}  // namespace blossom::planar
