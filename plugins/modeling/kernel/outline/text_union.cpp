#include "kernel/outline/text_union.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "geometry/numeric/union_find.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/booleans/region_boolean.h"
#include "geometry/planar/outline_crossing.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "kernel/parts/guarded.h"

namespace blossom::modeling {
namespace {

bool meet(const Bounds& a, const Bounds& b) {
  return !a.empty && !b.empty && (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

bool cross(const Region& a, const Region& b, const Progress& progress) {
  for (const Path& p : a.loops)
    for (const Path& q : b.loops)
      if (crossing(p, q, progress)) return true;
  return false;
}

Region fused(const std::vector<Region>& regions, const Progress& progress) {
  if (auto all = combined(regions, BooleanOperation::Union, progress)) return *std::move(all);
  const char* message = "The overlapping parts of the text cannot be united.";
  const char* hint = "Give the glyphs more spacing or take another font.";
  return guarded(message, hint, [&] {
    TopTools_ListOfShape first, rest;
    for (const Region& region : regions) (first.IsEmpty() ? first : rest).Append(toFaces(region));
    BRepAlgoAPI_Fuse fuse;
    fuse.SetArguments(first);
    fuse.SetTools(rest);
    fuse.Build();
    if (!fuse.IsDone()) throw Error(ErrorCode::InvalidInput, message, hint);
    ShapeUpgrade_UnifySameDomain unify(fuse.Shape(), false, true, false);
    unify.Build();
    return toRegion(planarCurves(unify.Shape()));
  });
}

/// The smallest contour of `outer` around contour k, if any.
std::optional<std::size_t> around(const std::vector<Path>& contours, const std::vector<double>& areas, double outer,
                                  std::size_t k) {
  std::optional<std::size_t> best;
  const Vec2 place = startPoint(contours[k]);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (areas[i] * outer <= 0 || std::abs(areas[i]) <= std::abs(areas[k])) continue;
    if (best && std::abs(areas[i]) >= std::abs(areas[*best])) continue;
    if (windingNumber(contours[i], place) != 0) best = i;
  }
  return best;
}

bool anyCross(const std::vector<Path>& contours, const Progress& progress) {
  for (std::size_t i = 0; i < contours.size(); ++i)
    for (std::size_t j = i + 1; j < contours.size(); ++j)
      if (crossing(contours[i], contours[j], progress)) return true;
  return false;
}

}  // namespace

Region united(std::vector<Region> regions, const Progress& progress) {
  UnionFind groups(regions.size());
  std::vector<Bounds> boxes;
  boxes.reserve(regions.size());
  for (const Region& region : regions) boxes.push_back(bounds(region));
  for (std::size_t i = 0; i < regions.size(); ++i)
    for (std::size_t j = i + 1; j < regions.size(); ++j)
      if (meet(boxes[i], boxes[j]) && cross(regions[i], regions[j], progress)) groups.unite(i, j);
  std::vector<std::vector<Region>> members(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) members[groups.find(i)].push_back(std::move(regions[i]));
  Region all;
  for (auto& group : members) {
    progress.check();
    if (group.empty()) continue;
    Region one = group.size() == 1 ? std::move(group.front()) : fused(group, progress);
    std::move(one.loops.begin(), one.loops.end(), std::back_inserter(all.loops));
  }
  return all;
}

Region nonZeroArea(const std::vector<Path>& contours, const Progress& progress) {
  if (!anyCross(contours, progress)) return toRegion({contours, FillRule::NonZero});
  std::vector<double> areas;
  areas.reserve(contours.size());
  for (const Path& contour : contours) areas.push_back(signedArea(contour));
  const double outer =
      *std::max_element(areas.begin(), areas.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::vector<Curves> parts(contours.size());
  for (std::size_t k = 0; k < contours.size(); ++k) {
    if (areas[k] * outer > 0)
      parts[k].paths.insert(parts[k].paths.begin(), contours[k]);
    else if (const auto container = around(contours, areas, outer, k))
      parts[*container].paths.push_back(contours[k]);
  }
  std::vector<Region> regions;
  for (const Curves& part : parts)
    if (!part.paths.empty()) regions.push_back(toRegion(part));
  return united(std::move(regions), progress);
}

}  // namespace blossom::modeling
