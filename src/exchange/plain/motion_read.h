#pragma once
#include <string>
#include <vector>

#include "geometry/shape/motion.h"
#include "parameter/parameter.h"

namespace blossom {

/// The motion that the JSON of a motion file describes (resources/manual/sweep.md). Messages name the way to the value that
/// is wrong: "orientation.poles[3][2]". @throws Error FormatDamaged; InvalidInput for edits.
Motion readMotion(const Value&, std::vector<std::string>& warnings);

}  // namespace blossom
