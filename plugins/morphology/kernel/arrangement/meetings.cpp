#include "kernel/arrangement/meetings.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "geometry/numeric/box_tree.h"

namespace blossom::morphology::arrangement {

namespace {

using Interval = std::array<int, 2>;  // two points of a line

Box3 boxOf(const Facet& facet, const Points& points) {
  Box3 box;
  for (std::size_t k = 0; k < facet.count; ++k) box.extend(inDoubles(points.grid(facet.corners[k])));
  return box;
}

/// Whether two convex polygons have a whole edge of both in common.
bool shareEdge(const Facet& f, const Facet& g) {
  for (std::size_t i = 0; i < f.count; ++i)
    for (std::size_t j = 0; j < g.count; ++j) {
      if (f.corner(i) == g.corner(j + 1) && f.corner(i + 1) == g.corner(j)) return true;
      if (f.corner(i) == g.corner(j) && f.corner(i + 1) == g.corner(j + 1)) return true;
    }
  return false;
}

bool isCorner(const Facet& facet, int point) {
  return std::find(facet.corners.begin(), facet.corners.begin() + static_cast<std::ptrdiff_t>(facet.count), point) !=
         facet.corners.begin() + static_cast<std::ptrdiff_t>(facet.count);
}

class PairOfFacets {
 public:
  PairOfFacets(const Planes& planes, Points& points) : planes_(planes), points_(points) {}

  [[nodiscard]] std::optional<Interval> common(const Facet& f, const Facet& g) {
    if (f.plane == g.plane || shareEdge(f, g)) return std::nullopt;
    const auto sidesOfF = sides(f, g.plane);
    if (!sidesOfF) return std::nullopt;
    const auto sidesOfG = sides(g, f.plane);
    if (!sidesOfG) return std::nullopt;
    const auto inF = section(f, *sidesOfF, g.plane), inG = section(g, *sidesOfG, f.plane);
    if (!inF || !inG) return std::nullopt;
    const auto both = overlap(*inF, *inG, planes_.line(f.plane, g.plane).axis);
    if (both && (*both)[0] == (*both)[1] && isCorner(f, (*both)[0]) && isCorner(g, (*both)[0])) return std::nullopt;
    return both;
  }

 private:
  using Sides = std::array<int, 4>;

  /// Of the corners; nothing when all lie on one side.
  std::optional<Sides> sides(const Facet& facet, int plane) {
    Sides sides{};
    bool above = false, below = false;
    bool on = false;
    for (std::size_t k = 0; k < facet.count; ++k) {
      sides[k] = points_.side(plane, facet.corners[k]);
      above = above || sides[k] > 0;
      below = below || sides[k] < 0;
      on = on || sides[k] == 0;
    }
    if (!(above && below) && !on) return std::nullopt;
    return sides;
  }

  /// What a facet has of another plane.
  std::optional<Interval> section(const Facet& facet, const Sides& sides, int plane) {
    Interval ends{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < facet.count && count < 2; ++k) {
      const std::size_t l = (k + 1) % facet.count;
      if (sides[k] == 0) {
        ends[count++] = facet.corners[k];
      } else if (sides[k] * sides[l] < 0) {
        ends[count] = points_.onEdge(facet.corners[k], facet.corners[l], plane);
        points_.note(ends[count++], facet.plane);
      }
    }
    if (count == 0) return std::nullopt;
    if (count == 1) ends[1] = ends[0];
    return ends;
  }

  std::optional<Interval> overlap(Interval a, Interval b, std::size_t axis) {
    if (points_.order(axis, a[0], a[1]) < 0) std::swap(a[0], a[1]);
    if (points_.order(axis, b[0], b[1]) < 0) std::swap(b[0], b[1]);
    const int from = points_.order(axis, a[0], b[0]) > 0 ? b[0] : a[0],
              to = points_.order(axis, a[1], b[1]) < 0 ? b[1] : a[1];
    if (points_.order(axis, from, to) < 0) return std::nullopt;
    return Interval{from, to};
  }

  const Planes& planes_;
  Points& points_;
};

using FacetPair = std::pair<std::size_t, std::size_t>;

/// A part of the work that is done beside others, always of the same size: what it finds does not depend on threads.
struct Part {
  std::unique_ptr<Points> points;
  std::vector<Meeting> found;
};
constexpr std::size_t pairsOfPart = 1024;

Part meetingsOf(std::span<const FacetPair> pairs, const std::vector<Facet>& facets, const Planes& planes,
                const Points& points, const Progress& progress) {
  Part part{std::make_unique<Points>(planes, &points), {}};
  PairOfFacets pair(planes, *part.points);
  std::size_t count = 0;
  for (const auto& [i, j] : pairs) {
    if (++count % 128 == 0) progress.check();
    const auto common = pair.common(facets[i], facets[j]);
    if (!common) continue;
    for (const int end : *common) {
      part.points->note(end, facets[i].plane);
      part.points->note(end, facets[j].plane);
    }
    part.found.push_back({(*common)[0], (*common)[1], static_cast<int>(i), static_cast<int>(j)});
  }
  return part;
}

constexpr std::size_t pairsAtATime = 256 * pairsOfPart;  // there may be many more than meet

void addMeetings(const std::vector<FacetPair>& pairs, const std::vector<Facet>& facets, const Planes& planes, Points& points,
                 std::vector<Meeting>& found, const Progress& progress) {
  std::vector<Part> parts((pairs.size() + pairsOfPart - 1) / pairsOfPart);
  parallelFor(parts.size(), 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const std::size_t from = k * pairsOfPart, count = std::min(pairsOfPart, pairs.size() - from);
      parts[k] = meetingsOf({pairs.data() + from, count}, facets, planes, points, progress);
    }
  });
  const auto samePlane = [](int plane) { return plane; };
  for (Part& part : parts) {
    progress.check();
    points.takeNotes(*part.points, static_cast<int>(planes.size()));
    for (Meeting meeting : part.found) {
      meeting.from = points.take(*part.points, meeting.from, samePlane);
      meeting.to = points.take(*part.points, meeting.to, samePlane);
      found.push_back(meeting);
    }
    part = {};
  }
}

}  // namespace

std::vector<Meeting> meetings(const std::vector<Facet>& facets, const Planes& planes, Points& points,
                              const Progress& progress) {
  std::vector<Box3> boxes;
  boxes.reserve(facets.size());
  for (const Facet& facet : facets) boxes.push_back(boxOf(facet, points));
  std::vector<Meeting> found;
  std::vector<FacetPair> pairs;
  forEachNearPair<3>(boxes, 0.0, progress, [&](std::size_t i, std::size_t j) {
    pairs.emplace_back(i, j);
    if (pairs.size() == pairsAtATime) {
      addMeetings(pairs, facets, planes, points, found, progress);
      pairs.clear();
    }
    return true;
  });
  addMeetings(pairs, facets, planes, points, found, progress);
  return found;
}

}  // namespace blossom::morphology::arrangement
