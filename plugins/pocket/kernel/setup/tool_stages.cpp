#include "kernel/setup/tool_stages.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace blossom::pocket {

namespace {

constexpr double unknownLength = 1e4;  // mm, above all parts

std::optional<ToolStage> cylinder(ToolPart part, double radius, double low, double high) {
  if (radius < 0 || high <= low) return std::nullopt;
  return ToolStage{part, {{0, low}, {radius, low}, {radius, high}, {0, high}}, 0};
}

/// All within `round` of a flat disc: the end of a ball or bull-nosed cutter.
ToolStage roundEnd(double radius, double corner, double inset) {
  const double disc = radius - corner;
  return {ToolPart::Flutes, {{0, corner}, {disc, corner}, {0, corner}}, corner - inset};
}

std::optional<ToolStage> cone(double radius, double angle, double high, double inset) {
  const double low = inset / std::sin(angle / 2);
  const double smaller = radius - inset;
  const double shoulder = low + smaller / std::tan(angle / 2);
  if (smaller <= 0 || shoulder >= high - inset) return std::nullopt;
  return ToolStage{ToolPart::Flutes, {{0, low}, {smaller, shoulder}, {smaller, high - inset}, {0, high - inset}}, 0};
}

}  // namespace

double ToolStage::reach() const {
  double most = 0;
  for (const Vec2& corner : profile) most = std::max(most, corner.x());
  return most + round;
}

std::vector<ToolStage> stagesOf(const ToolAssembly& tool, double inset) {
  std::vector<ToolStage> stages;
  const auto add = [&](std::optional<ToolStage> stage) {
    if (stage) stages.push_back(*std::move(stage));
  };
  const Cutter& cutter = tool.cutter;
  const double radius = cutter.diameter / 2;
  const double holder = tool.stickOut > 0 ? tool.stickOut : unknownLength;
  const double flutes = tool.fluteLength > 0 ? tool.fluteLength : holder;
  const bool isRound = cutter.cornerRadius > inset && radius > inset;
  if (cutter.vAngle > 0) {
    add(cone(radius, cutter.vAngle, std::max(flutes, 2 * radius / std::tan(cutter.vAngle / 2)), inset));
  } else {
    if (isRound) stages.push_back(roundEnd(radius, cutter.cornerRadius, inset));
    add(cylinder(ToolPart::Flutes, radius - inset, isRound ? cutter.cornerRadius : inset, flutes - inset));
  }
  if (tool.fluteLength > 0 && tool.shankDiameter > 0)
    add(cylinder(ToolPart::Shank, tool.shankDiameter / 2 - inset, flutes + inset, holder - inset));
  if (tool.stickOut > 0 && tool.holderDiameter > 0)
    add(cylinder(ToolPart::Holder, tool.holderDiameter / 2 - inset, holder + inset,
                 holder + (tool.holderLength > 0 ? tool.holderLength : unknownLength) - inset));
  return stages;
}

}  // namespace blossom::pocket
