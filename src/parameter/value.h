#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

namespace blossom {

/// The value of a parameter, in the one form used by documents, command line and panels alike. Canonical forms: flag bool,
/// count integer, number/ratio/length(mm)/angle(degrees) number, choice/text string, colour "#rrggbb", point and vector [x,
/// y, z], file {"path": .., "asset": ..}, curve [[t, value], ..], sub-shape {"input": name, "kind": "face"|"edge"|"vertex",
/// "index": n}, list [..], record {..}.
using Value = nlohmann::ordered_json;

/// Parses JSON from files nobody vouches for: depth and width of objects are limited, so that neither the recursion of later
/// code nor the linear look-up of ordered objects can be abused.
/// @throws Error FormatDamaged with line and column, LimitExceeded.
Value parseJson(std::string_view text);

}  // namespace blossom
