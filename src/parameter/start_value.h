#pragma once
#include "parameter/parameter.h"

namespace blossom {

/// The value that a new item of a list begins with; null when only the user can give it.
Value startValue(const ParameterSpec&);

}  // namespace blossom
