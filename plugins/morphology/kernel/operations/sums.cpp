#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/error.h"
#include "kernel/convex/convex_sum.h"
#include "kernel/convex/hull.h"
#include "kernel/morphology.h"
#include "kernel/operations/erosion.h"
#include "kernel/operations/work.h"

namespace blossom::morphology {

namespace {

constexpr const char* smallerElement = "Choose a smaller second shape.";

struct Pair {
  CommonGrid grid;
  Prepared a, b;
};

Pair prepare(Work& work, const Operand& a, const Operand& b) {
  const CommonGrid grid = gridFor(a.bounds(), b.bounds());
  Pair pair{grid, work.prepare(a, grid, 0, 0.05), {}};
  pair.b = work.prepare(b, grid, 0.05, 0.1);
  return pair;
}

/// The same where the first is melted, for which its bodies must not meet.
Pair prepareUnited(Work& work, const Operand& a, const Operand& b) {
  Pair pair = prepare(work, a, b);
  pair.a = work.united(std::move(pair.a), pair.grid, 0.08, 0.1);
  return pair;
}

/// Both as prisms along one axis.
struct PrismPair {
  Prism a, b;
};
std::optional<PrismPair> asPrisms(const Pair& pair) {
  for (const Prism& a : pair.a.prisms)
    for (const Prism& b : pair.b.prisms)
      if (a.axis == b.axis) return PrismPair{a, b};
  return std::nullopt;
}

/// Finishes what `operation` makes of both as prisms, where they are. @returns whether they are
template <class Operation>
bool finishedAsPrisms(Work& work, const Pair& pair, const Vec3& centre, const Operation& operation) {
  const auto prisms = asPrisms(pair);
  if (!prisms) return false;
  work.finish(operation(prisms->a, prisms->b, work.progress().part(0.1, 0.9)), centre, 0.9, 1);
  return true;
}

bool areConvex(const Pair& pair) { return pair.a.hull.faceCount() > 0 && pair.b.hull.faceCount() > 0; }

/// Weighted sums of two convex solids, whose corners are paired once.
class ConvexSums {
 public:
  ConvexSums(const Pair& pair, Work& work) : a_(pair.a.hull), b_(pair.b.hull), work_(work) {
    Stopwatch watch;
    corners_ = cornersOfSum(a_, b_, work.progress());
    work_.stats().way = Way::Hulls;
    work_.stats().sumMs += watch.lapMs();
  }

  /// weightA a + weightB b
  [[nodiscard]] Mesh sum(double weightA, double weightB) {
    Stopwatch watch;
    Mesh made = hullTriangles(pointsOfSum(a_, weightA, b_, weightB, corners_));
    MorphologyStats& stats = work_.stats();
    stats.candidates += made.faceCount();
    stats.sumMs += watch.lapMs();
    return made;
  }

 private:
  const Mesh &a_, &b_;
  Work& work_;
  std::vector<std::array<int, 2>> corners_;
};

Mesh withVolume(Mesh sum) {
  if (sum.faceCount() == 0)
    throw Error(ErrorCode::Degenerate, "The sum has no volume: both shapes are thin, and in one plane or one line.",
                "Choose a solid for one of them.");
  return sum;
}

/// weightA a + weightB b of shapes of any kind.
Mesh sumOf(Work& work, const Pair& pair, double weightA, double weightB, double from, double to) {
  return withVolume(work.sum(pair.a, weightA, pair.b, weightB, pair.grid, from, to));
}

Mesh leftOf(Mesh left, const Operand& a) {
  if (left.faceCount() == 0) nothingLeft(a, smallerElement);
  return left;
}
Prism leftOf(std::optional<Prism> left, const Operand& a) {
  if (!left) nothingLeft(a, smallerElement);
  return *std::move(left);
}

}  // namespace

MorphologyResult solidSum(const Operand& a, const Operand& b, const Progress& progress) {
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const Vec3 centre = pair.a.centre + pair.b.centre;
  const auto ofPrisms = [](const Prism& p, const Prism& q, const Progress& part) { return sum(p, q, part); };
  if (finishedAsPrisms(work, pair, centre, ofPrisms)) return work.result();
  const Mesh sum = areConvex(pair) ? ConvexSums(pair, work).sum(1, 1) : sumOf(work, pair, 1, 1, 0.1, 0.9);
  work.finish(sum, centre, 0.9, 1);
  return work.result();
}

MorphologyResult solidDifference(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepareUnited(work, a, b);
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    return leftOf(difference(p, q, part), a);
  };
  if (finishedAsPrisms(work, pair, pair.a.centre - pair.b.centre, ofPrisms)) return work.result();
  const Mesh left = leftOf(eroded(work, pair.a, pair.b, pair.grid, 0.1, 0.9), a);
  work.finish(left, pair.a.centre - pair.b.centre, 0.9, 1);
  return work.result();
}

MorphologyResult solidOpening(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepareUnited(work, a, b);
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    return sum(leftOf(difference(p, q, part.part(0, 0.5)), a), q, part.part(0.5, 1));
  };
  if (finishedAsPrisms(work, pair, pair.a.centre, ofPrisms)) return work.result();
  const Mesh left = leftOf(eroded(work, pair.a, pair.b, pair.grid, 0.1, 0.5), a);
  const Prepared core = work.asOperand(left, a.name, pair.grid, 0.5, 0.55);
  work.finish(work.sum(core, 1, pair.b, 1, pair.grid, 0.55, 0.9), pair.a.centre + core.centre, 0.9, 1);
  return work.result();
}

MorphologyResult solidClosing(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const auto requireClosed = [](bool empty) {
    if (empty) throw Error(ErrorCode::Internal, "The closing has lost the solid.", "Please report the two shapes.");
  };
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    std::optional<Prism> closed = difference(sum(p, q, part.part(0, 0.5)), q, part.part(0.5, 1));
    requireClosed(!closed);
    return *std::move(closed);
  };
  if (finishedAsPrisms(work, pair, pair.a.centre, ofPrisms)) return work.result();
  const Prepared grown = work.asOperand(sumOf(work, pair, 1, 1, 0.1, 0.5), a.name, pair.grid, 0.5, 0.55);
  const Mesh closed = eroded(work, grown, pair.b, pair.grid, 0.55, 0.9);
  requireClosed(closed.faceCount() == 0);
  work.finish(closed, pair.a.centre + grown.centre, 0.9, 1);
  return work.result();
}

MorphologyResult solidMorph(const Operand& a, const Operand& b, const std::vector<double>& weights,
                            const Progress& progress) {
  requireSolid(a);
  requireSolid(b);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const auto prisms = asPrisms(pair);
  std::optional<ConvexSums> convex;
  if (!prisms && areConvex(pair)) convex.emplace(pair, work);
  const double share = 0.9 / static_cast<double>(std::max<std::size_t>(1, weights.size()));
  double from = 0.1;
  for (const double w : weights) {
    const double most = from + 0.9 * share, to = from + share;
    const Vec3 centre = (1 - w) * pair.a.centre + w * pair.b.centre;
    if (w <= 0 || w >= 1)
      work.finish(w <= 0 ? pair.a : pair.b, pair.grid, from, to);
    else if (prisms)
      work.finish(sum(scaled(prisms->a, 1 - w), scaled(prisms->b, w), progress.part(from, most)), centre, most, to);
    else
      work.finish(convex ? convex->sum(1 - w, w) : sumOf(work, pair, 1 - w, w, from, most), centre, most, to);
    from = to;
  }
  return work.result();
}

}  // namespace blossom::morphology
