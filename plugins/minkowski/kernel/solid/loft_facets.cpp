#include "kernel/solid/loft_facets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "core/error.h"
#include "geometry/planar/winding/convolution.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr std::size_t maximumFacets = 20'000;

GridPoint extentOfLoop(const GridLoop& loop) {
  GridPoint low = loop.front(), high = loop.front();
  for (const GridPoint& p : loop) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return high - low;
}

bool lower(const LoftLevel& a, const LoftLevel& b) { return Wide(a.second) * b.first < Wide(b.second) * a.first; }

LoftLevel reduced(const LoftLevel& level) {
  const std::int64_t divisor = std::gcd(level.first, level.second);
  return {level.first / divisor, level.second / divisor};
}

/// Two loops that are paired between two levels.
struct LoopPair {
  const GridLoop *a, *b;
  LoftLevel from, to;
};

constexpr LoftLevel bottom{1, 0}, top{0, 1};

/// A hole of one set has room for a part of the other while it is strictly larger both ways: (1-t) hole > t part, where the
/// hole belongs to the lower set.
LoftLevel endOfRoom(const GridPoint& hole, const GridPoint& part) {
  const LoftLevel x{part.x, hole.x}, y{part.y, hole.y};
  return reduced(lower(x, y) ? x : y);
}

std::vector<LoopPair> loopPairs(std::span<const GridPolygon> a, std::span<const GridPolygon> b) {
  std::vector<LoopPair> pairs;
  for (const GridPolygon& partA : a)
    for (const GridPolygon& partB : b) {
      pairs.push_back({&partA.outer, &partB.outer, bottom, top});
      for (const GridLoop& hole : partA.holes)
        pairs.push_back({&hole, &partB.outer, bottom, endOfRoom(extentOfLoop(hole), extentOfLoop(partB.outer))});
      for (const GridLoop& hole : partB.holes) {
        const LoftLevel mirrored = endOfRoom(extentOfLoop(hole), extentOfLoop(partA.outer));
        pairs.push_back({&partA.outer, &hole, {mirrored.second, mirrored.first}, top});
      }
    }
  return pairs;
}

std::vector<LoftLevel> levelsOf(const std::vector<LoopPair>& pairs) {
  std::vector<LoftLevel> levels{bottom, top};
  for (const LoopPair& pair : pairs) levels.insert(levels.end(), {pair.from, pair.to});
  std::sort(levels.begin(), levels.end(), lower);
  const auto same = [](const LoftLevel& a, const LoftLevel& b) { return !lower(a, b) && !lower(b, a); };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  return levels;
}

LoftFacet facetOf(const EdgeAtCorner& pair) {
  LoftFacet facet;
  const int edges = pair.edgeOfFirst ? 0 : 1, corners = 1 - edges;
  facet.from[edges] = pair.from;
  facet.to[edges] = pair.to;
  facet.from[corners] = facet.to[corners] = pair.corner;
  facet.along = pair.to - pair.from;
  facet.count = pair.sign;
  facet.mayBound = pair.sign > 0;
  if (facet.along < GridPoint{0, 0}) {
    facet.along = {-facet.along.x, -facet.along.y};
    std::swap(facet.from, facet.to);
    facet.count = -facet.count;
  }
  for (const int end : {0, 1}) facet.offset[end] = cross(facet.along, facet.from[end]);
  return facet;
}

auto placeOf(const LoftFacet& f) { return std::tie(f.from[0], f.from[1], f.to[0], f.to[1], f.firstSlab, f.lastSlab); }

void joinSame(std::vector<LoftFacet>& facets) {
  std::sort(facets.begin(), facets.end(), [](const LoftFacet& a, const LoftFacet& b) { return placeOf(a) < placeOf(b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size();) {
    LoftFacet sum = facets[i];
    for (++i; i < facets.size() && placeOf(facets[i]) == placeOf(sum); ++i) {
      sum.count += facets[i].count;
      sum.mayBound |= facets[i].mayBound;
    }
    if (sum.count != 0) facets[kept++] = sum;
  }
  facets.resize(kept);
}

void numberPlanes(LoftFacets& loft) {
  std::map<std::tuple<GridPoint, Wide, Wide>, int> numbers;
  for (LoftFacet& facet : loft.facets) {
    const std::int64_t divisor = std::gcd(facet.along.x, facet.along.y);  // divides the offsets, too
    const LoftPlane plane{{facet.along.x / divisor, facet.along.y / divisor},
                          {facet.offset[0] / divisor, facet.offset[1] / divisor}};
    const auto [place, isNew] =
        numbers.try_emplace({plane.along, plane.offset[0], plane.offset[1]}, static_cast<int>(loft.planes.size()));
    if (isNew) loft.planes.push_back(plane);
    facet.plane = place->second;
  }
}

}  // namespace

LoftFacets loftFacets(std::span<const GridPolygon> a, std::span<const GridPolygon> b, const Progress& progress) {
  const std::vector<LoopPair> pairs = loopPairs(a, b);
  LoftFacets loft;
  loft.levels = levelsOf(pairs);
  const auto slabFrom = [&](const LoftLevel& level) {
    return static_cast<int>(std::lower_bound(loft.levels.begin(), loft.levels.end(), level, lower) - loft.levels.begin());
  };
  for (const LoopPair& pair : pairs) {
    if (!lower(pair.from, pair.to)) continue;
    for (const EdgeAtCorner& edge : pairsOf(*pair.a, *pair.b, progress)) {
      loft.facets.push_back(facetOf(edge));
      loft.facets.back().firstSlab = slabFrom(pair.from);
      loft.facets.back().lastSlab = slabFrom(pair.to) - 1;
    }
    if (loft.facets.size() > 4 * maximumFacets) joinSame(loft.facets);
    if (loft.facets.size() > 4 * maximumFacets) break;
  }
  joinSame(loft.facets);
  if (loft.facets.size() > maximumFacets)
    throw Error(ErrorCode::LimitExceeded,
                "The solid between these shapes has more than 20,000 facets before it is resolved.",
                "Raise the tolerance, so that curves get fewer corners, or simplify the outlines.");
  numberPlanes(loft);
  return loft;
}

}  // namespace blossom::minkowski
