#include "kernel/parts/crossing_warning.h"

#include <fmt/format.h>

#include <TopAbs_ShapeEnum.hxx>
#include <algorithm>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/crossing/part_overlap.h"
#include "geometry/crossing/surface_crossing.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {
namespace {

/// What cannot be tested, because it cannot be divided into triangles, say, is not refused for that: it is told.
template <class Test>
auto testedOrTold(const Test& test, std::vector<std::string>& warnings) -> decltype(test()) {
  try {
    return test();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) throw;
    warnings.push_back("Whether the shape cuts through itself could not be tested: " + error.message());
    return {};
  }
}

}  // namespace

void warnOfCrossing(const std::vector<TopoDS_Shape>& sheets, const std::string& why, std::vector<std::string>& warnings,
                    const Progress& progress) {
  if (sheets.empty()) return;
  const TopoDS_Shape all = compoundOf(sheets);
  if (subShapesOf(all, TopAbs_FACE).empty()) return;
  const auto crossing = testedOrTold([&] { return findCrossing(all, {}, progress).deepest; }, warnings);
  if (!crossing) return;
  warnings.push_back(fmt::format("The surface cuts through itself near {}, by at least {} mm. {}",
                                 placeText(crossing->point), leastText(crossing->depth), why));
}

void warnOfOverlap(const std::vector<TopoDS_Shape>& solids, const std::vector<std::size_t>& compared,
                   std::vector<std::string>& warnings, const Progress& progress) {
  for (const std::size_t k : compared)
    for (std::size_t i = 0; i < solids.size(); ++i) {
      progress.check();
      if (i == k) continue;
      const std::size_t before = warnings.size();
      const auto place = testedOrTold([&] { return overlapOf(solids[k], solids[i], progress); }, warnings);
      if (warnings.size() > before) return;
      if (!place) continue;
      warnings.push_back(fmt::format(
          "Bodies {} and {} hold the same space near {}, which counts twice in the volume. Set them farther apart, or unite "
          "them with \"join\".",
          std::min(i, k) + 1, std::max(i, k) + 1, placeText(*place)));
      return;
    }
}

}  // namespace blossom::modeling
