#include "kernel/operations/pair.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "geometry/shape/bounds.h"
#include "kernel/convex/convex_sum.h"
#include "kernel/convex/hull.h"

namespace blossom::morphology {

Pair preparedPair(Work& work, const Operand& a, const Operand& b) {
  const CommonGrid grid = gridFor(a.bounds(), b.bounds());
  auto [first, second] = work.prepareBoth(a, b, grid, 0, 0.1);
  return {grid, std::move(first), std::move(second)};
}

std::optional<PrismPair> asPrisms(const Prepared& first, const Prepared& second) {
  for (const Prism& a : first.prisms)
    for (const Prism& b : second.prisms)
      if (a.axis == b.axis) return PrismPair{a, b};
  return std::nullopt;
}

ConvexSums::ConvexSums(const Mesh& a, const Mesh& b, Work& work) : a_(a), b_(b), work_(work) {
  Stopwatch watch;
  corners_ = cornersOfSum(a_, b_, work.progress());
  MorphologyStats& stats = work_.stats();
  stats.way = Way::Hulls;
  ++stats.pairings;
  stats.sumMs += watch.lapMs();
}

Mesh ConvexSums::sum(double weightA, double weightB) {
  Stopwatch watch;
  Mesh made = hullTriangles(pointsOfSum(a_, weightA, b_, weightB, corners_));
  MorphologyStats& stats = work_.stats();
  stats.candidates += made.faceCount();
  stats.sumMs += watch.lapMs();
  return made;
}

namespace {

bool isSolid(const Prepared& operand) { return operand.triangles.faceCount() > 0; }

/// A sum of solids reaches exactly as far as both do.
bool reachesAsFar(const Mesh& sum, const Prepared& a, double weightA, const Prepared& b, double weightB) {
  const Bounds box = bounds(sum);
  const Vec3 low = weightA * a.bounds.low + weightB * b.bounds.low, high = weightA * a.bounds.high + weightB * b.bounds.high;
  const double near = 1e-9 * (high - low).norm();
  return (box.low - low).norm() <= near && (box.high - high).norm() <= near;
}

}  // namespace

Mesh sumOfAny(Work& work, const Prepared& a, double weightA, const Prepared& b, double weightB, const CommonGrid& grid,
              double from, double to, const arrangement::FeaturePairs* kept) {
  if (isConvex(a) && isConvex(b)) return ConvexSums(a.hull, b.hull, work).sum(weightA, weightB);
  Mesh sum = work.sum(a, weightA, b, weightB, grid, from, to, kept);
  const bool isLess = sum.faceCount() == 0 || (isSolid(a) && isSolid(b) && !reachesAsFar(sum, a, weightA, b, weightB));
  if (isLess && (a.bodiesMeet || b.bodiesMeet)) refuseTurnedShell(a.bodiesMeet ? a : b, work.progress());
  if (sum.faceCount() == 0 && !isSolid(a) && !isSolid(b))
    throw Error(ErrorCode::Degenerate, "The sum has no volume: both shapes are thin, and in one plane or one line.",
                "Choose a solid for one of them.");
  if (isLess)
    throw Error(ErrorCode::Internal, fmt::format("The sum of {} and {} has lost a part.", a.name, b.name),
                "Please report the two shapes.");
  return sum;
}

}  // namespace blossom::morphology
