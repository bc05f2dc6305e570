#include "kernel/operations/work.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/frame_progress.h"
#include "geometry/mesh/mesh_crossing.h"
#include "kernel/convex/hull.h"
#include "kernel/finished.h"
#include "kernel/flatness.h"
#include "kernel/place.h"
#include "kernel/self_crossing.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology {

namespace {

/// On the grid, without triangles that have no area there.
Mesh scaledWithoutDegenerate(const Prepared& operand, double factor, const CommonGrid& grid) {
  Mesh scaled = operand.triangles;
  const double step = grid.usualStep();
  for (Vec3& p : scaled.points)
    for (Eigen::Index k = 0; k < 3; ++k) p[k] = step * std::nearbyint(factor * p[k] / step);
  return withoutDegenerate(scaled, {operand.name});
}

/// The cube with corners at `half` along each axis and its opposite, as triangles.
Mesh cubeAround(double half) {
  std::vector<Vec3> corners;
  corners.reserve(8);
  for (int k = 0; k < 8; ++k) corners.push_back(half * Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  return hullTriangles(corners);
}

}  // namespace

Term termOf(const Prepared& operand, double factor) { return {operand.triangles, operand.pieces, factor}; }

void Work::startFrame(std::size_t frame, std::size_t count) {
  constexpr double preparation = 0.1;
  const Progress frames = whole_.part(preparation, 1);
  progress_ = count > 1 ? progressOfFrame(frames, frame, count) : frames;
}

Prepared Work::prepare(const Operand& operand, const CommonGrid& grid, double from, double to) {
  Stopwatch watch;
  Prepared made = prepared(operand, grid, progress_.part(from, to));
  stats_.checkMs += watch.lapMs();
  warnings_.insert(warnings_.end(), made.warnings.begin(), made.warnings.end());
  return made;
}

std::pair<Prepared, Prepared> Work::prepareBoth(const Operand& a, const Operand& b, const CommonGrid& grid, double from,
                                                double to) {
  Stopwatch watch;
  std::pair<Prepared, Prepared> made;
  sideBySide(
      progress_, [&] { made.first = prepared(a, grid, progress_.part(from, to)); },
      [&] { made.second = prepared(b, grid, progress_.part(from, to)); });
  stats_.checkMs += watch.lapMs();
  for (const Prepared* each : {&made.first, &made.second})
    warnings_.insert(warnings_.end(), each->warnings.begin(), each->warnings.end());
  return made;
}

Prepared Work::asOperand(const Mesh& triangles, const std::string& name, const CommonGrid& grid, double from, double to,
                         Slivers slivers) {
  Operand rounded;
  rounded.name = name;
  Finished made = finished(triangles, Vec3::Zero(), slivers, progress_.part(from, (from + to) / 2));
  rounded.mesh = std::move(made.mesh);
  loss_.add(made.loss);
  try {
    return prepared(rounded, grid, progress_.part((from + to) / 2, to));
  } catch (const Error& error) {  // not what the user gave
    if (error.code() != ErrorCode::InvalidInput) throw;
    throw CannotBeRounded("On the way to the result, rounding makes faces cross: " + error.message());
  }
}

Prepared Work::united(Prepared operand, const CommonGrid& grid, double from, double to) {
  if (!operand.bodiesMeet) return operand;
  Prepared made = asOperand(unitedBodies(operand, grid, from, (from + to) / 2), operand.name, grid, (from + to) / 2, to);
  made.centre += operand.centre;
  return made;
}

Mesh Work::unitedBodies(const Prepared& operand, const CommonGrid& grid, double from, double to) {
  static const std::vector<std::vector<Vec3>> origin{{Vec3::Zero()}};
  static const Mesh none;
  // Cracks between walls that nearly lie on each other are filled by a cube somewhat larger than they are wide.
  const double step = grid.usualStep(), half = step * std::ceil(1.5 * operand.wallsWithin / step);
  const Mesh cube = half > 0 ? cubeAround(half) : none;
  const Term by = half > 0 ? Term{cube, {}} : Term{none, origin};
  Mesh made = taken(arrangedSum(termOf(operand), by, grid.step, progress_.part(from, to)), operand);
  if (made.faceCount() == 0) refuseTurnedShell(operand, progress_);
  // By which its corners have moved.
  if (const double moved = std::sqrt(3) * half; moved > thicknessOfRounding * operand.bounds.diagonal())
    loss_.add({moved, 0});
  return made;
}

Mesh Work::sum(const Prepared& a, double weightA, const Prepared& b, double weightB, const CommonGrid& grid, double from,
               double to, const arrangement::FeaturePairs* kept) {
  const Progress part = progress_.part(from, to);
  if (!kept) ++stats_.pairings;
  if (auto made = arrangedSum(termOf(a, weightA), termOf(b, weightB), grid.step, part, kept))
    return taken(std::move(made), a);
  // A weight near 0 leaves triangles without area: without them the solid is the same on the grid.
  const Mesh small = scaledWithoutDegenerate(a, weightA, grid), other = scaledWithoutDegenerate(b, weightB, grid);
  return taken(arrangedSum({small, a.pieces}, {other, b.pieces}, grid.step, part), weightA < weightB ? a : b);
}

Mesh Work::taken(std::optional<ArrangedSum> made, const Prepared& operand) {
  if (!made) refuseSmallFaces(operand.name);
  stats_.way = Way::Arranged;
  for (std::size_t family = 0; family < made->candidates.size(); ++family) {
    stats_.candidates += made->candidates[family];
    stats_.families[family] += made->candidates[family];
  }
  stats_.leftOut += made->leftOut;
  stats_.sumMs += made->candidatesMs;
  stats_.uniteMs += made->arrangementMs + made->cellsMs;
  return std::move(made->triangles);
}

void Work::finish(const Prepared& operand, const CommonGrid& grid, double from, double to) {
  if (!operand.bodiesMeet) return finish(operand.triangles, operand.centre, from, to);
  finish(unitedBodies(operand, grid, from, (from + to) / 2), operand.centre, (from + to) / 2, to);
}

void Work::finish(const Mesh& triangles, const Vec3& centre, double from, double to) {
  Stopwatch watch;
  Finished made = finished(triangles, centre, Slivers::Go, progress_.part(from, to));
  solids_.push_back(std::move(made.mesh));
  loss_.add(made.loss);
  stats_.outputMs += watch.lapMs();
}

void Work::finish(const Prism& prism, const Vec3& centre, double from, double to) {
  stats_.way = Way::Prisms;
  finish(trianglesOf(prism, progress_.part(from, to)), centre, from, to);
}

MorphologyResult Work::result() {
  progress_.report(1);
  if (std::string lost = loss_.sentences(); !lost.empty()) warn(std::move(lost));
  return {std::move(solids_), stats_, std::move(warnings_)};
}

void requireSolid(const Operand& operand) {
  if (operand.form != Operand::Form::Body)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is not a solid: it has no volume.", operand.name),
                "Extrude it first, or choose a solid or a closed mesh.");
}

std::string insideSentence(std::string name) {
  if (name.starts_with("The ")) name[0] = 't';
  return name;
}

void refuseSmallFaces(const std::string& name) {
  throw Error(ErrorCode::Degenerate, fmt::format("{} has faces that are too small beside the other shape.", name),
              "Leave out details that are too small for its size, or choose shapes of more similar size.");
}

void refuseTurnedShell(const Prepared& operand, const Progress& progress) {
  const auto crossing = firstCrossing(operand.triangles, progress);
  const std::string place =
      crossing ? fmt::format(" near {}", Subject{operand.name, operand.centre}.place(crossing->place)) : std::string();
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{} has shells that cross{}, of which at least one looks inwards, as the wall of a void does.",
                          operand.name, place),
              "Orient the faces of all bodies outwards, and keep voids inside of them.");
}

void nothingLeft(const Operand& operand, const std::string& element, const std::string& remedy) {
  throw Error(ErrorCode::Degenerate,
              fmt::format("Nothing is left of {}: {} has no room inside of it.", insideSentence(operand.name),
                          insideSentence(element)),
              remedy);
}

}  // namespace blossom::morphology
