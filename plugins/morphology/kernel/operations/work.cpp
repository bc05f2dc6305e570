#include "kernel/operations/work.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "kernel/united.h"

namespace blossom::morphology {

Prepared Work::prepare(const Operand& operand, const CommonGrid& grid, double from, double to) {
  Stopwatch watch;
  Prepared made = prepared(operand, grid, progress_.part(from, to));
  stats_.checkMs += watch.lapMs();
  warnings_.insert(warnings_.end(), made.warnings.begin(), made.warnings.end());
  return made;
}

Parts Work::apart(const Prepared& operand, double from, double to) {
  Stopwatch watch;
  progress_.report(from, "Taking apart");
  Parts parts = partsOf(operand, progress_.part(from, to));
  stats_.decomposeMs += watch.lapMs();
  return parts;
}

Parts Work::outside(const Solid& solid, const Bounds& frame, double from, double to) {
  Stopwatch watch;
  progress_.report(from, "Taking apart");
  Parts parts = convexPartsOutside(solid, frame, progress_.part(from, to));
  stats_.decomposeMs += watch.lapMs();
  return parts;
}

Solid Work::sum(const Parts& a, const Parts& b, double from, double to) {
  stats_.partsA = partCount(a);
  stats_.partsB = partCount(b);
  SumCounts counts;
  Solid made = sumOf(a, b, counts, progress_.part(from, to));
  stats_.pairs += counts.pairs;
  stats_.candidates += counts.candidates;
  stats_.sumMs += counts.sumMs;
  stats_.uniteMs += counts.uniteMs;
  return made;
}

Solid Work::nefSum(const Prepared& a, double weightA, const Prepared& b, double weightB, double from, double to) {
  Stopwatch watch;
  stats_.way = Way::Nef;
  Solid made = minkowskiSum(a.solid, weightA, b.solid, weightB, progress_.part(from, to));
  stats_.sumMs += watch.lapMs();
  return made;
}

Prepared Work::asOperand(const Solid& solid, const Bounds& bounds, const CommonGrid& grid, double from, double to) {
  Prepared made;
  made.solid = solid;
  made.bounds = bounds;
  if (isConvex(solid)) return made;
  Operand rounded;
  rounded.mesh = finished(solid, Vec3::Zero(), progress_.part(from, (from + to) / 2)).mesh;
  try {
    made = prepared(rounded, grid, progress_.part((from + to) / 2, to));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput) throw;
  }
  return made;
}

void Work::finish(const Prepared& operand, double from, double to) {
  finish(operand.bodiesMeet ? united(operand.solid) : operand.solid, operand.centre, from, to);
}

void Work::finish(const Solid& solid, const Vec3& centre, double from, double to) {
  Stopwatch watch;
  add(finished(solid, centre, progress_.part(from, to)), watch);
}

void Work::finish(const Mesh& triangles, const Vec3& centre, double from, double to) {
  Stopwatch watch;
  add(finished(triangles, centre, progress_.part(from, to)), watch);
}

void Work::finish(const Prism& prism, const Vec3& centre, double from, double to) {
  stats_.prisms = true;
  finish(trianglesOf(prism, progress_.part(from, to)), centre, from, to);
}

void Work::add(Finished made, Stopwatch& watch) {
  solids_.push_back(std::move(made.mesh));
  if (!made.warning.empty()) warn(std::move(made.warning));
  stats_.outputMs += watch.lapMs();
}

MorphologyResult Work::result() {
  progress_.report(1);
  return {std::move(solids_), stats_, std::move(warnings_)};
}

void requireSolid(const Operand& operand) {
  if (operand.form != Operand::Form::Body)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is not a solid: it has no volume.", operand.name),
                "Extrude it first, or choose a solid or a closed mesh.");
}

void nothingLeft(const Operand& operand, const std::string& remedy) {
  std::string name = operand.name;
  if (!name.empty() && name[0] == 'T') name[0] = 't';  // "The solid" inside a sentence
  throw Error(ErrorCode::Degenerate,
              fmt::format("Nothing is left of {}: there is no room in it for what it is melted by.", name), remedy);
}

}  // namespace blossom::morphology
