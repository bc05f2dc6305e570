#include "kernel/arrangement/cells.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

#include "core/parallel.h"
#include "geometry/numeric/boxes.h"
#include "geometry/numeric/union_find.h"

namespace blossom::morphology::arrangement {

namespace {

/// A tile at an edge, seen along the edge from its lower point to its higher one.
struct AtEdge {
  int low = 0, high = 0;
  int plane = 0;
  int turned = 1;  ///< 1 where counter-clockwise around the edge is where the normal of the plane points to, -1 else
  bool outwardAhead = true;  ///< outward is counter-clockwise around the edge
  int patch = 0;
};

/// Those of one edge after each other. @param points how many there are
std::vector<AtEdge> tilesAtEdges(const std::vector<Tile>& tiles, std::size_t points, const Progress& progress) {
  std::vector<AtEdge> found;
  found.reserve(4 * tiles.size());
  for (const Tile& tile : tiles)
    for (std::size_t k = 0; k < tile.corners.size(); ++k) {
      if (!tile.isCut[k]) continue;
      const int from = tile.corners[k], to = tile.corners[(k + 1) % tile.corners.size()];
      const int turned = from < to ? 1 : -1;
      found.push_back(
          {std::min(from, to), std::max(from, to), tile.plane, turned, (turned > 0) == tile.sameWay, tile.patch});
    }
  std::vector<std::size_t> starts(points + 1, 0);  // of the edges with each lower point
  for (const AtEdge& each : found) ++starts[static_cast<std::size_t>(each.low) + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<AtEdge> sorted(found.size());
  std::vector<std::size_t> next = starts;
  for (const AtEdge& each : found) sorted[next[static_cast<std::size_t>(each.low)]++] = each;
  parallelFor(points, 1024, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p)
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(starts[p]),
                sorted.begin() + static_cast<std::ptrdiff_t>(starts[p + 1]),
                [](const AtEdge& a, const AtEdge& b) { return a.high < b.high; });
  });
  return sorted;
}

/// Puts the tiles around edges in their order.
class Fan {
 public:
  Fan(const Planes& planes, Points& points) : planes_(planes), points_(points) {}

  void sort(std::span<AtEdge> tiles) {
    if (tiles.size() < 3) return;
    // Along any axis along which the edge has a length; how long it seems in doubles does not matter.
    for (axis_ = 0; axis_ < 2; ++axis_)
      if (points_.order(axis_, tiles[0].low, tiles[0].high) != 0) break;
    way_ = points_.order(axis_, tiles[0].low, tiles[0].high);
    const AtEdge first = tiles[0];
    std::sort(tiles.begin() + 1, tiles.end(), [&](const AtEdge& a, const AtEdge& b) {
      const int halfA = half(first, a), halfB = half(first, b);
      if (halfA != halfB) return halfA < halfB;
      return halfA != 1 && (halfA == 0 || halfA == 2) && turn(a, b) > 0;
    });
  }

 private:
  /// Whether counter-clockwise from a, b comes within half a turn: 1; -1: clockwise; 0: both lie in one plane.
  int turn(const AtEdge& a, const AtEdge& b) {
    return a.plane == b.plane ? 0 : a.turned * b.turned * way_ * planes_.crossSign(a.plane, b.plane, axis_);
  }
  /// 0: in the first half turn, 1: opposite, 2: in the second half.
  int half(const AtEdge& first, const AtEdge& other) {
    const int sign = turn(first, other);
    return sign > 0 ? 0 : sign == 0 ? 1 : 2;
  }

  const Planes& planes_;
  Points& points_;
  std::size_t axis_ = 0;
  int way_ = 1;
};

/// The class of what lies behind all patches. (Patch 0 stands for it.)
constexpr std::size_t inside = 0;

/// Where the tiles of each edge begin, and the end.
std::vector<std::size_t> edgesOf(const std::vector<AtEdge>& tiles) {
  std::vector<std::size_t> starts;
  for (std::size_t k = 0; k < tiles.size(); ++k)
    if (k == 0 || tiles[k - 1].low != tiles[k].low || tiles[k - 1].high != tiles[k].high) starts.push_back(k);
  starts.push_back(tiles.size());
  return starts;
}

void uniteAroundEdges(std::vector<AtEdge> tiles, const Planes& planes, const Points& points, UnionFind& classes,
                      const Progress& progress) {
  const std::vector<std::size_t> starts = edgesOf(tiles);
  const auto around = [&](std::size_t edge) {
    return std::span(tiles).subspan(starts[edge], starts[edge + 1] - starts[edge]);
  };
  parallelFor(starts.size() - 1, 256, progress, [&](std::size_t first, std::size_t last) {
    Points here(planes, &points);  // what one thread computes of points stays with it
    Fan fan(planes, here);
    for (std::size_t edge = first; edge < last; ++edge) fan.sort(around(edge));
  });
  for (std::size_t edge = 0; edge + 1 < starts.size(); ++edge) {
    const std::span<const AtEdge> fan = around(edge);
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const AtEdge &a = fan[k], &b = fan[(k + 1) % fan.size()];
      classes.unite(a.outwardAhead ? static_cast<std::size_t>(a.patch) : inside,
                    b.outwardAhead ? inside : static_cast<std::size_t>(b.patch));
    }
  }
}

/// A height above a place in the plane of two axes, as a fraction.
struct Height {
  Bounded about;
  Whole numerator, denominator;  ///< the denominator is above 0

  friend int compared(const Height& a, const Height& b) {
    const Bounded apart = a.about - b.about;
    if (apart.decided()) return signOf(apart.value);
    return signOf(Whole(a.numerator * b.denominator - b.numerator * a.denominator));
  }
};

/// Looks along rays parallel to an axis for what lies before a patch.
class Shells {
 public:
  Shells(const std::vector<Tile>& tiles, const Planes& planes, Points& points, UnionFind& classes, const SumSpace& sum,
         const Progress& progress)
      : tiles_(tiles), planes_(planes), points_(points), classes_(classes), sum_(sum), boxes_(tiles.size()) {
    const auto cornersOf = [&](const Tile& tile) {
      Box3 box;
      for (const int c : tile.corners) {
        const Bounded3& p = points.about(c);
        box.extend(Eigen::Vector3d(p[0].value, p[1].value, p[2].value));
      }
      return box;
    };
    parallelFor(tiles.size(), 1024, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) boxes_[t] = cornersOf(tiles[t]);
    });
  }

  /// Whether the space before the patches of a class is outside, by rays from some of its tiles; nothing when the class was
  /// united with another one.
  std::optional<bool> isOutside(const std::vector<std::size_t>& tiles) {
    std::optional<Ray> within;
    for (const std::size_t tile : tiles) {
      const auto ray = rayFrom(tile);
      if (!ray) continue;
      if (!ray->hit) return sum_.isBounded;
      if (facesAway(*ray)) return false;
      if (unites(*ray)) return std::nullopt;
      if (!within || roomOf(*ray) > roomOf(*within)) within = ray;
    }
    // Thinner than the grid everywhere, it is nothing.
    return within && isRoom(*within);
  }

  /// Tiles of each class that send rays: some from which these are likely to leave the sum, and the largest ones, before
  /// which there is most room.
  [[nodiscard]] std::vector<std::vector<std::size_t>> senders(std::size_t patches) const {
    Box3 all;
    for (const Box3& box : boxes_) all.extend(box);
    const auto leaving = best(patches, [&](std::size_t t) {
      const auto axis = static_cast<Eigen::Index>(planes_[tiles_[t].plane].axis);
      const double middle = boxes_[t].center()[axis];
      const double left = looksUp(tiles_[t]) ? all.max()[axis] - middle : middle - all.min()[axis];
      return left - boxes_[t].sizes().norm() / 2;
    });
    auto chosen = best(patches, [&](std::size_t t) { return -boxes_[t].sizes().norm(); });
    for (std::size_t c = 0; c < patches; ++c) chosen[c].insert(chosen[c].begin(), leaving[c].begin(), leaving[c].end());
    return chosen;
  }

 private:
  static constexpr std::size_t mostRays = 6;  ///< of one class and one kind

  /// The tiles of each class with the lowest measures.
  template <class Measure>
  [[nodiscard]] std::vector<std::vector<std::size_t>> best(std::size_t patches, const Measure& measure) const {
    using Measured = std::pair<double, std::size_t>;
    std::vector<std::vector<Measured>> lowest(patches);  // of each class, in order
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
      std::vector<Measured>& here = lowest[classes_.find(static_cast<std::size_t>(tiles_[t].patch))];
      const Measured made(measure(t), t);
      if (here.size() == mostRays && !(made < here.back())) continue;
      if (here.size() == mostRays) here.pop_back();
      here.insert(std::upper_bound(here.begin(), here.end(), made), made);
    }
    std::vector<std::vector<std::size_t>> chosen(patches);
    for (std::size_t c = 0; c < patches; ++c)
      for (const Measured& each : lowest[c]) chosen[c].push_back(each.second);
    return chosen;
  }

  struct Ray {
    std::size_t tile = 0;
    std::size_t axis = 0;
    bool up = true;
    Grid3 place{};
    Height start;
    std::optional<std::size_t> hit;
    Height end;
  };

  Height heightAt(int plane, const Grid3& place, std::size_t axis) const {
    const Plane& there = planes_[plane];
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Grid3 d = place - there.point;
    Height height;
    height.about =
        exactly(there.point[axis]) - (there.about[i] * exactly(d[i]) + there.about[j] * exactly(d[j])) / there.about[axis];
    height.denominator = there.normal[axis];
    height.numerator =
        Whole(there.normal[axis]) * there.point[axis] - Whole(there.normal[i]) * d[i] - Whole(there.normal[j]) * d[j];
    if (height.denominator < 0) {
      height.denominator = -height.denominator;
      height.numerator = -height.numerator;
    }
    return height;
  }

  /// Whether a place lies within a tile seen along an axis: 1; -1: it does not; 0: on its edge, or the tile is seen from the
  /// side.
  int covers(const Tile& tile, int place, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    bool left = false, right = false, on = false;
    for (std::size_t k = 0; k < tile.corners.size(); ++k) {
      const int sign = points_.turn(u, v, tile.corners[k], tile.corners[(k + 1) % tile.corners.size()], place);
      left = left || sign > 0;
      right = right || sign < 0;
      on = on || sign == 0;
      if (left && right) return -1;
    }
    return on ? 0 : 1;
  }

  /// Outward along the axis of the plane of a tile; nothing when no ray was found that meets no edge.
  std::optional<Ray> rayFrom(std::size_t from) {
    for (int trial = 0; trial < 8; ++trial)
      if (auto ray = rayFrom(from, trial)) return ray;
    return std::nullopt;
  }
  std::optional<Ray> rayFrom(std::size_t from, int trial) {
    const Tile& tile = tiles_[from];
    Ray ray;
    ray.tile = from;
    ray.axis = planes_[tile.plane].axis;
    ray.up = looksUp(tile);
    std::array<double, 3> sum{};
    double weights = 0;
    for (std::size_t k = 0; k < tile.corners.size(); ++k) {
      random_ = random_ * 6364136223846793005ULL + 1442695040888963407ULL;
      const double weight = 1 + (trial == 0 ? 0.0 : static_cast<double>(random_ >> 40) / 1e6);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * points_.about(tile.corners[k])[i].value;
      weights += weight;
    }
    for (std::size_t i = 0; i < 3; ++i) ray.place[i] = i == ray.axis ? 0 : std::llround(sum[i] / weights);
    const int place = points_.at(ray.place);
    if (covers(tile, place, ray.axis) != 1) return std::nullopt;
    ray.start = heightAt(tile.plane, ray.place, ray.axis);
    for (std::size_t t = 0; t < tiles_.size(); ++t)
      if (t != from && !meets(ray, place, t)) return std::nullopt;
    return ray;
  }

  /// Notes a tile that the ray meets nearer than those before. @returns false when it meets its edge
  bool meets(Ray& ray, int place, std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == ray.axis) continue;
      const auto value = static_cast<double>(ray.place[k]);
      const auto i = static_cast<Eigen::Index>(k);
      if (boxes_[t].min()[i] - blur > value || boxes_[t].max()[i] + blur < value) return true;
    }
    const Tile& tile = tiles_[t];
    const int covered = covers(tile, place, ray.axis);
    if (covered < 0) return true;
    if (covered == 0) return false;
    const Height height = heightAt(tile.plane, ray.place, ray.axis);
    const int way = ray.up ? 1 : -1;
    const int ahead = way * compared(height, ray.start);
    if (ahead < 0) return true;
    if (ahead == 0) return false;
    if (ray.hit && way * compared(height, ray.end) >= 0) return true;
    ray.hit = t;
    ray.end = height;
    return true;
  }
  /// Whether a tile faces the higher side of the axis along which its plane is drawn.
  [[nodiscard]] bool looksUp(const Tile& tile) const {
    const Plane& plane = planes_[tile.plane];
    return (plane.normal[plane.axis] > 0) == tile.sameWay;
  }

  /// Whether the ray meets a tile from behind, where the sum is.
  [[nodiscard]] bool facesAway(const Ray& ray) const {
    const Tile& hit = tiles_[*ray.hit];
    return hit.patch == 0 || ((planes_[hit.plane].normal[ray.axis] > 0) == hit.sameWay) == ray.up;
  }
  /// What is before both tiles is one cell.
  bool unites(const Ray& ray) {
    const auto mine = static_cast<std::size_t>(tiles_[ray.tile].patch),
               other = static_cast<std::size_t>(tiles_[*ray.hit].patch);
    if (classes_.find(mine) == classes_.find(other)) return false;
    classes_.unite(mine, other);
    return true;
  }
  static double roomOf(const Ray& ray) { return std::abs(ray.end.about.value - ray.start.about.value); }
  [[nodiscard]] bool isRoom(const Ray& ray) const {
    constexpr double leastRoom = 0.1 * blur;  // above it the middle lies between both tiles in doubles, too
    if (roomOf(ray) < leastRoom) return false;
    Grid3 place = ray.place;
    place[ray.axis] = std::llround((ray.start.about.value + ray.end.about.value) / 2);
    return !sum_.holds(place);
  }

  const std::vector<Tile>& tiles_;
  const Planes& planes_;
  Points& points_;
  UnionFind& classes_;
  const SumSpace& sum_;
  std::vector<Box3> boxes_;
  std::uint64_t random_ = 1;
};

}  // namespace

std::vector<bool> boundingPatches(const std::vector<Tile>& tiles, std::size_t patches, const Planes& planes, Points& points,
                                  const SumSpace& sum, const Progress& progress) {
  UnionFind classes(patches);
  uniteAroundEdges(tilesAtEdges(tiles, points.size(), progress), planes, points, classes, progress);
  Shells shells(tiles, planes, points, classes, sum, progress);
  std::vector<bool> outside(patches, false);
  for (bool united = true; united;) {
    united = false;
    const auto senders = shells.senders(patches);
    for (std::size_t c = 1; c < patches && !united; ++c) {
      if (classes.find(c) != c || senders[c].empty()) continue;
      progress.check();
      const auto answer = shells.isOutside(senders[c]);
      united = !answer;
      outside[c] = answer.value_or(false);
    }
  }
  std::vector<bool> bounding(patches);
  for (std::size_t p = 0; p < patches; ++p) bounding[p] = outside[classes.find(p)];
  return bounding;
}

}  // namespace blossom::morphology::arrangement
