#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "parameter/parameter.h"

namespace blossom {

/// "a", "a or b", "a, b or c".
std::string enumerated(const std::vector<std::string>& names, std::string_view lastJoint);
/// "from 0 to 1", "above 0", "at least 3"; empty when the range is unbounded.
std::string describeRange(const ParameterSpec&, const LengthUnit& = {});
/// "must lie between 0 and 1", "must be above 0 mm".
std::string demandRange(const ParameterSpec&);
/// " mm", "°" or empty.
std::string_view unitSuffix(const ParameterSpec&);
/// "face", "edge" or "vertex"; "part" when the declaration does not name one.
std::string subShapeKind(const ParameterSpec&);
/// Any value as short text for a message; long text is cut off.
std::string quoted(const Value&);

}  // namespace blossom
