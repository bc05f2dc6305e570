#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/units.h"
#include "parameter/parameter.h"
#include "parameter/wording.h"
#include "parameter/written.h"

namespace blossom {
namespace {

[[noreturn]] void invalid(const ParameterSpec& spec, const std::string& subject, const std::string& demand,
                          const std::string& is, const std::string& hint = {}) {
  throw Error(ErrorCode::InvalidParameter, fmt::format("{} {}; {}.", subject, demand, is), hint.empty() ? spec.help : hint);
}

[[noreturn]] void wrongForm(const ParameterSpec& spec, const std::string& subject, const std::string& demand,
                            const Value& value, const std::string& hint = {}) {
  invalid(spec, subject, demand, value.is_null() ? "it is empty" : "it is " + quoted(value), hint);
}

void checkRange(const ParameterSpec& spec, const std::string& subject, double value, const std::string& is) {
  const bool tooSmall = spec.minimum && (value < *spec.minimum || (spec.aboveMinimum && value == *spec.minimum));
  const bool tooLarge = spec.maximum && value > *spec.maximum;
  if (tooSmall || tooLarge) invalid(spec, subject, demandRange(spec), is);
}

Value checkNumber(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) wrongForm(spec, subject, "must be a number", value);
  const double number = value.get<double>();
  checkRange(spec, subject, number, "it is " + formatNumber(number));
  return number;
}

/// Counts end up in ints.
Value checkCount(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  const bool number = value.is_number() && std::isfinite(value.get<double>());
  if (!number || std::trunc(value.get<double>()) != value.get<double>())
    wrongForm(spec, subject, "must be a whole number", value);
  const double whole = value.get<double>();
  checkRange(spec, subject, whole, "it is " + formatNumber(whole));
  constexpr double limit = std::numeric_limits<int>::max();
  if (std::abs(whole) > limit) wrongForm(spec, subject, fmt::format("must be at most {}", formatNumber(limit)), value);
  return static_cast<std::int64_t>(whole);
}

Value checkChoice(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  const auto* name = value.get_ptr<const std::string*>();
  if (name && std::find(spec.choices.begin(), spec.choices.end(), *name) != spec.choices.end()) return value;
  const std::string near = name ? nearestName(*name, spec.choices) : std::string();
  wrongForm(spec, subject, "must be " + enumerated(spec.choices, "or"), value,
            near.empty() ? "" : fmt::format("Did you mean {}?", near));
}

/// #rgb and #rrggbb in any case become #rrggbb in lower case.
Value checkColor(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  const auto* given = value.get_ptr<const std::string*>();
  const auto isHex = [](unsigned char c) { return std::isxdigit(c) != 0; };
  if (!given || (given->size() != 4 && given->size() != 7) || given->front() != '#' ||
      !std::all_of(given->begin() + 1, given->end(), isHex))
    wrongForm(spec, subject, "must be a colour", value, "Write it as #rrggbb, for example #ff8800.");
  std::string color = "#";
  for (const char c : given->substr(1)) color.append(given->size() == 4 ? 2 : 1, static_cast<char>(std::tolower(c)));
  return color;
}

Value checkCoordinates(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  const bool point = spec.kind == ParameterKind::Point;
  const bool needsAll = point && spec.minimum && *spec.minimum > 2;
  if (!value.is_array() || value.size() < (needsAll ? 3 : 2) || value.size() > 3)
    wrongForm(spec, subject, point ? "must be a point" : "must be a vector", value,
              needsAll ? "Write all of x,y,z." : "Write x,y,z; z may be left out and is then 0.");
  Value all = Value::array();
  constexpr std::string_view axes = "xyz";
  for (std::size_t i = 0; i < value.size(); ++i) {
    ParameterSpec named = coordinateOf(spec);
    named.name = fmt::format("{} of {}", axes[i], subject);
    all.push_back(checked(named, value[i]));
  }
  if (all.size() == 2) all.push_back(0.0);
  return all;
}

Value checkFile(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  if (value.is_null()) return {};
  if (const auto* path = value.get_ptr<const std::string*>())
    return path->empty() ? Value() : Value{{"path", *path}, {"asset", ""}};
  const auto isText = [&](const char* key) { return !value.contains(key) || value.at(key).is_string(); };
  if (!value.is_object() || !isText("path") || !isText("asset")) wrongForm(spec, subject, "must be a file", value);
  Value file{{"path", value.value("path", "")}, {"asset", value.value("asset", "")}};
  const auto blank = [&](const char* key) { return file.at(key).get_ref<const std::string&>().empty(); };
  return blank("path") && blank("asset") ? Value() : file;
}

Value checkCurve(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  constexpr const char* form = "Write t:value pairs with t not decreasing, for example 0:1, 0.5:2, 1:1.";
  if (!value.is_array()) wrongForm(spec, subject, "must be a curve", value, form);
  Value curve = Value::array();
  double last = -std::numeric_limits<double>::infinity();
  for (const Value& pair : value) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number())
      wrongForm(spec, subject, "must be a curve", value, form);
    const double t = checkNumber({}, "t of " + subject, pair[0]).get<double>();
    if (t < last) wrongForm(spec, subject, "must have values of t that do not decrease", value, form);
    curve.push_back({t, checkNumber(spec, "value of " + subject, pair[1])});
    last = t;
  }
  return curve;
}

Value checkSubShape(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  if (value.is_null()) return {};
  const std::string kind = subShapeKind(spec);
  const auto wrong = [&] {
    wrongForm(spec, subject, fmt::format("must name {} {} of an input", kind == "edge" ? "an" : "a", kind), value,
              fmt::format("Write input:{}:number, for example base:{}:0.", kind, kind));
  };
  if (!value.is_object() || !value.contains("index") || !value.at("index").is_number_integer() || value.at("index") < 0)
    wrong();
  const Value input = value.value("input", Value("")), found = value.value("kind", Value(kind));
  if (!input.is_string() || !found.is_string() || (!spec.choices.empty() && found != kind)) wrong();
  if (value.at("index") > std::numeric_limits<int>::max()) wrong();
  Value part{{"input", input}, {"kind", found}, {"index", value.at("index").get<std::int64_t>()}};
  if (const auto signature = value.find("signature"); signature != value.end() && signature->is_object())
    part["signature"] = *signature;
  return part;
}

Value checkAt(const ParameterSpec&, const std::string& subject, const Value&);

Value checkList(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  if (!value.is_array()) wrongForm(spec, subject, "must be a list", value);
  checkRange(spec, subject, static_cast<double>(value.size()), fmt::format("it has {}", value.size()));
  Value items = Value::array();
  for (const Value& item : value)
    items.push_back(checkAt(spec.fields.at(0), fmt::format("item {} of {}", items.size() + 1, subject), item));
  return items;
}

/// @param of " of item 2 of pins": what the names belong to
Value completeAt(const std::vector<ParameterSpec>& specs, const std::string& of, const Value& given) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const auto& spec : specs) names.push_back(spec.name);
  for (const auto& [name, value] : given.items()) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string near = nearestName(name, names);
    throw Error(ErrorCode::InvalidParameter, fmt::format("\"{}\" is not a parameter{}.", name, of),
                near.empty() ? (names.empty() ? "There are none." : fmt::format("There are {}.", enumerated(names, "and")))
                             : fmt::format("Did you mean {}?", near));
  }
  Value all = Value::object();
  for (const auto& spec : specs) {
    const auto found = given.find(spec.name);
    Value value = found != given.end() && !found->is_null() ? checkAt(spec, label(spec) + of, *found) : spec.fallback;
    if (value.is_null() && !spec.mayBeAbsent)
      throw Error(ErrorCode::InvalidParameter, fmt::format("{}{} must be given.", label(spec), of), spec.help);
    all[spec.name] = std::move(value);
  }
  return all;
}

Value checkAt(const ParameterSpec& spec, const std::string& subject, const Value& value) {
  using enum ParameterKind;
  if (isNumeric(spec) && isNamedExpression(value)) return checkAt(spec, subject, value.at("value"));
  const bool textual = spec.kind == Text || spec.kind == Choice || spec.kind == Color || spec.kind == File;
  if (value.is_string() && !textual) {
    ParameterSpec named = spec;
    named.name = subject;
    return parseText(named, value.get_ref<const std::string&>());
  }
  switch (spec.kind) {
    case Flag:
      if (!value.is_boolean()) wrongForm(spec, subject, "must be yes or no", value);
      return value;
    case Count:
      return checkCount(spec, subject, value);
    case Number:
    case Ratio:
    case Length:
    case Angle:
      return checkNumber(spec, subject, value);
    case Choice:
      return checkChoice(spec, subject, value);
    case Text:
      if (!value.is_string()) wrongForm(spec, subject, "must be a text", value);
      return value;
    case Color:
      return checkColor(spec, subject, value);
    case Point:
    case Vector:
    case Displacement:
      return checkCoordinates(spec, subject, value);
    case File:
      return checkFile(spec, subject, value);
    case Curve:
      return checkCurve(spec, subject, value);
    case SubShape:
      return checkSubShape(spec, subject, value);
    case List:
      return checkList(spec, subject, value);
    case Record:
      if (!value.is_object()) wrongForm(spec, subject, "must be a record", value);
      return completeAt(spec.fields, " of " + subject, value);
  }
  return value;
}

}  // namespace

Value checked(const ParameterSpec& spec, const Value& value) { return checkAt(spec, label(spec), value); }

Value completed(const std::vector<ParameterSpec>& specs, const Value& given) {
  if (!given.is_object() && !given.is_null())
    throw Error(ErrorCode::InvalidParameter, fmt::format("The parameters must be a record; they are {}.", quoted(given)));
  return completeAt(specs, "", given.is_null() ? Value::object() : given);
}

}  // namespace blossom
