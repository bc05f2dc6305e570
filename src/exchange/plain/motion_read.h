#pragma once
#include <string>
#include <vector>

#include "geometry/shape/motion.h"
#include "parameter/parameter.h"

namespace blossom {

/// What a motion file says of the signs of its quaternions, as a member of `orientation`: kept as they are. Files that
/// Blossom writes say so, for their signs are those of the motion that was edited; without it, signs are aligned when they
/// look as if they were lost (alignQuaternions).
inline constexpr const char *motionFileSigns = "signs", *motionFileSignsKept = "kept";

/// The motion described by the JSON of a motion file (resources/manual/sweep.md). Messages name the path to the wrong value:
/// "orientation.poles[3][2]". Edits are read, not applied. @throws Error FormatDamaged.
Motion readMotion(const Value&, std::vector<std::string>& warnings);

}  // namespace blossom
