#include "kernel/solid/level_edges.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/planar/winding/wide_products.h"

namespace blossom::minkowski {

using namespace planar;

void LevelEdges::collect(int i, const LoftTime& time) {
  above_ = below_ = -1;
  for (const LoftTime& level : scene_.levels) {
    const int order = compare(level, time);
    if (order <= 0) ++above_;
    if (order < 0) ++below_;
  }
  if (above_ == scene_.slabs()) above_ = -1;
  along_ = {i};
  places_ = {{i, 0}, {i, 1}};
  for (const int k : scene_.near(i)) {
    if (!scene_.counts(k, above_) && !scene_.counts(k, below_)) continue;
    const int from = predicates_.side(i, k, 0, time), to = predicates_.side(i, k, 1, time);
    if (predicates_.turn(i, k) != 0) {
      if (from * to <= 0) places_.push_back({k, -1});
    } else if (from == 0 && predicates_.ahead(i, k, 1, k, 0, time) > 0) {
      along_.push_back(k);
      places_.insert(places_.end(), {{k, 0}, {k, 1}});
    }
  }
  std::sort(along_.begin(), along_.end());
  std::sort(places_.begin(), places_.end(),
            [&](const PlaceOnLine& a, const PlaceOnLine& b) { return scene_.order(i, a, b, time) < 0; });
}

std::vector<int> LevelEdges::covering(int i, const PlaceOnLine& from, const PlaceOnLine& to, const LoftTime& time) const {
  std::vector<int> result;
  for (const int k : along_)
    if (scene_.order(i, {k, 0}, from, time) <= 0 && scene_.order(i, to, {k, 1}, time) <= 0) result.push_back(k);
  return result;
}

bool LevelEdges::isOurs(int i, int partner, const std::vector<int>& covering) const {
  int lowest = -1, lowestOther = -1;
  for (const int k : covering) {
    if (!scene_.facet(k).mayBound) continue;
    if (lowest < 0) lowest = k;
    if (lowestOther < 0 && scene_.facet(k).plane != scene_.facet(i).plane) lowestOther = k;
  }
  return lowest == i && (partner < 0 || lowestOther == partner);
}

/// Whether a moves faster to the left than b while it rises.
bool LevelEdges::steeper(int a, int b) const {
  const LoftFacet &ofA = scene_.facet(a), &ofB = scene_.facet(b);
  const bool flat = std::abs(ofA.along.x) > std::abs(ofA.along.y);
  const Wide sizeA = std::abs(flat ? ofA.along.x : ofA.along.y), sizeB = std::abs(flat ? ofB.along.x : ofB.along.y);
  return compareProducts(ofA.offset[1] - ofA.offset[0], sizeB, ofB.offset[1] - ofB.offset[0], sizeA) > 0;
}

std::pair<bool, bool> LevelEdges::turnOver(std::vector<int> covering, int slab, int winding, bool upwards,
                                           std::vector<HalfPlane>& out) const {
  if (slab < 0) return {false, false};
  std::erase_if(covering, [&](int k) { return !scene_.counts(k, slab); });
  std::sort(covering.begin(), covering.end(), [&](int a, int b) { return upwards ? steeper(a, b) : steeper(b, a); });
  const bool left = winding > 0;
  for (std::size_t k = 0; k < covering.size();) {
    const bool before = winding > 0;
    const LoftFacet& facet = scene_.facet(covering[k]);
    for (; k < covering.size() && scene_.facet(covering[k]).plane == facet.plane; ++k)
      winding -= scene_.facet(covering[k]).count;
    if (before != (winding > 0)) out.push_back({facet.plane, !before, before == upwards});
  }
  return {left, winding > 0};
}

LoftPredicates::Place LevelEdges::placeOf(int i, const PlaceOnLine& place, const LoftTime& time) const {
  return place.end >= 0 ? predicates_.placeOfEnd(place.facet, place.end, time)
                        : predicates_.placeOfMeeting(i, place.facet, time);
}

void LevelEdges::interval(int i, int partner, const PlaceOnLine& from, const PlaceOnLine& to, const LoftTime& time,
                          std::vector<LoftSide>& out) const {
  const std::vector<int> on = covering(i, from, to, time);
  if (!isOurs(i, partner, on)) return;
  std::vector<HalfPlane> bounding;
  const auto windingLeft = [&](int slab) { return slab < 0 ? 0 : scene_.windingBeyond(i, from, time, slab); };
  const auto [leftAbove, rightAbove] = turnOver(on, above_, windingLeft(above_), true, bounding);
  const auto [leftBelow, rightBelow] = turnOver(on, below_, windingLeft(below_), false, bounding);
  if (leftAbove != leftBelow) bounding.push_back({leftAbove ? bottomPlane : topPlane, false, leftBelow});
  if (rightAbove != rightBelow) bounding.push_back({rightAbove ? bottomPlane : topPlane, false, rightAbove});
  if (bounding.empty()) return;
  if ((leftAbove != leftBelow || rightAbove != rightBelow) && above_ >= 0 && below_ >= 0)
    throw Error(ErrorCode::Internal, "The slabs of the solid do not fit on each other.", "Please report the two shapes.");
  const auto sameFace = [](const HalfPlane& a, const HalfPlane& b) {
    return a.plane == b.plane && a.outsideLeft == b.outsideLeft;
  };
  if (bounding.size() == 2 && sameFace(bounding[0], bounding[1])) return;
  const LoftPredicates::Place start = placeOf(i, from, time), end = placeOf(i, to, time);
  for (const HalfPlane& half : bounding)
    out.push_back(half.forward ? LoftSide{start, end, half.plane, half.outsideLeft}
                               : LoftSide{end, start, half.plane, half.outsideLeft});
}

void LevelEdges::line(int i, int partner, const LoftTime& time, std::vector<LoftSide>& out) {
  collect(i, time);
  if (!scene_.counts(i, above_) && !scene_.counts(i, below_)) return;
  const PlaceOnLine first{i, 0}, last{i, 1};
  for (std::size_t k = 0; k + 1 < places_.size(); ++k) {
    const PlaceOnLine &from = places_[k], &to = places_[k + 1];
    if (scene_.order(i, from, to, time) == 0) continue;
    if (scene_.order(i, from, first, time) < 0 || scene_.order(i, last, to, time) < 0) continue;
    interval(i, partner, from, to, time, out);
  }
}

void LevelEdges::find(int i, std::vector<LoftSide>& out, const Progress& progress) {
  const LoftFacet& facet = scene_.facet(i);
  if (facet.from[0] != facet.to[0] && facet.firstSlab == 0) line(i, -1, scene_.levels.front(), out);
  if (facet.from[1] != facet.to[1] && facet.lastSlab == scene_.slabs() - 1) line(i, -1, scene_.levels.back(), out);
  for (const int j : scene_.near(i)) {
    progress.check();
    if (j < i || !scene_.facet(j).mayBound || predicates_.turn(i, j) != 0 || scene_.facet(j).plane == facet.plane) continue;
    const LoftRamp distance = predicates_.distanceRamp(i, j);
    if (distance.signAt(0) * distance.signAt(1) > 0) continue;
    const LoftPredicates::ExactRamp exact = predicates_.exactDistance(i, j);
    if (exact[0].sign() * exact[1].sign() < 0) line(i, j, timeOf(exact[1], Wide512(-exact[0])), out);
  }
}

}  // namespace blossom::minkowski
