#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

namespace blossom {

/// The value of a parameter, in the same form in documents, command line and panels. Canonical forms: flag bool, count
/// integer, number/ratio/length(mm)/angle(degrees) number, choice/text string, colour "#rrggbb", point and vector [x, y, z],
/// file {"path": .., "asset": ..}, curve [[t, value], ..], sub-shape {"input": name, "kind": "face"|"edge"|"vertex",
/// "index": n} and what it is found again by, "signature": {..} (naming/part_reference.h), list [..], record {..}.
using Value = nlohmann::ordered_json;

/// Parses JSON from untrusted files: depth and width of objects are limited, because later code recurses and looks up the
/// keys of ordered objects linearly.
/// @throws Error FormatDamaged with line and column, LimitExceeded.
Value parseJson(std::string_view text);

}  // namespace blossom
