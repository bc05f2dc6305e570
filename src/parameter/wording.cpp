#include "parameter/wording.h"

#include <fmt/format.h>

#include "core/units.h"

namespace blossom {
namespace {

constexpr std::size_t longestQuote = 60;

std::string items(double n) { return fmt::format("{} {}", formatNumber(n), n == 1 ? "item" : "items"); }

std::string plainBound(const ParameterSpec& spec, double value, const LengthUnit& unit) {
  return formatNumber(spec.kind == ParameterKind::Length ? value / unit.millimetres : value);
}

/// Bound with its unit; lists are bounded in their number of items.
std::string bound(const ParameterSpec& spec, double value, const LengthUnit& unit = {}) {
  if (spec.kind == ParameterKind::List) return items(value);
  const std::string number = plainBound(spec, value, unit);
  return spec.kind == ParameterKind::Length ? number + ' ' + unit.name : number + std::string(unitSuffix(spec));
}

}  // namespace

std::string enumerated(const std::vector<std::string>& names, std::string_view lastJoint) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? fmt::format(" {} ", lastJoint) : ", ";
    text += names[i];
  }
  return text;
}

std::string_view unitSuffix(const ParameterSpec& spec) {
  if (spec.kind == ParameterKind::Length) return " mm";
  if (spec.kind == ParameterKind::Angle) return "°";
  return "";
}

std::string describeRange(const ParameterSpec& spec, const LengthUnit& unit) {
  if (spec.kind == ParameterKind::Point) return {};  // "point x,y,z" says it
  if (spec.minimum && spec.maximum)
    return fmt::format("{} {} to {}", spec.aboveMinimum ? "above" : "from", plainBound(spec, *spec.minimum, unit),
                       bound(spec, *spec.maximum, unit));
  if (spec.minimum) return fmt::format("{} {}", spec.aboveMinimum ? "above" : "at least", bound(spec, *spec.minimum, unit));
  if (spec.maximum) return fmt::format("at most {}", bound(spec, *spec.maximum, unit));
  return {};
}

std::string demandRange(const ParameterSpec& spec) {
  const bool list = spec.kind == ParameterKind::List;
  const std::string be = list ? "must have" : "must be";
  if (spec.minimum && spec.maximum && spec.aboveMinimum)
    return fmt::format("{} above {} and at most {}", be, bound(spec, *spec.minimum), bound(spec, *spec.maximum));
  if (spec.minimum && spec.maximum)
    return fmt::format("{} between {} and {}", list ? be : "must lie", formatNumber(*spec.minimum),
                       bound(spec, *spec.maximum));
  return fmt::format("{} {}", be, describeRange(spec));
}

std::string subShapeKind(const ParameterSpec& spec) { return spec.choices.empty() ? "part" : spec.choices.front(); }

std::string quoted(const Value& value) {
  std::string text = value.is_number_float() ? formatNumber(value.get<double>())
                                             : value.dump(-1, ' ', false, Value::error_handler_t::replace);
  if (text.size() <= longestQuote) return text;
  std::size_t cut = longestQuote;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;  // never inside a UTF-8 character
  return text.substr(0, cut) + "..";
}

}  // namespace blossom
