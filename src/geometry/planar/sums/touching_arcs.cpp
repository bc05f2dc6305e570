#include "geometry/planar/sums/touching_arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/numeric/box_tree.h"
#include "geometry/planar/angles.h"
#include "geometry/planar/fitting/sampled_region.h"
#include "geometry/planar/segment_box.h"

namespace blossom::planar {
namespace {

struct PlacedArc {
  std::size_t loop = 0, segment = 0;
  Arc2 arc;
  std::vector<double> cuts = {};  ///< shares of the sweep
};

/// Two circles that touch, one within the other; with one angle, for both centres lie on one side.
struct Contact {
  double angle = 0;
  double large = 0, small = 0;  ///< the radii
};

std::optional<Contact> touchFromWithin(const Arc2& a, const Arc2& b) {
  constexpr double rounding = 1e-9;  // of the radius
  const Arc2 &large = a.radius < b.radius ? b : a, &small = a.radius < b.radius ? a : b;
  const Vec2 towards = small.center - large.center;
  const double apart = towards.norm(), within = rounding * large.radius;
  if (apart <= within || std::abs(apart - (large.radius - small.radius)) > within) return std::nullopt;
  return Contact{std::atan2(towards.y(), towards.x()), large.radius, small.radius};
}

/// The share of the sweep at which an arc has an angle, if not at an end.
std::optional<double> insideAt(const Arc2& arc, double angle) {
  constexpr double end = 1e-9;
  const double share = inOneTurn(arc.sweep > 0 ? angle - arc.start : arc.start - angle) / std::abs(arc.sweep);
  return share > end && share < 1 - end ? std::optional(share) : std::nullopt;
}

/// Turns from a contact at which both arcs are cut: for chords there that are shorter than the way to it, the gap is as wide
/// as they leave the larger arc.
std::vector<double> turnsFrom(const Contact& contact, double tolerance) {
  constexpr double finestShare = 1.0 / 64;  // as byFinerPolygons goes
  constexpr std::size_t mostCuts = 256;     // of nearly equal circles
  const double fine = arcStep(contact.large, finestShare * tolerance), coarse = arcStep(contact.large, tolerance);
  const double growth = std::min(1.0, std::sqrt(contact.large / contact.small - 1)) / 2;
  std::vector<double> turns{fine};
  while (turns.size() < mostCuts && growth * turns.back() < coarse)
    turns.push_back(turns.back() + std::max(fine, growth * turns.back()));
  return turns;
}

/// The larger of both is cut once more beside the contact: else their first chords would lie on each other.
void cutBeside(const Contact& contact, double sign, double tolerance, PlacedArc& a, PlacedArc& b) {
  const std::vector<double> turns = turnsFrom(contact, tolerance);
  const auto angleAt = [&](double turn) { return contact.angle + sign * turn; };
  if (!insideAt(a.arc, angleAt(turns.front() / 4)) || !insideAt(b.arc, angleAt(turns.front() / 4))) return;
  const auto cut = [&](PlacedArc& placed, double turn) {
    if (const auto share = insideAt(placed.arc, angleAt(turn))) placed.cuts.push_back(*share);
  };
  cut(a.arc.radius < b.arc.radius ? b : a, turns.front() / 2);
  for (PlacedArc* each : {&a, &b}) {
    cut(*each, 0);
    for (const double turn : turns) cut(*each, turn);
  }
}

std::vector<Segment> parts(const PlacedArc& placed) {
  std::vector<double> ends = placed.cuts;
  std::sort(ends.begin(), ends.end());
  constexpr double rounding = 1e-11;
  ends.erase(std::unique(ends.begin(), ends.end(), [](double p, double q) { return q - p < rounding; }), ends.end());
  ends.push_back(1);
  std::vector<Segment> all;
  double from = 0;
  for (const double to : ends) {
    Arc2 part = placed.arc;
    part.start += from * placed.arc.sweep;
    part.sweep *= to - from;
    all.emplace_back(part);
    from = to;
  }
  return all;
}

}  // namespace

std::optional<Region> dividedWhereArcsTouch(const Region& region, double tolerance, const Progress& progress) {
  std::vector<PlacedArc> arcs;
  std::vector<Box2> boxes;
  double size = 0;
  for (std::size_t loop = 0; loop < region.loops.size(); ++loop)
    for (std::size_t i = 0; i < region.loops[loop].segments.size(); ++i)
      if (const auto* arc = std::get_if<Arc2>(&region.loops[loop].segments[i])) {
        arcs.push_back({loop, i, *arc});
        boxes.push_back(boxAround(*arc));
        size = std::max(size, arc->radius);
      }
  constexpr double rounding = 1e-9;
  forEachNearPair<2>(boxes, rounding * size, progress, [&](std::size_t i, std::size_t j) {
    if (const auto contact = touchFromWithin(arcs[i].arc, arcs[j].arc))
      for (const double sign : {1.0, -1.0}) cutBeside(*contact, sign, tolerance, arcs[i], arcs[j]);
    return true;
  });
  std::erase_if(arcs, [](const PlacedArc& each) { return each.cuts.empty(); });
  if (arcs.empty()) return std::nullopt;
  Region divided = region;
  // Backwards, so that the places of those before stay.
  for (auto each = arcs.rbegin(); each != arcs.rend(); ++each) {
    std::vector<Segment>& segments = divided.loops[each->loop].segments;
    const auto place = segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(each->segment));
    std::vector<Segment> pieces = parts(*each);
    segments.insert(place, pieces.begin(), pieces.end());
  }
  return divided;
}

}  // namespace blossom::planar
