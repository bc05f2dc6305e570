#include "kernel/setup/tool_stages.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace blossom::pocket {

namespace {

constexpr double unknownLength = 1e4;  // mm, above all parts

/// A cylinder whose edges are rounded by `corner`.
std::optional<ToolStage> cylinder(ToolPart part, double radius, double corner, double low, double high, double inset) {
  const double round = std::max(0.0, corner - inset);
  const double smaller = inset + round;
  if (radius - smaller < 0 || high - low <= 2 * smaller) return std::nullopt;
  return ToolStage{
      part,
      {{0, low + smaller}, {radius - smaller, low + smaller}, {radius - smaller, high - smaller}, {0, high - smaller}},
      round};
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
  const double radius = tool.cutter.diameter / 2;
  const double flutes = tool.fluteLength > 0 ? tool.fluteLength : unknownLength;
  if (tool.cutter.vAngle > 0)
    add(cone(radius, tool.cutter.vAngle, std::max(flutes, 2 * radius / std::tan(tool.cutter.vAngle / 2)), inset));
  else
    add(cylinder(ToolPart::Flutes, radius, tool.cutter.cornerRadius, 0, flutes, inset));
  if (tool.fluteLength == 0) return stages;
  const double stickOut = std::max(tool.stickOut, tool.fluteLength);
  if (tool.shankDiameter > 0)
    add(cylinder(ToolPart::Shank, tool.shankDiameter / 2, 0, tool.fluteLength, tool.stickOut > 0 ? stickOut : unknownLength,
                 inset));
  if (tool.stickOut > 0 && tool.holderDiameter > 0)
    add(cylinder(ToolPart::Holder, tool.holderDiameter / 2, 0, stickOut,
                 stickOut + (tool.holderLength > 0 ? tool.holderLength : unknownLength), inset));
  return stages;
}

}  // namespace blossom::pocket
