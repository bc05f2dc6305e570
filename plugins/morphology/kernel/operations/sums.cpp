#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "kernel/morphology.h"
#include "kernel/operations/erosion.h"
#include "kernel/operations/exact_fit.h"
#include "kernel/operations/pair.h"

namespace blossom::morphology {

namespace {

/// The same where the first is melted, for which its bodies must not meet.
Pair prepareUnited(Work& work, const Operand& a, const Operand& b) {
  Pair pair = preparedPair(work, a, b);
  pair.a = work.united(std::move(pair.a), pair.grid, 0.08, 0.1);
  return pair;
}

/// Finishes what `operation` makes of both as prisms, where they are. @returns whether they are
template <class Operation>
bool finishedAsPrisms(Work& work, const Pair& pair, const Vec3& centre, const Operation& operation) {
  const auto prisms = asPrisms(pair.a, pair.b);
  if (!prisms) return false;
  work.finish(operation(prisms->a, prisms->b, work.progress().part(0.1, 0.9)), centre, 0.9, 1);
  return true;
}

[[noreturn]] void refuseNothingLeft(Work& work, const Operand& a, const Operand& b, const Pair& pair) {
  const Mesh nothing;
  if (fitsExactly(work, pair.a, pair.b, pair.grid, &nothing))
    throw Error(ErrorCode::Degenerate,
                fmt::format("Nothing is left of {}: {} fits exactly inside of it, without room to move.",
                            insideSentence(a.name), insideSentence(b.name)),
                fmt::format("Make {} a little smaller.", insideSentence(b.name)));
  nothingLeft(a, b.name, fmt::format("Make {} smaller.", insideSentence(b.name)));
}

/// @param left of the first shape; nothing: not known as a mesh
void warnOfTightPlaces(Work& work, const Pair& pair, const Mesh* left) {
  if (isConvex(pair.a) || !fitsExactly(work, pair.a, pair.b, pair.grid, left)) return;
  work.warn(
      "Some places are exactly as wide as the shape that moves in them: without room to move they have no volume, and are "
      "left out. Make that shape a little smaller where they count.");
}

/// About its middle.
Operand scaled(Operand shape, double factor) {
  const Vec3 middle = shape.bounds().center();
  const auto scale = [&](Vec3& p) { p = middle + factor * (p - middle); };
  for (Vec3& p : shape.mesh.points) scale(p);
  for (auto& piece : shape.pieces)
    for (Vec3& p : piece) scale(p);
  return shape;
}

constexpr std::array alternately{0.0, 1e-10, -1e-10, 1e-9, -1e-9, 1e-8, -1e-8};
/// Of what moves inside of a solid: smaller, it has room where it fits exactly, and a result that is another one.
constexpr std::array largerFirst{0.0, 1e-10, 1e-9, 1e-8, -1e-10, -1e-9, -1e-8};

/// Where shapes fit exactly, sheets of the result lie on each other but for rounding. When it cannot be written down so, the
/// second shape is taken imperceptibly larger, which closes such places, or else smaller.
/// @param operation (second shape, progress) -> MorphologyResult
template <class Operation>
MorphologyResult closingTightPlaces(const std::array<double, 7>& changes, const Operand& b, const Progress& progress,
                                    const Operation& operation) {
  for (const double change : changes) {
    try {
      if (change == 0) return operation(b, progress);
      MorphologyResult made = operation(scaled(b, 1 + change), progress);
      made.warnings.push_back(fmt::format(
          "The second shape has been taken {} by {:.0e} of its size: some places are just as wide as it is, and "
          "faces would cross there after rounding.{}",
          change > 0 ? "larger" : "smaller", std::abs(change), change > 0 ? "" : " Where it just fits, it has room now."));
      return made;
    } catch (const CannotBeRounded&) {
      if (change == changes.back()) throw;
    }
  }
  return {};
}

MorphologyResult plainSum(const Operand& a, const Operand& b, const Progress& progress) {
  Work work(progress);
  const Pair pair = preparedPair(work, a, b);
  const Vec3 centre = pair.a.centre + pair.b.centre;
  const auto ofPrisms = [](const Prism& p, const Prism& q, const Progress& part) { return sum(p, q, part); };
  if (finishedAsPrisms(work, pair, centre, ofPrisms)) return work.result();
  const Mesh sum = sumOfAny(work, pair.a, 1, pair.b, 1, pair.grid, 0.1, 0.9);
  work.finish(sum, centre, 0.9, 1);
  return work.result();
}

MorphologyResult plainDifference(const Operand& a, const Operand& b, const Progress& progress) {
  Work work(progress);
  const Pair pair = prepareUnited(work, a, b);
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    std::optional<Prism> left = difference(p, q, part);
    if (!left) refuseNothingLeft(work, a, b, pair);
    warnOfTightPlaces(work, pair, nullptr);
    return *std::move(left);
  };
  if (finishedAsPrisms(work, pair, pair.a.centre - pair.b.centre, ofPrisms)) return work.result();
  const Mesh left = eroded(work, pair.a, pair.b, pair.grid, 0.1, 0.9);
  if (left.faceCount() == 0) refuseNothingLeft(work, a, b, pair);
  warnOfTightPlaces(work, pair, &left);
  work.finish(left, pair.a.centre - pair.b.centre, 0.9, 1);
  return work.result();
}

MorphologyResult plainOpening(const Operand& a, const Operand& b, const Progress& progress) {
  Work work(progress);
  const Pair pair = prepareUnited(work, a, b);
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    const std::optional<Prism> left = difference(p, q, part.part(0, 0.5));
    if (!left) refuseNothingLeft(work, a, b, pair);
    warnOfTightPlaces(work, pair, nullptr);
    return sum(*left, q, part.part(0.5, 1));
  };
  if (finishedAsPrisms(work, pair, pair.a.centre, ofPrisms)) return work.result();
  const Mesh left = eroded(work, pair.a, pair.b, pair.grid, 0.1, 0.5);
  if (left.faceCount() == 0) refuseNothingLeft(work, a, b, pair);
  warnOfTightPlaces(work, pair, &left);
  const Prepared core = work.asOperand(left, a.name, pair.grid, 0.5, 0.55);
  const Mesh sum = sumOfAny(work, core, 1, pair.b, 1, pair.grid, 0.55, 0.9);
  work.finish(sum, pair.a.centre + core.centre, 0.9, 1);
  return work.result();
}

MorphologyResult plainClosing(const Operand& a, const Operand& b, const Progress& progress) {
  Work work(progress);
  const Pair pair = preparedPair(work, a, b);
  if (isConvex(pair.a)) {  // (A + B) - B is A
    work.stats().way = Way::Hulls;
    work.finish(pair.a, pair.grid, 0.1, 1);
    return work.result();
  }
  const auto requireClosed = [&](bool empty) {
    if (empty)
      throw Error(ErrorCode::Degenerate,
                  fmt::format("{} is too thin beside {}: rounding has lost it.", a.name, insideSentence(b.name)),
                  "Close it with a smaller shape.");
  };
  const auto ofPrisms = [&](const Prism& p, const Prism& q, const Progress& part) {
    std::optional<Prism> closed = difference(sum(p, q, part.part(0, 0.5)), q, part.part(0.5, 1));
    requireClosed(!closed);
    return *std::move(closed);
  };
  if (finishedAsPrisms(work, pair, pair.a.centre, ofPrisms)) return work.result();
  const Mesh sum = sumOfAny(work, pair.a, 1, pair.b, 1, pair.grid, 0.1, 0.5);
  const Prepared grown = work.asOperand(sum, a.name, pair.grid, 0.5, 0.55, Slivers::Go);
  const Mesh closed = eroded(work, grown, pair.b, pair.grid, 0.55, 0.9);
  requireClosed(closed.faceCount() == 0);
  work.finish(closed, pair.a.centre + grown.centre, 0.9, 1);
  return work.result();
}

}  // namespace

MorphologyResult solidSum(const Operand& a, const Operand& b, const Progress& progress) {
  return closingTightPlaces(alternately, b, progress,
                            [&](const Operand& second, const Progress& part) { return plainSum(a, second, part); });
}

MorphologyResult solidDifference(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  return closingTightPlaces(largerFirst, b, progress,
                            [&](const Operand& second, const Progress& part) { return plainDifference(a, second, part); });
}

MorphologyResult solidOpening(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  return closingTightPlaces(largerFirst, b, progress,
                            [&](const Operand& second, const Progress& part) { return plainOpening(a, second, part); });
}

MorphologyResult solidClosing(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  return closingTightPlaces(alternately, b, progress,
                            [&](const Operand& second, const Progress& part) { return plainClosing(a, second, part); });
}

SumParts partsOfSum(const Operand& a, const Operand& b, const Progress& progress) {
  Work work(progress);
  const Pair pair = preparedPair(work, a, b);
  const auto facets = sumFacets(termOf(pair.a), termOf(pair.b), pair.grid.step, progress);
  if (!facets) refuseSmallFaces(a.name);
  SumParts parts;
  for (const SumFacet& facet : *facets) {
    std::vector<Vec3>& placed = parts.facets.at(facet.family).emplace_back(facet.corners);
    for (Vec3& p : placed) p += pair.a.centre + pair.b.centre;
  }
  for (const Prepared* each : {&pair.a, &pair.b})
    for (const Vec3& p : reflexCorners(termOf(*each), pair.grid.step)) parts.reflex.emplace_back(p + each->centre);
  return parts;
}

MorphologyResult solidRounded(const Operand& a, const Operand& ball, RoundedEdges edges, const Progress& progress) {
  if (edges == RoundedEdges::Convex) return solidOpening(a, ball, progress);
  if (edges == RoundedEdges::Reflex) return solidClosing(a, ball, progress);
  MorphologyResult opened = solidOpening(a, ball, progress.part(0, 0.5));
  Operand half;
  half.name = a.name;
  half.mesh = opened.solids.front();
  MorphologyResult both = solidClosing(half, ball, progress.part(0.5, 1));
  both.warnings.insert(both.warnings.begin(), opened.warnings.begin(), opened.warnings.end());
  return both;
}

}  // namespace blossom::morphology
