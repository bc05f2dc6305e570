#include <fmt/format.h>

#include <charconv>

#include "core/error.h"
#include "core/units.h"
#include "parameter/parameter.h"
#include "parameter/wording.h"

namespace blossom {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Separators inside of parentheses belong to an expression, as in "max(1, 2), 3".
std::vector<std::string_view> split(std::string_view text, char separator, bool expressions = true) {
  std::vector<std::string_view> parts;
  if (trimmed(text).empty()) return parts;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (expressions && text[at] == '(') ++depth;
    if (expressions && text[at] == ')') --depth;
    if (text[at] != separator || depth > 0) continue;
    parts.push_back(trimmed(text.substr(from, at - from)));
    from = at + 1;
  }
  parts.push_back(trimmed(text.substr(from)));
  return parts;
}

[[noreturn]] void notUnderstood(const ParameterSpec& spec, const Error& why) {
  throw Error(ErrorCode::InvalidParameter, fmt::format("{}: {}", label(spec), why.message()), why.hint());
}

/// A number by `parse`, which throws without knowing the parameter's name.
template <class Parse>
Value measure(const ParameterSpec& spec, std::string_view text, Parse parse) {
  try {
    return checked(spec, parse(text));
  } catch (const Error& e) {
    if (e.message().starts_with(label(spec))) throw;  // from the range check
    notUnderstood(spec, e);
  }
}

Value parseFlag(const ParameterSpec& spec, std::string_view text) {
  for (const auto yes : {"yes", "true", "on", "1"})
    if (text == yes) return true;
  for (const auto no : {"no", "false", "off", "0"})
    if (text == no) return false;
  throw Error(ErrorCode::InvalidParameter, fmt::format("{} must be yes or no; it is {}.", label(spec), quoted(Value(text))),
              spec.help);
}

Value parseCurve(std::string_view text) {
  Value curve = Value::array();
  for (const auto pair : split(text, ',')) {
    const auto colon = pair.find(':');
    if (colon == std::string_view::npos)
      throw Error(ErrorCode::InvalidParameter, fmt::format("\"{}\" is not a pair t:value.", pair),
                  "Write for example 0:1, 0.5:2, 1:1.");
    curve.push_back({parseNumber(pair.substr(0, colon)), parseNumber(pair.substr(colon + 1))});
  }
  return curve;
}

/// "base:face:3"; the name may contain colons. Also "face:3" and "3".
Value parseSubShape(const ParameterSpec& spec, std::string_view text) {
  Value result{{"input", ""}, {"kind", subShapeKind(spec)}, {"index", nullptr}};
  const auto last = text.rfind(':');
  const std::string_view digits = last == std::string_view::npos ? text : text.substr(last + 1);
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error == std::errc{} && end == digits.data() + digits.size()) result["index"] = index;
  if (last != std::string_view::npos) {
    const std::string_view front = text.substr(0, last);
    const auto colon = front.rfind(':');
    result["kind"] = colon == std::string_view::npos ? front : front.substr(colon + 1);
    if (colon != std::string_view::npos) result["input"] = front.substr(0, colon);
  }
  return checked(spec, result);
}

/// Texts may contain any parenthesis.
bool itemsAreExpressions(const ParameterSpec& element) {
  using enum ParameterKind;
  return element.kind != Text && element.kind != File && element.kind != SubShape && element.kind != Choice;
}

bool itemsHoldCommas(const ParameterSpec& element) {
  using enum ParameterKind;
  return element.kind == Point || element.kind == Vector || element.kind == Displacement || element.kind == Curve ||
         element.kind == List;
}

Value parseJsonText(const ParameterSpec& spec, std::string_view text) {
  try {
    return parseJson(text);
  } catch (const Error& e) {
    notUnderstood(spec, e);
  }
}

Value parseList(const ParameterSpec& spec, std::string_view text, const NamedNumbers& names) {
  if (text.starts_with('[')) return checked(spec, parseJsonText(spec, text));
  const ParameterSpec& element = spec.fields.at(0);
  Value items = Value::array();
  for (const auto part : split(text, itemsHoldCommas(element) ? ';' : ',', itemsAreExpressions(element))) {
    ParameterSpec item = element;
    item.name = fmt::format("item {} of {}", items.size() + 1, label(spec));
    items.push_back(parseText(item, part, {}, names));
  }
  return checked(spec, items);
}

Value parseCoordinates(const ParameterSpec& spec, std::string_view text, const NamedNumbers& names) {
  if (text.starts_with('[')) return checked(spec, parseJsonText(spec, text));
  Value parts = Value::array();
  constexpr std::string_view axes = "xyz";
  for (const auto part : split(text, ',')) {
    ParameterSpec named = coordinateOf(spec);
    if (parts.size() < axes.size()) named.name = fmt::format("{} of {}", axes[parts.size()], label(spec));
    parts.push_back(names.empty() ? Value(part) : parseText(named, part, {}, names));
  }
  return checked(spec, parts);
}

std::string joined(const Value& values, const ParameterSpec& element, std::string_view separator) {
  std::string text;
  for (const Value& value : values) {
    if (!text.empty()) text += separator;
    text += formatText(element, value);
  }
  return text;
}

std::string formatCurve(const Value& curve) {
  std::string text;
  for (const Value& pair : curve) {
    if (!text.empty()) text += ", ";
    text += formatNumber(pair.at(0).get<double>()) + ":" + formatNumber(pair.at(1).get<double>());
  }
  return text;
}

std::string asJson(const Value& value) { return value.dump(-1, ' ', false, Value::error_handler_t::replace); }

/// With separators when that is unambiguous and lossless, else JSON.
std::string formatList(const ParameterSpec& spec, const Value& list) {
  const ParameterSpec& element = spec.fields.at(0);
  const char separator = itemsHoldCommas(element) ? ';' : ',';
  const auto plain = [&](const Value& item) {
    if (element.kind == ParameterKind::File && item.is_object() && !item.value("asset", std::string()).empty()) return false;
    const std::string text = formatText(element, item);
    return !text.empty() && trimmed(text).size() == text.size() && text.find(separator) == std::string::npos &&
           text.front() != '[';
  };
  if (element.kind == ParameterKind::Record || !std::all_of(list.begin(), list.end(), plain)) return asJson(list);
  return joined(list, element, std::string(1, separator) + " ");
}

}  // namespace

Value parseText(const ParameterSpec& spec, std::string_view given, const LengthUnit& unit, const NamedNumbers& names) {
  using enum ParameterKind;
  if (spec.kind == Text) return checked(spec, Value(given));
  const std::string_view text = trimmed(given);
  switch (spec.kind) {
    case Flag:
      return parseFlag(spec, text);
    case Count:
    case Number:
    case Ratio:
      return measure(spec, text, [&](std::string_view number) { return parseNumber(number, names); });
    case Length:
      return measure(spec, text, [&](std::string_view length) { return parseLength(length, unit, names); });
    case Angle:
      return measure(spec, text, [&](std::string_view angle) { return parseAngle(angle, names); });
    case Point:
    case Vector:
    case Displacement:
      return parseCoordinates(spec, text, names);
    case Curve:
      return text.starts_with('[') ? checked(spec, parseJsonText(spec, text)) : measure(spec, text, parseCurve);
    case SubShape:
      if (text.empty()) return {};
      return text.starts_with('{') ? checked(spec, parseJsonText(spec, text)) : parseSubShape(spec, text);
    case List:
      return parseList(spec, text, names);
    case Record:
      return checked(spec, parseJsonText(spec, text));
    case File:
      return checked(spec, Value(given));  // blanks may belong to a path
    case Choice:
    case Color:
    case Text:
      break;
  }
  return checked(spec, Value(text));
}

std::string formatText(const ParameterSpec& spec, const Value& value, const LengthUnit& unit) {
  using enum ParameterKind;
  if (value.is_null()) return {};
  switch (spec.kind) {
    case Flag:
      return value.get<bool>() ? "yes" : "no";
    case Count:
      return std::to_string(value.get<std::int64_t>());
    case Length:
      return formatLength(value.get<double>(), unit);
    case Number:
    case Ratio:
    case Angle:
      return formatNumber(value.get<double>()) + std::string(unitSuffix(spec));
    case Choice:
    case Text:
    case Color:
      return value.get<std::string>();
    case Point:
    case Vector:
    case Displacement:
      return joined(value, number(), ", ");
    case File:
      return value.is_string() ? value.get<std::string>() : value.value("path", "");
    case Curve:
      return formatCurve(value);
    case SubShape:
      return fmt::format("{}:{}:{}", value.value("input", ""), value.value("kind", ""),
                         value.value("index", std::int64_t{0}));
    case List:
      return formatList(spec, value);
    case Record:
      return asJson(value);
  }
  return {};
}

}  // namespace blossom
