#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/error.h"
#include "kernel/convex/convex_sum.h"
#include "kernel/morphology.h"
#include "kernel/operations/eroder.h"
#include "kernel/operations/work.h"

namespace blossom::morphology {

namespace {

Bounds plus(const Bounds& a, const Bounds& b) {
  Bounds sum;
  sum.add(a.low + b.low);
  sum.add(a.high + b.high);
  return sum;
}

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
    work_.stats().sumMs += watch.lapMs();
  }

  /// weightA a + weightB b
  [[nodiscard]] Mesh sum(double weightA, double weightB) {
    Stopwatch watch;
    Mesh made = hullTriangles(pointsOfSum(a_, weightA, b_, weightB, corners_));
    MorphologyStats& stats = work_.stats();
    stats.partsA = stats.partsB = 1;
    ++stats.pairs;
    stats.candidates += made.faceCount();
    stats.sumMs += watch.lapMs();
    return made;
  }

 private:
  const Mesh &a_, &b_;
  Work& work_;
  std::vector<std::array<int, 2>> corners_;
};

void refuseFlatSum(const Solid& sum) {
  if (isEmpty(sum))
    throw Error(ErrorCode::Degenerate, "The sum has no volume: both shapes are thin, and in one plane or one line.",
                "Choose a solid for one of them.");
}

Prism leftOf(std::optional<Prism> left, const Operand& a) {
  if (!left) nothingLeft(a, smallerElement);
  return *std::move(left);
}

}  // namespace

MorphologyResult solidSum(const Operand& a, const Operand& b, const Progress& progress, Way way) {
  if (way == Way::Nef) {
    requireSolid(a);
    requireSolid(b);
  }
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const Vec3 centre = pair.a.centre + pair.b.centre;
  const auto ofPrisms = [](const Prism& p, const Prism& q, const Progress& part) { return sum(p, q, part); };
  if (way != Way::Nef && finishedAsPrisms(work, pair, centre, ofPrisms)) return work.result();
  if (way != Way::Nef && areConvex(pair)) {
    work.finish(ConvexSums(pair, work).sum(1, 1), centre, 0.3, 1);
    return work.result();
  }
  const auto byParts = [&] {
    const Parts partsA = work.apart(pair.a, 0.1, 0.2), partsB = work.apart(pair.b, 0.2, 0.3);
    return work.sum(partsA, partsB, 0.3, 0.95);
  };
  const Solid sum = way == Way::Nef ? work.nefSum(pair.a, 1, pair.b, 1, 0.1, 0.95) : byParts();
  refuseFlatSum(sum);
  work.finish(sum, centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidDifference(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    return leftOf(difference(p, q, part), a);
  };
  if (finishedAsPrisms(work, pair, pair.a.centre - pair.b.centre, ofPrisms)) return work.result();
  Eroder eroder(work, pair.a.solid, pair.a.bounds);
  const Solid left = eroder.by(work.apart(pair.b, 0.1, 0.2), pair.b.bounds, pair.grid.step, 0.2, 0.95);
  if (isEmpty(left)) nothingLeft(a, smallerElement);
  work.finish(left, pair.a.centre - pair.b.centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidOpening(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    return sum(leftOf(difference(p, q, part.part(0, 0.5)), a), q, part.part(0.5, 1));
  };
  if (finishedAsPrisms(work, pair, pair.a.centre, ofPrisms)) return work.result();
  const Parts partsB = work.apart(pair.b, 0.1, 0.15);
  Eroder eroder(work, pair.a.solid, pair.a.bounds);
  const Solid left = eroder.by(partsB, pair.b.bounds, pair.grid.step, 0.15, 0.5);
  if (isEmpty(left)) nothingLeft(a, smallerElement);
  const Prepared core = work.asOperand(left, minus(pair.a.bounds, pair.b.bounds), pair.grid, 0.5, 0.55);
  const Solid opened = work.sum(work.apart(core, 0.55, 0.6), partsB, 0.6, 0.95);
  work.finish(opened, pair.a.centre + core.centre, 0.95, 1);
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
  const Parts partsA = work.apart(pair.a, 0.1, 0.15), partsB = work.apart(pair.b, 0.15, 0.2);
  const Solid sum = work.sum(partsA, partsB, 0.2, 0.6);
  const Prepared grown = work.asOperand(sum, plus(pair.a.bounds, pair.b.bounds), pair.grid, 0.6, 0.65);
  Eroder eroder(work, grown.solid, grown.bounds);
  const Solid closed = eroder.by(partsB, pair.b.bounds, pair.grid.step, 0.65, 0.95);
  requireClosed(isEmpty(closed));
  work.finish(closed, pair.a.centre + grown.centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidMorph(const Operand& a, const Operand& b, const std::vector<double>& weights, const Progress& progress,
                            Way way) {
  requireSolid(a);
  requireSolid(b);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const auto between = [](double w) { return w > 0 && w < 1; };
  const auto prisms = way == Way::Nef ? std::nullopt : asPrisms(pair);
  std::optional<ConvexSums> convex;
  if (way != Way::Nef && !prisms && areConvex(pair)) convex.emplace(pair, work);
  Parts partsA, partsB;
  if (way == Way::Corefined && !prisms && !convex && std::any_of(weights.begin(), weights.end(), between)) {
    partsA = work.apart(pair.a, 0.1, 0.15);
    partsB = work.apart(pair.b, 0.15, 0.2);
  }
  const double share = 0.8 / static_cast<double>(std::max<std::size_t>(1, weights.size()));
  double from = 0.2;
  for (const double w : weights) {
    if (!between(w)) {
      work.finish(w <= 0 ? pair.a : pair.b, from, from + share);
    } else if (prisms) {
      work.finish(sum(scaled(prisms->a, 1 - w), scaled(prisms->b, w), progress.part(from, from + 0.9 * share)),
                  (1 - w) * pair.a.centre + w * pair.b.centre, from + 0.9 * share, from + share);
    } else if (convex) {
      work.finish(convex->sum(1 - w, w), (1 - w) * pair.a.centre + w * pair.b.centre, from, from + share);
    } else {
      const Solid sum = way == Way::Nef ? work.nefSum(pair.a, 1 - w, pair.b, w, from, from + 0.9 * share)
                                        : work.sum(scaled(partsA, 1 - w, pair.grid.step), scaled(partsB, w, pair.grid.step),
                                                   from, from + 0.9 * share);
      work.finish(sum, (1 - w) * pair.a.centre + w * pair.b.centre, from + 0.9 * share, from + share);
    }
    from += share;
  }
  return work.result();
}

}  // namespace blossom::morphology
