#include "kernel/morph/ladder.h"

#include <fmt/format.h>

#include "core/error.h"
#include "kernel/morph/evaluation_order.h"
#include "kernel/morph/point_shape.h"
#include "kernel/morph/repetition.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

void checkRungs(std::span<const Region> shapes, std::span<const double> t) {
  if (shapes.size() < 2)
    throw Error(ErrorCode::InvalidParameter, "A ladder needs at least two control shapes.", "Give another shape.");
  if (t.size() + 1 != shapes.size())
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The ladder of {} control shapes takes {} {}, not {}.", shapes.size(), shapes.size() - 1,
                            shapes.size() == 2 ? "number" : "numbers", t.size()),
                "Give one number of 0 to 1 for each control shape after the first.");
  for (const double level : t)
    if (!(level >= 0 && level <= 1))
      throw Error(ErrorCode::InvalidParameter, fmt::format("Every t must lie between 0 and 1; one is {}.", level));
}

/// Each is an in-between of neighbours among the control shapes, at the first of the numbers.
std::vector<Region> regionsIn(const std::vector<SoundRegion>& rung, std::span<const Region> controls,
                              std::span<const double> t) {
  const std::vector<double> shares = sharesOf(t);
  std::vector<Region> regions;
  regions.reserve(rung.size());
  for (std::size_t i = 0; i < rung.size(); ++i)
    regions.push_back(PointPlaces(controls.subspan(i, shares.size())).moved(rung[i].region, shares));
  return regions;
}

/// One shape less: each leg from a shape to the next, at t.
std::vector<SoundRegion> nextRung(const std::vector<SoundRegion>& shapes, double t, Adder& add, const Progress& progress) {
  std::vector<SoundRegion> rung;
  for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
    progress.check();
    rung.push_back(between(shapes[i], shapes[i + 1], t, add, progress));
  }
  return rung;
}

}  // namespace

LadderResult ladder(std::span<const Region> shapes, std::span<const double> t, const LadderOptions& options,
                    const Progress& progress) {
  checkRungs(shapes, t);
  LadderResult result;
  result.levels.emplace_back(shapes.begin(), shapes.end());
  Adder add(options.maximumWork);
  add.plan(shapes.size() * (shapes.size() - 1) / 2);
  try {
    std::vector<SoundRegion> rung;
    for (std::size_t i = 0; i < shapes.size(); ++i)
      rung.push_back(soundControl(shapes[i], {.tolerance = options.tolerance, .effort = &add.effort()},
                                  fmt::format("control shape {}", i + 1), progress));
    for (std::size_t r = 0; r < t.size(); ++r) {
      rung = nextRung(rung, t[r], add, progress);
      result.levels.push_back(regionsIn(rung, shapes, t.first(r + 1)));
    }
  } catch (const TooMuchWork&) {
    result.complete = false;
  }
  result.sums = add.count();
  return result;
}

}  // namespace blossom::minkowski
