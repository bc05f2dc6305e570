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

/// A part of the work that is done beside others, always of the same size: what it finds does not depend on threads.
struct Part {
  std::unique_ptr<Points> points;
  std::vector<Meeting> found;
};
constexpr std::size_t facetsOfPart = 32;

/// All facets, to be asked for those that come near one.
struct NearFacets {
  std::vector<Box3> boxes;
  BoxTree<3> tree;

  NearFacets(const std::vector<Facet>& facets, const Points& points, const Progress& progress) : boxes(facets.size()) {
    parallelFor(facets.size(), 1024, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) boxes[k] = boxOf(facets[k], points);
    });
    tree = BoxTree<3>(boxes, 4, progress);
  }
};

/// Meetings of some facets with those of a higher number.
Part meetingsOf(std::span<const std::uint32_t> some, const NearFacets& near, const std::vector<Facet>& facets,
                const Planes& planes, const Points& points, const Progress& progress) {
  Part part{std::make_unique<Points>(planes, &points), {}};
  PairOfFacets pair(planes, *part.points);
  const auto test = [&](std::size_t i, std::size_t j) {
    const auto common = pair.common(facets[i], facets[j]);
    if (!common) return;
    for (const int end : *common) {
      part.points->note(end, facets[i].plane);
      part.points->note(end, facets[j].plane);
    }
    part.found.push_back({(*common)[0], (*common)[1], static_cast<int>(i), static_cast<int>(j)});
  };
  for (const std::uint32_t i : some) {
    std::size_t count = 0;
    const auto visit = [&](std::size_t j) {
      if (++count % 1024 == 0) progress.check();
      if (near.boxes[i].intersects(near.boxes[j])) test(i, j);
    };
    near.tree.meeting(near.boxes[i], visit, i + 1);
  }
  return part;
}

/// @param some facets that lie near each other
void addMeetings(std::span<const std::uint32_t> some, const NearFacets& near, const std::vector<Facet>& facets,
                 const Planes& planes, Points& points, std::vector<Meeting>& found, const Progress& progress) {
  std::vector<Part> parts((some.size() + facetsOfPart - 1) / facetsOfPart);
  parallelFor(parts.size(), 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const std::size_t from = k * facetsOfPart, count = std::min(facetsOfPart, some.size() - from);
      parts[k] = meetingsOf(some.subspan(from, count), near, facets, planes, points, progress);
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
  }
  parallelFor(parts.size(), 16, progress, [&](std::size_t first, std::size_t last) {  // freeing takes a while, too
    for (std::size_t k = first; k < last; ++k) parts[k] = {};
  });
}

}  // namespace

std::vector<Meeting> meetings(const std::vector<Facet>& facets, const Planes& planes, Points& points,
                              const Progress& progress) {
  const NearFacets near(facets, points, progress);
  const std::span<const std::uint32_t> order = near.tree.order();
  std::vector<Meeting> found;
  constexpr std::size_t atATime = 256 * facetsOfPart;  // what is found of them is kept apart until all are done
  for (std::size_t first = 0; first < order.size(); first += atATime)
    addMeetings(order.subspan(first, std::min(atATime, order.size() - first)), near, facets, planes, points, found,
                progress);
  return found;
}

}  // namespace blossom::morphology::arrangement
