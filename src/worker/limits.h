#pragma once
#include "parameter/value.h"

namespace blossom {

/// Limits computing time and memory of this process as a request asks for; both count from now on and until the next
/// request.
void applyLimits(const Value& request);

/// Whether this process is as good as a new one: not when a call has left much memory behind.
bool mayServeAgain();

}  // namespace blossom
