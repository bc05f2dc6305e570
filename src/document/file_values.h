#pragma once
#include <functional>

#include "parameter/parameter.h"

namespace blossom {

/// Calls `visit` with every file that a parameter holds, in lists and records too, as {"path", "asset"}; one that is written
/// as a plain path is brought into that form. What has another form than its declaration is passed over: the evaluation
/// refuses it.
void eachFile(const ParameterSpec&, Value&, const std::function<void(Value& file)>& visit);
void eachFile(const std::vector<ParameterSpec>&, Value& parameters, const std::function<void(Value& file)>& visit);

/// Whether one of these, or what they hold, can be a file.
bool holdsFiles(const std::vector<ParameterSpec>&);

}  // namespace blossom
