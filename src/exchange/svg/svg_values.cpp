#include "exchange/svg/svg_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "exchange/format/text.h"

namespace blossom::svg {

using parse::shown;
using parse::trimmed;

namespace {

bool isSeparator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ','; }

/// Removes the longest possible number from the front: 1.5 from "1.5.5".
std::optional<double> takeNumber(std::string_view& text) {
  std::string_view digits = text;
  if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return {};
  text = digits.substr(static_cast<std::size_t>(end - digits.data()));
  return value;
}

void skipSeparators(std::string_view& text) {
  while (!text.empty() && isSeparator(text.front())) text.remove_prefix(1);
}

Eigen::Affine2d matrix(double a, double b, double c, double d, double e, double f) {
  Eigen::Affine2d result = Eigen::Affine2d::Identity();
  result.affine() << a, c, e, b, d, f;
  return result;
}

Eigen::Affine2d transformStep(std::string_view name, const std::vector<double>& v) {
  const auto at = [&](std::size_t i, double fallback) { return i < v.size() ? v[i] : fallback; };
  if (name == "matrix" && v.size() == 6) return matrix(v[0], v[1], v[2], v[3], v[4], v[5]);
  if (name == "translate" && (v.size() == 1 || v.size() == 2)) return matrix(1, 0, 0, 1, v[0], at(1, 0));
  if (name == "scale" && (v.size() == 1 || v.size() == 2)) return matrix(v[0], 0, 0, at(1, v[0]), 0, 0);
  if (name == "skewX" && v.size() == 1) return matrix(1, 0, std::tan(toRadians(v[0])), 1, 0, 0);
  if (name == "skewY" && v.size() == 1) return matrix(1, std::tan(toRadians(v[0])), 0, 1, 0, 0);
  if (name == "rotate" && (v.size() == 1 || v.size() == 3)) {
    const Eigen::Vector2d center(at(1, 0), at(2, 0));
    return Eigen::Affine2d(Eigen::Translation2d(center) * Eigen::Rotation2Dd(toRadians(v[0])) *
                           Eigen::Translation2d(-center));
  }
  throw Error(ErrorCode::FormatDamaged,
              fmt::format("The transform {} with {} numbers is not known.", shown(name), v.size()));
}

}  // namespace

std::optional<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (skipSeparators(text); !text.empty(); skipSeparators(text)) {
    const std::optional<double> number = takeNumber(text);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Length> parseLength(std::string_view text) {
  text = trimmed(text);
  const std::optional<double> value = takeNumber(text);
  if (!value) return {};
  text = trimmed(text);
  if (text.size() > 4) return {};
  return Length{*value, std::string(text)};
}

double millimetresOf(std::string_view unit) {
  if (unit == "mm") return 1;
  if (unit == "cm") return 10;
  if (unit == "in") return 25.4;
  if (unit == "pt") return 25.4 / 72;
  if (unit == "pc") return 25.4 / 6;
  if (unit == "Q") return 0.25;
  return 0;
}

Eigen::Affine2d parseTransform(std::string_view text) {
  Eigen::Affine2d result = Eigen::Affine2d::Identity();
  text = trimmed(text);
  if (text == "none") return result;
  for (skipSeparators(text); !text.empty(); skipSeparators(text)) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      throw Error(ErrorCode::FormatDamaged, fmt::format("The transform {} has no closed brackets.", shown(text)));
    const auto numbers = parseNumbers(text.substr(open + 1, close - open - 1));
    if (!numbers) throw Error(ErrorCode::FormatDamaged, fmt::format("The transform {} needs numbers.", shown(text)));
    result = result * transformStep(trimmed(text.substr(0, open)), *numbers);
    text.remove_prefix(close + 1);
  }
  return result;
}

Eigen::Affine2d fitViewBox(const std::vector<double>& box, double width, double height, std::string_view aspect) {
  double sx = width / box[2], sy = height / box[3];
  if (aspect.find("none") != std::string_view::npos) return matrix(sx, 0, 0, sy, -box[0] * sx, -box[1] * sy);
  sx = sy = aspect.find("slice") != std::string_view::npos ? std::max(sx, sy) : std::min(sx, sy);
  const auto share = [&](char axis) {
    const std::string prefix(1, axis);
    if (aspect.find(prefix + "Min") != std::string_view::npos) return 0.0;
    return aspect.find(prefix + "Max") != std::string_view::npos ? 1.0 : 0.5;
  };
  return matrix(sx, 0, 0, sy, share('x') * (width - box[2] * sx) - box[0] * sx,
                share('Y') * (height - box[3] * sy) - box[1] * sy);
}

std::optional<Color> parsePaint(std::string_view text) {
  text = trimmed(text);
  if (text.substr(0, 4) != "rgb(" || text.back() != ')') return parseColor(text);
  std::string list(text.substr(4, text.size() - 5));
  const bool percent = list.find('%') != std::string::npos;
  std::replace(list.begin(), list.end(), '%', ' ');
  const auto numbers = parseNumbers(list);
  if (!numbers || numbers->size() != 3) return {};
  const auto channel = [&](double v) { return std::clamp(v / (percent ? 100 : 255), 0.0, 1.0); };
  return Color{channel((*numbers)[0]), channel((*numbers)[1]), channel((*numbers)[2])};
}

Declarations parseDeclarations(std::string_view text) {
  Declarations result;
  while (!text.empty()) {
    const std::size_t end = text.find(';');
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view value = trimmed(one.substr(colon + 1));
    value = trimmed(value.substr(0, value.find("!important")));
    result.insert_or_assign(std::string(trimmed(one.substr(0, colon))), std::string(value));
  }
  return result;
}

std::map<std::string, Declarations, std::less<>> parseStyleSheet(std::string_view text) {
  std::map<std::string, Declarations, std::less<>> rules;
  while (!text.empty()) {
    const std::size_t open = text.find('{'), close = text.find('}');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) break;
    std::string_view selectors = text.substr(0, open);
    const Declarations declarations = parseDeclarations(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
    while (!selectors.empty()) {
      const std::size_t comma = selectors.find(',');
      const std::string_view selector = trimmed(selectors.substr(0, comma));
      selectors.remove_prefix(comma == std::string_view::npos ? selectors.size() : comma + 1);
      if (selector.empty() || selector.find_first_of(" >+~:[*") != std::string_view::npos) continue;
      for (const auto& [name, value] : declarations) rules[std::string(selector)].insert_or_assign(name, value);
    }
  }
  return rules;
}

}  // namespace blossom::svg
