#pragma once
#include <functional>

#include "parameter/parameter.h"

namespace blossom {

/// Calls `visit` with every file in a parameter, also in lists and records, as {"path", "asset"}; a plain path is converted
/// to that form. Values that do not match their declaration are skipped, because the evaluation refuses them.
void eachFile(const ParameterSpec&, Value&, const std::function<void(Value& file)>& visit);
void eachFile(const std::vector<ParameterSpec>&, Value& parameters, const std::function<void(Value& file)>& visit);

/// Whether one of the parameters, or an element or field of one, is a file.
bool hasFileParameter(const std::vector<ParameterSpec>&);

}  // namespace blossom
