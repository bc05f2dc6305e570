#pragma once
#include <vector>

#include "kernel/deform.h"
#include "parameter/value.h"

namespace blossom::subdivision {

/// Parses "support", "paper" or "rings:N". @throws Error InvalidParameter.
FreeRule ruleOf(const std::string&);

/// Conversion between pulls and the records {"at": point, "to": point} of the parameter `pulls`.
std::vector<Pull> pullsOf(const std::vector<Value>&);
Value recordOf(const Pull&);

}  // namespace blossom::subdivision
