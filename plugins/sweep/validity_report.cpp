#include "validity_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/bspline/bspline.h"
#include "geometry/crossing/surface_crossing.h"
#include "kernel/crossing_cause.h"
#include "kernel/cubic_approximation.h"
#include "kernel/fold.h"
#include "kernel/grid/motion_point.h"
#include "kernel/validity.h"

namespace blossom::sweep {

namespace {

Value listOf(const Vec2& p) { return Value::array({p.x(), p.y()}); }
Value listOf(const Vec3& p) { return Value::array({p.x(), p.y(), p.z()}); }

std::string parametersText(const Vec2& at) { return fmt::format("u = {:.4g}, v = {:.4g}", at.x(), at.y()); }

/// Before all others: a panel shows the first one, and a list begins with it.
void warnFirst(Evaluated& out, std::string warning) { out.warnings.insert(out.warnings.begin(), std::move(warning)); }

/// What to do about a fold.
const char* remedyOf(const Fold& fold) {
  return fold.backwards ? "Make the sections smaller there, or the motion bend, turn and pull less."
                        : "Turn or pull it less there, or over a wider part, at a coarser level.";
}

std::string foldText(const Fold& fold, bool solid) {
  return fmt::format(
      "The surface folds over itself near {}, at {}: x_u x x_v reverses there, so that parts of the surface "
      "run back over others or turn inside out. {} {}",
      placeText(fold.place), parametersText({fold.u, fold.v}),
      solid ? "The solid may count space there twice, or not at all."
            : "Sheets that only lie on each other, or touch, are not counted as a crossing.",
      remedyOf(fold));
}

/// The parameters may come to a halt where the surface does not: then it is they that are told.
std::string smallNormalText(const Motion& motion, const Validity& validity) {
  const std::string at = parametersText({validity.u, validity.v});
  if (!hasNormalThere(motion, {validity.u, validity.v}))
    return fmt::format("The surface has no normal near {}: it runs into a point or an edge, or folds over there.", at);
  return fmt::format(
      "The parameters run very unevenly: near {} a step of them covers {:.2g} of the area that it does "
      "elsewhere. The surface is whole there. Make the weights and knots of the factors more alike.",
      at, validity.smallestShare);
}

Validity addNormal(const Motion& motion, bool solid, Evaluated& out, const Progress& progress) {
  constexpr double vanishing = 1e-6;
  Validity validity = examine(motion, progress);
  out.stats["min_normal"] = validity.smallestNormal;
  out.stats["min_normal_share"] = validity.smallestShare;
  out.stats["min_normal_at"] = listOf(Vec2(validity.u, validity.v));
  out.stats["min_normal_place"] = listOf(validity.place);
  if (validity.fold)
    warnFirst(out, foldText(*validity.fold, solid));
  else if (validity.smallestShare < vanishing)
    out.warnings.push_back(smallNormalText(motion, validity));
  return validity;
}

/// By how much weights differ: the least share of the largest.
double leastShare(const std::vector<Vec4>& poles) {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Vec4& pole : poles) least = std::min(least, pole[3]), largest = std::max(largest, pole[3]);
  return least / largest;
}

/// Of the factors of W = tw |r|^2 sw, that which differs most.
const char* causeOfSmallWeight(const Motion& motion) {
  constexpr double much = 0.1;
  const double ofTrajectory = leastShare(motion.trajectory.poles), ofScaling = leastShare(motion.scaling.poles);
  if (std::min(ofTrajectory, ofScaling) > much)
    return "neighbouring quaternions differ much in length or point away from each other there. Bring them to one length, "
           "or insert rows between them.";
  return ofTrajectory <= ofScaling ? "weights of the trajectory differ much. Make them more alike."
                                   : "weights of the scaling differ much. Make them more alike.";
}

void addWeight(const Motion& motion, const Surface& surface, Evaluated& out) {
  constexpr double small = 1e-6;  // of the largest
  const SmallestWeight smallest = smallestWeightOf(surface, motion);
  out.stats["min_weight_at"] = listOf(Vec2(smallest.u, smallest.v));
  out.stats["min_weight_place"] = listOf(smallest.place);
  if (smallest.weight < small)
    out.warnings.push_back(fmt::format("The smallest weight of the surface, {:.3g} of the largest, belongs to {}: {}",
                                       smallest.weight, parametersText({smallest.u, smallest.v}),
                                       causeOfSmallWeight(motion)));
}

void addCrossing(const Motion& motion, const Surface& surface, bool folds, Evaluated& out, const Progress& progress) {
  CrossingResult found;
  try {
    found = findCrossing(surface, {}, progress);
  } catch (const Error& error) {
    // A surface that needs too many triangles, say, is not refused for that.
    if (error.code() == ErrorCode::Cancelled) throw;
    out.warnings.push_back("Whether the surface crosses itself could not be tested: " + error.message());
    return;
  }
  if (found.covered && !folds)
    warnFirst(out,
              fmt::format("The surface lies on itself near {}: it passes there twice, and bounds no body. Move one of the "
                          "parts, or end the motion before it comes round again.",
                          placeText(*found.covered, found.size, 5)));
  // Sheets that lie on each other are no crossing, and not sound either.
  if (found.deepest || !(folds || found.covered)) out.figures.push_back({"crosses_itself", found.deepest.has_value()});
  if (!found.deepest) return;
  const SurfaceCrossing& crossing = *found.deepest;
  out.figures.push_back({"crossing_depth", crossing.depth, MeasureUnit::Length});
  out.stats["crossing_place"] = listOf(crossing.point);
  out.stats["crossing_first_at"] = listOf(crossing.first.at);
  out.stats["crossing_second_at"] = listOf(crossing.second.at);
  const CrossingCause why = causeOfCrossing(motion, crossing.first.at, crossing.second.at);
  warnFirst(out, fmt::format("The surface crosses itself near {}, at {} and {}, by at least {} mm: {} {}",
                             placeText(crossing.point, found.size, 5), parametersText(crossing.first.at),
                             parametersText(crossing.second.at), leastText(crossing.depth), why.cause, why.remedy));
}

void addDeviation(const Motion& motion, const Surface& surface, std::optional<double> known, Evaluated& out,
                  const Progress& progress) {
  constexpr int samplesOfASpan = 4;
  const double off =
      known ? *known : deviation(motion, surface, samplesOfASpan, std::numeric_limits<double>::infinity(), progress);
  out.figures.push_back({"export_deviation", off, MeasureUnit::Length});
}

void addExport(const Motion& motion, const Surface& surface, std::optional<double> deviation, Evaluated& out,
               const Progress& progress) {
  if (!deviation) addWeight(motion, surface, out);  // a cubic surface has no weights
  addDeviation(motion, surface, deviation, out, progress);
}

bool isRing(const SolidResult& solid) { return solid.start == EndCap::None && solid.end == EndCap::None; }

void refuseSectionsThatGoBack(const SolidResult& solid, const std::optional<Fold>& fold) {
  if (!isRing(solid) || !fold || !fold->backwards) return;
  throw Error(
      ErrorCode::Degenerate,
      fmt::format("The ring turns inside out near {}, at {}: its sections go back there, because the motion bends or "
                  "turns more tightly than they are wide. The solid would have a void inside.",
                  placeText(fold->place), parametersText({fold->u, fold->v})),
      std::string(remedyOf(*fold)) + " Or leave out --solid: the surface alone may fold.");
}

}  // namespace

void addValidity(const Motion& motion, const Surface& surface, std::optional<double> deviation, Evaluated& out,
                 const Progress& progress) {
  const bool folds = addNormal(motion, false, out, progress).fold.has_value();
  addExport(motion, surface, deviation, out, progress);
  addCrossing(motion, surface, folds, out, progress);
}

void addValidityOfSolid(const Motion& motion, const Surface& surface, const SolidResult& solid,
                        std::optional<double> deviation, Evaluated& out, const Progress& progress) {
  const std::optional<Fold> fold = addNormal(motion, true, out, progress).fold;
  refuseSectionsThatGoBack(solid, fold);
  addExport(motion, surface, deviation, out, progress);
  if (!fold) out.figures.push_back({"crosses_itself", false});
}

void refuseHollowRing(const Motion& motion, const SolidResult& solid, const Progress& progress) {
  if (isRing(solid)) refuseSectionsThatGoBack(solid, examine(motion, progress).fold);
}

}  // namespace blossom::sweep
