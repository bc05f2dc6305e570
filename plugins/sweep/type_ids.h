#pragma once

/// The feature types of this plugin, as documents name them.
namespace blossom::sweep {

inline constexpr const char *sweepType = "sweep.sweep", *growthType = "sweep.growth";
inline constexpr const char *primitiveType = "sweep.primitive", *frameType = "sweep.frame", *refineType = "sweep.refine";
inline constexpr const char *pullType = "sweep.pull", *twistType = "sweep.twist", *factorsType = "sweep.factors";

}  // namespace blossom::sweep
