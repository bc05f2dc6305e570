#include "pulls.h"

#include <fmt/format.h>

#include <charconv>

#include "core/error.h"

namespace blossom::subdivision {
namespace {

Vec3 vectorOf(const Value& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}
Value arrayOf(const Vec3& p) { return Value::array({p.x(), p.y(), p.z()}); }

}  // namespace

std::vector<Pull> pullsOf(const std::vector<Value>& records) {
  std::vector<Pull> pulls;
  for (const Value& each : records) pulls.push_back({vectorOf(each.at("at")), vectorOf(each.at("to"))});
  return pulls;
}

FreeRule ruleOf(const std::string& text) {
  if (text == "support") return {};
  if (text == "paper") return {.paper = true};
  constexpr std::string_view rings = "rings:";
  if (text.starts_with(rings)) {
    FreeRule rule;
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data() + rings.size(), end, rule.rings);
    if (error == std::errc{} && stopped == end && rule.rings >= -100 && rule.rings <= 100) return rule;
  }
  throw Error(ErrorCode::InvalidParameter, fmt::format("free must be support, paper or rings:N; it is \"{}\".", text),
              "Give rings:1 for the support and one ring around it, rings:-1 for one ring less.");
}

Value recordOf(const Pull& pull) { return {{"at", arrayOf(pull.at)}, {"to", arrayOf(pull.to)}}; }

}  // namespace blossom::subdivision
