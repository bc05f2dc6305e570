#include "kernel/arrangement/arranged_sum.h"

#include <bit>
#include <memory>
#include <set>
#include <span>

#include "core/parallel.h"
#include "core/stopwatch.h"
#include "kernel/arrangement/candidates.h"
#include "kernel/arrangement/cells.h"
#include "kernel/arrangement/meetings.h"
#include "kernel/arrangement/membership.h"
#include "kernel/arrangement/number_table.h"
#include "kernel/arrangement/plane_map.h"
#include "kernel/arrangement/tight_faces.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology {

using namespace arrangement;

namespace {

/// The facets of one plane and where others meet them.
struct Group {
  std::vector<const Facet*> facets;
  std::vector<const Meeting*> meetings;
  std::vector<int> others;  ///< the other plane of each meeting
};

std::vector<Group> groupsByPlane(const std::vector<Facet>& facets, const std::vector<Meeting>& found, const Planes& planes) {
  std::vector<Group> groups(planes.size());
  const auto groupOf = [&](int facet) -> Group& {
    return groups[static_cast<std::size_t>(facets[static_cast<std::size_t>(facet)].plane)];
  };
  for (const Facet& facet : facets) groups[static_cast<std::size_t>(facet.plane)].facets.push_back(&facet);
  for (const Meeting& meeting : found)
    for (const auto& [here, there] : {std::pair{meeting.first, meeting.second}, {meeting.second, meeting.first}}) {
      groupOf(here).meetings.push_back(&meeting);
      groupOf(here).others.push_back(facets[static_cast<std::size_t>(there)].plane);
    }
  return groups;
}

/// A plane divided beside the others, with the planes and points that this has added.
struct DividedPlane {
  std::unique_ptr<Planes> planes;
  std::unique_ptr<Points> points;
  PlaneMap::Divided map;
};

DividedPlane dividedPlane(int plane, const Group& group, const Planes& planes, const Points& points) {
  DividedPlane made;
  made.planes = std::make_unique<Planes>(&planes);
  made.points = std::make_unique<Points>(*made.planes, &points);
  PlaneMap map(plane, group.facets, *made.planes, *made.points);
  for (std::size_t k = 0; k < group.meetings.size(); ++k)
    map.cut(group.meetings[k]->from, group.meetings[k]->to, group.others[k]);
  made.map = map.divided();
  return made;
}

/// Tiles of all planes. Patch 0 stands for what has the sum on both sides.
class Tiling {
 public:
  Tiling(Planes& planes, Points& points) : planes_(planes), points_(points) {}

  /// Some planes at a time, which are divided beside each other: what is made of them does not depend on threads.
  void add(const std::vector<Group>& groups, const Progress& progress) {
    constexpr std::size_t atATime = 4096;
    for (std::size_t first = 0; first < groups.size(); first += atATime)
      add(std::span(groups).subspan(first, std::min(atATime, groups.size() - first)), static_cast<int>(first), progress);
  }

  [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }
  [[nodiscard]] std::size_t patches() const { return static_cast<std::size_t>(patches_); }

 private:
  void add(std::span<const Group> groups, int firstPlane, const Progress& progress) {
    std::vector<DividedPlane> divided(groups.size());
    parallelFor(groups.size(), 8, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        progress.check();
        if (!isWhole(groups[k]) && !groups[k].facets.empty())
          divided[k] = dividedPlane(firstPlane + static_cast<int>(k), groups[k], planes_, points_);
      }
    });
    for (std::size_t k = 0; k < groups.size(); ++k) {
      progress.check();
      if (isWhole(groups[k])) addWhole(*groups[k].facets.front());
      if (divided[k].points) addDivided(firstPlane + static_cast<int>(k), divided[k]);
    }
    // To free them takes a tenth of the time.
    parallelFor(divided.size(), 64, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) divided[k] = {};
    });
  }

  static bool isWhole(const Group& group) { return group.facets.size() == 1 && group.meetings.empty(); }

  void addWhole(const Facet& facet) {
    Tile tile{facet.plane, facet.sameWay, patches_++, {}, std::vector<bool>(facet.count, true)};
    tile.corners.assign(facet.corners.begin(), facet.corners.begin() + static_cast<std::ptrdiff_t>(facet.count));
    if (!facet.sameWay) std::reverse(tile.corners.begin(), tile.corners.end());
    tiles_.push_back(std::move(tile));
  }

  void addDivided(int plane, DividedPlane& divided) {
    std::vector<int> patchOf(divided.map.covers.size(), 0);
    for (std::size_t p = 0; p < patchOf.size(); ++p) {
      const Cover& cover = divided.map.covers[p];
      if ((cover.sameWay > 0) != (cover.otherWay > 0)) patchOf[p] = patches_++;
    }
    const auto planeHere = [&](int number) { return planes_.take(*divided.planes, number); };
    points_.takeNotes(*divided.points, divided.planes->sizeOfBase());
    for (const PlaneMap::Piece& piece : divided.map.pieces) {
      const auto patch = static_cast<std::size_t>(piece.patch);
      const Cover& cover = divided.map.covers[patch];
      if (cover.sameWay == 0 && cover.otherWay == 0) continue;
      Tile tile{plane, cover.sameWay > 0, patchOf[patch], {}, {}};
      for (const int corner : piece.corners) tile.corners.push_back(points_.take(*divided.points, corner, planeHere));
      tile.isCut.assign(piece.isCut.begin(), piece.isCut.end());
      tiles_.push_back(std::move(tile));
    }
  }

  Planes& planes_;
  Points& points_;
  std::vector<Tile> tiles_;
  int patches_ = 1;
};

/// The points of the tiles that count, in the order of first use.
std::vector<int> pointsOf(const std::vector<Tile>& tiles, const std::vector<bool>& counts, std::size_t points) {
  std::vector<bool> seen(points, false);
  std::vector<int> used;
  for (const Tile& tile : tiles)
    for (const int corner : tile.corners) {
      if (!counts[static_cast<std::size_t>(tile.patch)] || seen[static_cast<std::size_t>(corner)]) continue;
      seen[static_cast<std::size_t>(corner)] = true;
      used.push_back(corner);
    }
  return used;
}

/// Points as the corners of a mesh: rounded to doubles, those that this makes equal as one.
struct RoundedCorners {
  std::vector<Vec3> corners;
  std::vector<int> index;  ///< by point

  RoundedCorners(const std::vector<int>& used, const Planes& planes, const Points& points, double step,
                 const Progress& progress)
      : index(points.size(), -1) {
    using Place = std::array<double, 3>;
    std::vector<Place> places(used.size());
    parallelFor(used.size(), 1024, progress, [&](std::size_t first, std::size_t last) {
      Points here(planes, &points);
      for (std::size_t k = first; k < last; ++k) places[k] = here.nearest(used[k]);
    });
    NumberTable byPlace;
    for (std::size_t k = 0; k < used.size(); ++k) {
      const Place& place = places[k];
      std::uint64_t hash = 0;
      for (const double x : place) hash = mixedHash(hash, std::bit_cast<std::uint64_t>(x + 0.0));
      const int known = byPlace.find(hash, [&](int other) { return places[static_cast<std::size_t>(other)] == place; });
      int& number = index[static_cast<std::size_t>(used[k])];
      if (known >= 0) {
        number = index[static_cast<std::size_t>(used[static_cast<std::size_t>(known)])];
        continue;
      }
      byPlace.add(hash, static_cast<int>(k));
      number = static_cast<int>(corners.size());
      corners.push_back(step * Vec3(place[0], place[1], place[2]));
    }
  }
};

/// Triangles of the tiles whose patches bound the sum, those of the space outside of it when it is `turned`.
Mesh bounding(const std::vector<Tile>& tiles, const std::vector<bool>& bounds, RoundedCorners rounded, bool turned) {
  Mesh mesh;
  const auto of = [&](int point) { return rounded.index[static_cast<std::size_t>(point)]; };
  for (const Tile& tile : tiles) {
    if (!bounds[static_cast<std::size_t>(tile.patch)]) continue;
    for (std::size_t k = 1; k + 1 < tile.corners.size(); ++k) {
      std::array<int, 3> corners{of(tile.corners[0]), of(tile.corners[k]), of(tile.corners[k + 1])};
      if (tile.sameWay == turned) std::swap(corners[1], corners[2]);
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) mesh.addFace(corners);
    }
  }
  mesh.points = std::move(rounded.corners);
  return mesh;
}

/// One shape, and its pieces when it is thin.
struct Summand {
  Features whole;
  std::vector<Features> pieces;
};

std::optional<Summand> shapeOf(const Term& term, double step, bool insideOut = false) {
  Summand shape;
  if (term.triangles.faceCount() > 0) {
    auto features = featuresOf(term.triangles, term.factor, step, insideOut);
    if (!features) return std::nullopt;
    shape.whole = *std::move(features);
    return shape;
  }
  shape.whole = featuresOf(term.pieces, term.factor, step);
  for (const auto& piece : term.pieces) shape.pieces.push_back(featuresOf({&piece, 1}, term.factor, step));
  return shape;
}

struct Summands {
  Summand first, second;
};

/// Both beside each other.
std::optional<Summands> shapesOf(const Term& a, const Term& b, double step, const Progress& progress,
                                 bool insideOut = false) {
  std::optional<Summand> first, second;
  sideBySide(
      progress, [&] { first = shapeOf(a, step, insideOut); }, [&] { second = shapeOf(b, step); });
  if (!first || !second) return std::nullopt;
  return Summands{*std::move(first), *std::move(second)};
}

/// Whether the sum of two thin pieces has volume: three of their edges point in independent directions.
bool haveVolume(const Features& a, const Features& b) {
  std::vector<Grid3> along;
  for (const Features* piece : {&a, &b})
    for (const Features::Edge& edge : piece->edges)
      along.push_back(piece->points[static_cast<std::size_t>(edge.to)] - piece->points[static_cast<std::size_t>(edge.from)]);
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (dot(cross(along[i], along[j]), along[k]) != 0) return true;
  return false;
}

enum class DeepOnes { LeftOut, Kept };

/// Whether so many pairs are worth a core, which takes some milliseconds.
bool areMany(const FeaturePairs& pairs) {
  constexpr std::size_t many = 3000;
  return pairs.facesAndCorners.size() + pairs.cornersAndFaces.size() + pairs.edges.size() > many;
}

/// Behind the facets of two thin pieces there is their sum only when it has volume. Of a complement there are no pieces.
Candidates candidatesOf(const Summand& a, const Summand& b, Planes& planes, Points& points, bool insideOut, DeepOnes deep,
                        const FeaturePairs* kept, const Progress& progress) {
  const auto ofPairs = [&](const FeaturePairs& pairs) {
    std::optional<SumCore> core;
    if (deep == DeepOnes::LeftOut && areMany(pairs)) core.emplace(a.whole, b.whole, insideOut, progress);
    return candidates(a.whole, b.whole, pairs, core ? &*core : nullptr, planes, points, progress);
  };
  if (kept) return ofPairs(*kept);
  if (a.pieces.empty() || b.pieces.empty()) {
    FeaturePairs pairs = nearPairs(a.whole, b.whole, 0, progress);
    if (insideOut) leaveOutTightFaces(pairs, a.whole, b.whole);
    return ofPairs(pairs);
  }
  Candidates all;
  for (const Features& p : a.pieces)
    for (const Features& q : b.pieces) {
      if (!haveVolume(p, q)) continue;
      const Candidates more = candidates(p, q, nearPairs(p, q, 0, progress), nullptr, planes, points, progress);
      all.facets.insert(all.facets.end(), more.facets.begin(), more.facets.end());
      for (std::size_t family = 0; family < more.found.size(); ++family) all.found[family] += more.found[family];
    }
  return all;
}

ArrangedSum arranged(const Summand& a, const Summand& b, double step, bool insideOut, const FeaturePairs* kept,
                     const Progress& progress) {
  Stopwatch watch;
  Planes planes;
  Points points(planes);
  progress.report(0, "Pairing faces");
  const Candidates found = candidatesOf(a, b, planes, points, insideOut, DeepOnes::LeftOut, kept, progress);
  ArrangedSum made;
  made.candidates = found.found;
  made.leftOut = found.leftOut;
  made.candidatesMs = watch.lapMs();
  progress.report(0.2, "Cutting faces");
  const std::vector<Meeting> meeting = meetings(found.facets, planes, points, progress);
  const std::vector<Group> groups = groupsByPlane(found.facets, meeting, planes);
  Tiling tiling(planes, points);
  tiling.add(groups, progress);
  made.arrangementMs = watch.lapMs();
  progress.report(0.7, "Finding the outside");
  const SumSpace space{Membership(a.whole, b.whole, insideOut, progress), !insideOut};
  const std::vector<bool> bounds = boundingPatches(tiling.tiles(), tiling.patches(), planes, points, space, progress);
  const std::vector<int> used = pointsOf(tiling.tiles(), bounds, points.size());
  made.triangles = bounding(tiling.tiles(), bounds, RoundedCorners(used, planes, points, step, progress), insideOut);
  made.cellsMs = watch.lapMs();
  return made;
}

}  // namespace

std::shared_ptr<const FeaturePairs> keptPairs(const Term& a, const Term& b, double step, double leastFactor,
                                              const Progress& progress) {
  const auto both = shapesOf(a, b, step, progress);
  if (!both) return nullptr;
  // A corner of a scaled shape moves by half a usual step along each axis, an edge by twice that.
  const double rounding = 2 * static_cast<double>(usualSteps) / leastFactor;
  return std::make_shared<const FeaturePairs>(nearPairs(both->first.whole, both->second.whole, rounding, progress));
}

std::optional<ArrangedSum> arrangedSum(const Term& a, const Term& b, double step, const Progress& progress,
                                       const FeaturePairs* kept) {
  const auto both = shapesOf(a, b, step, progress);
  if (!both) return std::nullopt;
  return arranged(both->first, both->second, step, false, kept, progress);
}

std::optional<std::vector<SumFacet>> sumFacets(const Term& a, const Term& b, double step, const Progress& progress) {
  const auto both = shapesOf(a, b, step, progress);
  if (!both) return std::nullopt;
  Planes planes;
  Points points(planes);
  std::vector<SumFacet> made;
  const Candidates found = candidatesOf(both->first, both->second, planes, points, false, DeepOnes::Kept, nullptr, progress);
  for (const Facet& facet : found.facets) {
    SumFacet& placed = made.emplace_back(SumFacet{static_cast<std::size_t>(facet.family), {}});
    for (std::size_t k = 0; k < facet.count; ++k)
      placed.corners.emplace_back(step * inDoubles(points.grid(facet.corners[k])));
  }
  return made;
}

std::vector<Vec3> reflexCorners(const Term& term, double step) {
  const auto shape = shapeOf(term, step);
  std::vector<Vec3> made;
  if (!shape) return made;
  std::set<int> ends;
  for (const Features::Edge& edge : shape->whole.edges)
    if (isReflex(shape->whole, edge)) ends.insert({edge.from, edge.to});
  for (const int end : ends) made.emplace_back(step * inDoubles(shape->whole.points[static_cast<std::size_t>(end)]));
  return made;
}

std::optional<ArrangedSum> arrangedDifference(const Term& a, const Term& b, double step, const Progress& progress) {
  const auto both = shapesOf(a, {b.triangles, b.pieces, -b.factor}, step, progress, true);
  if (!both) return std::nullopt;
  return arranged(both->first, both->second, step, true, nullptr, progress);
}

}  // namespace blossom::morphology
