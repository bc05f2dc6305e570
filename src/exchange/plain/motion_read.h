#pragma once
#include <string>
#include <vector>

#include "geometry/shape/motion.h"
#include "parameter/parameter.h"

namespace blossom {

/// The motion described by the JSON of a motion file (resources/manual/sweep.md). Messages name the path to the wrong value:
/// "orientation.poles[3][2]". Edits are read, not applied. @throws Error FormatDamaged.
Motion readMotion(const Value&, std::vector<std::string>& warnings);

}  // namespace blossom
