#pragma once
#include <vector>

#include "core/vector.h"
#include "geometry/shape/toolpath.h"

namespace blossom::pocket {

/// The parts of a tool, from its tip up. Only the flutes cut.
enum class ToolPart { Flutes, Shank, Holder };

/// A cutter with what carries it. Lengths in mm, 0: not known.
struct ToolAssembly {
  Cutter cutter;
  double fluteLength = 0;
  double shankDiameter = 0;
  double stickOut = 0;  ///< from the tip to the holder
  double holderDiameter = 0, holderLength = 0;
};

/// A convex part of the turning tool: a body of revolution about the tool's axis, and all that lies within `round` of it.
struct ToolStage {
  ToolPart part = ToolPart::Flutes;
  std::vector<Vec2> profile;  ///< radius and height above the tip, from the axis below to the axis above; convex
  double round = 0;           ///< mm

  [[nodiscard]] double reach() const;  ///< mm, its largest radius
  [[nodiscard]] double low() const { return profile.front().y() - round; }
  [[nodiscard]] double high() const { return profile.back().y() + round; }
};

/// The stages of a tool, each shrunk by `inset` mm on all sides; those that vanish are left out. A round end is a stage of
/// its own. Without a length of the flutes they reach up to the holder.
std::vector<ToolStage> stagesOf(const ToolAssembly&, double inset);

}  // namespace blossom::pocket
