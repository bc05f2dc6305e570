#include "parameter/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/units.h"
#include "parameter/wording.h"

namespace blossom {
namespace {

constexpr std::array<std::string_view, 17> kindNames{"flag",   "count", "number",    "ratio", "length", "angle",
                                                     "choice", "text",  "color",     "point", "vector", "displacement",
                                                     "file",   "curve", "sub-shape", "list",  "record"};

ParameterSpec ofKind(ParameterKind kind) {
  ParameterSpec spec;
  spec.kind = kind;
  return spec;
}

ParameterSpec above0(ParameterKind kind) {
  ParameterSpec spec = ofKind(kind);
  spec.minimum = 0;
  spec.aboveMinimum = true;
  return spec;
}

std::string fieldNames(const std::vector<ParameterSpec>& fields) {
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const auto& field : fields) names.push_back(field.name);
  return enumerated(names, "and");
}

std::string plural(const LengthUnit& unit) { return unit.name == "in" ? "inches" : unit.name == "ft" ? "feet" : unit.name; }

/// "length in mm", without the range.
std::string describeKind(const ParameterSpec& spec, const LengthUnit& unit) {
  switch (spec.kind) {
    case ParameterKind::Flag:
      return "yes or no";
    case ParameterKind::Count:
      return "whole number";
    case ParameterKind::Number:
    case ParameterKind::Ratio:
      return "number";
    case ParameterKind::Length:
      return "length in " + plural(unit);
    case ParameterKind::Angle:
      return "angle in degrees";
    case ParameterKind::Choice:
      return enumerated(spec.choices, "or");
    case ParameterKind::Text:
      return "text";
    case ParameterKind::Color:
      return "colour as #rrggbb";
    case ParameterKind::Point:
      return "point x,y,z in " + plural(unit);
    case ParameterKind::Vector:
      return "vector x,y,z";
    case ParameterKind::Displacement:
      return "displacement x,y,z in " + plural(unit);
    case ParameterKind::File:
      return spec.fileTypes.empty() ? "file" : fmt::format("file ({})", spec.fileTypes);
    case ParameterKind::Curve:
      return "curve as t:value, t:value, ..";
    case ParameterKind::SubShape:
      return fmt::format("{} as input:{}:number", subShapeKind(spec), subShapeKind(spec));
    case ParameterKind::List:
      return spec.fields.empty() ? "list" : fmt::format("list; each item: {}", describe(spec.fields.front(), unit));
    case ParameterKind::Record:
      return fmt::format("record of {} as JSON", fieldNames(spec.fields));
  }
  return {};
}

}  // namespace

std::string_view parameterKindName(ParameterKind kind) noexcept {
  const auto index = static_cast<std::size_t>(kind);
  return index < kindNames.size() ? kindNames[index] : "";
}

std::string label(const ParameterSpec& spec) {
  std::string text = spec.name;
  std::replace(text.begin(), text.end(), '-', ' ');
  return text;
}

std::string describe(const ParameterSpec& spec, const LengthUnit& unit) {
  std::string text = describeKind(spec, unit);
  if (const std::string range = describeRange(spec, unit); !range.empty()) text += ", " + range;
  if (!spec.noneMeans.empty()) text += "; none: " + spec.noneMeans;
  if (const std::string condition = describeCondition(spec); !condition.empty()) text += "; " + condition;
  return text;
}

std::string describeCondition(const ParameterSpec& spec) {
  const auto spoken = [](std::string name) {
    std::replace(name.begin(), name.end(), '-', ' ');
    return name;
  };
  std::string text;
  if (!spec.condition.choice.empty())
    text = fmt::format("only if {} is {}", spoken(spec.condition.choice), enumerated(spec.condition.values, "or"));
  if (spec.inputCondition.input.empty()) return text;
  return fmt::format("{} {} {}", text.empty() ? "only" : text + ",", spec.inputCondition.given ? "with" : "without",
                     spoken(spec.inputCondition.input));
}

bool applies(const ParameterSpec& spec, const std::vector<ParameterSpec>& specs, const Value& given) {
  const auto choice = std::find_if(specs.begin(), specs.end(),
                                   [&](const ParameterSpec& each) { return each.name == spec.condition.choice; });
  if (spec.condition.choice.empty() || choice == specs.end()) return true;
  const auto has = [](const std::vector<std::string>& names, const Value& value) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return value == Value(name); });
  };
  const auto found = given.find(choice->name);
  const bool known = found != given.end() && has(choice->choices, *found);
  return has(spec.condition.values, known ? *found : choice->fallback);
}

ParameterSpec flag() { return ofKind(ParameterKind::Flag); }

ParameterSpec count(int minimum, std::optional<int> maximum) {
  ParameterSpec spec = ofKind(ParameterKind::Count);
  spec.minimum = minimum;
  if (maximum) spec.maximum = *maximum;
  return spec;
}

ParameterSpec number(std::optional<double> minimum, std::optional<double> maximum) {
  ParameterSpec spec = ofKind(ParameterKind::Number);
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

ParameterSpec positiveNumber() { return above0(ParameterKind::Number); }

ParameterSpec ratio() {
  ParameterSpec spec = ofKind(ParameterKind::Ratio);
  spec.minimum = 0;
  spec.maximum = 1;
  return spec;
}

ParameterSpec length() { return ofKind(ParameterKind::Length); }

ParameterSpec lengthFromZero() {
  ParameterSpec spec = ofKind(ParameterKind::Length);
  spec.minimum = 0;
  return spec;
}

ParameterSpec positiveLength() { return above0(ParameterKind::Length); }

ParameterSpec angle() { return ofKind(ParameterKind::Angle); }

ParameterSpec choice(std::vector<std::string> names) {
  ParameterSpec spec = ofKind(ParameterKind::Choice);
  spec.choices = std::move(names);
  return spec;
}

ParameterSpec text() { return ofKind(ParameterKind::Text); }
ParameterSpec color() { return ofKind(ParameterKind::Color); }
ParameterSpec point() { return ofKind(ParameterKind::Point); }

ParameterSpec pointInSpace() {
  ParameterSpec spec = point();
  spec.minimum = 3;
  return spec;
}
ParameterSpec vector() { return ofKind(ParameterKind::Vector); }
ParameterSpec displacement() { return ofKind(ParameterKind::Displacement); }

ParameterSpec coordinateOf(const ParameterSpec& spec) { return spec.kind == ParameterKind::Vector ? number() : length(); }

ParameterSpec file(std::string extensions) {
  ParameterSpec spec = ofKind(ParameterKind::File);
  spec.fileTypes = std::move(extensions);
  return spec;
}

ParameterSpec controlCurve() { return ofKind(ParameterKind::Curve); }

ParameterSpec subShape(std::string kind) {
  ParameterSpec spec = ofKind(ParameterKind::SubShape);
  spec.choices = {std::move(kind)};
  return spec;
}

ParameterSpec list(ParameterSpec element) {
  ParameterSpec spec = ofKind(ParameterKind::List);
  spec.fields = {std::move(element)};
  return spec;
}

ParameterSpec record(std::vector<ParameterSpec> fields) {
  ParameterSpec spec = ofKind(ParameterKind::Record);
  spec.fields = std::move(fields);
  return spec;
}

ParameterSpec optional(ParameterSpec spec) {
  spec.mayBeAbsent = true;
  return spec;
}

ParameterSpec whenNone(ParameterSpec spec, std::string means) {
  spec.noneMeans = std::move(means);
  return spec;
}

ParameterSpec onlyFor(ParameterSpec spec, std::string choice, std::vector<std::string> values) {
  spec.condition = {std::move(choice), std::move(values)};
  return spec;
}

ParameterSpec onlyWith(ParameterSpec spec, std::string input) {
  spec.inputCondition = {std::move(input), true};
  return spec;
}

ParameterSpec onlyWithout(ParameterSpec spec, std::string input) {
  spec.inputCondition = {std::move(input), false};
  return spec;
}

ParameterSpec onePer(ParameterSpec list, std::string input, int more, std::string like) {
  list.filling = {std::move(input), more, std::move(like)};
  return list;
}

}  // namespace blossom
