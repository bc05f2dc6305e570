#pragma once
#include "parameter/value.h"

namespace blossom {

/// Whether a value holds lists of lists, such as points of many outlines: data for programs, too much for a line of text.
/// O(size of the value).
bool isNestedData(const Value&);

}  // namespace blossom
