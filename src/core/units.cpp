#include "core/units.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/error.h"

namespace blossom {
namespace {

using UnitTable = std::array<std::pair<std::string_view, double>, 13>;

constexpr UnitTable lengthUnits{{{"mm", 1},
                                 {"um", 1e-3},
                                 {"µm", 1e-3},
                                 {"cm", 10},
                                 {"dm", 100},
                                 {"m", 1000},
                                 {"in", millimetresPerInch},
                                 {"inch", millimetresPerInch},
                                 {"\"", millimetresPerInch},
                                 {"ft", 12 * millimetresPerInch},
                                 {"'", 12 * millimetresPerInch},
                                 {"mil", millimetresPerInch / 1000},
                                 {"thou", millimetresPerInch / 1000}}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Reads one plain number off the front of the text.
std::optional<double> takeNumber(std::string_view& text) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  return value;
}

struct Quantity {
  double value;
  std::string_view unit;
};

/// "1 1/2 in" -> {1.5, "in"}. Whole numbers may be followed by a fraction, as on a tape measure.
std::optional<Quantity> parseQuantity(std::string_view text) {
  std::string_view rest = text;
  auto value = takeNumber(rest);
  if (!value) return std::nullopt;
  const auto takeFraction = [&](double numerator) -> std::optional<double> {
    rest.remove_prefix(1);
    const auto denominator = takeNumber(rest);
    if (!denominator || *denominator == 0) return std::nullopt;
    return numerator / *denominator;
  };
  if (!rest.empty() && rest.front() == '/') {
    value = takeFraction(*value);
  } else if (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
    const auto numerator = takeNumber(rest);
    if (!numerator || rest.empty() || rest.front() != '/') return std::nullopt;
    const auto fraction = takeFraction(*numerator);
    if (!fraction) return std::nullopt;
    value = *value + std::copysign(*fraction, *value);
  }
  if (!value) return std::nullopt;
  return Quantity{*value, rest};
}

[[noreturn]] void notUnderstood(std::string_view text, std::string_view what, std::string_view examples) {
  throw Error(ErrorCode::InvalidParameter, fmt::format("\"{}\" is not {}.", text, what),
              fmt::format("Write for example {}.", examples));
}

}  // namespace

double millimetresPer(std::string_view unit) {
  for (const auto& [name, factor] : lengthUnits)
    if (name == unit) return factor;
  return 0;
}

double parseLength(std::string_view text) {
  if (const auto quantity = parseQuantity(text)) {
    if (quantity->unit.empty()) return quantity->value;
    if (const double factor = millimetresPer(quantity->unit); factor > 0) return quantity->value * factor;
  }
  notUnderstood(text, "a length", "12, 3cm, 1/2 in or 0.5 m; without a unit it is mm");
}

double parseAngle(std::string_view text) {
  if (const auto quantity = parseQuantity(text)) {
    if (quantity->unit.empty() || quantity->unit == "deg" || quantity->unit == "°") return quantity->value;
    if (quantity->unit == "rad") return quantity->value * 180 / std::numbers::pi;
    if (quantity->unit == "turn") return quantity->value * 360;
  }
  notUnderstood(text, "an angle", "30, 30deg, 0.5rad or 0.25turn; without a unit it is degrees");
}

double parseNumber(std::string_view text) {
  if (const auto quantity = parseQuantity(text); quantity && quantity->unit.empty()) return quantity->value;
  notUnderstood(text, "a number", "0.5, 3/4 or 1e-3");
}

std::string formatNumber(double value) { return fmt::format("{}", value); }

}  // namespace blossom
