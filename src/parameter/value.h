#pragma once
#include <nlohmann/json.hpp>

namespace blossom {

/// The value of a parameter, in the one form used by documents, command line and panels alike. Canonical forms: flag bool, count
/// integer, number/ratio/length(mm)/angle(degrees) number, choice/text string, colour "#rrggbb", point and vector [x, y, z],
/// file {"path": .., "asset": ..}, curve [[t, value], ..], sub-shape {"input": name, "kind": "face"|"edge"|"vertex", "index": n},
/// list [..], record {..}.
using Value = nlohmann::ordered_json;

}  // namespace blossom
