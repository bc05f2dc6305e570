#pragma once
#include <string>
#include <vector>

#include "parameter/value.h"

namespace blossom {

/// JSON for people and version control: two blanks per level, short values on one line (a point, a list of knots). Numbers
/// have enough digits to be read back as the same double; bytes that are no UTF-8 become U+FFFD.
std::string prettyJson(const Value&);

/// The texts of the complete objects directly in the array under `key`, for truncated documents. Interprets only strings and
/// brackets.
std::vector<std::string> completeObjects(const std::string& json, const std::string& key);

}  // namespace blossom
