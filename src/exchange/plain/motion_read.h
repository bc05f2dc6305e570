#pragma once
#include <string>
#include <vector>

#include "geometry/shape/motion.h"
#include "parameter/parameter.h"

namespace blossom {

/// The motion described by the JSON of a motion file (resources/manual/sweep.md). Messages name the path to the wrong value:
/// "orientation.poles[3][2]". @throws Error FormatDamaged; InvalidInput for edits.
Motion readMotion(const Value&, std::vector<std::string>& warnings);

}  // namespace blossom
