#pragma once
#include <vector>

#include "kernel/deform.h"
#include "parameter/value.h"

namespace blossom::subdivision {

/// "support", "paper" or "rings:N". @throws Error InvalidParameter.
FreeRule ruleOf(const std::string&);

/// Between the records of the parameter `pulls`, {"at": point, "to": point}, and what they stand for.
std::vector<Pull> pullsOf(const std::vector<Value>&);
Value recordOf(const Pull&);

}  // namespace blossom::subdivision
