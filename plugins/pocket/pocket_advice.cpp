#include "pocket_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/units.h"

namespace blossom::pocket {

namespace {

/// Edges of ordinary end mills are two to four times as long as they are thick.
constexpr double longestReach = 5;
/// More than that at once bends and breaks tools that cut over their whole width.
constexpr double deepestStep = 2;
/// mm; clamps, chips and warped stock are higher than less.
constexpr double minimumSafeHeight = 1, minimumApproach = 0.1;
constexpr double steepestRamp = 45;  // degrees; end mills do not cut at their middle
constexpr double longestBite = 1;    // of the diameter in one turn

std::string mm(double value) { return formatNumber(std::round(value * 1e6) / 1e6) + " mm"; }

}  // namespace

std::vector<std::string> adviceOn(const PocketOptions& o) {
  std::vector<std::string> advice;
  const double diameter = o.cutter.diameter;
  if (o.depth > longestReach * diameter)
    advice.push_back(
        fmt::format("The pocket is {} deep, {:.1f} times the tool's diameter of {}: a tool that long bends, and its "
                    "shank may touch the walls. Use one of at least {}, or make sure that its edge is long enough.",
                    mm(o.depth), o.depth / diameter, mm(diameter), mm(o.depth / longestReach)));
  const double total = o.depth - o.leaveFloor, wanted = o.stepdown > 0 ? o.stepdown : diameter / 2;
  const double step = total / std::max(1.0, std::ceil(total / wanted - 1e-9));
  if (step > deepestStep * diameter)
    advice.push_back(fmt::format("Each pass is {} deep, {:.1f} times the tool's diameter. Give a stepdown of at most {}.",
                                 mm(step), step / diameter, mm(deepestStep * diameter)));
  if (o.safeHeight < minimumSafeHeight)
    advice.push_back(
        fmt::format("Rapids cross only {} above the stock: clamps, chips and uneven stock are higher. Give a safe "
                    "height of at least {}.",
                    mm(o.safeHeight), mm(minimumSafeHeight)));
  if (o.approach < minimumApproach)
    advice.push_back(fmt::format("Rapids down end only {} above the material. Give an approach of at least {}.",
                                 mm(o.approach), mm(minimumApproach)));
  if (o.entry != Entry::Plunge && toDegrees(o.rampAngle) > steepestRamp)
    advice.push_back(fmt::format("The entry falls at {}°, which is nearly a plunge. Give a ramp angle of at most {}°.",
                                 formatNumber(toDegrees(o.rampAngle)), formatNumber(steepestRamp)));
  if (o.plungeFeed > o.feed)
    advice.push_back(
        fmt::format("The tool goes down at {} mm a minute, faster than it cuts ({}). Give a plunge feed of at most "
                    "{}.",
                    formatNumber(o.plungeFeed), formatNumber(o.feed), formatNumber(o.feed)));
  if (o.cutter.spindle > 0 && o.feed / o.cutter.spindle > longestBite * diameter)
    advice.push_back(
        fmt::format("The tool moves {:.3g} mm in each turn of the spindle, more than its diameter. Give a feed of at "
                    "most {:.0f} mm a minute, or turn faster.",
                    o.feed / o.cutter.spindle, longestBite * diameter * o.cutter.spindle));
  return advice;
}

}  // namespace blossom::pocket
