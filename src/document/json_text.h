#pragma once
#include <string>
#include <vector>

#include "parameter/value.h"

namespace blossom {

/// JSON for people and version control: two blanks per level, but whatever fits stays on one line (a point, a list of
/// knots). Numbers read back as the same doubles; bytes that are no UTF-8 become U+FFFD.
std::string prettyJson(const Value&);

/// The texts of the objects that stand directly in the array under `key`, as far as they are complete: for documents cut off
/// in the middle. Knows strings and brackets only.
std::vector<std::string> completeObjects(const std::string& json, const std::string& key);

}  // namespace blossom
