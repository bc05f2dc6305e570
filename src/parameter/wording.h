#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "parameter/parameter.h"

namespace blossom {

/// "a", "a or b", "a, b or c".
std::string enumerated(const std::vector<std::string>& names, std::string_view lastJoint);
/// "from 0 to 1", "above 0", "at least 3"; empty when any value goes.
std::string describeRange(const ParameterSpec&);
/// "must lie between 0 and 1", "must be above 0 mm".
std::string demandRange(const ParameterSpec&);
/// " mm", "°" or nothing.
std::string_view unitSuffix(const ParameterSpec&);
/// "face", "edge", "vertex"; "part" when the declaration does not say.
std::string subShapeKind(const ParameterSpec&);
/// Short text of any value for a message: cut off when long.
std::string quoted(const Value&);

}  // namespace blossom
