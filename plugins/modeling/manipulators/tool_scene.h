#pragma once
#include <QString>

#include "kernel/outline/outline_snap.h"
#include "ui/plugin/tool.h"

namespace blossom::modeling {

inline constexpr double gripPixels = 8;   ///< maximum distance at which the mouse grabs a point or a curve
inline constexpr double reachPixels = 9;  ///< maximum distance at which it snaps

/// Points and curves of all visible features in the plane z = 0, except one feature.
SnapScene snapScene(const ui::ToolHost&, const FeatureId& except);

/// "end point", "midpoint", .. for the status line and beside the marker; empty for None.
QString snapName(SnapKind);

}  // namespace blossom::modeling
