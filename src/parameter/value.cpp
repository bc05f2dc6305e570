#include "parameter/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.h"

namespace blossom {
namespace {

constexpr int deepest = 100;
constexpr std::size_t widest = 4096;

/// nlohmann's "[json.exception.parse_error.101] parse error at line 1, column 5: ..." without the part for programmers.
std::string withoutPrefix(const std::string& what) {
  const auto end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

}  // namespace

Value parseJson(std::string_view text) {
  std::vector<std::size_t> keysAtDepth(deepest + 2, 0);
  const Value::parser_callback_t limits = [&](int depth, Value::parse_event_t event, Value&) {
    if (depth > deepest)
      throw Error(ErrorCode::LimitExceeded, fmt::format("The JSON is nested more than {} levels deep.", deepest));
    const auto level = static_cast<std::size_t>(std::max(depth, 0));
    if (event == Value::parse_event_t::object_start) keysAtDepth[level + 1] = 0;
    if (event == Value::parse_event_t::key && ++keysAtDepth[level] > widest)
      throw Error(ErrorCode::LimitExceeded, fmt::format("An object in the JSON has more than {} keys.", widest));
    return true;
  };
  try {
    return Value::parse(text, limits);
  } catch (const Value::exception& e) {
    throw Error(ErrorCode::FormatDamaged, fmt::format("The JSON cannot be read: {}.", withoutPrefix(e.what())));
  }
}

}  // namespace blossom
