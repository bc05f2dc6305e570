#include "cli/parameter_flags.h"

#include <fmt/format.h>

namespace blossom {
namespace {

std::string helpText(const ParameterSpec& spec) {
  std::string text = spec.help;
  const bool wordsElsewhere = spec.kind == ParameterKind::Flag || spec.kind == ParameterKind::Choice;
  if (const std::string condition = describeCondition(spec); wordsElsewhere && !condition.empty())
    text += " (" + condition + ')';
  if (spec.kind == ParameterKind::Flag) return spec.fallback == Value(true) ? text + " [on]" : text;
  if (spec.kind == ParameterKind::Choice && !spec.fallback.is_null())  // the words stand in front of it
    return fmt::format("{} (default {})", text, formatText(spec, spec.fallback));
  text += " (" + describe(spec);
  if (spec.fallback.is_null()) return text + (spec.mayBeAbsent ? ")" : "; must be given)");
  const std::string fallback = formatText(spec, spec.fallback);
  return fallback.empty() ? text + ")" : fmt::format("{}; default {})", text, fallback);
}

/// Lists may be given in several flags; anything else once.
std::string textOf(const ParameterSpec& spec, const CLI::Option& option) {
  const auto& results = option.results();
  if (results.size() > 1 && spec.kind != ParameterKind::List && spec.kind != ParameterKind::Flag)
    throw UsageError(fmt::format("{} is given {} times.", option.get_name(), results.size()), "Give it once.");
  if (spec.kind != ParameterKind::List) return results.back();
  std::string joined;
  for (const auto& each : results) joined += (joined.empty() ? "" : ",") + each;
  return joined;
}

}  // namespace

std::string namingFlag(const std::string& flag, const std::string& parameter, const std::string& message) {
  if (message.starts_with(parameter)) return flag + message.substr(parameter.size());
  return flag + ": " + message;
}

std::string placeholder(const ParameterSpec& spec) {
  switch (spec.kind) {
    case ParameterKind::Flag:
      return "";
    case ParameterKind::Count:
      return "COUNT";
    case ParameterKind::Number:
    case ParameterKind::Ratio:
      return "NUMBER";
    case ParameterKind::Length:
      return "LENGTH";
    case ParameterKind::Angle:
      return "ANGLE";
    case ParameterKind::Text:
      return "TEXT";
    case ParameterKind::Color:
      return "COLOUR";
    case ParameterKind::Point:
    case ParameterKind::Vector:
    case ParameterKind::Displacement:
      return "X,Y,Z";
    case ParameterKind::File:
      return "FILE";
    case ParameterKind::Curve:
      return "T:VALUE,..";
    case ParameterKind::SubShape:
      return "INPUT:KIND:INDEX";
    case ParameterKind::List:
      return spec.fields.empty() ? "LIST" : placeholder(spec.fields.front()) + ",..";
    case ParameterKind::Record:
      return "JSON";
    case ParameterKind::Choice:
      break;
  }
  std::string all;
  for (const auto& name : spec.choices) all += (all.empty() ? "" : "|") + name;
  return all;
}

ParameterFlags::ParameterFlags(CommandLine& line, CLI::App& app, const std::vector<ParameterSpec>& specs,
                               const std::string& prefix, const std::string& group) {
  for (const ParameterSpec& spec : specs) {
    if (spec.kind != ParameterKind::Record || spec.fallback.is_null()) {
      declare(line, app, spec, "", prefix, group);
      continue;
    }
    for (const ParameterSpec& field : spec.fields) declare(line, app, field, spec.name, prefix + spec.name + '.', group);
  }
}

void ParameterFlags::declare(CommandLine& line, CLI::App& app, const ParameterSpec& spec, const std::string& record,
                             const std::string& prefix, const std::string& group) {
  CLI::Option* option = app.get_option_no_throw("--" + prefix + spec.name);
  if (option) {
    entries_.push_back({record, spec, option, true});
    return;
  }
  const std::string help = helpText(spec);
  if (spec.kind == ParameterKind::Flag) {
    option = app.add_flag(fmt::format("--{0}{1},!--{0}no-{1}", prefix, spec.name), help);
  } else {
    option = app.add_option("--" + prefix + spec.name, help);
    option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  option->type_name(placeholder(spec))->group(group);
  if (spec.kind == ParameterKind::Choice) line.choices[option] = spec.choices;
  entries_.push_back({record, spec, option, false});
}

Value ParameterFlags::values() const {
  Value values = Value::object();
  for (const Entry& entry : entries_) {
    if (entry.option->count() == 0) continue;
    Value& among = entry.record.empty() ? values : values[entry.record];
    try {
      among[entry.spec.name] = parseText(entry.spec, textOf(entry.spec, *entry.option));
    } catch (const UsageError&) {
      throw;
    } catch (const Error& error) {
      throw UsageError(namingFlag(entry.option->get_name(), entry.spec.name, error.message()), error.hint(), error.code());
    }
  }
  return values;
}

std::string ParameterFlags::firstUsed() const {
  for (const Entry& entry : entries_)
    if (!entry.shared && entry.option->count() > 0) return entry.option->get_name();
  return {};
}

}  // namespace blossom
